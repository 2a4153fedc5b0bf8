// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "campaign/encoding.hpp"
#include "oracle/records/text.hpp"
#include "publish/evidence/compare_parts.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/json_value.hpp"
#include "publish/report/summary.hpp"

namespace gonogo::oracle::evidence {

using report::text_of;

namespace {

constexpr std::size_t kNamedDifferences = 1'000;

// What a verdict rests on; run time, notes and traces may differ.
constexpr std::array<const char*, 12> kDeparture = {"verdict",   "clause",  "b",       "record",
                                                    "word",      "want",    "got",     "reading",
                                                    "deviation", "witness", "feature", "message"};

Decision decision_of_line(const Json& line) {
  return decision(verdict_kind(text_of(line, "verdict")).value_or(VerdictKind::oracle_error));
}

// How a case changed; nothing: it did not. What passed and does so no more is worse, under any new
// verdict (J-RUN-16).
std::optional<Change> change_of(const Json& before, const Json& after) {
  const Decision was = decision_of_line(before);
  const Decision is = decision_of_line(after);
  if (was == Decision::go && is != Decision::go) return Change::regression;
  const bool was_known = text_of(before, "verdict") == name(VerdictKind::xfail);
  if (was_known && fails_otherwise(text_of(before, "departure"), departure_part(before),
                                   departure_part(after))) {
    return Change::regression;
  }
  if (was == Decision::no_go && is == Decision::go) return Change::mended;
  if (was == Decision::no_go && is == Decision::no_go) {
    return departure_part(before) == departure_part(after) ? std::nullopt
                                                           : std::optional(Change::departure);
  }
  if (text_of(before, "verdict") == text_of(after, "verdict")) return std::nullopt;
  return Change::verdict;
}

// A results file with the case that is up.
class Side {
 public:
  explicit Side(const std::string& path) : reader_(path) { step(); }
  const ResultsReader& reader() const { return reader_; }
  const Json* line() const { return at_end_ ? nullptr : &line_; }
  const std::string& id() const { return id_; }
  void step() {
    at_end_ = !reader_.next(line_);
    id_ = at_end_ ? std::string() : text_of(line_, "id");
  }

 private:
  ResultsReader reader_;
  Json line_;
  std::string id_;
  bool at_end_ = false;
};

void add_both(Comparison& comparison, const Json& before, const Json& after) {
  const std::optional<Change> change = change_of(before, after);
  if (!change) {
    ++comparison.same;
    return;
  }
  comparison.changed.push_back({*change, text_of(after, "id"), text_of(after, "dialect"),
                                text_of(after, "cycle"), departure_part(before),
                                departure_part(after)});
}

void note_incomplete(const Side& side, Comparison& comparison) {
  if (side.reader().footer()) return;
  comparison.notes.push_back(fmt::format(
      "{} is incomplete: it has no footer, and cases are missing.", side.reader().path()));
}

std::string followed_by(const Side& side) {
  const auto& footer = side.reader().footer();
  const std::string followed = report::Summary::follows(footer ? &*footer : nullptr);
  return followed.empty() ? "no reading mattered" : followed;
}

// What makes two runs hard to compare, a sentence each.
void note_differences(const Side& before, const Side& after, Comparison& comparison) {
  const Json& was = before.reader().header();
  const Json& is = after.reader().header();
  for (const HeaderPart& part : kHeaderParts) {
    const Json a = header_part(was, part);
    const Json b = header_part(is, part);
    if (a != b) {
      comparison.notes.push_back(fmt::format("The runs differ in the {}: {} before, {} now.",
                                             part.what, visible(dump(a)), visible(dump(b))));
    }
  }
  if (const std::string a = followed_by(before), b = followed_by(after); a != b) {
    comparison.notes.push_back(
        fmt::format("The readings that explain everything that passed differ. Before: {}. Now: {}.",
                    visible(a), visible(b)));
  }
}

}  // namespace

Json departure_part(const Json& line) {
  Json part;
  for (const char* key : kDeparture) {
    if (line.contains(key)) part[key] = line[key];
  }
  return part;
}

bool fails_otherwise(const std::string& departure, Json known, Json now) {
  const std::string verdict = text_of(now, "verdict");
  const auto kind = verdict_kind(verdict);
  if (!kind || decision(*kind) != Decision::no_go || *kind == VerdictKind::xpass) return false;
  if (verdict != departure) return true;
  // The message of an older format has the reason, too.
  for (const char* key : {"verdict", "message"}) {
    known.erase(key);
    now.erase(key);
  }
  return known != now;
}

Json header_part(const Json& header, const HeaderPart& part) {
  const Json::json_pointer at(part.pointer);
  return header.contains(at) ? header.at(at) : Json(nullptr);
}

void add_id(std::uint64_t& count, std::vector<std::string>& first, const std::string& id) {
  ++count;
  if (first.size() < kNamedDifferences) first.push_back(id);
}

std::uint64_t Comparison::count(Change change) const {
  return static_cast<std::uint64_t>(std::ranges::count(changed, change, &ChangedCase::change));
}

Comparison compare_results(const std::string& before, const std::string& after) {
  Comparison comparison;
  Side old_side(before);
  Side new_side(after);
  comparison.old_header = old_side.reader().header();
  comparison.new_header = new_side.reader().header();
  while (old_side.line() != nullptr || new_side.line() != nullptr) {
    const bool only_new =
        old_side.line() == nullptr || (new_side.line() != nullptr && new_side.id() < old_side.id());
    const bool only_old =
        !only_new && (new_side.line() == nullptr || old_side.id() < new_side.id());
    if (only_new) {
      add_id(comparison.added, comparison.first_added, new_side.id());
    } else if (only_old) {
      add_id(comparison.gone, comparison.first_gone, old_side.id());
    } else {
      add_both(comparison, *old_side.line(), *new_side.line());
    }
    if (!only_new) old_side.step();
    if (!only_old) new_side.step();
  }
  note_incomplete(old_side, comparison);
  note_incomplete(new_side, comparison);
  note_differences(old_side, new_side, comparison);
  return comparison;
}

}  // namespace gonogo::oracle::evidence
