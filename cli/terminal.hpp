// SPDX-License-Identifier: GPL-3.0-or-later
//
// The width of a terminal, texts for people that fit it, and colour for one that shows it: not in a
// pipe, not with NO_COLOR set, not on TERM=dumb.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gonogo::cli {

// How many characters a line of the terminal has; 80 where it does not say.
std::size_t columns_of_terminal(int descriptor);

// The text with lines that are too long broken between words; what follows stands under the
// first word behind the line's key. Blocks of programs ("12 | G00 X1", or indented by four), rows
// of tables and commands, which are copied, stay as they are.
std::string wrapped(std::string_view text, std::size_t columns);

enum class Tone : std::uint8_t { good, bad, unsure, strong };

bool wants_colour(int descriptor);
// The text as it is, or between the codes that colour it.
std::string in_tone(std::string_view text, Tone tone, bool colour);
// How long the code of a colour is that the text begins with; 0: it begins with none of in_tone().
std::size_t length_of_tone(std::string_view text);
// The tone of a line that begins with the decision of a run: GO, NO-GO, UNDECIDED.
Tone tone_of(std::string_view decision);

}  // namespace gonogo::cli
