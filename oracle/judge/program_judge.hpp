// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of one program under one assignment of readings: the subject's records come in, the
// reference is pulled along, the first departure decides.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "oracle/judge/curve_match.hpp"
#include "oracle/judge/helix_pocket_judge.hpp"
#include "oracle/judge/plain_motion.hpp"
#include "oracle/judge/pocket_milling_judge.hpp"
#include "oracle/judge/program_input.hpp"
#include "oracle/judge/progress.hpp"
#include "oracle/judge/queue.hpp"
#include "oracle/judge/record_budget.hpp"
#include "oracle/judge/reference_stream.hpp"
#include "oracle/judge/thread_judge.hpp"
#include "oracle/region/level.hpp"
#include "oracle/verdict.hpp"

namespace gonogo::oracle {

class ProgramJudge {
 public:
  // `profile` says every reading that counts; it, `program` and `terms` must outlive the judge.
  ProgramJudge(const reference::Profile& profile, const ProgramText& program,
               const JudgeTerms& terms);
  // The subject's next record. False when nothing it can still send changes the answer.
  bool record(const Record& record);
  // Its next record as a line of JSON, where that is how the reference writes its own and nothing
  // more has to be looked at: true when that was all. Else `record` has to be told.
  bool line(std::string_view line);
  // The subject's end; the verdict.
  Verdict finish(const RunEnd& end);

  // How far the comparison came, in items of the reference.
  std::size_t progress() const { return departed_at_.value_or(reference_.items()); }
  // Whether nothing that is still to come changes the answer.
  bool is_decided() const { return verdict_.has_value(); }
  // What its reference has asked for so far.
  const reference::ReadingsInUse& readings() const { return reference_.readings(); }
  // Whether the record, or the line, that it was told last is item number `progress` of the
  // reference, which would say so whatever the subject had done.
  bool is_in_step() const { return in_step_ && !reference_.was_moved(); }

 private:
  void decide_too_many(const Record& record);
  bool makes_progress(const Motion& motion);

  // While the records of both sides are the same, in equal_steps.cpp. True when that was all.
  bool equal_record(const Record& record);
  bool fall_into_step(const Record& record);
  bool plain_ahead();
  void go_on(AxisSet axes, reference::ClauseId clause);
  void leave_step(std::size_t number);

  void take_record(const Record& record);
  void take_motion(const Record& record);
  // Whether a motion too small to see is what the reference makes next, which need not have dropped
  // the same motions before it. Then it is used up.
  bool is_due(const Motion& motion);
  bool ends_here(const Motion& motion, const Motion& next);
  void flush_pending();
  void process(Motion motion);
  // One step of the reference against one motion; true when the motion is used up. A path that ends
  // within the motion leaves the rest of it.
  bool process_step(Motion& motion);
  // Nothing where the step is no open path.
  std::optional<OpenPathAnswer> take_in_path(const Motion& motion, const ReferenceStep& step);
  // Whether it leads to a cycle and may be meant as none.
  bool is_unseen(const Motion& motion, const ReferenceStep& step) const;
  void stop_before(const Motion& motion, const ReferenceStep& step);
  void moves_before_renaming(const Motion& motion, const ReferenceStep& step);
  bool match_motion(Motion& motion, const Motion& want);
  void note_properties(const OpenPathAnswer& answer, const Motion& motion);
  // As a piece of the reference's current motion; where it is done, the reference goes on.
  MatchResult try_motion(const Motion& motion, const Motion& want);
  bool reached(const Motion& want, const Position& at) const;
  // Whether a motion may be meant as none before a step that is no motion.
  bool means_nothing(const Motion& motion, const ReferenceStep& step) const;
  bool goes_on_outside(const Motion& motion);
  void take_dwell(const Record& record);
  // What is said of a dwell that comes within a motion of the reference: the verdict, or that the
  // motion is short.
  Verdict dwell_behind(Verdict verdict);
  void take_m_functions();
  // Follows the renamings of the position that come before a record of `block` (0: not known).
  void follow_renamings(std::uint64_t block);
  void rename(const reference::Renaming& renaming);
  void take_m_function(const Record& record);
  bool take_placed_m_function(const Record& record);
  void m_function_is_due(const Record& want, const Record* got, std::size_t number);
  void note_block(const Record& record);
  void m_out_of_place(const Record& record);
  void settle_m_functions(bool at_end);
  void settle_m_functions_before(std::size_t alarm_block, bool at_load);
  void settle_m_functions_of_earlier(std::uint64_t block);
  void note_match(const Motion& motion, const Motion& want);

  // Pocket levels, in level_judge.cpp. True when the motion belongs to the level.
  bool collect(const Motion& motion, const reference::PocketLevel& level);
  // `here` is where the subject stands after the level.
  void finish_level(const reference::PocketLevel& level, const Position& here);
  Verdict level_fault(const reference::PocketLevel& level, const region::Finding& finding,
                      const Position& here) const;
  bool is_known_level(const reference::PocketLevel& level) const;
  // Whether it is so small that it is cleared where the subject stands.
  bool needs_no_motion(const reference::PocketLevel& level) const;
  void go_on_below(const reference::PocketLevel& level);
  void depart_from_level(VerdictKind kind, const Motion& motion,
                         const reference::PocketLevel& level, std::string message);

