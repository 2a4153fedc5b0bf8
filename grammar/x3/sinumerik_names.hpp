// SPDX-License-Identifier: GPL-3.0-or-later
//
// SINUMERIK: names and what stands round them. The parsers write into the last of Block::named and
// leave the iterator where it was when they do not match.
#pragma once

#include <algorithm>
#include <limits>

#include "grammar/x3/letter_address.hpp"
#include "grammar/x3/values.hpp"

namespace gonogo::grammar::sinumerik {

using namespace x3;  // the vocabulary of the dialect grammars

inline constexpr ByteSet kNameStart = kLetter | ByteSet{"_"};
inline constexpr ByteSet kName = kNameStart | kDigit;
inline constexpr ByteSet kPrintable = ByteSet::range(' ', '~') | ByteSet{"\t"};
inline constexpr ByteSet kOtherBlank =
    (ByteSet::range('\0', '\x1F') | ByteSet{"\x7F&"}) - ByteSet{"\t"};
inline constexpr ByteSet kProgramName = kPrintable - ByteSet{";"};
// What an outside construct goes on with, and what stands between the brackets of a call.
inline constexpr ByteSet kRest = kProgramName - ByteSet{"\""};
inline constexpr ByteSet kNoQuote =
    (ByteSet::range('\0', '\x7F') | ByteSet::range('\x80', '\xFF')) - ByteSet{"\""};
// G and L take a number alone, R an index alone; N is no word.
inline constexpr ByteSet kCode{"GLgl"};
inline constexpr ByteSet kParameter{"Rr"};
inline constexpr ByteSet kPlainAddress = kLetter - kCode - ByteSet{"NRnr"};
// What may stand in a block outside comments and strings.
inline constexpr ByteSet kSinumerikProgram = kPrintable - ByteSet{"!#&?@\\^`{|}~"};

// Addresses of several letters; a digit behind them is not part of the name.
inline constexpr std::array<std::string_view, 5> kNamedAddresses{"CR", "AR", "AP", "RP", "TURN"};
inline constexpr std::array<std::string_view, 1> kRotations{"RPL"};
inline constexpr std::array<std::string_view, 2> kDimensions{"AC", "IC"};
inline constexpr std::array<std::string_view, 5> kFunctions{"SIN", "COS", "TAN", "SQRT", "ABS"};
inline constexpr std::array<std::string_view, 8> kOperators{"DIV",   "MOD",  "AND",   "OR",
                                                            "B_AND", "B_OR", "B_XOR", "XOR"};
inline constexpr std::array<std::string_view, 24> kControlWords{
    "IF",      "ELSE",   "ENDIF", "WHILE",  "ENDWHILE", "FOR",   "ENDFOR", "LOOP",
    "ENDLOOP", "REPEAT", "UNTIL", "CASE",   "GOTO",     "GOTOF", "GOTOB",  "GOTOC",
    "GOTOS",   "DEF",    "PROC",  "EXTERN", "CALL",     "PCALL", "MCALL",  "RET"};

// The word that is being read.
template <typename Context>
NamedWord& current(const Context& context) {
  return target(context).block.named.back();
}

inline bool is_digit(char byte) {
  return kDigit.contains(byte);
}

// The bytes of the name at `first`: two letters and what follows; empty when there is none.
inline std::string_view name_at(Iterator first, Iterator last) {
  if (last - first < 2 || !kNameStart.contains(first[0]) || !kNameStart.contains(first[1])) {
    return {};
  }
  Iterator end = first + 2;
  while (end != last && kName.contains(*end)) ++end;
  return {first, static_cast<std::size_t>(end - first)};
}

inline bool same_name(std::string_view written, std::string_view name) {
  return written.size() == name.size() &&
         std::equal(written.begin(), written.end(), name.begin(),
                    [](char a, char b) { return capital_of(a) == b; });
}

// The place of a name in a list; the size of the list when it is not there.
template <std::size_t size>
std::size_t place_of(std::string_view written, const std::array<std::string_view, size>& names) {
  std::size_t place = 0;
  while (place < size && !same_name(written, names[place])) ++place;
  return place;
}

// One of the addresses of several letters, with nothing but digits behind it: CR5, RPL45. CR5X is a
// name of its own, since a name goes on as far as it can.
template <std::size_t size>
std::string_view address_at(std::string_view name,
                            const std::array<std::string_view, size>& addresses) {
  const auto digits = std::find_if(name.begin(), name.end(), is_digit);
  if (!std::all_of(digits, name.end(), is_digit)) return {};
  const std::string_view address(name.begin(), digits);
  return place_of(address, addresses) < size ? address : std::string_view{};
}

inline void set_name(std::string_view written, NamedWord& word) {
  for (const char letter : written) word.name.push_back(capital_of(letter));
}

// The name of a word: any.
struct AnyName : Silent<AnyName> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    const std::string_view name = name_at(first, last);
    if (name.empty()) return false;
    set_name(name, current(context));
    first += name.size();
    return true;
  }
};

