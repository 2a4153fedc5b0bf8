// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/compare_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "campaign/encoding.hpp"
#include "publish/evidence/compare_parts.hpp"
#include "publish/evidence/run_state.hpp"
#include "publish/report/case_paths.hpp"

namespace gonogo::oracle::evidence {
namespace {

// A results file with the case that is up; the whole line is built of a case that departs only.
class SideOfRuns {
 public:
  explicit SideOfRuns(const std::string& path) : reader_(path) { step(); }
  const ResultsReader& reader() const { return reader_; }
  bool is_at(const std::string& id) const { return !at_end_ && line_.id == id; }
  bool at_end() const { return at_end_; }
  const CaseHead& line() const { return line_; }
  Decision decision() const {
    return oracle::decision(verdict_kind(line_.verdict).value_or(VerdictKind::oracle_error));
  }
  Json part() const {
    if (decision() == Decision::go) return {{"verdict", line_.verdict}};
    return departure_part(reader_.json());
  }
  void step() { at_end_ = !reader_.next(line_); }

 private:
  ResultsReader reader_;
  CaseHead line_;
  bool at_end_ = false;
};

using Sides = std::vector<std::unique_ptr<SideOfRuns>>;

// The sides that have the case, the run now last where it has it.
std::vector<const SideOfRuns*> having(const Sides& sides, const std::string& id) {
  std::vector<const SideOfRuns*> at;
  for (const auto& side : sides) {
    if (side->is_at(id)) at.push_back(side.get());
  }
  return at;
}

// REQUIRES: the last of them is the run now, and there is one before.
std::optional<Change> change_among(const std::vector<const SideOfRuns*>& at) {
  const SideOfRuns& now = *at.back();
  bool was_go = false;
  bool is_other_failure = false;
  bool was_no_go = false;
  bool same_verdict = true;
  bool same_departure = true;
  for (const SideOfRuns* one : at) {
    if (one == &now) continue;
    was_go = was_go || one->decision() == Decision::go;
    is_other_failure =
        is_other_failure || (one->line().verdict == name(VerdictKind::xfail) &&
                             fails_otherwise(one->line().departure, one->part(), now.part()));
    was_no_go = was_no_go || one->decision() == Decision::no_go;
    same_verdict = same_verdict && one->line().verdict == now.line().verdict;
    const bool both = one->decision() == Decision::no_go && now.decision() == Decision::no_go;
    same_departure = same_departure && (!both || one->part() == now.part());
  }
  if (now.decision() != Decision::go && was_go) return Change::regression;
  if (is_other_failure) return Change::regression;
  if (now.decision() == Decision::go && was_no_go) return Change::mended;
  if (now.decision() == Decision::no_go && was_no_go && !same_departure) return Change::departure;
  return same_verdict ? std::nullopt : std::optional(Change::verdict);
}

void add_case(const Sides& sides, const std::string& id, RunsComparison& out) {
  const std::vector<const SideOfRuns*> at = having(sides, id);
  if (!sides.back()->is_at(id)) return add_id(out.gone, out.first_gone, id);
  if (at.size() == 1) return add_id(out.added, out.first_added, id);
  const std::optional<Change> change = change_among(at);
  if (!change) {
    ++out.same;
    return;
  }
  CaseOfRuns changed{*change, id, at.back()->line().dialect, at.back()->line().cycle, {}};
  for (const auto& side : sides) {
    changed.runs.push_back(side->is_at(id) ? side->part() : Json(nullptr));
  }
  out.changed.push_back(std::move(changed));
}

void note_runs(const Sides& sides, RunsComparison& out) {
  for (const auto& side : sides) {
    if (side->reader().footer()) continue;
    out.notes.push_back(fmt::format("{} is incomplete: it has no footer, and cases are missing.",
                                    side->reader().path()));
  }
  for (const HeaderPart& part : kHeaderParts) {
    std::vector<std::string> values;
    for (const Json& header : out.headers) values.push_back(dump(header_part(header, part)));
    if (std::ranges::count(values, values.front()) == std::ssize(values)) continue;
    out.notes.push_back(
        fmt::format("The runs differ in the {}: {}.", part.what, fmt::join(values, ", ")));
  }
}

}  // namespace

std::uint64_t RunsComparison::count(Change change) const {
  return static_cast<std::uint64_t>(std::ranges::count(changed, change, &CaseOfRuns::change));
}

RunsComparison compare_runs(const std::vector<std::string>& paths) {
  RunsComparison out;
  out.paths = paths;
  Sides sides;
  for (const std::string& path : paths) sides.push_back(std::make_unique<SideOfRuns>(path));
  for (const auto& side : sides) out.headers.push_back(side->reader().header());
  while (true) {
    const std::string* first = nullptr;
    for (const auto& side : sides) {
      if (side->at_end()) continue;
      if (first == nullptr || side->line().id < *first) first = &side->line().id;
    }
    if (first == nullptr) break;
    const std::string id = *first;
    add_case(sides, id, out);
    for (const auto& side : sides) {
      if (side->is_at(id)) side->step();
    }
  }
  note_runs(sides, out);
  return out;
}

}  // namespace gonogo::oracle::evidence
