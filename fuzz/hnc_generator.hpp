// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of the HNC-21T, valid and nearly valid.
#pragma once

#include "fuzz/generator.hpp"

namespace gonogo::fuzz {

// Documented bounds: a failure is reproduced by the choices and these. With the defaults a program
// has some hundred motions at most.
struct HncSettings {
  int blocks = 8;                   // at most, after the head
  int pecks = 8;                    // of a hole or plunge whose depth is an increment, at most
  int steps = 6;                    // axial steps of a groove, at most
  int starts = 4;                   // of a thread, at most
  std::uint32_t fault_one_in = 12;  // blocks in which one thing is put wrong; 0: never
  bool arcs = true;
};

// REQUIRES: the dialect hnc21t. Avoids what the manual and the reading leave undecided.
GeneratedProgram generate_hnc(Choices& choices, const HncSettings& settings,
                              Distribution* distribution = nullptr);

}  // namespace gonogo::fuzz
