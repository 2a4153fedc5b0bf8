// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which motions of the subject are which steps of the reference (docs/relation.md, R1, R3). A
// hypothesis says at which step the subject is, and how far along it. A motion may be a piece of
// the step, end it, go on from it into the next where the two are one line or circle, be
// negligible, or stand behind steps too small to see, which the subject omits. What no hypothesis
// explains is a NO-GO, described by the hypothesis that came farthest.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "oracle/open/free_step.hpp"
#include "oracle/records/rounding_census.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/steps/reference_steps.hpp"

namespace gonogo::oracle {

// One way to read what the subject has put out so far.
struct Hypothesis {
  std::size_t step = 0;
  Position at;      // where the subject stands, as the step names it
  Position anchor;  // where its last motion ended that was not negligible

  // For a step that is a motion, once it has begun; it may be joined with steps behind it.
  std::shared_ptr<const Curve> curve;
  std::size_t joined = 0;
  CurveProgress progress;
  std::optional<Motion> piece;  // the last that was taken of it
  // The motion before the step, and how far along it the subject had come before its last piece.
  std::shared_ptr<const Curve> left;
  CurveProgress left_progress;

  // For a step whose path is open. `waiting`: its next motion, which others may continue.
  std::shared_ptr<FreeStep> open;
  std::optional<Motion> waiting;

  std::size_t passed = 0;             // item of the last motion that was left behind
  std::optional<Motion> after_alarm;  // motion in or after the block that should have alarmed

  // For the grade of a pass.
  bool exact = true;    // every end and centre is exact so far
  bool rounded = true;  // ... or correctly rounded
  RoundingCensus coordinates;
  std::size_t property_motions = 0;
  std::optional<Verdict> instead;  // of a pass: the first advice or gap behind which it continued

  // Whether its step has not begun.
  bool is_fresh() const { return !curve && !open; }
};

// J-CMP-12. What departs is out of order if a later record `shows` that (null: none does), and
// `message` says so. `verdict`: the verdict then, where something else departs.
struct OtherOrder {
  std::function<bool(const Record&)> shows = nullptr;
  std::string_view message = {};
  std::optional<Verdict> verdict = {};
};

// Why a hypothesis does not explain a motion, a dwell or an end: a verdict, or how the motion
// departs from the step.
struct Refutation {
  Hypothesis from;
  std::optional<Motion> motion;  // what departs, where there is no verdict
  CurveAnswer answer;
  std::optional<Verdict> verdict;
  OtherOrder other_order = {};
  bool may_be_passed = false;  // the step is negligible: what departs may be of one behind it
  bool is_undue = false;       // no motion is due where it comes
  bool is_of_other_block() const { return !verdict && answer.departure == Departure::block; }
};

// What does not count against the budget of records.
struct Forgiven {
  std::size_t records = 0;
  std::size_t level_cuts = 0;
};

class Alignment {
 public:
  // All must outlive it.
  Alignment(ReferenceSteps& steps, const Position& start, const Tolerances& tolerances,
            FreeStepMemory& memory);

  // The subject's next motion, or dwell. False: no hypothesis explains it (see `refutation`).
  bool take_motion(const Record& record, std::size_t number);
  bool take_dwell(const Record& record, std::size_t number);
  // The subject's next M function. `of_alarm`: it may belong to a block that alarms.
  enum class MFunction { taken, of_alarm, departs };
  MFunction take_m_function(const Record& record, std::size_t number);
  // R5: the M function that has to come before the step begins, and has not; null: none.
  const DueMFunction* overdue(const Hypothesis& from);

  const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }
  std::vector<Hypothesis>& hypotheses() { return hypotheses_; }
  // The first step that may not have been passed yet.
  std::size_t first_step() const;
  // Where no hypothesis is left: that the gauge cannot decide, or why the farthest one is refuted.
  const std::optional<Verdict>& gap() const { return gap_; }
  Refutation& refutation() { return *farthest_; }
  Forgiven take_forgiven() { return std::exchange(forgiven_, {}); }

  // At the end of the subject's motions: nothing waits any more. False: no hypothesis is left.
  bool settle();
  // Goes past what the subject need not show where it stands: a motion too small to see, a path
  // that may end, a renaming.
  struct Passing {
    bool passed = false;
    std::optional<Verdict> why_not = {};  // of an open path that may not end here
  };
  Passing pass(Hypothesis& hypothesis);
  // R3: whether the step is a dwell so short that rounding makes it none.
  bool may_be_none(const ReferenceStep& step) const;
  // Goes past a step as it is.
  void skip(Hypothesis& hypothesis);
  // R7. Goes on behind an end that no text states, which is an advice. `departure`: what comes
  // there departs from the end. False where the step is no such end, or the certifier is strict.
  bool go_on_behind_end(Hypothesis& hypothesis, Verdict departure);
  // The judge of an open step; null: the step is not open.
  FreeStep* free_step_of(Hypothesis& hypothesis);

 private:
  // R9.
  static constexpr const char* kTooManySmall =
      "More than 100,000 motions in a row are too small to see.";

  // What one record leads to.
  struct Stage {
    std::vector<Hypothesis> reached;
    std::unordered_set<std::size_t> seen;  // steps that were reached before they began
    bool branches = false;                 // from several hypotheses
  };

  // What the hypothesis follows of its step.
  static const Motion& wanted(const Hypothesis& from, const ReferenceSteps::Step& step) {
    return from.curve ? from.curve->motion() : std::get<Motion>(step.what);
  }

