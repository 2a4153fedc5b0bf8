// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many programs a subject was asked that are in no corpus, since they were drawn in the run.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace gonogo::oracle {

struct FreshCount {
  std::size_t wanted = 0;    // as many as cases of the dialect were judged, or as was asked for
  std::size_t programs = 0;  // that there was time for
  std::size_t judged = 0;    // of them; the others were skipped, undecided or too long

  friend bool operator==(const FreshCount&, const FreshCount&) = default;
};
// By dialect. Empty: none was asked.
using FreshCounts = std::map<std::string, FreshCount>;

void add_fresh(FreshCounts& sum, const FreshCounts& more);
std::size_t fresh_judged(const FreshCounts& counts);
// A dialect of which many programs were asked and hardly any was judged; empty: there is none. Who
// answers the cases of a corpus, and skips what is in none, may know them by heart (J-RUN-14).
std::string hardly_answered(const FreshCounts& counts);

// The key `fresh` of the footer. What is no count is left out.
nlohmann::ordered_json fresh_json(const FreshCounts& counts);
FreshCounts fresh_from_json(const nlohmann::ordered_json& object);

// Whether the case of a line is a fresh program: its id begins as those of no corpus do.
inline constexpr std::string_view kFreshRoom = "fresh";
bool is_fresh(std::string_view id);

}  // namespace gonogo::oracle
