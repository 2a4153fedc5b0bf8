// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "expanders/common/address_set.hpp"
#include "expanders/common/complaints.hpp"
#include "expanders/common/tokenizer.hpp"
#include "expanders/hnc/codes.hpp"

namespace gonogo::expanders::hnc {

/// One block, its words sorted by address. Fixed size: reading it allocates nothing.
class Block {
 public:
  enum class Reading {
    kWords,     // may be without any word
    kSkipped,   // `/` with the block skip on
    kTapeMark,  // `%`, alone
    kMacro,     // a variable, an expression or a statement of the macro language
    kSyntax
  };

  Reading read(std::string_view line, bool block_skip);

  bool has(char address) const { return words_.has(address); }
  bool has_any(AddressSet addresses) const { return words_.any_of(addresses); }
  const Decimal& number(char address) const { return numbers_[index_of(address)]; }
  Position position(char address) const {
    return has(address) ? positions_[index_of(address)] : kNowhere;
  }
  /// Addresses of the words; N, O and G are not among them.
  AddressSet words() const { return words_; }
  const Code* code(Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  bool has_code(Group group, unsigned number) const {
    return code(group) != nullptr && code(group)->number == number;
  }
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
  Reading unreadable(std::string_view rest);
  void take(const Word& word, Position position);
  void take_code(const Decimal& number, Position position);
  void note_duplicate(char address, Position position);

  AddressSet words_;
  std::array<Decimal, 26> numbers_;  // valid where words_ has the address
  std::array<Position, 26> positions_{};
  std::array<const Code*, kGroups> codes_{};
  std::array<Position, kGroups> code_positions_{};
  bool any_code_ = false;
  bool begins_program_ = false;
  bool unknown_code_ = false;
  const Code* outside_ = nullptr;
  char duplicate_ = 0;
  Position duplicate_position_ = kNowhere;
  char last_address_ = 0;
  std::string_view macro_;
};

}  // namespace gonogo::expanders::hnc
