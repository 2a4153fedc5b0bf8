// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "expanders/common/address_set.hpp"
#include "expanders/common/fixed.hpp"
#include "expanders/gsk/alarms.hpp"
#include "expanders/gsk/codes.hpp"

namespace gonogo::expanders::gsk {

/// One block, its words sorted by address. Fixed size: reading it allocates nothing.
class Block {
 public:
  enum class Reading {
    kWords,     // may be without any word
    kSkipped,   // `/` with the block skip on
    kTapeMark,  // `%`
    kSyntax
  };

  /// Reads `line`. `later_wins`: of one address or one code group given twice the later holds.
  Reading read(std::string_view line, bool block_skip, bool later_wins);

  bool has(char address) const { return words_.has(address); }
  bool has_any(AddressSet addresses) const { return words_.any_of(addresses); }
  const Decimal& number(char address) const {
    return numbers_[static_cast<std::size_t>(address - 'A')];
  }
  /// Addresses of the words; N, O and G are not among them.
  AddressSet words() const { return words_; }
  const Code* code(Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  bool has_code(Group group, std::uint16_t number) const {
    return code(group) != nullptr && code(group)->number == number;
  }
  bool empty() const { return words_.empty() && !any_code_; }
  /// Whether the number of a program stands at its head.
  bool begins_program() const { return begins_program_; }
  /// What reading found wrong with words that can be read; the first of them.
  const std::optional<Alarm>& defect() const { return defect_; }
  /// The first code that is not implemented; null: none.
  const Code* unsupported() const { return unsupported_; }
  /// Address of the word at which a syntax error was met; 0: before the first.
  char last_address() const { return last_address_; }

 private:
  void clear();
  void take_code(const Decimal& number, bool later_wins);
  void take_word(char address, const Decimal& number, bool later_wins);
  void note_defect(AlarmKind kind, char address) {
    if (!defect_) defect_ = Alarm{kind, address};
  }

  AddressSet words_;
  std::array<Decimal, 26> numbers_;  // valid where words_ has the address
  std::array<const Code*, kGroups> codes_{};
  bool any_code_ = false;
  bool begins_program_ = false;
  std::optional<Alarm> defect_;
  const Code* unsupported_ = nullptr;
  char last_address_ = 0;
};

}  // namespace gonogo::expanders::gsk
