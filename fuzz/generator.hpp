// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of a dialect, valid and nearly valid, from decisions.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "fuzz/choices.hpp"
#include "reference/profile.hpp"

namespace gonogo::fuzz {

// A program and the machine that it is for.
struct GeneratedProgram {
  reference::Profile profile;
  std::string text;
};

// Counts what the generated programs hold, by name ("g94 entry", "plane G19", "fault: sign", ...).
using Distribution = std::map<std::string, std::size_t>;

// The generator of one dialect, with the built-in expander that its programs try.
struct Generator {
  std::string_view dialect;   // "gsk988ta"
  std::string_view expander;  // "gsk"
  // With the dialect's own default settings. `distribution` may be null.
  GeneratedProgram (*generate)(Choices& choices, Distribution* distribution);
};

std::span<const Generator> generators();
// By the name of a built-in expander, and its dialect; the first one where none is given. Null:
// none.
const Generator* find_generator(std::string_view expander, std::string_view dialect = {});

// Sets one reading of the profile's dialect to an alternative that need not be the default.
// Returns "name=value".
std::string choose_reading(Choices& choices, reference::Profile& profile);

}  // namespace gonogo::fuzz
