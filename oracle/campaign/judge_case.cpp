// SPDX-License-Identifier: GPL-3.0-or-later
//
// One case with one subject: the run, and the repetitions that a verdict other than GO needs.
#include <fmt/format.h>

#include "oracle/campaign/campaign.hpp"
#include "oracle/judge/evidence.hpp"

namespace gonogo::oracle {
namespace {

// Records that are kept as evidence of a NO-GO.
constexpr std::size_t kKeptRecords = 20'000;

// One run of a program by the subject, judged as it goes.
struct Attempt {
  SessionVerdict session;
  RunEnd end;
  std::vector<Record> records;  // at most kKeptRecords
  bool whole = true;            // all of them were kept
};

class CaseJudge {
 public:
  CaseJudge(const Case& test, const CampaignOptions& options, Subject& subject)
      : test_(test),
        subject_(subject),
        terms_(make_terms(subject.info(), test.profile, options.tolerance, options.chord)),
        limits_(options.limits),
        alarm_map_(options.alarm_map.get()) {}

  CaseResult judge(SessionVerdict& session);

 private:
  std::optional<Verdict> skipped_feature() const;
  Attempt run();
  void confirm(Attempt& attempt, CaseResult& result);
  void confirm_timeout(Attempt& attempt, CaseResult& result);
  bool is_plain_profile() const { return reference::profile_json(test_.profile) == "{}"; }
  void interpret_skip(Attempt& attempt) const;

  const Case& test_;
  Subject& subject_;
  JudgeTerms terms_;
  Limits limits_;
  const AlarmMap* alarm_map_;
};

// A feature that was not declared is `skip`, without a run.
std::optional<Verdict> CaseJudge::skipped_feature() const {
  for (const std::string& feature : test_.features) {
    if (subject_.info().declares(test_.dialect, feature)) continue;
    Verdict verdict;
    verdict.kind = VerdictKind::skip;
    verdict.feature = feature;
    verdict.message = fmt::format("The subject does not declare {} in {}.", feature, test_.dialect);
    return verdict;
  }
  return std::nullopt;
}

// A refused profile is a skip, but not a profile of defaults only; a declared feature that is
// skipped breaks the protocol.
void CaseJudge::interpret_skip(Attempt& attempt) const {
  Verdict& verdict = attempt.session.verdict;
  if (attempt.end.kind == RunEnd::Kind::refused && is_plain_profile()) {
    verdict.kind = VerdictKind::protocol;
    verdict.message =
        fmt::format("The subject refuses the profile of defaults: {}", attempt.end.message);
  } else if (attempt.end.kind == RunEnd::Kind::skip && !test_.features.empty() &&
             !subject_.info().everything && attempt.end.feature != "bytes") {
    const bool declared = subject_.info().declares(test_.dialect, attempt.end.feature);
    if (!declared) return;
    verdict.kind = VerdictKind::protocol;
    verdict.message = fmt::format("The subject declares {} and then skips it: {}",
                                  attempt.end.feature, attempt.end.message);
  }
}

Attempt CaseJudge::run() {
  Attempt attempt;
  try {
    JudgeSession session(test_.profile, test_.program, terms_);
    attempt.end = subject_.run(test_.id, test_.program, [&](const Record& record) {
      if (attempt.records.size() < kKeptRecords) {
        attempt.records.push_back(record);
      } else {
        attempt.whole = false;
      }
      return session.record(record);
    });
    if (attempt.end.kind == RunEnd::Kind::alarm && alarm_map_ != nullptr) {
      if (auto known = alarm_map_->class_of(attempt.end.alarm.native)) {
        attempt.end.alarm.alarm_class = *known;
      }
    }
    attempt.session = session.finish(attempt.end);
    interpret_skip(attempt);
  } catch (const SubjectUnusable&) {
    throw;
  } catch (const std::exception& error) {
    attempt.session.verdict.kind = VerdictKind::oracle_error;
    attempt.session.verdict.message = fmt::format("An error of the gauge itself: {}", error.what());
  }
  return attempt;
}

// Two runs that differ: the subject keeps something from run to run.
bool differs(const Attempt& a, const Attempt& b) {
  const Verdict& x = a.session.verdict;
  const Verdict& y = b.session.verdict;
  return x.kind != y.kind || x.record != y.record || x.got != y.got;
}

// A NO-GO is run again alone in a fresh process; two different answers are a state leak.
void CaseJudge::confirm(Attempt& attempt, CaseResult& result) {
  if (!subject_.keeps_state()) return;
  subject_.renew();
  subject_.configure(test_.profile);
  Attempt again = run();
  ++result.attempts;
  if (!differs(attempt, again)) return;
  Verdict& verdict = attempt.session.verdict;
  const std::string first(name(verdict.kind));
  verdict.kind = VerdictKind::state_leak;
  verdict.message =
      fmt::format("The first run ended {} ({}), the same program in a fresh process {}.", first,
                  verdict.message, name(again.session.verdict.kind));
}

// Near the limit times flap: three more tries with four times the limit.
void CaseJudge::confirm_timeout(Attempt& attempt, CaseResult& result) {
  constexpr int kTries = 3;
  constexpr int kFactor = 4;
  for (int i = 0; i < kTries; ++i) {
    subject_.renew();
    subject_.set_run_limit(limits_.run * kFactor);
    subject_.configure(test_.profile);
    Attempt again = run();
    ++result.attempts;
    if (again.session.verdict.kind == VerdictKind::timeout) continue;
    attempt = std::move(again);
    break;
  }
  subject_.set_run_limit(limits_.run);
}

CaseResult CaseJudge::judge(SessionVerdict& session) {
  CaseResult result;
  result.id = test_.id;
  result.dialect = test_.dialect;
  result.cycle = test_.cycle;
  result.clauses = test_.clauses;
  result.profile = reference::profile_json(test_.profile);
  for (const Expectation& expectation : test_.expect) {
    result.expected_gap = result.expected_gap || expectation.not_covered;
  }
  if (auto skip = skipped_feature()) {
    result.verdict = *skip;
    return result;
  }
  subject_.configure(test_.profile);
  Attempt attempt = run();
  if (attempt.session.verdict.kind == VerdictKind::timeout) confirm_timeout(attempt, result);
  if (decision(attempt.session.verdict.kind) == Decision::no_go) confirm(attempt, result);
  result.verdict = attempt.session.verdict;
  result.microseconds = attempt.end.microseconds;
  if (decision(result.verdict.kind) != Decision::go) {
    result.program = test_.program;
    result.notes = attempt.end.notes;
    for (const Record& record : attempt.records) result.trace.push_back(record_text(record));
    const bool comparable =
        attempt.end.kind == RunEnd::Kind::ok || attempt.end.kind == RunEnd::Kind::alarm;
    if (decision(result.verdict.kind) == Decision::no_go && comparable && attempt.whole) {
      result.verdict.reading =
          explaining_reading(test_.profile, test_.program, terms_, attempt.records, attempt.end);
    }
  }
  session = std::move(attempt.session);
  return result;
}

}  // namespace

CaseResult judge_case(const Case& test, const CampaignOptions& options, Subject& subject,
                      SessionVerdict& session) {
  return CaseJudge(test, options, subject).judge(session);
}

}  // namespace gonogo::oracle
