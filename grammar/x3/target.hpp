// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where parsed nodes go. A block is reused from line to line, so rules do not return containers:
// the block travels in the context, and the directives here put the attribute of their subject
// into one of its members, in place and with its span. Nothing is undone but a node that its own
// subject refused, which is all that grammars without backtracking need.
#pragma once

#include <boost/spirit/home/x3.hpp>
#include <cstdint>

#include "grammar/ast.hpp"
#include "grammar/byte_set.hpp"

namespace gonogo::grammar::x3 {

namespace spirit = boost::spirit::x3;

using Iterator = const char*;

struct Target {
  Block& block;
  Iterator line;         // first byte of the line, from which spans count
  std::size_t brackets;  // open brackets of an outside construct

  Span span(Iterator begin, Iterator end) const {
    return {static_cast<std::uint32_t>(begin - line), static_cast<std::uint32_t>(end - line)};
  }
};

struct TargetTag;

template <typename Context>
Target& target(const Context& context) {
  return spirit::get<TargetTag>(context);
}

// append<&Block::words>[word]: a new element of the list, with its span.
template <typename Subject, auto list>
struct Append : spirit::unary_parser<Subject, Append<Subject, list>> {
  using spirit::unary_parser<Subject, Append>::unary_parser;
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    Target& into = target(context);
    const Iterator begin = first;
    auto& node = (into.block.*list).emplace_back();
    if (!this->subject.parse(first, last, context, rule, node)) {
      (into.block.*list).pop_back();
      return false;
    }
    node.where = into.span(begin, first);
    return true;
  }
};

// store<&Block::sequence_number>[number]: the number of a block or a program, with its span.
template <typename Subject, auto member>
struct Store : spirit::unary_parser<Subject, Store<Subject, member>> {
  using spirit::unary_parser<Subject, Store>::unary_parser;
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    Target& into = target(context);
    const Iterator begin = first;
    auto& node = (into.block.*member).emplace();
    if (!this->subject.parse(first, last, context, rule, node)) return false;
    into.block.number_place.span = into.span(begin, first);
    return true;
  }
};

// flag<&Block::skip>[slash]: true when the subject is there.
template <typename Subject, auto member>
struct Flag : spirit::unary_parser<Subject, Flag<Subject, member>> {
  using spirit::unary_parser<Subject, Flag>::unary_parser;
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    if (!this->subject.parse(first, last, context, rule, spirit::unused)) return false;
    target(context).block.*member = true;
    return true;
  }
};

// What a construct begins with: a name, or all up to a blank.
inline std::string first_word(Iterator begin, Iterator end) {
  constexpr std::ptrdiff_t kLongest = 30;
  if (end - begin > kLongest) end = begin + kLongest;
  Iterator last = begin;
  while (last != end && (kLetter.contains(*last) || *last == '_')) ++last;
  if (last - begin < 2) {
    while (last != end && !kBlank.contains(*last)) ++last;
  }
  return {begin, last};
}

// outside<kName>[construct]: notes that the block holds a construct that is not read. Its span
// ends before trailing blanks.
template <typename Subject, const char* name>
struct Outside : spirit::unary_parser<Subject, Outside<Subject, name>> {
  using spirit::unary_parser<Subject, Outside>::unary_parser;
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    Target& into = target(context);
    const Iterator begin = first;
    if (!this->subject.parse(first, last, context, rule, spirit::unused)) return false;
    Iterator end = first;
    while (kBlank.contains(end[-1])) --end;
    into.block.outside = OutsideConstruct{name, into.span(begin, end), first_word(begin, end)};
    return true;
  }
};

template <template <typename, auto> typename Directive, auto parameter>
struct DirectiveGenerator {
  template <typename Subject>
  constexpr auto operator[](const Subject& subject) const {
    using Parser = typename spirit::extension::as_parser<Subject>::value_type;
    return Directive<Parser, parameter>(spirit::as_parser(subject));
  }
};

template <const char* name>
struct OutsideGenerator {
  template <typename Subject>
  constexpr auto operator[](const Subject& subject) const {
    using Parser = typename spirit::extension::as_parser<Subject>::value_type;
    return Outside<Parser, name>(spirit::as_parser(subject));
  }
};

template <auto list>
inline constexpr DirectiveGenerator<Append, list> append{};
template <auto member>
inline constexpr DirectiveGenerator<Store, member> store{};
template <auto member>
inline constexpr DirectiveGenerator<Flag, member> flag{};
template <const char* name>
inline constexpr OutsideGenerator<name> outside{};

}  // namespace gonogo::grammar::x3