  // In alignment_m_functions.cpp.
  const DueMFunction* overdue_at(std::size_t step);
  bool waits_for_m_function(Hypothesis& from, const Motion& motion, Stage& stage);
  bool is_undue(const Motion& motion, const ReferenceSteps::Step& step) const;
  void refute_missing(Hypothesis from, const DueMFunction& due, std::string got,
                      std::size_t number);
  MFunction meet_m_function(Hypothesis& from, const Record& record, std::size_t number);
  void refute_early(Hypothesis from, const Record& record, std::size_t number);
  void refute_m_function(Hypothesis from, const Record& record, std::size_t number);
  bool is_told(const DueMFunction& due, const Record& record) const;
  bool is_within(const Hypothesis& from, const DueMFunction& due);
  bool comes_beside(const Hypothesis& from, const Record& record);
  bool may_come_early(const Hypothesis& from, const Record& record);
  bool may_be_of_alarm(const Hypothesis& from, const Record& record);
  bool is_due_later(const Hypothesis& from, const Record& record);

  void walk(Hypothesis from, Motion motion, Stage& stage);
  // One step; true where the hypothesis goes on to the next one with the motion.
  bool meet(Hypothesis& from, Motion& motion, Stage& stage);
  bool meet_motion(Hypothesis& from, const Motion& motion, Stage& stage);
  bool take_ways(const Hypothesis& from, const Motion& motion, const CurveAnswer& answer,
                 Stage& stage);
  void take_longer_end(const Hypothesis& from, const Motion& motion, Stage& stage);
  // R1: joins the step behind, which may move nothing. False where it does not go on.
  bool join_step(Hypothesis& from);
  bool join_motion(Hypothesis& from);
  bool join_chords(Hypothesis& from, const Motion& next, Motion& both);
  bool extend(Hypothesis& from, const Motion& motion, CurveAnswer& answer);
  void depart(const Hypothesis& from, const Motion& motion, CurveAnswer answer, Stage& stage);
  bool leads_outside(const Hypothesis& from, const Motion& motion);
  bool leads_over_m_function(const Hypothesis& from, const Motion& motion);
  bool leads_into_free_step(const Hypothesis& from, const Motion& motion, Stage& stage);
  bool leads_past_corner(const Hypothesis& from, const Motion& motion, Stage& stage);
  bool takes_coarse_centre(const Hypothesis& from, const Motion& motion, const CurveAnswer& answer,
                           Stage& stage);
  void meet_free_step(Hypothesis from, Motion motion, Stage& stage);
  void meet_behind_free_step(Hypothesis from, const Motion& motion, Stage& stage);
  void begin_free_step(Hypothesis& from);
  // The waiting motion goes to its step. Where it ends there, or goes beyond, `from` is used up,
  // and `reached` is the result.
  bool take_waiting(Hypothesis& from, std::vector<Hypothesis>& reached);
  bool leave_free_step(Hypothesis& from, const Position& here);
  bool meet_renaming(Hypothesis& from, Motion& motion, Stage& stage);
  bool leads_to_new_name(const Hypothesis& from, const Motion& motion);
  bool meet_last(Hypothesis& from, const Motion& motion, Stage& stage);
  // What shows that the dwell of this step only comes later; nothing for another step.
  OtherOrder late_dwell(const ReferenceStep& due) const;
  bool meet_dwell(Hypothesis& from, const Record& record, std::size_t number);

  // Whether the record is of a block before this one, where lines tell.
  bool is_of_earlier_block(const Record& record, std::uint64_t block) const {
    return tolerances_.compare_blocks && steps_.is_in_order() && record.block < block;
  }
  bool is_negligible(const Hypothesis& from, const Motion& motion, const Position& place) const;
  // Whether it is one more piece of the motion that the subject has left.
  bool ends_left(const Hypothesis& from, const Motion& motion) const;
  bool can_pass(const Hypothesis& from, const Motion& want) const;
  void leave_motion(Hypothesis& from);
  static void keep(Hypothesis hypothesis, std::vector<Hypothesis>& reached);
  static void stay(Hypothesis from, const Motion& motion, Stage& stage);
  bool finish(std::vector<Hypothesis> reached);
  void refute(Refutation refutation);
  void keep_own(const Refutation& refutation);
  void refute(Hypothesis from, Verdict verdict, OtherOrder other_order = {});
  // No motion is due where this one comes.
  void refute_undue(Hypothesis from, Verdict verdict, OtherOrder other_order = {});
  void leave_undecided(std::size_t step, Verdict gap);
  bool passes_too_many(const Hypothesis& from, std::size_t passed);
  const ReferenceSteps::Step& step_of(const Hypothesis& from) { return steps_.at(from.step); }
  // The step behind those that are joined.
  const ReferenceSteps::Step& step_behind(const Hypothesis& from) {
    return steps_.at(from.step + from.joined + 1);
  }

  ReferenceSteps& steps_;
  const Tolerances& tolerances_;
  FreeStepMemory& memory_;
  std::vector<Hypothesis> hypotheses_;
  std::optional<Refutation> farthest_;
  // J-CMP-12: of the motion that is met, from a step of its own block that is too small to see.
  std::optional<Refutation> own_;
  // For a hypothesis that may be right as far as is known, and the step where it was given up.
  std::optional<Verdict> gap_;
  std::size_t gap_step_ = 0;
  Forgiven forgiven_;
};

}  // namespace gonogo::oracle
