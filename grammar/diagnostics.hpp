// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the place where a grammar stopped to a located error. Private to grammar/.
#pragma once

#include <cstddef>
#include <string_view>

#include "grammar/ast.hpp"
#include "grammar/byte_set.hpp"

namespace gonogo::grammar {

// `key` is the name of the rule that was expected at `offset` of `line`; one table maps the keys to
// codes and phrases. An unknown key is a fault of the grammar and aborts. `program` are the bytes
// that the dialect has outside comments.
SyntaxError diagnose(std::string_view line, std::string_view key, std::size_t offset,
                     const ByteSet& program);

}  // namespace gonogo::grammar
