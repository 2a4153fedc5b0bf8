// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders {

/// Longer lines are refused.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;

/// How lines are numbered: all of them, or as two planted faults do.
enum class Counting { kAll, kWithoutBlank, kPairTwice };

/// Cuts a program into lines; LF, CR LF and CR each end one.
class LineReader {
 public:
  explicit LineReader(std::string_view program, Counting counting = Counting::kAll)
      : rest_(program), counting_(counting) {}

  /// False at the end of the program.
  bool next(std::string_view& line);
  /// The line that was read last, from 1; 0 before the first.
  std::uint64_t number() const { return number_; }

 private:
  std::string_view rest_;
  Counting counting_;
  std::uint64_t number_ = 0;
};

inline bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
/// Whether the text is the word, in either case.
inline bool same_letters(std::string_view text, std::string_view capitals) {
  return std::equal(text.begin(), text.end(), capitals.begin(), capitals.end(),
                    [](char a, char b) { return a == b || a == b - 'A' + 'a'; });
}

struct Word {
  char address = 0;  ///< 'A' to 'Z', or one of the further addresses of the dialect
  Decimal number;
};

enum class Token { kWord, kSkip, kTapeMark, kEnd, kSyntax };

/// Cuts a line into words: blanks and (comments) separate nothing, `;` ends the block. Every byte
/// value may occur; outside of comments those that start no token are kSyntax.
class Tokenizer {
 public:
  explicit Tokenizer(std::string_view line, std::string_view further = {})
      : cursor_(line.data()), token_(cursor_), end_(line.data() + line.size()), further_(further) {}

  Token next(Word& word);
  /// The line from the first byte of the token that was read last.
  std::string_view from_token() const { return {token_, static_cast<std::size_t>(end_ - token_)}; }
  /// The number of the word that was read last, as it is written.
  std::string_view number_text() const {
    return {token_ + 1, static_cast<std::size_t>(cursor_ - token_ - 1)};
  }
  /// Whether the number of the word is nothing but digits, as those of N and O are.
  bool has_plain_number() const;
  /// Skips the digits that follow the token; false: there are none.
  bool skip_digits();

 private:
  bool skip_blanks();

  const char* cursor_;
  const char* token_;
  const char* end_;
  std::string_view further_;  // addresses that are no letters
};

}  // namespace gonogo::expanders
