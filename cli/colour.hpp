// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colour for a terminal that shows it: not in a pipe, not with NO_COLOR set, not on TERM=dumb.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gonogo::cli {

enum class Tone : std::uint8_t { good, bad, unsure, strong };

bool wants_colour(int descriptor);
// The text as it is, or between the codes that colour it.
std::string in_tone(std::string_view text, Tone tone, bool colour);
// How long the code of a colour is that the text begins with; 0: it begins with none of in_tone().
std::size_t length_of_tone(std::string_view text);
// The tone of a line that begins with the decision of a run: GO, NO-GO, UNDECIDED.
Tone tone_of(std::string_view decision);

}  // namespace gonogo::cli
