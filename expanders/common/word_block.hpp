// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "expanders/common/address_set.hpp"
#include "expanders/common/codes.hpp"
#include "expanders/common/complaints.hpp"
#include "expanders/common/tokenizer.hpp"

namespace gonogo::expanders {

/// The words of a block sorted by address, its codes by group, and what was wrong with them.
class WordBlock {
 public:
  bool has(char address) const { return words_.has(address); }
  bool has_any(AddressSet addresses) const { return words_.any_of(addresses); }
  /// For a word that is there.
  const Decimal& number(char address) const { return numbers_[index_of(address)]; }
  Position position(char address) const {
    return has(address) ? positions_[index_of(address)] : kNowhere;
  }
  /// Addresses of the words; those of numbers of lines and programs and of codes are not among
  /// them.
  AddressSet words() const { return words_; }
  template <typename Group>
  const Code* code(Group group) const {
    return codes_[static_cast<std::size_t>(group)];
  }

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

 protected:
  void clear() {
    words_ = AddressSet{};
    codes_.fill(nullptr);
    any_code_ = unknown_code_ = false;
    outside_ = nullptr;
    duplicate_ = last_address_ = 0;
    duplicate_position_ = kNowhere;
    macro_ = {};
  }
  void put(const Word& word, Position position) {
    words_.add(word.address);
    numbers_[index_of(word.address)] = word.number;
    positions_[index_of(word.address)] = position;
  }
  /// Null: the control has no such code. False then.
  bool note_code(const Code* code) {
    any_code_ = true;
    if (code == nullptr) {
      unknown_code_ = true;
    } else if (code->support == Support::kOutside && outside_ == nullptr) {
      outside_ = code;
    }
    return code != nullptr;
  }
  void note_duplicate(char address, Position position) {
    if (duplicate_ != 0) return;
    duplicate_ = address;
    duplicate_position_ = position;
  }

  std::array<const Code*, kMostGroups> codes_{};
  bool any_code_ = false;
  char last_address_ = 0;
  std::string_view macro_;

 private:
  static constexpr std::size_t kAddresses = '^' - '@' + 1;
  static std::size_t index_of(char address) { return static_cast<std::size_t>(address - '@'); }

  AddressSet words_;
  std::array<Decimal, kAddresses> numbers_;  // valid where words_ has the address
  std::array<Position, kAddresses> positions_{};
  bool unknown_code_ = false;
  const Code* outside_ = nullptr;
  char duplicate_ = 0;
  Position duplicate_position_ = kNowhere;
};

}  // namespace gonogo::expanders
