// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/case_roll.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/encoding.hpp"
#include "campaign/selection.hpp"
#include "oracle/records/fresh_counts.hpp"

namespace gonogo::oracle {

using Json = ResultsReader::Json;

namespace {

constexpr std::size_t kMostHeldLines = 50'000;
constexpr std::size_t kMostHeldBytes = std::size_t{64} << 20;

VerdictKind kind_of_line(const Json& line) {
  const auto verdict = line.find("verdict");
  const bool is_text = verdict != line.end() && verdict->is_string();
  return verdict_kind(is_text ? verdict->get<std::string>() : std::string())
      .value_or(VerdictKind::oracle_error);
}

}  // namespace

std::string line_fault(const Case& test, const Json& line) {
  const auto fault = [&](const char* key, const Json& own, const Json& otherwise) -> std::string {
    const Json told = line.value(key, otherwise);
    if (told == own) return {};
    return fmt::format("{}: the line says {} {}, but corpus and header make it {}.", test.id, key,
                       dump(told), dump(own));
  };
  const VerdictKind kind = kind_of_line(line);
  const bool says_nothing = kind == VerdictKind::oracle_gap || kind == VerdictKind::skip;
  const bool expects_gap = std::ranges::any_of(test.expect, &Expectation::not_covered);
  const Json program = program_json(test.program);
  // As a campaign writes what is neither GO nor skipped, an xfail among it.
  const bool needs_program = decision(kind) != Decision::go && kind != VerdictKind::skip;
  for (const std::string& one :
       {fault("dialect", test.dialect, nullptr), fault("cycle", test.cycle, nullptr),
        fault("features", test.features, Json::array()),
        fault("clauses", test.clauses, Json::array()),
        fault("profile", Json::parse(reference::profile_json(test.profile)), Json::object()),
        fault("expected", says_nothing && expects_gap, false),
        fault("program", program, needs_program ? Json() : program)}) {
    if (!one.empty()) return one;
  }
  if (!needs_program || line.value("trace", Json()).is_array()) return {};
  return fmt::format("{}: the line says {}, and has no trace.", test.id, name(kind));
}

CaseRoll::CaseRoll(const Corpus& corpus, const Json& header, Visit visit, Note note)
    : corpus_(corpus), asked_(asked_in(header)), visit_(std::move(visit)), note_(std::move(note)) {}

void CaseRoll::take(const CaseHead& head, std::string line) {
  bytes_ += line.size();
  lines_.emplace(head.id, std::move(line));
  if (lines_.size() >= kMostHeldLines || bytes_ >= kMostHeldBytes) call(false);
}

void CaseRoll::finish() {
  call(true);
}

// The cases from behind the last one that was called up to the last line that is held.
void CaseRoll::call(bool is_last) {
  const std::string last = lines_.empty() ? std::string() : lines_.rbegin()->first;
  CaseReader cases(corpus_, Detail::to_run);
  while (std::optional<Case> test = cases.next()) {
    if (note_ && is_first_call_) note_(test->id);
    const bool is_due = test->id > called_ && (is_last || test->id <= last);
    if (is_due && is_selected(asked_, *test)) call_one(*std::move(test));
  }
  for (const auto& [id, line] : lines_) {
    if (is_fresh(id)) {
      if (visit_) visit_(nullptr, Json::parse(line));
      continue;
    }
    faults_.push_back(fmt::format("{}: the run was not asked for such a case.", id));
  }
  lines_.clear();
  bytes_ = 0;
  called_ = last;
  is_first_call_ = false;
}

void CaseRoll::call_one(Case test) {
  const std::string id = test.id;
  const std::optional<Case> merged = under(asked_, std::move(test));
  if (!merged) {
    ++left_out_;
    return;
  }
  const auto found = lines_.find(id);
  if (found == lines_.end()) {
    faults_.push_back(fmt::format("{}: the run was asked for it, and its line is missing.", id));
    return;
  }
  const Json line = Json::parse(found->second);
  lines_.erase(found);
  if (std::string fault = line_fault(*merged, line); !fault.empty()) {
    faults_.push_back(std::move(fault));
  } else if (visit_) {
    visit_(&*merged, line);
  }
}

}  // namespace gonogo::oracle
