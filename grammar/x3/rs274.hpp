// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dialect of RS274/NGC: one line of text into one block. No Spirit here.
#pragma once

#include <optional>
#include <string_view>

#include "grammar/ast.hpp"

namespace gonogo::grammar::rs274 {

// Fills `block`, which is empty. On an error the block is unspecified.
std::optional<SyntaxError> parse_line(std::string_view line, Block& block);

}  // namespace gonogo::grammar::rs274
