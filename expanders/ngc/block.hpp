// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expanders/common/word_block.hpp"
#include "expanders/ngc/codes.hpp"
#include "expanders/ngc/whole.hpp"

namespace gonogo::expanders::ngc {

/// An M word.
struct FunctionWord {
  std::optional<Fixed> number;         ///< nothing: it is not whole, or too large
  const FunctionKind* kind = nullptr;  ///< null: the control has no such function
  bool too_large = false;
  Position position = 0;
};

/// One block. Reading one allocates nothing but room for M words, which is kept.
class Block : public WordBlock {
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

  /// In the order of the line.
  const std::vector<FunctionWord>& functions() const { return functions_; }
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
      return word.kind != nullptr && word.kind->words.has(address);
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
  bool empty() const { return words().empty() && !any_code_ && functions_.empty(); }

 private:
  void clear();
  Reading unreadable(std::string_view rest);
  Reading read_words(std::string_view line, const Manner& manner);
  bool take_line_number(const Tokenizer& tokens, const Word& word, const Manner& manner);
  void take_motion(const Code& code, Position position);
  void settle_motion(const Manner& manner);
  void take(const Word& word, Position position, const WholeNumbers& whole);
  void take_code(std::optional<Fixed> tenths, Position position);

  std::vector<FunctionWord> functions_;
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
