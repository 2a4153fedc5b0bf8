// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "campaign/encoding.hpp"
#include "campaign/reading_tally.hpp"
#include "oracle/records/input_file.hpp"
#include "oracle/records/text.hpp"
#include "oracle/records/trace_reader.hpp"
#include "publish/evidence/text.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

namespace fs = std::filesystem;
using report::text_of;

constexpr const char* kFromTrace = "from its trace";
constexpr const char* kFromLine = "from what its line holds";
constexpr const char* kFromCorpus = "from the corpus, which expects no answer";
constexpr const char* kFromHeader = "from what the subject declares";

// What a line of format 2 may hold.
constexpr std::array<std::string_view, 35> kKeys{
    "id",          "dialect",   "cycle",   "features", "clauses", "verdict",   "property_motions",
    "coordinates", "departure", "rule",    "gap",      "clause",  "basis",     "reading",
    "b",           "record",    "word",    "want",     "got",     "deviation", "witness",
    "feature",     "message",   "known",   "expected", "mapped",  "readings",  "us",
    "attempts",    "profile",   "program", "sampled",  "trace",   "notes",     "told_under"};

// Why no run has written the line so; empty: one may have.
std::string form_fault(const Json& line, const std::string& id) {
  for (const auto& [key, value] : line.items()) {
    if (std::ranges::find(kKeys, key) == kKeys.end()) {
      return fmt::format("{}: a line has no key {}.", id, key);
    }
  }
  const auto is_count = [&](const char* key, std::int64_t least) {
    const auto value = line.find(key);
    return value == line.end() || (value->is_number_integer() && *value >= least);
  };
  if (!is_count("us", 0)) return fmt::format("{}: us is no count of microseconds.", id);
  if (!is_count("attempts", 1)) return fmt::format("{}: attempts is no count of runs.", id);
  return {};
}

// As it was before the readings of the run were reconciled.
VerdictKind kind_before(const Json& line) {
  const auto readings = line.find("readings");
  const Json& source = readings == line.end() ? line : *readings;
  return verdict_kind(text_of(source, "verdict")).value_or(VerdictKind::oracle_error);
}

// What the line says of the trace alone.
VerdictKind told_kind(const Json& line, const CaseRow& row) {
  if (row.kind != VerdictKind::xfail || line.contains("readings")) return kind_before(line);
  return verdict_kind(row.departure).value_or(VerdictKind::oracle_error);
}

// What of a verdict a trace cannot tell: how the subject behaved, or what came of several runs.
std::string why_no_trace_tells(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::fail_declaration:
    case VerdictKind::state_leak:
    case VerdictKind::crash:
    case VerdictKind::timeout:
    case VerdictKind::out_of_memory:
    case VerdictKind::protocol:
    case VerdictKind::oracle_error:
      return fmt::format("{}: no trace tells it", name(kind));
    default:
      return {};
  }
}

SessionVerdict judge_trace(const std::string& path, const reference::Profile& profile,
                           const std::string& program, const Tolerances& tolerances) {
  std::ifstream file = open_regular(path);
  file.exceptions(std::ios::badbit);  // what cannot be read is not the end of the trace
  JudgeSession session(profile, program, tolerances);
  TraceReader reader;
  RunEnd end;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    TraceLine read = reader.read(line);
    if (auto* record = std::get_if<reference::Record>(&read)) {
      if (!session.record(*record)) break;
    } else if (auto* alarm = std::get_if<SubjectAlarm>(&read)) {
      end.kind = RunEnd::Kind::alarm;
      end.alarm = std::move(*alarm);
    } else {
      throw ResultsError(
          fmt::format("{}, line {}: {}", path, number, std::get<TraceFault>(read).message));
    }
  }
  return session.finish(end);
}

