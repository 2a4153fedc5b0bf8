// SPDX-License-Identifier: GPL-3.0-or-later
//
// The structured mutator in the fuzz targets whose input is decisions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fuzz/generate/choices.hpp"

namespace gonogo::fuzz {

// Makes the decisions of an input, as the target does. Each target has its own.
void decide(generate::Choices& choices);

// The decisions of the input that is tried now. They are noted, for most often the engine changes
// that input next.
generate::Choices choices_of(const std::uint8_t* data, std::size_t size);

}  // namespace gonogo::fuzz
