// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same blocks laid out in other ways.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string>

#include "metamorphic_program.hpp"

namespace gonogo::reference::testing {

// Draws layouts from a seed that RapidCheck chooses.
class Layout {
 public:
  explicit Layout(std::uint32_t seed) : random_(seed) {}

  std::size_t below(std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_);
  }
  std::string blanks(std::size_t most) {
    std::string blank;
    for (std::size_t count = below(most + 1); count > 0; --count) blank += " \t"[below(2)];
    return blank;
  }
  void shuffle(Words& words) { std::shuffle(words.begin(), words.end(), random_); }

  // Any number of blanks, none too, before and after a word and within it.
  std::string spaced(const Words& words) {
    std::string line = blanks(2);
    for (const Word& word : words) line += word.address + blanks(2) + word.number + blanks(2);
    return line;
  }

  // A block number, comments between the words and after them, a slash that is not obeyed.
  std::string commented(const Words& words) {
    std::string line = below(3) == 0 ? "/" : "";
    if (below(2) == 0) line += "N" + std::to_string(below(100'000)) + " ";
    for (const Word& word : words) {
      if (below(4) == 0) line += kComments[below(kComments.size())];
      line += word.address + word.number + " ";
    }
    if (below(3) == 0) line += "; X99 (\xB0\xA1";
    return line;
  }

  // A line that moves nothing.
  std::string idle() {
    static const std::array<std::string, 5> kIdle = {"", " \t", "N77", "(X5 Z5 F-1)", "; G999"};
    return kIdle[below(kIdle.size())];
  }
  std::string line_end() {
    static const std::array<std::string, 2> kEnds = {"\n", "\r\n"};
    return kEnds[below(kEnds.size())];
  }

 private:
  inline static const std::array<std::string, 4> kComments = {"()", "(G0 X5)", "(\xB0\xA1; F0)",
                                                              "(N1)(M30)"};
  std::mt19937 random_;
};

}  // namespace gonogo::reference::testing
