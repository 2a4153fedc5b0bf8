// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "expanders/common/word_block.hpp"

namespace gonogo::expanders {

/// One block of letters and numbers. Reading it allocates nothing.
class LetterBlock : public WordBlock {
 public:
  enum class Reading {
    kWords,     // may be without any word
    kSkipped,   // `/` with the block skip on
    kTapeMark,  // `%`, alone
    kMacro,     // a variable, an expression or a statement of the macro language
    kSyntax
  };

  /// How a maker's lines are read.
  struct Manner {
    const CodeTable& codes;
    GroupNumber free_group = kMostGroups;  ///< its codes exclude nothing
    /// Words of the macro language that begin a statement or a function; none: no such language.
    std::span<const std::string_view> macro_words = {};
    bool named_by_tape_mark = false;  ///< `%1` begins a program
    bool block_skip = false;
    bool later_wins = false;  ///< of one address or one group given twice the later holds
  };

  Reading read(std::string_view line, const Manner& manner);

  /// Whether the block has `address` with a number that is not whole.
  bool has_fraction(char address) const {
    return has(address) && (number(address).finer || number(address).value % kOne != 0);
  }
  /// Whether the code of the group is G`number`.
  template <typename Group>
  bool has_code(Group group, unsigned number) const {
    return code(group) != nullptr && code(group)->tenths == number * 10;
  }
  template <typename Group>
  Position code_position(Group group) const {
    return code_positions_[static_cast<std::size_t>(group)];
  }
  bool empty() const { return words().empty() && !any_code_; }
  /// Whether the number of a program stands at its head.
  bool begins_program() const { return begins_program_; }

 private:
  Reading read_words(std::string_view line, const Manner& manner);
  void take(const Word& word, Position position, const Manner& manner);
  void take_code(const Decimal& number, Position position, const Manner& manner);

  std::array<Position, kMostGroups> code_positions_{};
  bool begins_program_ = false;
};

}  // namespace gonogo::expanders
