// SPDX-License-Identifier: GPL-3.0-or-later
//
// Characters that people, word processors and scanned manuals write in place of ASCII. Private to
// grammar/.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gonogo::grammar {

// What was meant by the character at `offset`, as a noun phrase that names the ASCII character:
// "'-' of ASCII and not U+2212, which looks like it". Empty when nothing is known.
std::string meant_instead(std::string_view line, std::size_t offset);

}  // namespace gonogo::grammar
