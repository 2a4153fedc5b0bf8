// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "expanders/common/address_set.hpp"
#include "expanders/common/complaints.hpp"
#include "expanders/common/tokenizer.hpp"
#include "expanders/ngc/codes.hpp"
#include "expanders/ngc/whole.hpp"

namespace gonogo::expanders::ngc {

/// An M word.
struct FunctionWord {
  std::optional<Fixed> number;  ///< nothing: it is not whole, or too large
  bool too_large = false;
  Position position = 0;
};

/// One block, its words sorted by address. Reading one allocates nothing but room for M words,
/// which is kept.
class Block {
 public:
  enum class Reading {
    kWords,     // may be without any word
    kSkipped,   // `/` with the block delete on
    kTapeMark,  // `%`, alone
    kMacro,     // O word, parameter, expression
    kSyntax
  };

  /// How lines are read, faults included.
  struct Manner {
    bool block_delete = false;
    bool capitals_only = false;
    const WholeRule& whole;
  };

  Reading read(std::string_view line, Manner manner);

  bool has(char address) const { return words_.has(address); }
  bool has_any(AddressSet addresses) const { return words_.any_of(addresses); }
  const Decimal& number(char address) const { return numbers_[index_of(address)]; }
  Position position(char address) const {
    return has(address) ? positions_[index_of(address)] : kNowhere;
  }
  /// Addresses of the words; N, G and M are not among them.
  AddressSet words() const { return words_; }
  /// In the order of the line.
  const std::vector<FunctionWord>& functions() const { return functions_; }
  const Code* code(Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  bool has_dwell() const {
    const Code* once = code(Group::kOnce);
    return once != nullptr && once->tenths == 40;
  }
  /// P of an arc; G4, G64 and some M functions take it for themselves.
  bool has_turns() const {
    const Code* control = code(Group::kControl);
    if (!has('P') || has_dwell() || (control != nullptr && control->tenths == 640)) return false;
    return std::none_of(functions_.begin(), functions_.end(), [](const FunctionWord& word) {
      return word.number && takes_p(*word.number);
    });
  }
  bool empty() const { return words_.empty() && !any_code_ && functions_.empty(); }

  /// The first code that is not implemented; null: none.
  const Code* outside() const { return outside_; }
  /// Whether a G code is unknown.
  bool unknown_code() const { return unknown_code_; }
  /// Address of the first word or code (G) that stands twice; 0: none.
  char duplicate() const { return duplicate_; }
  /// Where it stands the second time.
  Position duplicate_position() const { return duplicate_position_; }
  /// The construct that was met, one byte.
  std::string_view macro() const { return macro_; }
  /// Address of the word at which a syntax error was met; 0: before the first.
  char last_address() const { return last_address_; }

 private:
  static std::size_t index_of(char address) { return static_cast<std::size_t>(address - 'A'); }
  void clear();
  Reading unreadable(std::string_view rest);
  void take(const Word& word, Position position, const WholeRule& whole);
  void take_code(std::optional<Fixed> tenths, Position position);
  void note_duplicate(char address, Position position);

  AddressSet words_;
  std::array<Decimal, 26> numbers_;  // valid where words_ has the address
  std::array<Position, 26> positions_{};
  std::vector<FunctionWord> functions_;
  std::array<const Code*, kGroups> codes_{};
  bool any_code_ = false;
  bool unknown_code_ = false;
  const Code* outside_ = nullptr;
  char duplicate_ = 0;
  Position duplicate_position_ = kNowhere;
  char last_address_ = 0;
  std::string_view macro_;
};

}  // namespace gonogo::expanders::ngc
