// SPDX-License-Identifier: GPL-3.0-or-later
//
// An example program under a profile: what the reference makes of it, to be drawn and described.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "publish/report/figure.hpp"
#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle::manual {

// A record of the trial in words.
struct ExampleStep {
  std::uint64_t block = 0;
  std::string text;
  reference::ClauseId clause = reference::kNoClause;
  bool moves = false;
  friend bool operator==(const ExampleStep&, const ExampleStep&) = default;
};

struct ExampleRun {
  std::vector<ExampleStep> steps;  // one a record, then the alarm if there is one
  report::Path path;               // one motion a step; the first positioning moves nothing
  std::optional<reference::AlarmReport> alarm;
  std::string not_covered;            // why the reference ends there; empty: it does not
  std::vector<report::Limit> limits;  // what is fixed where the path is open
};

// The profile of an example: TOML lines without the dialect. Throws std::runtime_error where they
// are wrong: examples are part of the program.
reference::Profile example_profile(std::string_view dialect, std::string_view lines);
void choose(reference::Profile& profile, std::string_view reading, std::string_view value);

ExampleRun try_program(const reference::Profile& profile, std::string_view program);

// Whether two paths look the same in a drawing: curves and rapids, within what can be seen.
bool draw_the_same(const report::Path& a, const report::Path& b);

}  // namespace gonogo::oracle::manual