  // Threads, helical pockets and pockets of LCYC75, in open_path_steps.cpp.
  ThreadJudge& thread_judge(const reference::ThreadMilling& thread);
  HelixPocketJudge& helix_pocket_judge(const reference::HelixPocket& pocket);
  PocketMillingJudge& pocket_judge(const reference::PocketMilling& pocket);
  // Whether a motion belongs to a pocket, which may be as small as the tolerance: nothing of it is
  // dropped. Puts through the approach to the pocket.
  bool mills_pocket(const Motion& motion);
  // A traverse that leads above a pocket and on into it; from then on its rest.
  bool dives_into_pocket(Motion& motion);
  bool follow_open_path(const OpenPathAnswer& answer, Motion& motion);
  // Goes on after the current open path, which ends `here`; false when it is none or incomplete.
  bool end_open_path(const Position& here);
  // The same before a record of a later block; also of a pocket level.
  void end_open_path_before(std::uint64_t block);
  std::optional<Verdict> unfinished_open_path();

  // The end of the subject, in judge_end.cpp.
  void judge_ok_end();
  void judge_alarm_end(const SubjectAlarm& alarm);
  void judge_other_end(const RunEnd& end);
  // A step that the subject's alarm leaves undone, and the items of the reference up to there.
  struct Unfinished {
    ReferenceStep step;
    std::size_t items;
  };
  std::optional<Verdict> compare_alarm(const SubjectAlarm& alarm,
                                       const reference::AlarmReport& report,
                                       const std::optional<Unfinished>& unfinished);
  Verdict spurious_alarm(const SubjectAlarm& alarm, const std::optional<Unfinished>& unfinished,
                         std::string message);
  void conclude_alarm(std::optional<Verdict> departure, const SubjectAlarm& alarm,
                      std::uint64_t block, const std::optional<Unfinished>& unfinished,
                      bool at_load);
  void compare_end(const Record& end);
  void ends_early(const ReferenceStep& step, const std::string& got);

  void decide(Verdict verdict);
  void decide_gap(std::string message);
  bool is_of_block(const SubjectAlarm& alarm, const Motion& motion) const;
  void refuse_alarm_outside(const SubjectAlarm& alarm);
  void decide_undecided(const exact::Undecided& undecided);
  void decide_not_covered(const reference::NotCovered& outside);
  // In departure.cpp.
  void report_departure(const MatchResult& result, const Motion& motion, const Motion& want);
  // What of the reference's current motion the subject has put out last; null: nothing.
  const Motion* piece_before() const { return match_ && piece_ ? &*piece_ : nullptr; }
  bool ended_short(const Motion& motion, const Motion& want, const Apart& apart);
  void report_path_departure(const MatchResult& result, const Motion& motion, const Motion& want,
                             Verdict& verdict);
  Verdict short_of(const Motion& want, const Motion& piece) const;
  // From the reference's current step on.
  bool fits_later(const Motion& motion);
  // In departure.cpp: goes on after an arc whose centre is too coarse for a rule of ours.
  bool takes_coarse_centre(const MatchResult& result, const Motion& motion, const Motion& want);

  const reference::Profile& profile_;
  const JudgeTerms& terms_;
  ProgramText program_;
  ProgramInput input_;
  ReferenceStream reference_;
  RecordBudget budget_;
  VisitedPlaces visited_;

  Position position_;              // where the subject stands
  Position anchor_;                // where its last motion that was kept ended
  std::optional<Motion> pending_;  // joined so far
  std::size_t records_ = 0;

  // While the records of both sides are the same; then position, anchor and pending are behind.
  struct InStep {
    PlainMotion last;
    PlainMotion next;
    AxisSet axes;  // of the last one, as the subject names them
    reference::ClauseId clause = reference::kNoClause;
    const reference::Item* ahead =
        nullptr;  // of the reference: `next`, if `is_plain`; null: not asked
    bool is_plain = false;
  };
  std::optional<InStep> in_step_;
  std::optional<Motion> want_;  // the reference's current motion, which match_ looks at
  std::optional<CurveMatch> match_;
  std::optional<Motion> piece_;  // of want_, the last one that match_ has taken

  Position plunge_;  // where the tool came down
  std::vector<region::LevelMotion> level_motions_;
  std::vector<Record> level_records_;                 // the same, for the evidence
  std::optional<reference::PocketLevel> last_level_;  // judged GO, with its motions and plunge
  std::vector<region::LevelMotion> last_motions_;
  Position last_plunge_;

  std::optional<ThreadJudge> thread_;  // while the reference's step is one
  RunOutSet run_outs_;                 // that explain the threads so far
  std::optional<HelixPocketJudge> helix_pocket_;
  std::optional<PocketMillingJudge> pocket_;

  Queue<Record> want_m_;
  struct GotM {
    Record record;
    bool after_cut;  // of its block
  };
  Queue<GotM> got_m_;
  std::uint64_t cut_block_ = 0;     // of the last cutting motion
  std::uint64_t motion_block_ = 0;  // of the last motion or dwell
  std::uint64_t m_block_ = 0;       // of the last M function that the subject passed on

  std::optional<Verdict> verdict_;
  std::optional<Verdict> advice_;           // of what the judge went on after, the first
  std::optional<std::size_t> departed_at_;  // in items, before what comes later is looked at
  std::optional<Motion> after_alarm_;       // motion in or after the block that should have alarmed
  std::optional<Record> end_record_;        // the subject's `end`
  bool moved_ = false;                      // the subject has put out a motion
  bool exact_ = true;                       // every end and centre is exact so far
  bool rounded_ = true;                     // ... or correctly rounded
  std::size_t property_motions_ = 0;        // of the subject, that open steps have taken
};

}  // namespace gonogo::oracle
