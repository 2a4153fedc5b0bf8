// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the tool stands by the words of a program alone, as far as traverses, lines and arcs with
// plain words say.
#pragma once

#include <array>
#include <optional>

#include "fuzz/relations/related_lines.hpp"

namespace gonogo::relations {

class WrittenPlaces {
 public:
  WrittenPlaces(const ProgramText& text, const Profile& profile);

  // Blocks in their order.
  void take(const TextBlock& block);

  // The coordinate along the axis (0: X), as a word would say it. Nothing: it is not known.
  const std::optional<Number>& at(std::size_t axis) const { return at_[axis]; }
  // Whether the block is a traverse, a line or an arc whose words are numbers beside no more than
  // modes that leave coordinates what they are.
  bool is_plain_motion(const TextBlock& block) const;
  // A word of an end point: along which axis, and whether its number is a coordinate.
  struct EndWord {
    std::size_t axis = 0;
    bool is_absolute = false;
  };
  // Nothing: it is no such word.
  std::optional<EndWord> end_word(const TextBlock& block, const TextWord& word) const;

 private:
  bool is_still(const TextBlock& block) const;

  const ProgramText& text_;
  const Profile& profile_;
  std::array<std::optional<Number>, 3> at_;
};

}  // namespace gonogo::relations
