// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of SINUMERIK 840D path commands, and of 802S with its frames and cycles; valid and
// nearly valid.
#pragma once

#include "fuzz/generator.hpp"

namespace gonogo::fuzz {

// Documented bounds: a failure is reproduced by the choices and these. With the defaults a program
// has some thirty motions at most.
struct SinumerikSettings {
  std::string_view dialect = "sinumerik840d";  // or "sinumerik802s"
  int blocks = 12;                  // at most, after the head; a chain of arcs counts as one
  int turns = 4;                    // of an arc, at most
  std::uint32_t fault_one_in = 12;  // blocks in which one thing is put wrong; 0: never
};

// Avoids what the reading leaves undecided, and what hangs on
// the last bit of an irrational number.
GeneratedProgram generate_sinumerik(Choices& choices, const SinumerikSettings& settings,
                                    Distribution* distribution = nullptr);

}  // namespace gonogo::fuzz
