// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/block.hpp"

#include <algorithm>

namespace gonogo::expanders::ngc {
namespace {

// Functions that may stand for a number: `X SIN[30]`.
constexpr std::string_view kFunctions[] = {"ABS", "ACOS", "ASIN", "ATAN",  "COS", "EXISTS", "EXP",
                                           "FIX", "FUP",  "LN",   "ROUND", "SIN", "SQRT",   "TAN"};

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

bool same_letters(std::string_view text, std::string_view capitals) {
  return std::equal(text.begin(), text.end(), capitals.begin(), capitals.end(),
                    [](char a, char b) { return a == b || a == b - 'A' + 'a'; });
}

bool is_function(std::string_view rest) {
  std::size_t letters = 0;
  while (letters < rest.size() && is_letter(rest[letters])) ++letters;
  return std::any_of(std::begin(kFunctions), std::end(kFunctions), [&](std::string_view name) {
    return same_letters(rest.substr(0, letters), name);
  });
}

// The construct at the start of `rest`, where no word could be read; empty: none.
std::string_view macro_at(std::string_view rest) {
  if (rest.empty()) return {};
  if (rest[0] == '#' || rest[0] == '[' || rest[0] == 'O' || rest[0] == 'o')
    return rest.substr(0, 1);
  if (!is_letter(rest[0])) return {};
  rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest[0])) rest.remove_prefix(1);
  if (!rest.empty() && (rest[0] == '-' || rest[0] == '+')) rest.remove_prefix(1);
  const bool begins = !rest.empty() && (rest[0] == '#' || rest[0] == '[' || is_function(rest));
  return begins ? rest.substr(0, 1) : std::string_view{};
}

// NGC-COM-01: `%` with nothing but blanks beside it.
bool is_alone(std::string_view line) {
  return std::all_of(line.begin(), line.end(), [](char c) { return is_blank(c) || c == '%'; }) &&
         std::count(line.begin(), line.end(), '%') == 1;
}

// Whether a comment stands before `token`, which ends `line`.
bool follows_comment(std::string_view line, std::string_view token) {
  return line.substr(0, line.size() - token.size()).find('(') != std::string_view::npos;
}

bool is_small(std::string_view token) {
  return !token.empty() && token[0] >= 'a' && token[0] <= 'z';
}

}  // namespace

void Block::clear() {
  words_ = AddressSet{};
  functions_.clear();
  codes_.fill(nullptr);
  any_code_ = false;
  unknown_code_ = false;
  outside_ = nullptr;
  duplicate_ = 0;
  duplicate_position_ = kNowhere;
  last_address_ = 0;
  macro_ = {};
}

Block::Reading Block::unreadable(std::string_view rest) {
  macro_ = macro_at(rest);
  return macro_.empty() ? Reading::kSyntax : Reading::kMacro;
}

Block::Reading Block::read(std::string_view line, Manner manner) {
  clear();
  if (line.size() > kLongestLine) return Reading::kSyntax;
  Tokenizer tokens(line);
  Word word;
  bool first_word = true;  // N may stand here
  for (Position position = 0;; ++position) {
    switch (tokens.next(word)) {
      case Token::kEnd:
        return Reading::kWords;
      case Token::kSyntax:
        return unreadable(tokens.from_token());
      case Token::kTapeMark:
        return is_alone(line) ? Reading::kTapeMark : Reading::kSyntax;
      case Token::kSkip:
        if (position != 0 || follows_comment(line, tokens.from_token())) return Reading::kSyntax;
        if (manner.block_delete) return Reading::kSkipped;
        break;
      case Token::kWord:
        if (word.address == 'O') return unreadable(tokens.from_token());
        last_address_ = word.address;
        if (manner.capitals_only && is_small(tokens.from_token())) return Reading::kSyntax;
        if (word.address != 'N') {
          take(word, position, manner.whole);
        } else if (!first_word || !tokens.has_plain_number() ||
                   follows_comment(line, tokens.from_token())) {
          return Reading::kSyntax;
        }
        first_word = false;
        break;
    }
  }
}

void Block::take(const Word& word, Position position, const WholeRule& whole) {
  if (word.address == 'G') return take_code(whole_tenths(word.number, whole), position);
  if (word.address == 'M') {
    functions_.push_back({whole_function(word.number, whole), word.number.overflow, position});
    return;
  }
  if (words_.has(word.address)) return note_duplicate(word.address, position);
  words_.add(word.address);
  numbers_[index_of(word.address)] = word.number;
  positions_[index_of(word.address)] = position;
}

void Block::take_code(std::optional<Fixed> tenths, Position position) {
  any_code_ = true;
  const Code* code = tenths ? find_code(*tenths) : nullptr;
  if (code == nullptr) {
    unknown_code_ = true;
    return;
  }
  if (code->support == Support::kOutside && outside_ == nullptr) outside_ = code;
  const auto group = static_cast<std::size_t>(code->group);
  if (codes_[group] != nullptr) return note_duplicate('G', position);
  codes_[group] = code;
}

void Block::note_duplicate(char address, Position position) {
  if (duplicate_ != 0) return;
  duplicate_ = address;
  duplicate_position_ = position;
}

}  // namespace gonogo::expanders::ngc
