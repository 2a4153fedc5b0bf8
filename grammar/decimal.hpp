// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact decimals from digits. Private to grammar/.
#pragma once

#include "grammar/ast.hpp"

namespace gonogo::grammar {

// Reads [+-] digits [. digits], [+-] . digits or [+-] digits . from the beginning of [first, last)
// into `value`, which is empty. Returns the end of the number, or null when there is none.
const char* read_decimal(const char* first, const char* last, Decimal& value);

// Reads digits alone.
const char* read_whole(const char* first, const char* last, Decimal& value);

}  // namespace gonogo::grammar