// In what the verdict of the trace differs from the line, a sentence; empty: in nothing.
std::string trace_fault(const Json& line, const CaseRow& row, const SessionVerdict& now) {
  const VerdictKind told = told_kind(line, row);
  const VerdictKind kind = now.verdict.kind;
  const bool is_same = told == VerdictKind::xpass ? decision(kind) == Decision::go : told == kind;
  if (!is_same) {
    return fmt::format("{}: the verdict was {}, but derived from the trace it is {}. {}", row.id,
                       name(told), name(kind), now.verdict.message);
  }
  if (told != kind || decision(kind) != Decision::go) return {};
  // Where the readings of the run make a pass none, its line says more.
  if (row.kind == kind) {
    for (const char* key : {"rule", "gap", "departure", "clause", "want", "got", "record",
                            "deviation", "witness", "message"}) {
      if (line.contains(key)) return fmt::format("{}: a pass has no {}.", row.id, key);
    }
    const auto told_census = line.find("coordinates");
    const auto was =
        told_census == line.end() ? std::nullopt : RoundingCensus::from_json(*told_census);
    if (was != now.verdict.coordinates) {
      return fmt::format("{}: the trace has other counts of coordinates than the line.", row.id);
    }
  }
  const auto open = open_readings(now);
  const Json explaining = open ? Json(open->explaining) : Json::array();
  const Json was = line.value("readings", Json::object()).value("explaining", Json::array());
  if (was == explaining) return {};
  return fmt::format(
      "{}: the readings that explain it were {}, but derived from the trace they are {}.", row.id,
      dump(was), dump(explaining));
}

}  // namespace

VerdictsAgain::VerdictsAgain(const Json& header, std::string traces,
                             std::vector<KnownFailure> waivers)
    : is_format_2_(report::count_of(header, "format") == 2),
      tolerances_(run_tolerances(header)),
      traces_(std::move(traces)),
      waivers_(std::move(waivers)) {}

std::string VerdictsAgain::path_of(const std::string& id) const {
  return (fs::path(traces_) / (id + ".jsonl")).string();
}

void VerdictsAgain::take(const Json& line, const Case* test) {
  const CaseRow row = case_row(line);
  Answer answer = answer_of(line, row, test);
  if (!answer.fault.empty()) faults_.push_back(std::move(answer.fault));
  if (!answer.not_derived.empty()) ++not_derived_[answer.not_derived];
}

VerdictsAgain::Answer VerdictsAgain::answer_of(const Json& line, const CaseRow& row,
                                               const Case* test) {
  if (std::string fault = is_format_2_ ? form_fault(line, row.id) : ""; !fault.empty()) {
    return {fault, {}};
  }
  if (std::string fault = waiver_fault(line, row); !fault.empty()) return {fault, {}};
  if (test != nullptr) {
    const bool is_skip = row.kind == VerdictKind::skip;
    for (const std::string& feature : test->features) {
      if (tolerances_.subject.declares(test->dialect, feature)) continue;
      if (is_skip && text_of(line, "feature") == feature) return ++derived_[kFromHeader], Answer{};
      return {fmt::format("{}: the subject does not declare {} in {}: such a case is skipped.",
                          row.id, feature, test->dialect),
              {}};
    }
    if (is_skip) return of_skip(line, row, *test);
    run_.try_emplace(test->dialect + dump(line.value("profile", Json::object())), row.id);
  }
  if (std::string why = why_no_trace_tells(told_kind(line, row)); !why.empty()) return {{}, why};
  if (test != nullptr && fs::exists(path_of(row.id))) {
    Answer answer = of_trace(line, row, *test);
    if (!answer.fault.empty() || !answer.not_derived.empty()) return answer;
    // What the line says of the departure besides is held against its own trace.
    return {tolerances_.subject.recorded ? std::string() : rejudge(line, tolerances_).fault, {}};
  }
  const Rejudged again = tolerances_.subject.recorded ? Rejudged{} : rejudge(line, tolerances_);
  if (!again.fault.empty()) return {again.fault, {}};
  if (again.judged) return ++derived_[kFromLine], Answer{};
  return {{}, fmt::format("{} without a trace that would tell it", row.verdict())};
}

