// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject while programs are tried on it: it may crash, hang and keep state; it is made again.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "campaign/known_failures.hpp"
#include "fuzz/hunt/specimen.hpp"
#include "oracle/differential/subject.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/motion/tolerances.hpp"

namespace gonogo::hunt {

using SubjectMaker = std::function<std::unique_ptr<oracle::Subject>()>;

// How the subject is judged.
struct TrialOptions {
  oracle::Grants grants;
  std::shared_ptr<const oracle::AlarmMap> alarm_map;  // null: the subject's classes as they are
  std::chrono::milliseconds run_limit{2'000};
  std::size_t most_records = 5'000;  // of a program, where all of them agree
  bool blind = false;  // for the check of the bench: a judge that says GO to everything
};

// What the subject put out, and what the judge says of it.
struct JudgedRun {
  oracle::Verdict verdict;
  std::vector<reference::Record> records;  // at most 20,000
  oracle::RunEnd end;
};

class Trial {
 public:
  // `make` gives a subject whenever it is asked. Throws what it throws.
  Trial(SubjectMaker make, TrialOptions options);

  const oracle::SubjectInfo& info() const { return subject_->info(); }

  // In the process that ran the programs before. Nothing: too long to be of use.
  std::optional<oracle::Verdict> run(const generate::GeneratedProgram& program);
  // Whether the subject moved in that run.
  bool moved() const { return moved_; }
  // How many records it sent in that run.
  std::size_t records() const { return records_; }
  // In a process of its own, after the programs that came before it in the reproducer.
  std::optional<oracle::Verdict> run_alone(const Reproducer& reproducer);
  // The same with all that a report needs, and the reading under which it would be GO.
  JudgedRun examine(const Reproducer& reproducer);

  // Whether a run can differ from one in a fresh process.
  bool keeps_state() const { return subject_->keeps_state(); }
  // What ran before the last program in its process, the last of them; oldest first.
  std::vector<generate::GeneratedProgram> history() const;
  // Another time limit, until the next call.
  void set_run_limit(std::chrono::milliseconds limit);
  std::chrono::milliseconds run_limit() const { return options_.run_limit; }

 private:
  std::optional<oracle::Verdict> judge(oracle::Subject& subject,
                                       const generate::GeneratedProgram& program,
                                       JudgedRun* judged);
  oracle::RunEnd run_once(oracle::Subject& subject, const generate::GeneratedProgram& program,
                          const oracle::RecordSink& sink);
  std::unique_ptr<oracle::Subject> made() const;
  // The second subject in a new process, after these programs.
  oracle::Subject& fresh(const std::vector<generate::GeneratedProgram>& before);

  bool moved_ = false;
  std::size_t records_ = 0;
  SubjectMaker make_;
  TrialOptions options_;
  std::unique_ptr<oracle::Subject> subject_;
  std::unique_ptr<oracle::Subject> second_;         // for runs alone
  std::deque<generate::GeneratedProgram> history_;  // the last program at its end
};

}  // namespace gonogo::hunt
