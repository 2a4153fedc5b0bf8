// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers beyond the range of any machine. Each control refuses them from a bound of its own, and
// no manual states it, except GSK's table for the milling cycles: the gauge cannot say what is
// right there.
#pragma once

#include "grammar/ast.hpp"
#include "reference/axis.hpp"

namespace gonogo::reference {

// A written number of ten million or more, in any unit: more digits than a word of any of the
// manuals has.
bool is_beyond_range(const grammar::Decimal& value);
bool is_beyond_range(const Number& value);

// The first word with such a number; codes, functions, tools and the like have no length. Null:
// none.
const grammar::Word* word_beyond_range(const grammar::Block& block);

// Whether an axis stands 100 km or more away. What is only enclosed counts as near.
bool is_beyond_range(const Position& position);

}  // namespace gonogo::reference
