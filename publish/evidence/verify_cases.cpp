// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

#include "campaign/case_judge.hpp"
#include "campaign/encoding.hpp"
#include "oracle/records/text.hpp"
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
constexpr const char* kOfRuns = "xfail: no trace tells in how many of its runs a flaky case failed";

// What a line of format 2 may hold.
constexpr std::array<std::string_view, 35> kKeys{
    "id",          "dialect",   "cycle",   "features", "clauses", "verdict",   "property_motions",
    "coordinates", "departure", "rule",    "gap",      "clause",  "basis",     "reading",
    "b",           "record",    "word",    "want",     "got",     "deviation", "witness",
    "feature",     "message",   "known",   "expected", "mapped",  "readings",  "us",
    "attempts",    "profile",   "program", "sampled",  "trace",   "notes",     "told_under"};

constexpr std::array<std::string_view, 5> kKeysOfReadings{"open", "explaining", "verdict", "known",
                                                          "against"};
constexpr std::array<std::string_view, 10> kKeysOfSampled{
    "samples", "tolerance", "noise", "following", "go_from",
    "worst",   "at",        "b",     "longest",   "unseen"};

// A key of the object that is none of these; empty: there is none.
std::string surplus_key(const Json& object, std::span<const std::string_view> keys) {
  if (!object.is_object()) return {};
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(keys, key) == keys.end()) return key;
  }
  return {};
}

// What of a line is surplus, though another line may have it.
std::string surplus_word(const Json& line, const CaseRow& row, bool is_recorded, bool is_shard) {
  if (!is_recorded && line.contains("sampled")) return "sampled";
  const bool goes_wrong = decision(kind_before(line)) != Decision::go;
  for (const char* key : {"coordinates", "property_motions", "readings"}) {
    if (goes_wrong && line.contains(key)) return key;
  }
  // The readings of the other shards may make it a failure.
  const bool may_fail = is_shard && line.contains("readings");
  for (const char* key : {"program", "trace"}) {
    if (row.decision() == Decision::go && !may_fail && line.contains(key)) return key;
  }
  return {};
}

// Why no run has written the line so; empty: one may have.
std::string form_fault(const Json& line, const std::string& id) {
  if (const std::string key = surplus_key(line, kKeys); !key.empty()) {
    return fmt::format("{}: a line has no key {}.", id, key);
  }
  using Keys = std::span<const std::string_view>;
  for (const auto& [object, keys] :
       {std::pair("readings", Keys(kKeysOfReadings)), std::pair("sampled", Keys(kKeysOfSampled))}) {
    const std::string key = surplus_key(line.value(object, Json()), keys);
    if (!key.empty()) return fmt::format("{}: {} has no key {}.", id, object, key);
  }
  const auto is_count = [&](const char* key, std::int64_t least) {
    const auto value = line.find(key);
    return value == line.end() || (value->is_number_integer() && *value >= least);
  };
  if (!is_count("us", 0)) return fmt::format("{}: us is no count of microseconds.", id);
  if (!is_count("attempts", 1)) return fmt::format("{}: attempts is no count of runs.", id);
  return {};
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

}  // namespace

VerdictsAgain::VerdictsAgain(const Json& header, std::string traces,
                             std::vector<KnownFailure> waivers, std::vector<AlarmMap::Entry> alarms,
                             bool is_own)
    : is_format_2_(report::count_of(header, "format") == 2),
      is_shard_(text_of(header, "shard") != "1/1"),
      tolerances_(run_tolerances(header)),
      traces_(std::move(traces)),
      waivers_(std::move(waivers)),
      alarms_(std::move(alarms)) {
  wording_.has_rules = is_format_2_;
  wording_.is_own = is_own && is_format_2_;
}

std::string VerdictsAgain::path_of(const std::string& id) const {
  return (fs::path(traces_) / (id + ".jsonl")).string();
}

void VerdictsAgain::take(const Json& line, const Case* test) {
  const CaseRow row = case_row(line);
  Answer answer = answer_of(line, row, test);
  if (answer.fault.empty() && answer.not_derived.empty() && waivers_.rests_on_runs(row)) {
    answer.not_derived = kOfRuns;
  }
  if (!answer.fault.empty()) {
    faults_.push_back(std::move(answer.fault));
  } else if (!answer.not_derived.empty()) {
    ++not_derived_[answer.not_derived];
  } else {
    ++derived_[answer.way];
  }
}

