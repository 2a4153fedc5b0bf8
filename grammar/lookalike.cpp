// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/lookalike.hpp"

#include <array>
#include <cstdio>

#include "grammar/byte_set.hpp"
#include "grammar/utf8.hpp"

namespace gonogo::grammar {
namespace {

struct Lookalike {
  char32_t code_point;
  char ascii;
};

// Signs, and the Greek and Cyrillic capitals that text recognition puts into programs.
constexpr Lookalike kLookalikes[] = {
    {0x2010, '-'},  {0x2011, '-'}, {0x2012, '-'},  {0x2013, '-'},  {0x2014, '-'}, {0x2015, '-'},
    {0x2212, '-'},  {0xFE63, '-'}, {0xFE62, '+'},  {0x3002, '.'},  {0xFF61, '.'}, {0x2024, '.'},
    {0x3001, ','},  {0x037E, ';'}, {0x2018, '\''}, {0x2019, '\''}, {0x201C, '"'}, {0x201D, '"'},
    {0x2032, '\''}, {0x2033, '"'}, {0x2044, '/'},  {0x2215, '/'},  {0x00A0, ' '}, {0x202F, ' '},
    {0x3000, ' '},  {0x0391, 'A'}, {0x0392, 'B'},  {0x0395, 'E'},  {0x0396, 'Z'}, {0x0397, 'H'},
    {0x0399, 'I'},  {0x039A, 'K'}, {0x039C, 'M'},  {0x039D, 'N'},  {0x039F, 'O'}, {0x03A1, 'P'},
    {0x03A4, 'T'},  {0x03A5, 'Y'}, {0x03A7, 'X'},  {0x0405, 'S'},  {0x0406, 'I'}, {0x0408, 'J'},
    {0x0410, 'A'},  {0x0412, 'B'}, {0x0415, 'E'},  {0x041A, 'K'},  {0x041C, 'M'}, {0x041D, 'H'},
    {0x041E, 'O'},  {0x0420, 'P'}, {0x0421, 'C'},  {0x0422, 'T'},  {0x0423, 'Y'}, {0x0425, 'X'},
};

// The fullwidth forms stand in the order of ASCII.
char fullwidth(char32_t offset_from_exclamation_mark) {
  const char ascii = static_cast<char>('!' + static_cast<char>(offset_from_exclamation_mark));
  return capital_of(ascii);
}

char ascii_for(char32_t code_point) {
  if (code_point >= 0xFF01 && code_point <= 0xFF5E) return fullwidth(code_point - 0xFF01);
  if (code_point >= 0x2000 && code_point <= 0x200A) return ' ';
  for (const Lookalike& entry : kLookalikes) {
    if (entry.code_point == code_point) return entry.ascii;
  }
  return 0;
}

std::string quoted(char ascii) {
  return ascii == ' ' ? std::string("a blank") : std::string{'\'', ascii, '\''};
}

std::string hexadecimal(char32_t code_point) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "U+%04X", static_cast<unsigned>(code_point));
  return text.data();
}

}  // namespace

std::string meant_instead(std::string_view line, std::size_t offset) {
  const Character character = decode_character(line, offset);
  if (!character.valid) {
    // The fullwidth forms of GBK are 0xA3 and the ASCII code + 0x80.
    const auto next = offset + 1 < line.size() ? static_cast<unsigned char>(line[offset + 1]) : 0U;
    if (character.code_point != 0xA3 || next < 0xA1 || next > 0xFE) return {};
    return quoted(fullwidth(next - 0xA1U)) + " of ASCII and not its fullwidth form in GBK";
  }
  if (character.code_point < 0x80 && kLowerCase.contains(line[offset])) {
    return "the capital letter " + quoted(capital_of(line[offset])) +
           ", for lower case is not read";
  }
  if (character.code_point == 0xFEFF) return "a program without a byte order mark";
  const char ascii = ascii_for(character.code_point);
  if (ascii == 0) return {};
  return quoted(ascii) + " of ASCII and not " + hexadecimal(character.code_point) +
         ", which looks like it";
}

}  // namespace gonogo::grammar
