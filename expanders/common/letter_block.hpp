// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "expanders/common/address_set.hpp"
#include "expanders/common/codes.hpp"
#include "expanders/common/complaints.hpp"
#include "expanders/common/tokenizer.hpp"

namespace gonogo::expanders {

/// One block of letters and numbers, its words sorted by address. Reading it allocates nothing.
class LetterBlock {
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

  bool has(char address) const { return words_.has(address); }
  bool has_any(AddressSet addresses) const { return words_.any_of(addresses); }
  /// For a word that is there.
  const Decimal& number(char address) const { return numbers_[index_of(address)]; }
  Position position(char address) const {
    return has(address) ? positions_[index_of(address)] : kNowhere;
  }
  /// Whether the block has `address` with a number that is not whole.
  bool has_fraction(char address) const {
    return has(address) && (number(address).finer || number(address).value % kOne != 0);
  }
  /// Addresses of the words; N, O and G are not among them.
  AddressSet words() const { return words_; }
  template <typename Group>
  const Code* code(Group group) const {
    return codes_[static_cast<std::size_t>(group)];
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
  bool empty() const { return words_.empty() && !any_code_; }
  /// Whether the number of a program stands at its head.
  bool begins_program() const { return begins_program_; }

  /// The first code that is not implemented; null: none.
  const Code* outside() const { return outside_; }
  /// Whether a G code is unknown.
  bool unknown_code() const { return unknown_code_; }
  /// Address of the first word or code (G) that stands twice; 0: none.
  char duplicate() const { return duplicate_; }
  /// Where it stands the second time.
  Position duplicate_position() const { return duplicate_position_; }
  /// What of the macro language was met.
  std::string_view macro() const { return macro_; }
  /// Address of the word at which a syntax error was met; 0: before the first.
  char last_address() const { return last_address_; }

 private:
  static std::size_t index_of(char address) { return static_cast<std::size_t>(address - 'A'); }
  void clear();
  Reading read_words(std::string_view line, const Manner& manner);
  void take(const Word& word, Position position, const Manner& manner);
  void take_code(const Decimal& number, Position position, const Manner& manner);
  void note_duplicate(char address, Position position);

  AddressSet words_;
  std::array<Decimal, 26> numbers_;  // valid where words_ has the address
  std::array<Position, 26> positions_{};
  std::array<const Code*, kMostGroups> codes_{};
  std::array<Position, kMostGroups> code_positions_{};
  bool any_code_ = false;
  bool begins_program_ = false;
  bool unknown_code_ = false;
  const Code* outside_ = nullptr;
  char duplicate_ = 0;
  Position duplicate_position_ = kNowhere;
  char last_address_ = 0;
  std::string_view macro_;
};

}  // namespace gonogo::expanders
