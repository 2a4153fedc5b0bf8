// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program against one subject under every admissible combination of readings.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "oracle/judge/program_judge.hpp"
#include "oracle/judge/sampled_outcome.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/steps/different_assignments.hpp"
#include "oracle/steps/record_log.hpp"

namespace gonogo::oracle {

// The records of an outcome, as often as they are asked for: in memory, or read from a file anew.
class RecordSeries {
 public:
  virtual ~RecordSeries() = default;
  virtual std::size_t size() const = 0;
  // Hands them out in their order until `take` says false.
  virtual void each(const std::function<bool(const Record&)>& take) const = 0;
};

class RecordsInMemory : public RecordSeries {
 public:
  explicit RecordsInMemory(std::span<const Record> records) : records_(records) {}
  std::size_t size() const override { return records_.size(); }
  void each(const std::function<bool(const Record&)>& take) const override {
    for (const Record& record : records_) {
      if (!take(record)) return;
    }
  }

 private:
  std::span<const Record> records_;
};

// What the judge says under every assignment.
struct SessionVerdict {
  Verdict verdict;                                   // GO if any assignment is
  std::vector<reference::ReadingChoice> explaining;  // assignments under which it is GO
  std::vector<reference::ReadingKey> open;           // the open readings that made a difference
};

// One judge stands for all assignments until the reference differs under one of them; then that one
// has a judge of its own, until its first departure (J-READ-01).
class JudgeSession {
 public:
  // `profile` may say "any"; `profile`, `program` and `tolerances` must outlive the session.
  JudgeSession(const reference::Profile& profile, const ProgramText& program,
               const Tolerances& tolerances, Forking forking = Forking::when_different);
  ~JudgeSession();
  // The subject's next record. False when nothing it can still send changes the answer.
  bool record(const Record& record);
  // The same as a line of JSON. True: the reference writes its own record so, and nothing more has
  // to be looked at. Else call `record`. Its line number is known then.
  bool line(std::string_view line);
  SessionVerdict finish(const RunEnd& end);

 private:
  // Assignments under which the reference says the same, and their judge.
  struct Fork;

  void log(const Record& record, bool undecided);
  Fork& add_fork(AssignmentSet set);
  // Gives forks to the assignments that have parted from that fork.
  void part(Fork& fork);
  void settle_forks();
  void stop_forking();
  void bury(const std::shared_ptr<Fork>& fork);
  void explain_best();
  void try_lengths(const Fork& fork);
  void try_length(const Fork& fork, reference::ReadingKey key, const Number& length);
  std::uint64_t departed_block(const ProgramJudge& judge) const;
  // Whether the verdict is the best so far. `unexplained`: the fork whose departure is still to be
  // explained, if it counts; null: it is explained.
  bool consider(SampledVerdict said, std::shared_ptr<Fork> unexplained = nullptr);
  void finish_forks(const RunEnd& end);
  void finish_sampled(const SampledOutcome& sampled, const RunEnd& end);
  // Where every fork departs: tries readings together that make no difference one by one.
  void finish_together(const RunEnd& end);

  const reference::Profile& profile_;
  ProgramText program_;
  const Tolerances& tolerances_;
  const Forking forking_;
  std::vector<std::shared_ptr<Fork>> alive_;
  // What they have taken, while others may have to take it, too.
  std::optional<RecordLog> taken_;
  std::size_t records_ = 0;  // of the subject, and its end
  std::size_t best_records_ = 0;
  std::optional<SampledVerdict> best_;          // of those that are at their end
  std::shared_ptr<Fork> best_unexplained_;      // as of `consider`
  std::optional<Surplus> surplus_;              // of the best, until the next record
  std::optional<std::uint64_t> surplus_block_;  // of the best, where that record shows it
  struct Departed {
    SampledVerdict said;
    std::shared_ptr<Fork> unexplained;
  };
  std::vector<Departed> departures_;                  // of those at their end, the NO-GO
  std::vector<reference::ReadingChoice> explaining_;  // of those that are GO
  std::set<reference::ReadingKey> open_;              // that made a difference
  std::size_t most_others_ = 0;                       // that one fork looked at to the last
  std::set<std::string, std::less<>> lengths_;  // that were tried of readings that are lengths
  std::uint64_t last_block_ = 0;                // of the subject's last record
  Position stood_;                              // before it, except renamings
  Position stands_;                             // behind it
  bool too_many_ = false;
};

// Judges a recorded outcome.
SessionVerdict judge_outcome(const reference::Profile& profile, const ProgramText& program,
                             const Tolerances& tolerances, const RecordSeries& records,
                             const RunEnd& end);
SessionVerdict judge_outcome(const reference::Profile& profile, const ProgramText& program,
                             const Tolerances& tolerances, std::span<const Record> records,
                             const RunEnd& end);

// In explaining_reading.cpp. For a NO-GO: "k=v" of the first other reading under which the outcome
// is GO; else "". Tries every reading that the program touches under any assignment, except the
// open ones, which have been tried. Gives up, with "", where it would judge more than
// `most_records` (each assignment counting for 1,000 more).
std::string explaining_reading(const reference::Profile& profile, const ProgramText& program,
                               const Tolerances& tolerances, const RecordSeries& records,
                               const RunEnd& end, std::size_t most_records = kMostRecordsAgain);
std::string explaining_reading(const reference::Profile& profile, const ProgramText& program,
                               const Tolerances& tolerances, std::span<const Record> records,
                               const RunEnd& end, std::size_t most_records = kMostRecordsAgain);

}  // namespace gonogo::oracle
