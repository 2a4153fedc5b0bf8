// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/case_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/records/finding.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {
namespace {

// Records that are kept as evidence of a NO-GO.
constexpr std::size_t kKeptRecords = 20'000;
constexpr int kTries = 3;
// An answer after the limit shows a slow machine; no answer in so many times the limit is a hang
// (J-RUN-08).
constexpr int kTimeoutFactor = 4;

}  // namespace

// One run of a program by the subject, judged as it goes.
struct CaseJudge::Attempt {
  SessionVerdict session;
  RunEnd end;
  std::vector<Record> records;  // at most kKeptRecords
  bool whole = true;            // all of them were kept
  std::string mapped;           // the entry of the alarm map that was met
  // Where the campaign keeps traces: that of this run, so that line and trace are of one run.
  std::unique_ptr<TraceFile> trace;

  // Whether the subject answered, rather than hung or broke down.
  bool answers() const { return !is_breakdown(session.verdict.kind); }
  // Two runs that differ: the subject keeps something from run to run.
  bool differs(const Attempt& other) const {
    const Verdict& x = session.verdict;
    const Verdict& y = other.session.verdict;
    return x.kind != y.kind || x.record != y.record || x.got != y.got;
  }
};

CaseJudge::CaseJudge(const CampaignOptions& options, const SubjectMaker& make_subject)
    : options_(options),
      make_subject_(make_subject),
      known_failures_(options.known_failures),
      subject_(make()) {}

// A subject that started once may fail to start again for a passing reason.
std::unique_ptr<Subject> CaseJudge::make() const {
  for (int tries = 1;; ++tries) {
    try {
      std::unique_ptr<Subject> subject = make_subject_();
      subject->set_run_limit(options_.limits.run * kTimeoutFactor);
      return subject;
    } catch (const SubjectUnusable&) {
      if (tries >= kTries) throw;
    }
  }
}

std::size_t CaseJudge::window() const {
  return static_cast<std::size_t>(std::max(1, subject_->info().max_in_flight));
}

void CaseJudge::prepare(const Case& test) {
  if (profile_ && *profile_ == test.profile) return;
  profile_ = test.profile;
  profile_text_ = reference::profile_json(test.profile);
  subject_->configure(test.profile);
}

bool CaseJudge::announce(const Case& test) {
  if (!profile_ || *profile_ != test.profile) return false;
  if (!undeclared_feature(test)) subject_->announce(test.id, test.program);
  return true;
}

// A case of an undeclared feature is `skip`, without a run.
std::optional<std::string> CaseJudge::undeclared_feature(const Case& test) const {
  for (const std::string& feature : test.features) {
    if (!subject_->info().declares(test.dialect, feature)) return feature;
  }
  return std::nullopt;
}

// Whether the subject declares what the case needs. Not asked where it declares nothing at all,
// where the corpus expects no answer, and of recorded output, which may be a part.
bool CaseJudge::is_claimed(const Case& test, const RunEnd& end) const {
  const SubjectInfo& info = subject_->info();
  if (info.everything || info.recorded) return false;
  if (std::ranges::any_of(test.expect, &Expectation::not_covered)) return false;
  // A program that is not UTF-8 is for subjects with the feature only.
  if (end.feature == "bytes" && !info.features.contains("bytes")) return false;
  return info.declares(test.dialect, "");
}

// A skip is no claim (J-RUN-05); but what was declared, or a profile of defaults, is a failure of
// the declaration to skip (J-RUN-05).
void CaseJudge::interpret_skip(const Case& test, Attempt& attempt) const {
  Verdict& verdict = attempt.session.verdict;
  const bool refuses_defaults = attempt.end.kind == RunEnd::Kind::refused && profile_text_ == "{}";
  if (refuses_defaults && !subject_->info().everything) {
    verdict.kind = VerdictKind::fail_declaration;
    verdict.message =
        fmt::format("The subject refuses the profile of defaults: {}", attempt.end.message);
  } else if (attempt.end.kind == RunEnd::Kind::skip && is_claimed(test, attempt.end)) {
    verdict.kind = VerdictKind::fail_declaration;
    verdict.message =
        fmt::format("The subject skips what it declares ({}): {}", fmt::join(test.features, ", "),
                    attempt.end.message.empty() ? attempt.end.feature : attempt.end.message);
  }
}