// The name of a word: an address of several letters.
template <const auto& addresses>
struct NamedAddress : Silent<NamedAddress<addresses>> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    const std::string_view name = address_at(name_at(first, last), addresses);
    if (name.empty()) return false;
    set_name(name, current(context));
    first += name.size();
    return true;
  }
};

// The name of a word: one letter of a set, not followed by another.
template <const ByteSet& letters>
struct LetterName : Silent<LetterName<letters>> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    if (first == last || !letters.contains(*first)) return false;
    if (last - first > 1 && kNameStart.contains(first[1])) return false;
    current(context).name.push_back(capital_of(*first));
    ++first;
    return true;
  }
};

// A name of a list, and any name. They are not kept.
template <const auto& names>
struct NameOf : Silent<NameOf<names>> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    const std::string_view name = name_at(first, last);
    if (name.empty() || place_of(name, names) == names.size()) return false;
    first += name.size();
    return true;
  }
};
struct SomeName : Silent<SomeName> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    const std::string_view name = name_at(first, last);
    first += name.size();
    return !name.empty();
  }
};

// At least one byte of a set.
template <const ByteSet& set>
struct SomeOf : Silent<SomeOf<set>> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    const Iterator begin = first;
    while (first != last && set.contains(*first)) ++first;
    return first != begin;
  }
};

// The whole number between a letter and '='. One above 64 bits is the largest.
struct Index : Silent<Index> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    Decimal number;
    const Iterator end = read_whole(first, last, number);
    if (end == nullptr) return false;
    std::uint64_t& index = current(context).index.emplace(0);
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    for (; first != end; ++first) {
      const auto digit = static_cast<std::uint64_t>(*first - '0');
      index = index > (kMost - digit) / 10 ? kMost : index * 10 + digit;
    }
    return true;
  }
};
// Looks ahead whether there is one.
struct IndexAhead : Silent<IndexAhead> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    Iterator end = first;
    while (end != last && kDigit.contains(*end)) ++end;
    if (end == first) return false;
    end = skip_blanks(end, last);
    return end != last && *end == '=';
  }
};

// Looks ahead whether the word is L and such a number follows: L1=5 is no call of a subprogram.
struct NumberedLAhead : Silent<NumberedLAhead> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute& attribute) const {
    return current(context).name == "L" &&
           IndexAhead{}.parse(first, last, context, rule, attribute);
  }
};

// '=' of a word.
struct Equals : Silent<Equals> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    if (first == last || *first != '=') return false;
    current(context).has_equals = true;
    ++first;
    return true;
  }
};

// N or ':' before its number, not the beginning of a name.
struct NumberAhead : Silent<NumberAhead> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    return name_at(first, last).empty();
  }
};

}  // namespace gonogo::grammar::sinumerik
