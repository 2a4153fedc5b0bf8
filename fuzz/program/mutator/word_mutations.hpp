// SPDX-License-Identifier: GPL-3.0-or-later
//
// Single changes of a program in words, each seen from its result alone: what a number looks like,
// and words and blocks of a dictionary put in. What they cannot do they leave undone.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fuzz/program/mutator/dice.hpp"
#include "fuzz/program/text.hpp"

namespace gonogo::program {

// The value may stay or change: a digit, the sign, the decimal point, zeros before or behind,
// digits beyond the resolution.
void change_spelling(Dice& dice, std::vector<TextLine>& lines);
// An entry as one more word of a block, in the place of a word (rather of the same address), or as
// a block of its own.
void insert_entry(Dice& dice, std::vector<TextLine>& lines, std::span<const std::string> entries);
void replace_by_entry(Dice& dice, std::vector<TextLine>& lines,
                      std::span<const std::string> entries);
void insert_block(Dice& dice, std::vector<TextLine>& lines, std::span<const std::string> entries);
// What a grammar reads over: blanks between words, the case of letters, what ends a line.
void change_looks(Dice& dice, std::vector<TextLine>& lines);

}  // namespace gonogo::program
