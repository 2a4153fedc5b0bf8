// SPDX-License-Identifier: GPL-3.0-or-later
//
// The width of a terminal, and texts for people that fit it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gonogo::cli {

// How many characters a line of the terminal has; 80 where it does not say.
std::size_t columns_of_terminal(int descriptor);

// The text with lines that are too long broken between words; what follows stands under the
// first word behind the line's key. Blocks of programs ("12 | G00 X1", or indented by four), rows
// of tables and commands, which are copied, stay as they are.
std::string wrapped(std::string_view text, std::size_t columns);

}  // namespace gonogo::cli
