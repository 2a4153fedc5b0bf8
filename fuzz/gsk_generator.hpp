// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of the GSK 988TA, valid and nearly valid.
#pragma once

#include <map>
#include <string>

#include "fuzz/choices.hpp"
#include "reference/profile.hpp"

namespace gonogo::fuzz {

// Documented bounds: a failure is reproduced by the choices and these.
struct GskSettings {
  int blocks = 8;                   // at most, after the head
  int rings = 8;                    // (I - D) / L of a pocket, at most
  int layers = 4;                   // of a pocket, at most
  std::uint32_t fault_one_in = 12;  // blocks in which one thing is put wrong; 0: never
  bool arcs = true;
  bool pockets = true;
};

// A program and the machine that it is for.
struct GeneratedProgram {
  reference::Profile profile;
  std::string text;
};

// Counts what the generated programs hold, by name ("g94 entry", "plane G19", "fault: sign", ...).
using Distribution = std::map<std::string, std::size_t>;

// REQUIRES: the dialect gsk988ta. Avoids what the manual and the reading leave undecided.
GeneratedProgram generate_gsk(Choices& choices, const GskSettings& settings,
                              Distribution* distribution = nullptr);

}  // namespace gonogo::fuzz