VerdictsAgain::Answer VerdictsAgain::answer_of(const Json& line, const CaseRow& row,
                                               const Case* test) {
  if (std::string fault = is_format_2_ ? form_fault(line, row.id) : ""; !fault.empty()) {
    return {fault};
  }
  if (const std::string word = surplus_word(line, row, tolerances_.subject.recorded, is_shard_);
      is_format_2_ && !word.empty()) {
    return {fmt::format("{}: {} has no {}.", row.id, row.verdict(), word)};
  }
  if (std::string fault = waivers_.fault(line, row, wording_.is_own); !fault.empty()) {
    return {fault};
  }
  if (test != nullptr) {
    const bool is_skip = row.kind == VerdictKind::skip;
    for (const std::string& feature : test->features) {
      if (tolerances_.subject.declares(test->dialect, feature)) continue;
      if (is_skip && text_of(line, "feature") == feature) return {{}, {}, kFromHeader};
      return {fmt::format("{}: the subject does not declare {} in {}: such a case is skipped.",
                          row.id, feature, test->dialect)};
    }
    if (is_skip) return of_skip(line, row, *test);
    run_.try_emplace(test->dialect + dump(line.value("profile", Json::object())), row.id);
  }
  if (std::string why = why_no_trace_tells(told_kind(line, row)); !why.empty()) return {{}, why};
  Wording wording = wording_;
  wording.additions = waivers_.additions(row);
  wording.additions.emplace_back(kNoAnswerAgain);
  if (test != nullptr && fs::exists(path_of(row.id))) {
    Answer answer = of_trace(line, row, *test, wording);
    if (!answer.fault.empty() || !answer.not_derived.empty()) return answer;
    // Program and trace of the line come to the same; how the run ended they may not say.
    wording.holds_words = false;
    if (!tolerances_.subject.recorded) answer.fault = rejudge(line, tolerances_, wording).fault;
    return answer;
  }
  const Rejudged again =
      tolerances_.subject.recorded ? Rejudged{} : rejudge(line, tolerances_, wording);
  if (!again.fault.empty()) return {again.fault};
  if (again.judged) return {{}, {}, kFromLine};
  return {{}, fmt::format("{} without a trace that would tell it", row.verdict())};
}

// Whether the subject may have skipped it (J-RUN-05).
VerdictsAgain::Answer VerdictsAgain::of_skip(const Json& line, const CaseRow& row,
                                             const Case& test) {
  const SubjectInfo& subject = tolerances_.subject;
  if (fs::exists(path_of(row.id))) {
    return {fmt::format("{}: it was skipped, but there is a trace of it.", row.id)};
  }
  const bool is_bytes = text_of(line, "feature") == "bytes" &&
                        !subject.features.contains("bytes") && !is_utf8(test.program);
  if (is_bytes) return {{}, {}, kFromHeader};
  // It claims nothing there about what the subject did.
  const bool expects_gap = std::ranges::any_of(test.expect, &Expectation::not_covered);
  if (expects_gap) return {{}, {}, kFromCorpus};
  if (subject.everything || subject.recorded) {
    return {{}, "skip: the line alone says why"};
  }
  const Json profile = line.value("profile", Json::object());
  if (profile.empty()) {
    return {
        fmt::format("{}: the subject declares all that it needs, and the profile of defaults is "
                    "no reason to skip it.",
                    row.id)};
  }
  refused_.try_emplace(test.dialect + dump(profile), row.id);
  return {{}, "skip: only the subject can say whether it refuses the profile"};
}

VerdictsAgain::Answer VerdictsAgain::of_trace(const Json& line, const CaseRow& row,
                                              const Case& test, const Wording& wording) const {
  // What stood before the programs of recorded output is not in the traces.
  if (tolerances_.subject.recorded && decision(told_kind(line, row)) != Decision::go) {
    return {{}, fmt::format("{} of recorded output", row.verdict())};
  }
  const Tolerances tolerances =
      make_tolerances(tolerances_.subject, test.profile, tolerances_.grants);
  return {
      trace_fault(line, row, path_of(test.id), test, tolerances, alarms_, wording), {}, kFromTrace};
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
