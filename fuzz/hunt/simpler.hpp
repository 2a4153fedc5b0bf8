// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simpler numbers and words to try in the place of those of a program.
#pragma once

#include <string>
#include <vector>

#include "fuzz/program/text.hpp"

namespace gonogo::hunt {

// The simplest first: shorter texts; of equal ones, that with the smaller value.
std::vector<program::SmallDecimal> simpler_values(const program::SmallDecimal& number);
// Writes `value` wherever the line has `number`, but in codes.
void replace_number(program::TextLine& line, const program::SmallDecimal& number,
                    const program::SmallDecimal& value);
// The word in capitals, without blanks; a code by its name. What is no word stays.
std::string plain_text(const program::TextWord& word);

}  // namespace gonogo::hunt
