// SPDX-License-Identifier: GPL-3.0-or-later
//
// SINUMERIK: words of a block, calls and what the gauge does not read.
#pragma once

#include "grammar/x3/sinumerik_values.hpp"

namespace gonogo::grammar::sinumerik {

inline constexpr char kString[] = "string";

// word_item[subject]: a new word with its span, which ends before trailing blanks. A word that
// turns out to hold an outside construct is taken back, and the construct begins where it began.
template <typename Subject>
struct WordItem : spirit::unary_parser<Subject, WordItem<Subject>> {
  using spirit::unary_parser<Subject, WordItem>::unary_parser;
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    Target& into = target(context);
    Block& block = into.block;
    const Iterator begin = first;
    const std::size_t terms = block.terms.size();
    block.named.emplace_back().first_term = static_cast<std::uint32_t>(terms);
    const bool met = this->subject.parse(first, last, context, rule, spirit::unused);
    if (!met || block.outside) {
      block.named.pop_back();
      block.terms.erase(block.terms.begin() + static_cast<std::ptrdiff_t>(terms),
                        block.terms.end());
      if (met) block.outside->where.begin = into.span(begin, begin).begin;
      return met;
    }
    NamedWord& word = block.named.back();
    word.terms = static_cast<std::uint32_t>(block.terms.size() - terms);
    Iterator end = first;
    while (kBlank.contains(end[-1])) --end;
    word.where = into.span(begin, end);
    return true;
  }
};

inline constexpr PlainGenerator<WordItem> word_item{};

// '(' behind a name: a call, whose arguments follow.
struct Call : Silent<Call> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    if (first == last || *first != '(') return false;
    current(context).is_call = true;
    target(context).brackets = 0;
    ++first;
    return true;
  }
};

// Arguments up to the next string or the bracket that closes the call. Brackets are counted
// without recursion, so that a line full of them cannot exhaust the stack.
struct Arguments : Silent<Arguments> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    std::size_t& brackets = target(context).brackets;
    const Iterator begin = first;
    for (; first != last && kRest.contains(*first); ++first) {
      if (*first == '(') ++brackets;
      if (*first != ')') continue;
      if (brackets == 0) break;
      --brackets;
    }
    return first != begin;
  }
};

// An outside construct has been noted: the rest of the line has been skipped.
struct Noted : Silent<Noted> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator&, const Iterator&, const Context& context, RuleContext&, Attribute&) const {
    return target(context).block.outside.has_value();
  }
};

}  // namespace gonogo::grammar::sinumerik
