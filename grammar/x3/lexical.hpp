// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest parsers of all dialects: bytes, numbers, comment texts, keywords. Each leaves the
// iterator where it was when it does not match.
#pragma once

#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "grammar/decimal.hpp"
#include "grammar/x3/target.hpp"

namespace gonogo::grammar::x3 {

// The byte that the grammar sees.
template <Letters letters>
constexpr char as_capital(char byte) {
  return letters == Letters::any_case ? capital_of(byte) : byte;
}

// One byte of a set.
template <const ByteSet& set>
struct OneOf : spirit::parser<OneOf<set>> {
  using attribute_type = char;
  static constexpr bool has_attribute = true;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute& attribute) const {
    if (first == last || !set.contains(*first)) return false;
    spirit::traits::move_to(*first, attribute);
    ++first;
    return true;
  }
};

// One given byte.
template <char wanted>
struct Byte : spirit::parser<Byte<wanted>> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    if (first == last || *first != wanted) return false;
    ++first;
    return true;
  }
};

// One given letter.
template <char wanted, Letters letters>
struct Letter : spirit::parser<Letter<wanted, letters>> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    if (first == last || as_capital<letters>(*first) != wanted) return false;
    ++first;
    return true;
  }
};

// The letter of a word, as a capital.
template <Letters letters>
struct Address : spirit::parser<Address<letters>> {
  using attribute_type = char;
  static constexpr bool has_attribute = true;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute& attribute) const {
    if (first == last || !kAddress.contains(as_capital<letters>(*first))) return false;
    spirit::traits::move_to(as_capital<letters>(*first), attribute);
    ++first;
    return true;
  }
};

// Any number of bytes of a set, also none.
template <const ByteSet& set>
struct ManyOf : spirit::parser<ManyOf<set>> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    while (first != last && set.contains(*first)) ++first;
    return true;
  }
};

// A decimal number; `sign`: whether it may carry a sign and a point.
enum class NumberForm { decimal, whole };

template <NumberForm form>
struct Number : spirit::parser<Number<form>> {
  using attribute_type = Decimal;
  static constexpr bool has_attribute = true;

  template <typename Context, typename RuleContext>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Decimal& value) const {
    const Iterator end = form == NumberForm::decimal ? read_decimal(first, last, value)
                                                     : read_whole(first, last, value);
    if (end == nullptr) return false;
    first = end;
    return true;
  }
};

// The bytes up to the next ')', which is taken too. A search for the byte is right in every
// encoding that programs come in: the second byte of a GBK character is 0x40 or above, and neither
// UTF-8 nor Latin-1 uses 0x29 for anything else.
struct ClosedText : spirit::parser<ClosedText> {
  using attribute_type = std::string;
  static constexpr bool has_attribute = true;
  static constexpr bool handles_container = true;

  template <typename Context, typename RuleContext>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             std::string& text) const {
    const auto size = static_cast<std::size_t>(last - first);
    const void* close = size == 0 ? nullptr : std::memchr(first, ')', size);
    if (close == nullptr) return false;
    const auto end = static_cast<Iterator>(close);
    text.assign(first, end);
    first = end + 1;
    return true;
  }
};

// The bytes up to the end of the line, at least one.
struct RestOfLine : spirit::parser<RestOfLine> {
  using attribute_type = std::string;
  static constexpr bool has_attribute = true;
  static constexpr bool handles_container = true;

  template <typename Context, typename RuleContext>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             std::string& text) const {
    if (first == last) return false;
    text.assign(first, last);
    first = last;
    return true;
  }
};

// A keyword of a list, not followed by a further letter.
template <const auto& words, Letters letters>
struct Keyword : spirit::parser<Keyword<words, letters>> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    if (last - first < 2 || !is_letter(first[1])) return false;  // nearly every word
    const std::string_view rest(first, static_cast<std::size_t>(last - first));
    for (const std::string_view word : words) {
      if (!begins_with(rest, word)) continue;
      if (rest.size() > word.size() && is_letter(rest[word.size()])) continue;
      first += word.size();
      return true;
    }
    return false;
  }

 private:
  static bool is_letter(char byte) { return kCapital.contains(as_capital<letters>(byte)); }
  static bool begins_with(std::string_view text, std::string_view word) {
    if (text.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
      if (as_capital<letters>(text[i]) != word[i]) return false;
    }
    return true;
  }
};

// Counts brackets without recursion, so that a line full of them cannot exhaust the stack.
struct OpenBracket : spirit::parser<OpenBracket> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    if (first == last || *first != '[') return false;
    ++target(context).brackets;
    ++first;
    return true;
  }
};

struct CloseBracket : spirit::parser<CloseBracket> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    if (first == last || *first != ']' || target(context).brackets == 0) return false;
    --target(context).brackets;
    ++first;
    return true;
  }
};

struct BracketsClosed : spirit::parser<BracketsClosed> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator&, const Iterator&, const Context& context, RuleContext&, Attribute&) const {
    return target(context).brackets == 0;
  }
};

}  // namespace gonogo::grammar::x3
