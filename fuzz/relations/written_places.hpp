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
  WrittenPlaces(const program::ProgramText& text, const reference::Profile& profile);

  // Blocks in their order.
  void take(const program::TextBlock& block);

  // The coordinate along the axis (0: X), as a word would say it. Nothing: it is not known.
  const std::optional<Number>& at(std::size_t axis) const { return at_[axis]; }
  // Whether the block is a traverse, a line or an arc whose words are numbers beside no more than
  // modes that leave coordinates what they are.
  bool is_plain_motion(const program::TextBlock& block) const;
  // A word of an end point: along which axis, and whether its number is a coordinate.
  struct EndWord {
    std::size_t axis = 0;
    bool is_absolute = false;
  };
  // Nothing: it is no such word.
  std::optional<EndWord> end_word(const program::TextBlock& block,
                                  const program::TextWord& word) const;

 private:
  bool is_still(const program::TextBlock& block) const;

  const program::ProgramText& text_;
  const reference::Profile& profile_;
  std::array<std::optional<Number>, 3> at_;
};

}  // namespace gonogo::relations
