// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-EXP-09: a second order of operators.
#pragma once

#include <cstdint>
#include <vector>

#include "grammar/ast.hpp"

namespace gonogo::reference::rs274 {

// Whether an operator or a function takes two values.
bool takes_two(grammar::TermKind kind);
// Whether it is another value when AND, OR and XOR are of the group of + and -.
bool has_logic_before_sum(const grammar::Block& block, const grammar::TermRange& range);
// The terms of that value in the order in which they are done; places in Block::terms.
std::vector<std::uint32_t> logic_among_sums(const grammar::Block& block,
                                            const grammar::TermRange& range);

}  // namespace gonogo::reference::rs274
