// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/block.hpp"

#include <algorithm>

namespace gonogo::expanders::hnc {
namespace {

// Words of the macro language that begin a statement or a function.
constexpr std::string_view kMacroWords[] = {
    "IF",  "ELSE", "ENDIF", "WHILE", "ENDW", "DO",   "END", "GOTO", "CALL", "AR", "SIN",
    "COS", "TAN",  "ATAN",  "ABS",   "INT",  "SQRT", "EXP", "SIGN", "PI",   "RL", "RC"};

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool same_letters(std::string_view text, std::string_view capitals) {
  return std::equal(text.begin(), text.end(), capitals.begin(), capitals.end(),
                    [](char a, char b) { return a == b || a == b - 'A' + 'a'; });
}

// The construct of the macro language at the start of `rest`; empty: none.
std::string_view macro_at(std::string_view rest) {
  std::size_t letters = 0;
  while (letters < rest.size() && is_letter(rest[letters])) ++letters;
  const std::string_view run = rest.substr(0, letters);
  for (const std::string_view word : kMacroWords) {
    if (same_letters(run, word)) return run;
  }
  if (letters > 1) return {};
  rest.remove_prefix(letters);
  while (!rest.empty() && (rest[0] == ' ' || rest[0] == '\t')) rest.remove_prefix(1);
  if (letters == 1 && !rest.empty() && (rest[0] == '-' || rest[0] == '+')) rest.remove_prefix(1);
  const bool begins = !rest.empty() && (rest[0] == '#' || rest[0] == '[');
  return begins ? rest.substr(0, 1) : std::string_view{};
}

}  // namespace

void Block::clear() {
  words_ = AddressSet{};
  codes_.fill(nullptr);
  any_code_ = false;
  begins_program_ = false;
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

Block::Reading Block::read(std::string_view line, bool block_skip) {
  clear();
  if (line.size() > kLongestLine) return Reading::kSyntax;
  Tokenizer tokens(line);
  Word word;
  bool first_word = true;  // nothing but `/` before it: N or O may stand here
  for (Position position = 0;; ++position) {
    switch (tokens.next(word)) {
      case Token::kEnd:
        return Reading::kWords;
      case Token::kSyntax:
        return unreadable(tokens.from_token());
      case Token::kTapeMark:
        if (position != 0) return Reading::kSyntax;
        first_word = false;
        if (tokens.skip_digits()) {
          begins_program_ = true;
          break;
        }
        return tokens.next(word) == Token::kEnd ? Reading::kTapeMark : Reading::kSyntax;
      case Token::kSkip:
        if (position != 0) return Reading::kSyntax;
        if (block_skip) return Reading::kSkipped;
        break;
      case Token::kWord:
        last_address_ = word.address;
        if (tokens.from_token()[0] >= 'a') return Reading::kSyntax;  // a small letter
        if (word.address == 'N' || word.address == 'O') {
          if (!first_word || !tokens.has_plain_number()) return Reading::kSyntax;
          begins_program_ = word.address == 'O';
        } else {
          take(word, position);
        }
        first_word = false;
        break;
    }
  }
}

void Block::take(const Word& word, Position position) {
  if (word.address == 'G') return take_code(word.number, position);
  if (words_.has(word.address)) return note_duplicate(word.address, position);
  words_.add(word.address);
  numbers_[index_of(word.address)] = word.number;
  positions_[index_of(word.address)] = position;
}

void Block::take_code(const Decimal& number, Position position) {
  any_code_ = true;
  const Code* code = find_code(number);
  if (code == nullptr) {
    unknown_code_ = true;
    return;
  }
  if (code->support == Support::kOutside && outside_ == nullptr) outside_ = code;
  if (code->group == Group::kFree) return;
  const auto group = static_cast<std::size_t>(code->group);
  if (codes_[group] != nullptr) return note_duplicate('G', position);
  codes_[group] = code;
  code_positions_[group] = position;
}

void Block::note_duplicate(char address, Position position) {
  if (duplicate_ != 0) return;
  duplicate_ = address;
  duplicate_position_ = position;
}

}  // namespace gonogo::expanders::hnc
