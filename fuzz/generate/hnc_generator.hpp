// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of the HNC-21T, valid and nearly valid.
#pragma once

#include "fuzz/generate/generator.hpp"

namespace gonogo::generate {

// REQUIRES: a kind other than raw. The dialect hnc21t. Avoids what the manual and the reading leave
// undecided.
GeneratedProgram generate_hnc(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                              Distribution* distribution);

}  // namespace gonogo::generate
