// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/utf8.hpp"

namespace gonogo::grammar {
namespace {

struct Range {
  char32_t first;
  char32_t last;
};

// Blocks whose characters take two cells: Hangul, CJK with its signs and kana, the fullwidth forms,
// pictographs, and the supplementary ideographs.
constexpr Range kWide[] = {{0x1100, 0x115F},   {0x2E80, 0x303E},  {0x3041, 0xA4CF},
                           {0xAC00, 0xD7A3},   {0xF900, 0xFAFF},  {0xFE30, 0xFE4F},
                           {0xFF00, 0xFF60},   {0xFFE0, 0xFFE6},  {0x1F300, 0x1F64F},
                           {0x1F900, 0x1F9FF}, {0x20000, 0x3FFFD}};

// Controls, and characters that hide, turn round or break the line they stand in.
constexpr Range kUnprintable[] = {{0x00, 0x1F},     {0x7F, 0x9F},     {0xAD, 0xAD},
                                  {0x200B, 0x200F}, {0x2028, 0x202E}, {0x2060, 0x206F},
                                  {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}, {0xE0000, 0xE0FFF}};

template <std::size_t size>
bool within(const Range (&ranges)[size], char32_t code_point) {
  for (const Range& range : ranges) {
    if (code_point >= range.first && code_point <= range.last) return true;
  }
  return false;
}

}  // namespace

Character decode_character(std::string_view text, std::size_t offset) {
  const auto byte = [&](std::size_t index) -> char32_t {
    return static_cast<unsigned char>(text[offset + index]);
  };
  const char32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::uint32_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  const Character damaged{lead, 1, false};
  if (lead < 0xC2 || lead > 0xF4 || text.size() - offset < length) return damaged;

  char32_t code_point = lead & (0x7FU >> length);
  for (std::uint32_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return damaged;
    code_point = (code_point << 6U) | (byte(i) & 0x3FU);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code_point >= 0xD800 && code_point <= 0xDFFF;
  if (code_point < kLeast[length] || code_point > 0x10FFFF || surrogate) return damaged;
  return {code_point, length, true};
}

unsigned cells(char32_t code_point) {
  return within(kWide, code_point) ? 2 : 1;
}

bool is_printable(char32_t code_point) {
  return !within(kUnprintable, code_point);
}

}  // namespace gonogo::grammar
