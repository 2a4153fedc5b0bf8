// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of SINUMERIK 840D path commands, and of 802S with its frames and cycles; valid and
// nearly valid.
#pragma once

#include "fuzz/generate/generator.hpp"

namespace gonogo::generate {

// `dialect` is sinumerik840d or sinumerik802s. REQUIRES: a kind other than raw.
// Avoids what the reading leaves undecided, and what depends on
// the last bit of an irrational number.
GeneratedProgram generate_sinumerik(std::string_view dialect, Choices& choices,
                                    const GeneratorSettings& settings, ProgramKind kind,
                                    Distribution* distribution);

}  // namespace gonogo::generate