CaseJudge::Attempt CaseJudge::run(Subject& subject, const Case& test, const Tolerances& tolerances,
                                  int number) const {
  Attempt attempt;
  if (!options_.traces.empty()) {
    attempt.trace = std::make_unique<TraceFile>(options_.traces, test.id, number);
  }
  TraceFile* const keep = attempt.trace.get();
  try {
    JudgeSession session(test.profile, test.program, tolerances);
    attempt.end = subject.run(test.id, test.program, [&](const Record& record) {
      if (attempt.records.size() < kKeptRecords) {
        attempt.records.push_back(record);
      } else {
        attempt.whole = false;
      }
      if (keep != nullptr) keep->record(record);
      return session.record(record);
    });
    if (options_.alarm_map) {
      if (const auto* known = options_.alarm_map->name_class(attempt.end)) {
        attempt.mapped = known->native;
      }
    }
    attempt.session = session.finish(attempt.end);
    interpret_skip(test, attempt);
    if (keep != nullptr) keep->finish(attempt.end);
  } catch (const SubjectUnusable&) {
    throw;
  } catch (const ResultsUnwritable&) {
    throw;
  } catch (const std::exception& error) {
    attempt.session.verdict.kind = VerdictKind::oracle_error;
    attempt.session.verdict.message = fmt::format("An error of the gauge itself: {}", error.what());
  }
  return attempt;
}

Subject& CaseJudge::fresh_subject(const reference::Profile& profile) {
  if (!second_) second_ = make();
  second_->renew();
  second_->configure(profile);
  return *second_;
}

// Too much memory in either run is `out-of-memory` (J-RUN-08), since the moment when it is noticed
// differs from run to run.
bool CaseJudge::settle_memory(Attempt& attempt, Attempt& again) {
  const bool first = attempt.session.verdict.kind == VerdictKind::out_of_memory;
  const bool second = again.session.verdict.kind == VerdictKind::out_of_memory;
  if (!first && !second) return false;
  if (!first) {
    attempt = std::move(again);
    attempt.session.verdict.message += " That was a fresh process, which has run nothing else.";
    return true;
  }
  if (second) return true;
  if (again.answers()) {
    attempt.session.verdict.message +=
        " A fresh process, which has run nothing else, runs the same program without.";
  } else {
    attempt.session.verdict.message +=
        fmt::format(" A fresh process, which has run nothing else, ended {}.",
                    name(again.session.verdict.kind));
  }
  return true;
}

// A case that is known to be flaky runs as often as its entry says, each time in a fresh process.
// It is as known only where no more runs fail than that; a run that fails otherwise is the
// verdict.
bool CaseJudge::settle_flaky(const Case& test, const Tolerances& tolerances, Attempt& attempt,
                             CaseResult& result) {
  const KnownFailure* const known = known_failures_.flaky_entry(test.id, attempt.session.verdict);
  if (known == nullptr) return false;
  int failures = 1;
  for (int runs = 1; runs < known->flaky->runs; ++runs) {
    Attempt again = run(fresh_subject(test.profile), test, tolerances, ++result.attempts);
    if (decision(again.session.verdict.kind) != Decision::no_go) continue;
    if (!known->is(again.session.verdict)) {
      attempt = std::move(again);
      return true;
    }
    ++failures;
  }
  Verdict& verdict = attempt.session.verdict;
  if (failures <= known->flaky->failures) {
    known->make_known(verdict);
    attempt.end.notes += fmt::format("{}{}.", attempt.end.notes.empty() ? "" : "\n",
                                     failed_runs(failures, *known->flaky));
  } else {
    verdict.message += known->beyond_flaky(failures);
  }
  return true;
}

// A NO-GO is run again alone in a fresh process; two different answers are a state leak (J-RUN-08).
void CaseJudge::confirm(const Case& test, const Tolerances& tolerances, Attempt& attempt,
                        CaseResult& result) {
  if (!subject_->keeps_state() || attempt.end.given_up) return;
  Attempt again = run(fresh_subject(test.profile), test, tolerances, ++result.attempts);
  if (again.end.given_up || settle_memory(attempt, again)) return;
  if (again.session.verdict.kind == VerdictKind::timeout) {
    // No answer is no other answer.
    attempt.session.verdict.message += kNoAnswerAgain;
    return;
  }
  if (!attempt.differs(again)) {
    // Nothing ran beside it or before, so the answer is the same each time.
    attempt = std::move(again);
    return;
  }
  Verdict& verdict = attempt.session.verdict;
  const std::string first(name(verdict.kind));
  verdict.kind = VerdictKind::state_leak;
  verdict.message =
      fmt::format("The first run ended {} ({}), the same program in a fresh process {}.", first,
                  verdict.message, name(again.session.verdict.kind));
}

