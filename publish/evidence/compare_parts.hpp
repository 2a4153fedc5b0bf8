// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the comparisons of two and of many runs have in common.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "publish/evidence/compare.hpp"

namespace gonogo::oracle::evidence {

// What the verdict of a case line rests on; run time, notes and traces may differ.
Json departure_part(const Json& line);
// Whether a case that was known to fail with `departure` is NO-GO now and departs otherwise
// (J-RUN-16); of both the departure_part.
bool fails_otherwise(const std::string& departure, Json known, Json now);

// What besides their cases makes runs hard to compare: its name in a sentence, and its place in the
// header.
struct HeaderPart {
  std::string_view what;
  const char* pointer;
};
inline constexpr std::array<HeaderPart, 21> kHeaderParts = {{
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
Json header_part(const Json& header, const HeaderPart& part);

// The changes in the order in which people need them.
struct ChangeNames {
  Change change;
  const char* key;
  std::string_view title;
};
inline constexpr std::array<ChangeNames, 4> kChanges = {{
    {Change::regression, "regressions",
     "Regressions (GO before and not GO now, or known to fail and otherwise now)"},
    {Change::departure, "departures", "Other departures (NO-GO before and now)"},
    {Change::verdict, "verdicts", "Other changes of the verdict"},
    {Change::mended, "mended", "Mended (NO-GO before, GO now)"},
}};

// "fail.geometry GSK-G94-02 line 5, 0.5 mm"; of null "-".
std::string departure_words(const Json& part);
// A list of ids below its title; nothing where there are none.
std::string text_ids(std::string_view title, std::uint64_t count,
                     const std::vector<std::string>& first);
std::string markdown_ids(std::string_view title, std::uint64_t count,
                         const std::vector<std::string>& first);

// Cases of each change, in the order of kChanges.
using ChangeCounts = std::array<std::uint64_t, kChanges.size()>;
template <typename Compared>
ChangeCounts counts_of(const Compared& comparison) {
  ChangeCounts counts{};
  for (std::size_t i = 0; i < kChanges.size(); ++i) {
    counts[i] = comparison.count(kChanges[i].change);
  }
  return counts;
}

// How many cases changed, came, went and are the same: as lines, as an object, as a table.
std::string text_counts(const ComparedCases& cases, const ChangeCounts& counts);
Json json_counts(const ComparedCases& cases, const ChangeCounts& counts);
std::string markdown_counts(const ComparedCases& cases, const ChangeCounts& counts);
// "No regressions", or how many.
std::string regressions_title(std::uint64_t regressions);
// The document as text, with its last part added.
std::string json_document(Json root, const ComparedCases& cases);

// Counts an id, and keeps it while there is room.
void add_id(std::uint64_t& count, std::vector<std::string>& first, const std::string& id);

}  // namespace gonogo::oracle::evidence
