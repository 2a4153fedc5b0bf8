// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/known_failures.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "oracle/records/run_scope.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

// Most globs differ in what stands before their first wildcard.
bool matches(const std::string& glob, const std::string& text) {
  const std::size_t literal = glob.find_first_of("*?[\\");
  if (literal == std::string::npos) return glob == text;
  if (text.compare(0, literal, glob, 0, literal) != 0) return false;
  return ::fnmatch(glob.c_str(), text.c_str(), 0) == 0;
}

}  // namespace

bool KnownFailure::covers(const std::string& id) const {
  return matches(cases, id);
}

bool KnownFailure::is(const Verdict& got_verdict) const {
  return got_verdict.kind == verdict &&
         (deviation.empty() || deviation == got_verdict.deviation_exact) &&
         (got.empty() || got == got_verdict.got);
}

void KnownFailure::make_known(Verdict& known) const {
  known.known = visible(reason);
  known.departure = known.kind;
  known.kind = VerdictKind::xfail;
}

std::string KnownFailure::pass_message() const {
  return fmt::format("Known to fail with {} ({}), but it passes.", name(verdict), visible(reason));
}

std::string failed_runs(int failures, const Flaky& flaky) {
  return fmt::format("{} of {} runs failed so", failures, flaky.runs);
}

std::string KnownFailure::beyond_flaky(int runs_that_failed) const {
  return fmt::format(" {}; it is known to fail in at most {} of them ({}).",
                     failed_runs(runs_that_failed, *flaky), flaky->failures, visible(reason));
}

void KnownFailures::note_case(const std::string& id) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].covers(id)) ++cases_[i];
  }
}

void KnownFailures::apply(CaseResult& result) const {
  Verdict& verdict = result.verdict;
  const Decision answer = decision(verdict.kind);
  for (const KnownFailure& entry : entries_) {
    if (entry.flaky || !entry.covers(result.id)) continue;
    if (answer == Decision::undecided || answer == Decision::neither) return;
    if (answer == Decision::go && entry.verdict == VerdictKind::fail_reading && result.readings) {
      result.readings->known = visible(entry.reason);  // the readings of the run tell
      return;
    }
    if (answer == Decision::go) {
      verdict.kind = VerdictKind::xpass;
      verdict.message = entry.pass_message();
      result.readings.reset();  // any reading may explain it
      return;
    }
    if (!entry.is(verdict)) continue;
    entry.make_known(verdict);
    return;
  }
}

bool KnownFailures::must_fail(const std::string& id) const {
  return std::ranges::any_of(
      entries_, [&](const KnownFailure& entry) { return !entry.flaky && entry.covers(id); });
}

const KnownFailure* KnownFailures::flaky_entry(const std::string& id,
                                               const Verdict& verdict) const {
  const auto found = std::ranges::find_if(entries_, [&](const KnownFailure& entry) {
    return entry.flaky && entry.is(verdict) && entry.covers(id);
  });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::string> KnownFailures::stale() const {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (cases_[i] == 0) {
      texts.push_back(
          fmt::format("known failure {}: no case has this id", visible(entries_[i].cases)));
    } else if (cases_[i] > kMostCasesOfAGlob) {
      texts.push_back(fmt::format("known failure {}: it covers {} cases, more than {}; list them",
                                  visible(entries_[i].cases), cases_[i], kMostCasesOfAGlob));
    }
  }
  return texts;
}

const AlarmMap::Entry* AlarmMap::entry_for(const std::string& native) const {
  const auto found = std::ranges::find_if(
      entries_, [&](const Entry& entry) { return matches(entry.native, native); });
  return found == entries_.end() ? nullptr : &*found;
}

const AlarmMap::Entry* AlarmMap::name_class(RunEnd& end) const {
  if (end.kind != RunEnd::Kind::alarm) return nullptr;
  const Entry* const known = entry_for(end.alarm.native);
  if (known != nullptr) end.alarm.alarm_class = known->alarm_class;
  return known;
}

std::string stale_alarm(const std::string& native) {
  return fmt::format("{}{}: no case met it", kStaleAlarm, visible(native));
}

std::vector<std::string> AlarmMap::natives() const {
  std::vector<std::string> natives;
  for (const Entry& entry : entries_) natives.push_back(entry.native);
  return natives;
}

}  // namespace gonogo::oracle
