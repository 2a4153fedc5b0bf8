// SPDX-License-Identifier: GPL-3.0-or-later
//
// What RS274/NGC has beside words and numbers, as text. Private to grammar/.
#pragma once

#include <string>

#include "grammar/ast.hpp"

namespace gonogo::grammar {

// The value, with the fewest brackets that its terms need; one that is a number alone in brackets.
std::string text_of_terms(const Block& block, const TermRange& range);
void print(const Assignment& assignment, const Block& block, std::string& out);
void print(const Control& control, const Block& block, std::string& out);

}  // namespace gonogo::grammar
