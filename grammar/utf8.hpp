// SPDX-License-Identifier: GPL-3.0-or-later
//
// Single characters of UTF-8 text that may be damaged or in another encoding. Private to grammar/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gonogo::grammar {

struct Character {
  char32_t code_point = 0;
  std::uint32_t length = 0;  // bytes; 1 where the text is not UTF-8
  bool valid = false;        // false: one byte that is not part of a UTF-8 sequence
};

// The character that begins at `offset`, which lies within the text. Overlong forms, surrogates and
// values above U+10FFFF are not valid.
Character decode_character(std::string_view text, std::size_t offset);

// Cells on a terminal: 2 for the wide characters of East Asia, else 1.
unsigned cells(char32_t code_point);

// False for control characters and for those that hide, reorder or break a line.
bool is_printable(char32_t code_point);

}  // namespace gonogo::grammar
