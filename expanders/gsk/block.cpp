// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/block.hpp"

#include "expanders/common/tokenizer.hpp"

namespace gonogo::expanders::gsk {

void Block::clear() {
  words_ = AddressSet{};
  codes_.fill(nullptr);
  any_code_ = false;
  begins_program_ = false;
  defect_.reset();
  unsupported_ = nullptr;
  last_address_ = 0;
}

Block::Reading Block::read(std::string_view line, bool block_skip, bool later_wins) {
  clear();
  if (line.size() > kLongestLine) return Reading::kSyntax;
  Tokenizer tokens(line);
  Word word;
  bool first = true;       // nothing before this token
  bool first_word = true;  // nothing but `/` before it: N or O may stand here
  while (true) {
    switch (tokens.next(word)) {
      case Token::kEnd:
        return Reading::kWords;
      case Token::kSyntax:
        return Reading::kSyntax;
      case Token::kTapeMark:
        return first && tokens.next(word) == Token::kEnd ? Reading::kTapeMark : Reading::kSyntax;
      case Token::kSkip:
        if (!first) return Reading::kSyntax;
        if (block_skip) return Reading::kSkipped;
        break;
      case Token::kWord:
        last_address_ = word.address;
        if (tokens.from_token()[0] >= 'a') return Reading::kSyntax;  // a small letter
        if (word.address == 'N' || word.address == 'O') {
          if (!first_word || !tokens.has_plain_number()) return Reading::kSyntax;
          begins_program_ = word.address == 'O';
        } else if (word.address == 'G') {
          take_code(word.number, later_wins);
        } else {
          take_word(word.address, word.number, later_wins);
        }
        first_word = false;
        break;
    }
    first = false;
  }
}

void Block::take_code(const Decimal& number, bool later_wins) {
  any_code_ = true;
  const Code* code = find_code(number);
  if (code == nullptr) {
    note_defect(AlarmKind::kUndefinedCode, 'G');  // GSK-COM-02
    return;
  }
  if (code->support == Support::kLater && unsupported_ == nullptr) unsupported_ = code;
  const Code*& place = codes_[static_cast<std::size_t>(code->group)];
  if (place != nullptr && !later_wins) note_defect(AlarmKind::kDuplicateWord, 'G');  // GSK-COM-07
  place = code;
}

void Block::take_word(char address, const Decimal& number, bool later_wins) {
  if (words_.has(address) && !later_wins) {
    note_defect(AlarmKind::kDuplicateWord, address);  // GSK-COM-07
  }
  words_.add(address);
  numbers_[static_cast<std::size_t>(address - 'A')] = number;
}

}  // namespace gonogo::expanders::gsk
