// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of the GSK 988TA, valid and nearly valid.
#pragma once

#include "fuzz/generator.hpp"

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

// REQUIRES: the dialect gsk988ta. Avoids what the manual and the reading leave undecided.
GeneratedProgram generate_gsk(Choices& choices, const GskSettings& settings,
                              Distribution* distribution = nullptr);

}  // namespace gonogo::fuzz