// No answer within four times the limit. Up to three tries follow in fresh processes, each with
// four times the limit. An answer after the limit shows a slow machine, and counts. Three answers
// within the limit show that an earlier program made the subject hang, a state leak
// (J-RUN-08).
void CaseJudge::confirm_timeout(const Case& test, const Tolerances& tolerances, Attempt& attempt,
                                CaseResult& result) {
  const auto limit = std::chrono::microseconds(options_.limits.run).count();
  int in_time = 0;
  for (int i = 0; i < kTries; ++i) {
    Attempt again = run(fresh_subject(test.profile), test, tolerances, ++result.attempts);
    if (again.session.verdict.kind == VerdictKind::timeout) continue;
    if (!again.answers()) {
      attempt = std::move(again);
      attempt.session.verdict.message += " The first run gave no answer in time.";
      return;
    }
    const bool is_slow = again.end.microseconds > limit || !subject_->keeps_state();
    if (!is_slow && ++in_time < kTries) continue;
    if (is_slow) {
      attempt = std::move(again);
    } else {
      attempt.session.verdict.kind = VerdictKind::state_leak;
      attempt.session.verdict.message = fmt::format(
          "{} In fresh processes, which had run nothing else, the same program was answered within "
          "{} ms, {} times out of {}: {}.",
          attempt.session.verdict.message, options_.limits.run.count(), in_time, kTries,
          name(again.session.verdict.kind));
    }
    return;
  }
}

void CaseJudge::keep_path(const Case& test, const Attempt& attempt, CaseResult& result) {
  result.program = test.program;
  // How far it came before a limit differs from run to run.
  const bool is_cut =
      attempt.end.kind == RunEnd::Kind::timeout || attempt.end.kind == RunEnd::Kind::out_of_memory;
  if (!is_cut) {
    for (const Record& record : attempt.records) result.trace.push_back(record_text(record));
  }
  if (attempt.session.verdict.sampled != nullptr) {
    result.trace = attempt.session.verdict.sampled->drawn;
  }
}

void CaseJudge::keep_evidence(const Case& test, const Tolerances& tolerances,
                              const Attempt& attempt, CaseResult& result) const {
  keep_path(test, attempt, result);
  result.notes = attempt.end.notes;
  const bool comparable =
      attempt.end.kind == RunEnd::Kind::ok || attempt.end.kind == RunEnd::Kind::alarm;
  const bool departs = decision(result.verdict.kind) == Decision::no_go ||
                       result.verdict.kind == VerdictKind::advice;
  if (departs && comparable && attempt.whole) {
    Tolerances plain = tolerances;
    plain.measure = false;
    result.verdict.reading =
        explaining_reading(test.profile, test.program, plain, attempt.records, attempt.end);
  }
}

// J-RUN-08.
void CaseJudge::finish(const Case& test, CaseResult& result) {
  const std::optional<RunEnd> broken = subject_->finish();
  if (!broken) return;
  result.verdict = {};
  result.verdict.kind = VerdictKind::crash;
  result.verdict.message = broken->message;
  result.notes = broken->notes;
  result.program = test.program;
  result.readings.reset();
}

CaseResult CaseJudge::judge(const Case& test) {
  prepare(test);
  CaseResult result;
  result.id = test.id;
  result.dialect = test.dialect;
  result.cycle = test.cycle;
  result.features = test.features;
  result.clauses = test.clauses;
  result.profile = profile_text_;
  result.expected_gap = std::ranges::any_of(test.expect, &Expectation::not_covered);
  if (const auto feature = undeclared_feature(test)) {
    // An earlier run may have left a trace.
    if (!options_.traces.empty()) TraceFile(options_.traces, test.id);
    result.verdict.kind = VerdictKind::skip;
    result.verdict.feature = *feature;
    result.verdict.message =
        fmt::format("The subject does not declare {} in {}.", *feature, test.dialect);
    return result;
  }
  const Tolerances tolerances = make_tolerances(subject_->info(), test.profile, options_.grants);
  Attempt attempt = run(*subject_, test, tolerances, result.attempts);
  if (result.expected_gap && attempt.session.verdict.kind == VerdictKind::timeout) {
    // The time of a program that the corpus does not cover says nothing (J-RUN-08).
    attempt.session.verdict =
        gap_verdict(GapReason::not_covered, std::move(attempt.session.verdict.message));
  }
  const bool is_settled = settle_flaky(test, tolerances, attempt, result);
  if (!is_settled && attempt.session.verdict.kind == VerdictKind::timeout) {
    confirm_timeout(test, tolerances, attempt, result);
  }
  // Three tries in fresh processes have confirmed a timeout or its cause.
  const VerdictKind kind = attempt.session.verdict.kind;
  const bool is_confirmed = kind == VerdictKind::timeout || kind == VerdictKind::state_leak;
  if (decision(kind) == Decision::no_go && !is_settled && !is_confirmed) {
    confirm(test, tolerances, attempt, result);
  }
  if (attempt.trace) attempt.trace->keep();
  result.verdict = attempt.session.verdict;
  result.microseconds = attempt.end.microseconds;
  result.mapped = attempt.mapped;
  if (decision(result.verdict.kind) == Decision::go) {
    result.readings = open_readings(attempt.session);
    // The readings of the run may leave it a failure; what is known to fail must not pass.
    if (result.readings || known_failures_.must_fail(test.id)) keep_path(test, attempt, result);
  } else if (result.verdict.kind != VerdictKind::skip) {
    keep_evidence(test, tolerances, attempt, result);
  }
  return result;
}

}  // namespace gonogo::oracle
