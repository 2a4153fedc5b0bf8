// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/scan.hpp"

#include <algorithm>

namespace gonogo::expanders::sinumerik {

namespace {

bool is_unprinted(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < ' ' || byte == 127;
}

}  // namespace

// SIE-LEX-01
void skip_blanks(const char*& cursor, const char* end) {
  while (cursor != end && (*cursor == ' ' || *cursor == '&' || is_unprinted(*cursor))) ++cursor;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool is_name_part(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}

char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool is_name_start(char c) {
  return is_letter(c) || c == '_';
}

bool are_digits(const char* from, const char* to) {
  return std::all_of(from, to, &is_digit);
}

bool read_index(const char*& cursor, const char* end, std::size_t most, std::size_t& index) {
  if (cursor == end || !is_digit(*cursor)) return false;
  index = 0;
  for (; cursor != end && is_digit(*cursor); ++cursor) {
    if (index < most) index = index * 10 + static_cast<std::size_t>(*cursor - '0');
  }
  index = std::min(index, most);
  return true;
}

bool at_exponent(const char* cursor, const char* end) {
  if (end - cursor < 3 || capital(cursor[0]) != 'E' || capital(cursor[1]) != 'X') return false;
  const char c = cursor[2];
  return is_digit(c) || c == '-' || c == '+';
}

bool is_program_name(const char* cursor, const char* end) {
  const char* const stop = std::find(cursor, end, ';');
  return std::all_of(cursor, stop, [](char c) { return static_cast<unsigned char>(c) < 128; });
}

void skip_label(const char*& cursor, const char* end) {
  const char* stop = cursor;
  if (end - stop < 2 || !is_name_start(stop[0]) || !is_name_start(stop[1])) return;
  while (stop != end && is_name_part(*stop)) ++stop;
  if (stop != end && *stop == ':') cursor = stop + 1;
}

bool skip_call(const char*& cursor, const char* end) {
  std::size_t depth = 0;
  bool in_string = false;
  for (; cursor != end; ++cursor) {
    const char c = *cursor;
    if (c == '"') in_string = !in_string;
    if (in_string) continue;
    if (static_cast<unsigned char>(c) > 127 || c == ';') return false;
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) {
      ++cursor;
      return true;
    }
  }
  return false;
}

}  // namespace gonogo::expanders::sinumerik
