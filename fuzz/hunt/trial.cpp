// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/trial.hpp"
#include "subjects/make_subject.hpp"

#include <fmt/format.h>

namespace gonogo::hunt {
namespace {

constexpr std::size_t kHistory = 16;
constexpr std::size_t kKeptRecords = 20'000;

// Whether the subject broke down, rather than answering something wrong.
bool broke_down(const std::optional<oracle::Verdict>& verdict) {
  using Kind = oracle::VerdictKind;
  return verdict && (verdict->kind == Kind::crash || verdict->kind == Kind::timeout ||
                     verdict->kind == Kind::out_of_memory || verdict->kind == Kind::protocol);
}

}  // namespace

Trial::Trial(SubjectMaker make, TrialOptions options)
    : make_(std::move(make)), options_(std::move(options)), subject_(made()) {}

// What has been made once may fail to be made for a reason that passes.
std::unique_ptr<oracle::Subject> Trial::made() const {
  constexpr int kTries = 3;
  for (int tries = 1;; ++tries) {
    try {
      auto subject = make_();
      subject->set_run_limit(options_.run_limit);
      return subject;
    } catch (const oracle::SubjectUnusable&) {
      if (tries == kTries) throw;
    }
  }
}

oracle::RunEnd Trial::run_once(oracle::Subject& subject, const generate::GeneratedProgram& program,
                               const oracle::RecordSink& sink) {
  subject.configure(program.profile);
  oracle::RunEnd end = subject.run("generated", program.text, sink);
  if (options_.alarm_map) options_.alarm_map->name_class(end);
  return end;
}

std::optional<oracle::Verdict> Trial::judge(oracle::Subject& subject,
                                            const generate::GeneratedProgram& program,
                                            JudgedRun* judged) {
  const oracle::Tolerances tolerances =
      make_tolerances(subject.info(), program.profile, options_.grants);
  oracle::Verdict verdict;
  try {
    oracle::JudgeSession session(program.profile, program.text, tolerances);
    bool too_long = false;
    moved_ = false;
    records_ = 0;
    const oracle::RunEnd end = run_once(subject, program, [&](const reference::Record& record) {
      if (judged != nullptr && judged->records.size() < kKeptRecords) {
        judged->records.push_back(record);
      }
      moved_ = moved_ || reference::is_motion(record.kind);
      if (!session.record(record)) return false;
      too_long = ++records_ > options_.most_records;
      return !too_long;
    });
    if (too_long) return std::nullopt;
    verdict = session.finish(end).verdict;
    if (judged != nullptr) judged->end = end;
  } catch (const oracle::SubjectUnusable&) {
    throw;
  } catch (const std::exception& error) {
    verdict.kind = oracle::VerdictKind::oracle_error;
    verdict.message = fmt::format("An error of the gauge itself: {}", error.what());
  }
  if (options_.blind) verdict = {};
  return verdict;
}

std::optional<oracle::Verdict> Trial::run(const generate::GeneratedProgram& program) {
  history_.push_back(program);
  if (history_.size() > kHistory) history_.pop_front();
  std::optional<oracle::Verdict> verdict = judge(*subject_, program, nullptr);
  // A subject that breaks down too often in a row gives itself up; a new one does not.
  if (broke_down(verdict)) {
    subject_ = made();
    history_.erase(history_.begin(), history_.end() - 1);
  }
  return verdict;
}

oracle::Subject& Trial::fresh(const std::vector<generate::GeneratedProgram>& before) {
  if (!second_) second_ = made();
  second_->renew();
  for (const generate::GeneratedProgram& program : before) {
    std::size_t records = 0;
    run_once(*second_, program,
             [&](const reference::Record&) { return ++records <= options_.most_records; });
  }
  return *second_;
}

std::optional<oracle::Verdict> Trial::run_alone(const Reproducer& reproducer) {
  std::optional<oracle::Verdict> verdict =
      judge(fresh(reproducer.before), reproducer.program, nullptr);
  if (broke_down(verdict)) second_.reset();
  return verdict;
}

JudgedRun Trial::examine(const Reproducer& reproducer) {
  JudgedRun judged;
  oracle::Subject& subject = fresh(reproducer.before);
  const auto verdict = judge(subject, reproducer.program, &judged);
  if (verdict) judged.verdict = *verdict;
  const bool comparable =
      judged.end.kind == oracle::RunEnd::Kind::ok || judged.end.kind == oracle::RunEnd::Kind::alarm;
  if (decision(judged.verdict.kind) == oracle::Decision::no_go && comparable &&
      judged.records.size() < kKeptRecords) {
    constexpr std::size_t kMostJudged = 200'000;
    const auto& [profile, text] = reproducer.program;
    judged.verdict.reading = oracle::explaining_reading(
        profile, text, make_tolerances(subject.info(), profile, options_.grants), judged.records,
        judged.end, kMostJudged);
  }
  second_.reset();
  return judged;
}

std::vector<generate::GeneratedProgram> Trial::history() const {
  if (history_.empty()) return {};
  return {history_.begin(), history_.end() - 1};
}

void Trial::set_run_limit(std::chrono::milliseconds limit) {
  subject_->set_run_limit(limit);
  options_.run_limit = limit;
  second_.reset();
}

}  // namespace gonogo::hunt
