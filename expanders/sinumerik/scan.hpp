// SPDX-License-Identifier: GPL-3.0-or-later
// What a line is cut by. Each reader moves `cursor` on, up to `end`.
#pragma once

#include <cstddef>

namespace gonogo::expanders::sinumerik {

/// Blanks and tabs.
void skip_blanks(const char*& cursor, const char* end);
bool is_digit(char c);
bool is_letter(char c);
/// Letters, digits and the underscore.
bool is_name_part(char c);
char capital(char c);

enum class Scan {
  kRead,
  kSyntax,
  kOutside  ///< something that the control has and this expander does not
};

/// Names begin with two of these: a letter or the underscore.
bool is_name_start(char c);
bool are_digits(const char* from, const char* to);

/// Reads a whole number without sign at `cursor`; too large ones become `most`.
bool read_index(const char*& cursor, const char* end, std::size_t most, std::size_t& index);

/// Whether an exponent (`EX3`, `EX-3`) follows.
bool at_exponent(const char* cursor, const char* end);

/// Whether what follows, up to a comment, is written in what the name of a program is.
bool is_program_name(const char* cursor, const char* end);

/// Skips `LABEL:`, where one follows.
void skip_label(const char*& cursor, const char* end);

/// Skips the arguments of a call; false when the brackets do not close.
bool skip_call(const char*& cursor, const char* end);

}  // namespace gonogo::expanders::sinumerik
