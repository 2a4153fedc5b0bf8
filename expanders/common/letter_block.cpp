// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/common/letter_block.hpp"

namespace gonogo::expanders {
namespace {

// The construct of the macro language at the start of `rest`; empty: none.
std::string_view macro_at(std::string_view rest, std::span<const std::string_view> words) {
  if (words.empty()) return {};
  std::size_t letters = 0;
  while (letters < rest.size() && is_letter(rest[letters])) ++letters;
  const std::string_view run = rest.substr(0, letters);
  for (const std::string_view word : words) {
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

LetterBlock::Reading LetterBlock::read(std::string_view line, const Manner& manner) {
  clear();
  begins_program_ = false;
  return line.size() > kLongestLine ? Reading::kSyntax : read_words(line, manner);
}

LetterBlock::Reading LetterBlock::read_words(std::string_view line, const Manner& manner) {
  Tokenizer tokens(line);
  Word word;
  bool first_word = true;  // nothing but `/` before it: N or O may stand here
  for (Position position = 0;; ++position) {
    switch (tokens.next(word)) {
      case Token::kEnd:
        return Reading::kWords;
      case Token::kSyntax:
        macro_ = macro_at(tokens.from_token(), manner.macro_words);
        return macro_.empty() ? Reading::kSyntax : Reading::kMacro;
      case Token::kTapeMark:
        if (position != 0) return Reading::kSyntax;
        first_word = false;
        if (manner.named_by_tape_mark && tokens.skip_digits()) {
          begins_program_ = true;
          break;
        }
        return tokens.next(word) == Token::kEnd ? Reading::kTapeMark : Reading::kSyntax;
      case Token::kSkip:
        if (position != 0) return Reading::kSyntax;
        if (manner.block_skip) return Reading::kSkipped;
        break;
      case Token::kWord:
        last_address_ = word.address;
        if (tokens.from_token()[0] >= 'a') return Reading::kSyntax;  // a small letter
        if (word.address == 'N' || word.address == 'O') {
          if (!first_word || !tokens.has_plain_number()) return Reading::kSyntax;
          begins_program_ = word.address == 'O';
        } else {
          take(word, position, manner);
        }
        first_word = false;
        break;
    }
  }
}

void LetterBlock::take(const Word& word, Position position, const Manner& manner) {
  if (word.address == 'G') return take_code(word.number, position, manner);
  if (has(word.address) && !manner.later_wins) return note_duplicate(word.address, position);
  put(word, position);
}

void LetterBlock::take_code(const Decimal& number, Position position, const Manner& manner) {
  const Code* code = manner.codes.find(number);
  if (!note_code(code) || code->group == manner.free_group) return;
  if (codes_[code->group] != nullptr && !manner.later_wins) return note_duplicate('G', position);
  codes_[code->group] = code;
  code_positions_[code->group] = position;
}

}  // namespace gonogo::expanders
