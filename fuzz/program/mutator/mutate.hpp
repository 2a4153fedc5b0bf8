// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program made out of others: by changing the generator's decisions, or the text itself.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/program/mutator/dice.hpp"
#include "fuzz/program/text.hpp"

namespace gonogo::program {

// Other decisions: bits flipped, bytes changed a little, inserted, cut out, copied from `other`.
std::vector<std::uint8_t> mutate_bytes(Dice& dice, std::vector<std::uint8_t> bytes,
                                       const std::vector<std::uint8_t>& other);

// Another text for the same machine: blocks and words cut out, doubled, moved, taken from `other`;
// values set to those of other words or next to them, negated, to limits; codes and addresses
// exchanged; seldom single characters, so that it need not even be a program.
std::string mutate_text(Dice& dice, const std::string& text, const std::string& other);

}  // namespace gonogo::program
