// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of one block of a lathe program: exact, in true lengths.
#pragma once

#include <array>
#include <optional>

#include "reference/words.hpp"

namespace gonogo::reference::hnc21t {

inline constexpr AxisAddresses kX = {Axis::x, 'X', 'U'};
inline constexpr AxisAddresses kZ = {Axis::z, 'Z', 'W'};
inline constexpr std::array<AxisAddresses, 2> kAxisAddresses = {kX, kZ};
constexpr const AxisAddresses& addresses_of(Axis axis) {
  return axis == Axis::x ? kX : kZ;
}

// How words are meant: G20, G36, G91.
struct WordModes {
  bool inch = false;
  bool diameter = true;
  bool incremental = false;
};

class BlockWords : public WordTable {
 public:
  BlockWords(const grammar::Block& block, const WordModes& modes)
      : WordTable(block), modes_(modes) {}

  // As a length in mm. X and U are diameters only through axis_word().
  std::optional<Number> length(char address) const;
  // The axis word, absolute or incremental (U and W always); X and U halved when they are
  // diameters.
  std::optional<AxisWord> axis_word(const AxisAddresses& addresses) const;
  bool has_axis_word() const { return has(kX) || has(kZ); }
  const WordModes& modes() const { return modes_; }

 private:
  WordModes modes_;
};

}  // namespace gonogo::reference::hnc21t