// Whether the subject may have skipped it (J-RUN-05).
VerdictsAgain::Answer VerdictsAgain::of_skip(const Json& line, const CaseRow& row,
                                             const Case& test) {
  const SubjectInfo& subject = tolerances_.subject;
  if (fs::exists(path_of(row.id))) {
    return {fmt::format("{}: it was skipped, but there is a trace of it.", row.id), {}};
  }
  const bool is_bytes = text_of(line, "feature") == "bytes" &&
                        !subject.features.contains("bytes") && !is_utf8(test.program);
  if (is_bytes) return ++derived_[kFromHeader], Answer{};
  // It claims nothing there about what the subject did.
  const bool expects_gap = std::ranges::any_of(test.expect, &Expectation::not_covered);
  if (expects_gap) return ++derived_[kFromCorpus], Answer{};
  if (subject.everything || subject.recorded) {
    return {{}, "skip: the line alone says why"};
  }
  const Json profile = line.value("profile", Json::object());
  if (profile.empty()) {
    return {
        fmt::format("{}: the subject declares all that it needs, and the profile of defaults is "
                    "no reason to skip it.",
                    row.id),
        {}};
  }
  refused_.try_emplace(test.dialect + dump(profile), row.id);
  return {{}, "skip: only the subject can say whether it refuses the profile"};
}

VerdictsAgain::Answer VerdictsAgain::of_trace(const Json& line, const CaseRow& row,
                                              const Case& test) {
  // What stood before the programs of recorded output is not in the traces.
  if (tolerances_.subject.recorded && decision(told_kind(line, row)) != Decision::go) {
    return {{}, fmt::format("{} of recorded output", row.verdict())};
  }
  const Tolerances tolerances =
      make_tolerances(tolerances_.subject, test.profile, tolerances_.grants);
  const SessionVerdict now = judge_trace(path_of(test.id), test.profile, test.program, tolerances);
  ++derived_[kFromTrace];
  return {trace_fault(line, row, now), {}};
}

// A known failure, and one that passes, is that of an entry of the run.
std::string VerdictsAgain::waiver_fault(const Json& line, const CaseRow& row) const {
  if (row.kind != VerdictKind::xfail && row.kind != VerdictKind::xpass) return {};
  Verdict departure;
  departure.kind = verdict_kind(row.departure).value_or(VerdictKind::oracle_error);
  departure.deviation_exact = row.deviation_exact;
  departure.got = text_of(line, "got");
  const bool is_known = std::ranges::any_of(waivers_, [&](const KnownFailure& entry) {
    return entry.covers(row.id) && (row.kind == VerdictKind::xpass || entry.is(departure));
  });
  if (is_known) return {};
  return fmt::format("{}: it is {}, and no known failure of the run says so.", row.id,
                     row.verdict());
}

void VerdictsAgain::tell(Findings& findings) const {
  std::vector<std::string> faults = faults_;
  for (const auto& [machine, skipped] : refused_) {
    const auto run = run_.find(machine);
    if (run == run_.end()) continue;
    faults.push_back(fmt::format("{}: it was skipped, but {} was run under the same profile.",
                                 skipped, run->second));
  }
  std::vector<std::string> ways;
  for (const auto& [way, cases] : derived_)
    ways.push_back(fmt::format("{} {}", grouped(cases), way));
  findings.add_list(faults,
                    fmt::format("Verdicts derived again, all the same: {}.",
                                ways.empty() ? "none" : fmt::format("{}", fmt::join(ways, ", "))));
  for (const auto& [reason, cases] : not_derived_) {
    findings.add_unproven(fmt::format("{} could not be derived here ({}). --subject runs {} again.",
                                      counted(cases, "verdict", "verdicts"), reason,
                                      cases == 1 ? "it" : "them"));
  }
}

}  // namespace gonogo::oracle::evidence
