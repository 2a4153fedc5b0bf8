// SPDX-License-Identifier: GPL-3.0-or-later
//
// A filter before the grammars of grammar/x3/, which are the definition: it reads the blocks that
// nearly all of a long program consists of, and leaves all others alone. Private to grammar/.
#pragma once

#include <string_view>

#include "grammar/ast.hpp"

namespace gonogo::grammar {

// A plain block is [N digits] item* [';' text], with blanks between. An item is a letter and a
// number of at most 18 digits; of letter-address programs also a comment in brackets, of SINUMERIK
// also one of CR, AR, AP and RP, '=' and a number. Fills `block`, which is empty, as the dialect's
// grammar would; false where the line is not plain, and then the block is empty again.
bool read_plain_block(Dialect dialect, std::string_view line, Block& block);

}  // namespace gonogo::grammar
