// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dialects of SINUMERIK: one line of text into one block. No Spirit here.
#pragma once

#include <optional>
#include <string_view>

#include "grammar/ast.hpp"

namespace gonogo::grammar::sinumerik {

// Fills `block`, which is empty. On an error the block is unspecified.
std::optional<SyntaxError> parse_line(std::string_view line, Block& block);

}  // namespace gonogo::grammar::sinumerik
