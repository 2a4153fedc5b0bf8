// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "campaign/encoding.hpp"
#include "oracle/records/text.hpp"
#include "publish/evidence/results_side.hpp"
#include "publish/report/summary.hpp"

namespace gonogo::oracle::evidence {
namespace {

constexpr std::size_t kNamedDifferences = 1'000;

// What a verdict rests on; run time, notes and traces may differ.
constexpr std::array<const char*, 12> kDeparture = {"verdict",   "clause",  "b",       "record",
                                                    "word",      "want",    "got",     "reading",
                                                    "deviation", "witness", "feature", "message"};

// What besides their cases makes runs hard to compare: its name in a sentence, and its place in the
// header.
struct HeaderPart {
  std::string_view what;
  const char* pointer;
};
constexpr std::array<HeaderPart, 21> kHeaderParts = {{
    {"subject", "/subject/name"},
    {"version of the subject", "/subject/version"},
    {"version of gonogo", "/gonogo"},
    {"corpus", "/corpus"},
    {"profile", "/profile"},
    {"readings asked for", "/readings"},
    {"tolerance", "/tolerance"},
    {"chord", "/chord"},
    {"feed resolution", "/feed_resolution"},
    {"blend", "/blend"},
    {"feed tolerance", "/feed_tolerance"},
    {"names of cases shown", "/show_ids"},
    {"strictness", "/strict"},
    {"sandbox", "/sandbox"},
    {"features declared", "/subject/dialects"},
    {"what is reported besides motions", "/subject/features"},
    {"numbers declared", "/subject/numeric"},
    {"cases asked for", "/selection"},
    {"shard", "/shard"},
    {"known failures (SHA-256)", "/known_failures"},
    {"alarm map (SHA-256)", "/alarm_map"},
}};

std::string header_part(const Json& header, const HeaderPart& part) {
  const Json::json_pointer at(part.pointer);
  return dump(header.contains(at) ? header.at(at) : Json(nullptr));
}

Decision decision_of(const ResultsSide& side) {
  return decision(verdict_kind(side.line()->verdict).value_or(VerdictKind::oracle_error));
}

Json departure_part(const ResultsSide& side) {
  const Json line = side.reader().json();
  Json part;
  for (const char* key : kDeparture) {
    if (line.contains(key)) part[key] = line[key];
  }
  return part;
}

// Whether a case that was known to fail is NO-GO now and departs otherwise (J-RUN-16).
bool fails_otherwise(const ResultsSide& before, const ResultsSide& now) {
  const std::string& verdict = now.line()->verdict;
  if (before.line()->verdict != name(VerdictKind::xfail)) return false;
  if (decision_of(now) != Decision::no_go || verdict == name(VerdictKind::xpass)) return false;
  if (verdict != before.line()->departure) return true;
  Json known = departure_part(before);
  Json told = departure_part(now);
  // The message of an older format has the reason, too.
  for (const char* key : {"verdict", "message"}) {
    known.erase(key);
    told.erase(key);
  }
  return known != told;
}

// How a case changed that is up in all of them; nothing: it did not. What passed and does so no
// more is worse, under any new verdict (J-RUN-16). REQUIRES: the last of them is the run now, and
// there is one before.
std::optional<Change> change_among(const std::vector<const ResultsSide*>& at) {
  const ResultsSide& now = *at.back();
  const Decision is = decision_of(now);
  bool was_go = false;
  bool was_no_go = false;
  bool is_other_failure = false;
  bool is_elsewhere = false;
  bool same_verdict = true;
  for (const ResultsSide* one : at) {
    if (one == &now) continue;
    const Decision was = decision_of(*one);
    was_go = was_go || was == Decision::go;
    was_no_go = was_no_go || was == Decision::no_go;
    is_other_failure = is_other_failure || fails_otherwise(*one, now);
    is_elsewhere = is_elsewhere || (was == Decision::no_go && is == Decision::no_go &&
                                    departure_part(*one) != departure_part(now));
    same_verdict = same_verdict && one->line()->verdict == now.line()->verdict;
  }
  if ((was_go && is != Decision::go) || is_other_failure) return Change::regression;
  if (was_no_go && is == Decision::go) return Change::mended;
  if (is_elsewhere) return Change::departure;
  return same_verdict ? std::nullopt : std::optional(Change::verdict);
}

void add_case(const ResultsSides& sides, const std::string& id, Comparison& out) {
  std::vector<const ResultsSide*> at;
  for (const auto& side : sides) {
    if (side->is_at(id)) at.push_back(side.get());
  }
  if (!sides.back()->is_at(id)) return out.gone.add(id, kNamedDifferences);
  if (at.size() == 1) return out.added.add(id, kNamedDifferences);
  const std::optional<Change> change = change_among(at);
  if (!change) {
    ++out.same;
    return;
  }
  const CaseHead& now = *at.back()->line();
  ChangedCase changed{*change, id, now.dialect, now.cycle, {}};
  for (const auto& side : sides) {
    changed.runs.push_back(side->is_at(id) ? departure_part(*side) : Json(nullptr));
  }
  out.changed.push_back(std::move(changed));
}

std::string followed_by(const ResultsSide& side) {
  const auto& footer = side.reader().footer();
  const std::string followed = report::Summary::follows(footer ? &*footer : nullptr);
  return followed.empty() ? "no reading mattered" : followed;
}

// What makes the runs hard to compare, a sentence each.
void note_differences(const ResultsSides& sides, Comparison& out) {
  for (const auto& side : sides) {
    if (side->reader().footer()) continue;
    out.notes.push_back(fmt::format("{} is incomplete: it has no footer, and cases are missing.",
                                    side->reader().path()));
  }
  const bool are_two = sides.size() == 2;
  for (const HeaderPart& part : kHeaderParts) {
    std::vector<std::string> values;
    for (const Json& header : out.headers) values.push_back(header_part(header, part));
    if (std::ranges::count(values, values.front()) == std::ssize(values)) continue;
    const std::string told =
        are_two ? fmt::format("{} before, {} now", visible(values.front()), visible(values.back()))
                : fmt::format("{}", fmt::join(values, ", "));
    out.notes.push_back(fmt::format("The runs differ in the {}: {}.", part.what, told));
  }
  if (!are_two) return;
  if (const std::string a = followed_by(*sides.front()), b = followed_by(*sides.back()); a != b) {
    out.notes.push_back(
        fmt::format("The readings that explain everything that passed differ. Before: {}. Now: {}.",
                    visible(a), visible(b)));
  }
}

}  // namespace

std::uint64_t Comparison::count(Change change) const {
  return static_cast<std::uint64_t>(std::ranges::count(changed, change, &ChangedCase::change));
}

Comparison compare_runs(const std::vector<std::string>& paths) {
  Comparison out;
  out.paths = paths;
  ResultsSides sides;
  for (const std::string& path : paths) {
    sides.push_back(std::make_unique<ResultsSide>(path));
    out.headers.push_back(sides.back()->reader().header());
  }
  while (const CaseHead* first = first_line(sides)) {
    const std::string id = first->id;
    add_case(sides, id, out);
    step_past(sides, id);
  }
  note_differences(sides, out);
  return out;
}

}  // namespace gonogo::oracle::evidence
