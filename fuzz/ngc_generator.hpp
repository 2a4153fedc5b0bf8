// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of RS274/NGC path commands, valid and nearly valid.
#pragma once

#include "fuzz/generator.hpp"

namespace gonogo::fuzz {

// Documented bounds: a failure is reproduced by the choices and these. With the defaults a program
// has some ten motions at most.
struct NgcSettings {
  int blocks = 10;                  // at most, after the head
  int turns = 4;                    // of an arc, at most
  std::uint32_t fault_one_in = 12;  // blocks in which one thing is put wrong; 0: never
};

// REQUIRES: the dialect rs274. Avoids what the reading leaves undecided.
GeneratedProgram generate_ngc(Choices& choices, const NgcSettings& settings,
                              Distribution* distribution = nullptr);

}  // namespace gonogo::fuzz
