// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of the words of SINUMERIK. Private to grammar/.
#pragma once

#include <string>

#include "grammar/ast.hpp"

namespace gonogo::grammar {

// Appends CR=2*(R1+3), I1=AC(5), G2, MSG(). The terms of the word are those of `block`.
void print(const NamedWord& word, const Block& block, std::string& out);

}  // namespace gonogo::grammar
