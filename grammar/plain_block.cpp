// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/plain_block.hpp"

#include <cstdint>
#include <cstring>

#include "grammar/byte_set.hpp"

namespace gonogo::grammar {
namespace {

constexpr std::ptrdiff_t kMostPlainDigits = 18;  // above them a Decimal has its digits as text
constexpr std::size_t kUsualItems = 8;           // of a block, for which there is room at once

// The line while it is read.
struct Cursor {
  const char* at;
  const char* const line;
  const char* const end;

  bool done() const { return at == end; }
  void skip_blanks() {
    while (at != end && (*at == ' ' || *at == '\t')) ++at;
  }
  // Takes digits into `magnitude`; how many there were.
  std::ptrdiff_t take_digits(std::uint64_t& magnitude) {
    const char* const begin = at;
    for (; at != end; ++at) {
      const auto digit = static_cast<unsigned char>(*at - '0');
      if (digit > 9) break;
      magnitude = magnitude * 10 + digit;
    }
    return at - begin;
  }
  bool take_number(Decimal& value) {
    if (at != end && (*at == '-' || *at == '+')) value.negative = *at++ == '-';
    std::ptrdiff_t digits = take_digits(value.magnitude);
    if (at != end && *at == '.') {
      ++at;
      const std::ptrdiff_t places = take_digits(value.magnitude);
      value.scale = static_cast<std::uint32_t>(places);
      digits += places;
    }
    return digits > 0 && digits <= kMostPlainDigits;
  }
  std::uint32_t place(const char* byte) const { return static_cast<std::uint32_t>(byte - line); }
  Span from(const char* begin) const { return {place(begin), place(at)}; }
};

// N and its number, where the block begins with them.
template <Letters letters>
bool take_sequence_number(Cursor& cursor, Block& block) {
  if (cursor.done() || (*cursor.at != 'N' && (letters == Letters::capital || *cursor.at != 'n'))) {
    return true;
  }
  ++cursor.at;
  cursor.skip_blanks();
  const char* const begin = cursor.at;
  const std::ptrdiff_t digits = cursor.take_digits(block.sequence_number.emplace().magnitude);
  block.number_place.span = cursor.from(begin);
  return digits > 0 && digits <= kMostPlainDigits;
}

// ';' and the rest of the line, which is a comment where there is any.
bool take_line_comment(Cursor& cursor, Block& block) {
  block.line_comment.span = {cursor.place(cursor.at), cursor.place(cursor.end)};
  const char* const begin = ++cursor.at;
  if (begin == cursor.end) return true;
  Comment& comment = block.comments.emplace_back();
  comment.text.assign(begin, cursor.end);
  comment.to_end_of_line = true;
  cursor.at = cursor.end;
  comment.where = cursor.from(begin);
  return true;
}

// '(' and the text up to the next ')'.
bool take_comment(Cursor& cursor, Block& block) {
  const char* const begin = cursor.at++;
  const auto* const close = static_cast<const char*>(
      std::memchr(cursor.at, ')', static_cast<std::size_t>(cursor.end - cursor.at)));
  if (close == nullptr) return false;
  Comment& comment = block.comments.emplace_back();
  comment.text.assign(cursor.at, close);
  cursor.at = close + 1;
  comment.where = cursor.from(begin);
  return true;
}

// An item of letter-address programs: a word or a comment.
template <Letters letters>
struct LetterAddress {
  static void make_room(Block& block) { block.words.reserve(kUsualItems); }
  static bool take(Cursor& cursor, Block& block) {
    const char* const begin = cursor.at;
    if (*begin == '(') return take_comment(cursor, block);
    const char letter = letters == Letters::any_case ? capital_of(*begin) : *begin;
    if (!kAddress.contains(letter)) return false;
    ++cursor.at;
    cursor.skip_blanks();
    Word& word = block.words.emplace_back();
    word.address = letter;
    const bool taken = cursor.take_number(word.value);
    word.where = cursor.from(begin);
    return taken;
  }
};

// An item of SINUMERIK: a letter and a constant, or an address of two letters, '=' and a constant.
// What an operator follows is no constant.
struct Sinumerik {
  static void make_room(Block& block) {
    block.named.reserve(kUsualItems);
    block.terms.reserve(kUsualItems);
  }
  static bool take(Cursor& cursor, Block& block) {
    const char* const begin = cursor.at;
    const char letter = capital_of(*begin);
    if (!kCapital.contains(letter) || letter == 'N') return false;
    NamedWord& word = block.named.emplace_back();
    word.name.push_back(letter);
    ++cursor.at;
    if (is_address(letter, cursor)) {
      word.name.push_back(capital_of(*cursor.at++));
      cursor.skip_blanks();
      if (cursor.done() || *cursor.at++ != '=') return false;
      word.has_equals = true;
    } else if (letter == 'R') {
      return false;  // a parameter
    }
    cursor.skip_blanks();
    const char* const constant = cursor.at;
    Term& term = block.terms.emplace_back();
    if (!cursor.take_number(term.number)) return false;
    term.where = cursor.from(constant);
    word.first_term = static_cast<std::uint32_t>(block.terms.size() - 1);
    word.terms = 1;
    word.where = cursor.from(begin);
    cursor.skip_blanks();
    return cursor.done() || kAfterConstant.contains(*cursor.at);
  }

 private:
  static constexpr ByteSet kAfterConstant = kLetter | ByteSet{";"};

  // CR, AR, AP and RP.
  static bool is_address(char letter, const Cursor& cursor) {
    if (cursor.done()) return false;
    const char second = capital_of(*cursor.at);
    if (second == 'R') return letter == 'C' || letter == 'A';
    return second == 'P' && (letter == 'A' || letter == 'R');
  }
};

template <Letters letters, typename Item>
bool read_plain(std::string_view line, Block& block) {
  Item::make_room(block);
  Cursor cursor{line.data(), line.data(), line.data() + line.size()};
  cursor.skip_blanks();
  if (!take_sequence_number<letters>(cursor, block)) return false;
  for (cursor.skip_blanks(); !cursor.done(); cursor.skip_blanks()) {
    if (*cursor.at == ';') return take_line_comment(cursor, block);
    if (!Item::take(cursor, block)) return false;
  }
  return true;
}

bool read_plain_of(Dialect dialect, std::string_view line, Block& block) {
  switch (dialect) {
    case Dialect::gsk988ta:
    case Dialect::hnc21t:
      return read_plain<Letters::capital, LetterAddress<Letters::capital>>(line, block);
    case Dialect::rs274:
      return read_plain<Letters::any_case, LetterAddress<Letters::any_case>>(line, block);
    case Dialect::sinumerik:
      return read_plain<Letters::any_case, Sinumerik>(line, block);
  }
  __builtin_unreachable();
}

}  // namespace

bool read_plain_block(Dialect dialect, std::string_view line, Block& block) {
  if (read_plain_of(dialect, line, block)) return true;
  block.clear();
  return false;
}

}  // namespace gonogo::grammar
