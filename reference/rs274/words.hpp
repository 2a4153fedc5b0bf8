// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of one block: exact, in mm and degrees.
#pragma once

#include <array>
#include <optional>

#include "reference/words.hpp"

namespace gonogo::reference::rs274 {

struct AxisLetter {
  Axis axis;
  char address;
};
inline constexpr std::array<AxisLetter, kAxes> kAxisLetters = {
    {{Axis::x, 'X'}, {Axis::y, 'Y'}, {Axis::z, 'Z'}, {Axis::a, 'A'}, {Axis::c, 'C'}}};
constexpr char address_of(Axis axis) {
  return kAxisLetters[index(axis)].address;
}

// How words are meant: G20, G91, G90.1, G7.
struct WordModes {
  bool inch = false;
  bool incremental = false;
  bool absolute_centre = false;
  bool diameter = false;  // NGC-DIA-01

  // NGC-UNI-01: mm of a number of the program, and the number of so many mm.
  Number length_of(const Number& number) const { return inch ? inches(number) : number; }
  Number number_of(const Number& length) const { return inch ? length / inches(1) : length; }
};

class BlockWords : public WordTable {
 public:
  // `modes` may change while the block is read.
  BlockWords(const grammar::Block& block, const WordModes& modes, const WordValues* values)
      : WordTable(block, values), modes_(modes) {}

  // As a length in mm.
  std::optional<Number> length(char address) const;
  // As an axis word: mm, or degrees as written.
  std::optional<Number> along(const AxisLetter& axis) const;
  bool has_axis_word() const;
  bool has_linear_axis_word() const { return has('X') || has('Y') || has('Z') || is_polar(); }
  // NGC-POL-01
  bool is_polar() const { return has('@') || has('^'); }
  bool has_rotary_axis_word() const { return has('A') || has('C'); }
  bool has_offset() const { return has('I') || has('J') || has('K'); }
  const WordModes& modes() const { return modes_; }

 private:
  const WordModes& modes_;
};

}  // namespace gonogo::reference::rs274
