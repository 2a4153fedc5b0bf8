// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of RS274/NGC path commands and cycles, valid and nearly valid.
#pragma once

#include "fuzz/generate/generator.hpp"

namespace gonogo::generate {

// REQUIRES: a kind other than raw. The dialect rs274. Avoids what the reading leaves undecided.
GeneratedProgram generate_ngc(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                              Distribution* distribution);

}  // namespace gonogo::generate
