// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
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
    kName,      // O and a number, alone
    kBlank,     // nothing at all
    kMacro,     // O word, parameter, expression
    kSyntax
  };

  /// How lines are read.
  struct Manner {
    bool block_delete = false;
    bool reads_skipped = false;
    bool forgets_g80 = false;
    const WholeNumbers& whole;
    const Faults& faults;
  };

  Reading read(std::string_view line, const Manner& manner);

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
  /// Whether a code or function of the block, motions left out, has a use for the word.
  bool uses(char address) const {
    const Code* control = code(Group::kControl);
    const bool blends = control != nullptr && control->tenths == 640;
    if (address == 'P' && (has_dwell() || blends)) return true;
    if (address == 'Q' && blends) return true;
    const Code* speed = code(Group::kSpindle);
    if (address == 'D' && speed != nullptr && speed->tenths == 960) return true;
    return std::any_of(functions_.begin(), functions_.end(), [&](const FunctionWord& word) {
      return word.number && uses_word(*word.number, address);
    });
  }
  bool has_function(Fixed m) const {
    return std::any_of(functions_.begin(), functions_.end(),
                       [&](const FunctionWord& word) { return word.number == m; });
  }
  /// The number of the line has decimals, or more digits than NIST's interpreter takes.
  bool long_number() const { return long_number_; }
  /// A polar word stands twice.
  bool twice_polar() const { return twice_polar_; }
  /// NGC-COM-10: the last comment in brackets is (abort,...).
  bool aborts() const;
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
  static std::size_t index_of(char address) { return static_cast<std::size_t>(address - '@'); }
  void clear();
  Reading unreadable(std::string_view rest);
  Reading read_words(std::string_view line, const Manner& manner);
  bool take_line_number(const Tokenizer& tokens, const Word& word, const Manner& manner);
  void take_motion(const Code& code, Position position);
  void settle_motion(const Manner& manner);
  void take(const Word& word, Position position, const WholeNumbers& whole);
  void take_code(std::optional<Fixed> tenths, Position position);
  void note_duplicate(char address, Position position);

  AddressSet words_;
  static constexpr std::size_t kAddresses = '^' - '@' + 1;
  std::array<Decimal, kAddresses> numbers_;  // valid where words_ has the address
  std::array<Position, kAddresses> positions_{};
  std::vector<FunctionWord> functions_;
  std::array<const Code*, kGroups> codes_{};
  bool any_code_ = false;
  bool unknown_code_ = false;
  const Code* outside_ = nullptr;
  char duplicate_ = 0;
  Position duplicate_position_ = kNowhere;
  char last_address_ = 0;
  std::string_view macro_;
  bool long_number_ = false;
  bool skipped_ = false;
  bool twice_polar_ = false;
  std::string line_;  // without blanks

  // Codes of the motion group, G80 apart.
  struct Motions {
    const Code* code = nullptr;
    const Code* off = nullptr;
    const Code* last = nullptr;
    unsigned codes = 0;
    unsigned offs = 0;
    Position second = kNowhere;
  };
  Motions motions_;
};

}  // namespace gonogo::expanders::ngc
