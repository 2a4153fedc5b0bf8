// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/common/tokenizer.hpp"

#include <algorithm>
#include <cstring>

namespace gonogo::expanders {

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  std::size_t length = 0;
  while (length < rest_.size() && rest_[length] != '\n' && rest_[length] != '\r') ++length;
  line = rest_.substr(0, length);
  std::size_t used = length;
  if (used < rest_.size()) {
    const bool pair = rest_[used] == '\r' && used + 1 < rest_.size() && rest_[used + 1] == '\n';
    used += pair ? 2 : 1;
    if (pair && counting_ == Counting::kPairTwice) ++number_;
  }
  rest_.remove_prefix(used);
  if (!(line.empty() && counting_ == Counting::kWithoutBlank)) ++number_;
  return true;
}

// Skips blanks and comments; false when a comment does not end on the line.
bool Tokenizer::skip_blanks() {
  while (cursor_ != end_) {
    if (*cursor_ == ' ' || *cursor_ == '\t') {
      ++cursor_;
    } else if (*cursor_ == '(') {
      const void* close = std::memchr(cursor_, ')', static_cast<std::size_t>(end_ - cursor_));
      if (close == nullptr) return false;
      cursor_ = static_cast<const char*>(close) + 1;
    } else {
      break;
    }
  }
  return true;
}

bool Tokenizer::has_plain_number() const {
  const char* digits = token_ + 1;
  while (digits != cursor_ && (*digits == ' ' || *digits == '\t')) ++digits;
  return std::all_of(digits, cursor_, [](char c) { return c >= '0' && c <= '9'; });
}

bool Tokenizer::skip_digits() {
  while (cursor_ != end_ && (*cursor_ == ' ' || *cursor_ == '\t')) ++cursor_;
  const char* const first = cursor_;
  while (cursor_ != end_ && *cursor_ >= '0' && *cursor_ <= '9') ++cursor_;
  return cursor_ != first;
}

Token Tokenizer::next(Word& word) {
  const bool closed = skip_blanks();
  token_ = cursor_;
  if (!closed) return Token::kSyntax;
  if (cursor_ == end_ || *cursor_ == ';') return Token::kEnd;
  const char c = *cursor_++;
  if (c == '/') return Token::kSkip;
  if (c == '%') return Token::kTapeMark;
  if (c >= 'a' && c <= 'z') {
    word.address = static_cast<char>(c - 'a' + 'A');
  } else if ((c >= 'A' && c <= 'Z') || further_.find(c) != std::string_view::npos) {
    word.address = c;
  } else {
    return Token::kSyntax;
  }
  while (cursor_ != end_ && (*cursor_ == ' ' || *cursor_ == '\t')) ++cursor_;
  return read_decimal(cursor_, end_, word.number) ? Token::kWord : Token::kSyntax;
}

}  // namespace gonogo::expanders
