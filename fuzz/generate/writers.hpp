// SPDX-License-Identifier: GPL-3.0-or-later
//
// What writes the programs of the generators. Those of the dialects write every kind but raw, and
// avoid what the manual or the reading leaves undecided.
#pragma once

#include "fuzz/generate/generator.hpp"

namespace gonogo::generate {

GeneratedProgram generate_gsk(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                              Distribution* distribution);
GeneratedProgram generate_hnc(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                              Distribution* distribution);
GeneratedProgram generate_ngc(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                              Distribution* distribution);
// `dialect` is sinumerik840d or sinumerik802s. Avoids what depends on the last bit of an irrational
// number, too.
GeneratedProgram generate_sinumerik(std::string_view dialect, Choices& choices,
                                    const GeneratorSettings& settings, ProgramKind kind,
                                    Distribution* distribution);

// Words of a dialect without regard to their meaning: entries of its dictionary
// (fuzz/program/dictionaries), letters with numbers in any spelling, and seldom a byte that no
// program has. It varies only the readings of the machine.
GeneratedProgram raw_program(std::string_view dialect, Choices& choices,
                             const GeneratorSettings& settings);

}  // namespace gonogo::generate
