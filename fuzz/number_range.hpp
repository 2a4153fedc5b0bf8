// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace gonogo::fuzz {

// Whether every number of the text, wherever it stands, has at most nine digits before the point and
// seven behind it, zeros at its ends not counted. The built-in expanders count in 1e-9 mm and are
// exact for these, inches too; of others they keep the nearest, and whatever turns over between the
// two (a further peck of 1e-20 mm, a chord above twice the radius) they decide for another program.
bool has_short_numbers(std::string_view text);

}  // namespace gonogo::fuzz
