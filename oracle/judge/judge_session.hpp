// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program against one subject under every admissible assignment of readings.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "oracle/judge/program_judge.hpp"
#include "oracle/judge/record_log.hpp"
#include "oracle/judge/sampled_outcome.hpp"
#include "oracle/region/constants.hpp"

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
  void each(const std::function<bool(const Record&)>& take) const override;

 private:
  std::span<const Record> records_;
};

// What the judge says under every assignment.
struct SessionVerdict {
  Verdict verdict;                                   // GO if any assignment is
  std::vector<reference::ReadingChoice> explaining;  // assignments under which it is GO
  std::vector<reference::ReadingKey> open;           // the open readings that the program touches
};

// Until the reference asks for an open reading, every assignment means the same: one judge stands
// for all, and the assignments are looked for only then.
class JudgeSession {
 public:
  // `profile` may say "any"; `profile`, `program` and `terms` must outlive the session.
  JudgeSession(const reference::Profile& profile, const ProgramText& program,
               const JudgeTerms& terms);
  // The subject's next record. False when nothing it can still send changes the answer.
  bool record(const Record& record);
  // The same as a line of JSON, where that is the reference's own and nothing more has to be looked
  // at: true when that was all. Else `record` has to be given. Its line number is known then.
  bool line(std::string_view line);
  SessionVerdict finish(const RunEnd& end);

 private:
  // While one judge stands for all.
  struct Unsettled {
    std::vector<reference::ReadingKey> open;  // that the program may touch
    RecordLog taken;
  };
  bool touches_open() const;
  bool record_unsettled(const Record& record);
  // Looks for the assignments, and gives their judges what the one has taken.
  void settle();
  bool tell_judges(const Record& record);

  ProgramJudge& judge_of(std::size_t assignment);
  // What is said under one assignment, and how far it came.
  SampledVerdict finish_under(std::size_t assignment, const RunEnd& end);

  const reference::Profile& profile_;
  ProgramText program_;
  const JudgeTerms& terms_;
  std::vector<reference::ReadingChoice> choices_;  // each with its judge
  // One judge stands for all assignments, or each has its own.
  struct AssignedJudge {
    AssignedJudge(reference::Profile its_profile, const ProgramText& program,
                  const JudgeTerms& terms)
        : profile(std::move(its_profile)), judge(profile, program, terms) {}
    const reference::Profile profile;
    ProgramJudge judge;
  };
  std::optional<ProgramJudge> only_judge_;
  std::vector<std::unique_ptr<AssignedJudge>> assigned_judges_;
  std::optional<Unsettled> unsettled_;
  std::vector<reference::ReadingKey> open_;
  bool too_many_ = false;
};

// Whether what is said under one assignment counts before what is said under another: the best
// pass; else a gap, for under that assignment the subject may be right; else the departure that
// comes last.
bool outranks(const SampledVerdict& one, const SampledVerdict& other);

// The readings that a run of the reference under this profile asks for.
std::vector<reference::ReadingKey> touched_by(const reference::Profile& profile,
                                              const ProgramText& program);

// The assignments of the open readings ("any", not judged by properties) that the program touches.
struct Assignments {
  std::vector<reference::ReadingChoice> choices;  // at least one
  std::vector<reference::ReadingKey> open;
  bool too_many = false;
};
Assignments assignments_of(const reference::Profile& profile, const ProgramText& program);

// Judges a recorded outcome.
SessionVerdict judge_outcome(const reference::Profile& profile, const ProgramText& program,
                             const JudgeTerms& terms, const RecordSeries& records,
                             const RunEnd& end);
SessionVerdict judge_outcome(const reference::Profile& profile, const ProgramText& program,
                             const JudgeTerms& terms, std::span<const Record> records,
                             const RunEnd& end);

// In explaining_reading.cpp. For a NO-GO: "k=v" of the first other reading under which the outcome
// is GO; else "". Every reading is tried that the program touches under any assignment; readings
// that are open already have been. Gives up, with "", where it would judge more records than that
// (each assignment counting for 1,000 more).
std::string explaining_reading(const reference::Profile& profile, const ProgramText& program,
                               const JudgeTerms& terms, const RecordSeries& records,
                               const RunEnd& end, std::size_t most_records = kMostRecordsAgain);
std::string explaining_reading(const reference::Profile& profile, const ProgramText& program,
                               const JudgeTerms& terms, std::span<const Record> records,
                               const RunEnd& end, std::size_t most_records = kMostRecordsAgain);

}  // namespace gonogo::oracle
