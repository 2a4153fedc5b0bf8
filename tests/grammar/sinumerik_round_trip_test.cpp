// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties of parse_block and print over generated trees and texts of SINUMERIK.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/grammar/sinumerik_trees.hpp"

namespace gonogo::grammar {
namespace {

rc::Gen<Decimal> any_sinumerik_decimal(bool negative) {
  return rc::gen::exec([negative] {
    Decimal value;
    value.negative = negative && *rc::gen::arbitrary<bool>();
    value.scale = static_cast<std::uint32_t>(*rc::gen::inRange(0, 25));
    value.magnitude = *rc::gen::inRange<std::uint64_t>(0, 1000000);
    if (*rc::gen::inRange(0, 10) == 0) {
      value.magnitude = 0;
      value.long_digits =
          "9" + std::string(static_cast<std::size_t>(*rc::gen::inRange(18, 40)), '3');
    }
    return value;
  });
}

// Appends the terms of a value in postfix order; `room` bounds its depth.
void append_value(std::vector<Term>& terms, int room) {
  const int kind = room == 0 ? *rc::gen::inRange(0, 2) : *rc::gen::inRange(0, 7);
  if (kind == 0) {
    terms.push_back({TermKind::number, *any_sinumerik_decimal(true), {}});
  } else if (kind == 1) {
    Decimal number;
    number.magnitude = *rc::gen::inRange<std::uint64_t>(0, 2000);
    terms.push_back({TermKind::parameter, number, {}});
  } else if (kind == 2) {
    append_value(terms, room - 1);
    terms.push_back({*rc::gen::element(TermKind::negate, TermKind::sin, TermKind::cos,
                                       TermKind::tan, TermKind::sqrt, TermKind::abs),
                     {},
                     {}});
  } else {
    append_value(terms, room - 1);
    append_value(terms, room - 1);
    terms.push_back(
        {*rc::gen::element(TermKind::add, TermKind::subtract, TermKind::multiply, TermKind::divide),
         {},
         {}});
  }
}

NamedWord with_value(std::string name, std::vector<Term>& terms) {
  NamedWord word;
  word.name = std::move(name);
  word.has_equals = true;
  word.first_term = static_cast<std::uint32_t>(terms.size());
  append_value(terms, 4);
  word.terms = static_cast<std::uint32_t>(terms.size()) - word.first_term;
  return word;
}

NamedWord with_constant(std::string name, std::vector<Term>& terms) {
  NamedWord word;
  word.name = std::move(name);
  word.first_term = static_cast<std::uint32_t>(terms.size());
  word.terms = 1;
  terms.push_back({TermKind::number, *any_sinumerik_decimal(true), {}});
  return word;
}

NamedWord alone(std::string name, const std::vector<Term>& terms) {
  NamedWord word;
  word.name = std::move(name);
  word.first_term = static_cast<std::uint32_t>(terms.size());
  return word;
}

NamedWord any_named_word(std::vector<Term>& terms) {
  switch (*rc::gen::inRange(0, 7)) {
    case 0:
      return with_constant(*rc::gen::element<std::string>("G", "X", "L", "E", "O", "RPL"), terms);
    case 1:
      return with_value(*rc::gen::element<std::string>("X", "F", "CR", "RPL", "LIMS"), terms);
    case 2: {
      NamedWord word = with_value(*rc::gen::element<std::string>("R", "H", "X", "I"), terms);
      word.index = *rc::gen::arbitrary<std::uint64_t>();
      return word;
    }
    case 3: {
      NamedWord word = with_value(*rc::gen::element<std::string>("Z", "AP", "I", "J"), terms);
      if (word.name == "J") word.index = 1;
      word.dimension = *rc::gen::element(Dimension::absolute, Dimension::incremental);
      return word;
    }
    case 4: {
      NamedWord word = alone(*rc::gen::element<std::string>("MSG", "CYCLE82", "POT"), terms);
      word.is_call = true;
      return word;
    }
    default:
      return alone(*rc::gen::element<std::string>("CIP", "CT", "EX", "RPL", "LCYC75", "_A", "MOD"),
                   terms);
  }
}

// A tree that a line can have. MOD behind a value is an operator, so a value is not before it.
rc::Gen<Block> any_sinumerik_block() {
  return rc::gen::exec([] {
    Block block;
    block.tape_mark = *rc::gen::weightedElement<bool>({{1, true}, {30, false}});
    if (!block.tape_mark) {
      block.skip = *rc::gen::arbitrary<bool>();
      if (*rc::gen::arbitrary<bool>()) {
        block.sequence_number.emplace().magnitude = *rc::gen::inRange<std::uint64_t>(0, 99999);
      }
      const int words = *rc::gen::inRange(0, 8);
      for (int i = 0; i < words; ++i) {
        const bool behind_value = !block.named.empty() && block.named.back().has_equals &&
                                  block.named.back().dimension == Dimension::as_in_force;
        block.named.push_back(any_named_word(block.terms));
        if (behind_value && block.named.back().name == "MOD") block.named.back().name = "CT";
      }
      const std::string outside = *rc::gen::element<std::string>(
          "", "", "", "variable", "expression", "control-statement", "string");
      if (!outside.empty()) block.outside = OutsideConstruct{outside, {}};
    }
    const std::string tail = *rc::gen::arbitrary<std::string>();
    if (!tail.empty()) block.comments.push_back(line_comment(tail));
    return block;
  });
}

// Text of a program, more often well formed than not.
rc::Gen<std::string> any_sinumerik_line() {
  const auto usual = rc::gen::element<std::string>("G1", " X10", "Y=R1*2", " CR=5", "R5=(1+2)", " ",
                                                   "I1=AC(2)", " CIP ", "F100", "MSG(\"a\")",
                                                   "Z=-SIN(30)", "+1", "*R2", " RPL45", "TURN=2");
  const auto piece = rc::gen::element<std::string>(
      "N10 ", ":5", "/", "/3", "%", "AB:", ";", "=", "(", ")", "\"", "$A", "IF", "X[1]", "EX5", "R",
      "AC(", "POT(1)", "CR5", "-", ".", "_", "\t", "x", "\xE2\x80\x93", "\xFF", "MOD", "<", ",",
      "'", "L=");
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(
                          rc::gen::weightedOneOf<std::string>({{8, usual}, {1, piece}})),
                      [](const std::vector<std::string>& pieces) {
                        std::string line;
                        for (const std::string& text : pieces) line += text;
                        return line;
                      });
}

RC_GTEST_PROP(SinumerikRoundTrip, APrintedTreeIsReadAsTheSameTree, ()) {
  const Block tree = *any_sinumerik_block();
  RC_TAG(tree.outside ? tree.outside->name : "read");
  const std::string text = print(Dialect::sinumerik, tree);
  Block again;
  const auto error = parse_block(Dialect::sinumerik, text, again);
  if (error) RC_FAIL(render(*error, text, 1, text));
  RC_LOG() << text;
  RC_ASSERT(again == tree);
}

RC_GTEST_PROP(SinumerikRoundTrip, APrintedLineIsPrintedTheSameAgain, ()) {
  const std::string line = *any_sinumerik_line();
  Block block;
  const bool good = !parse_block(Dialect::sinumerik, line, block);
  RC_PRE(good);
  const std::string once = print(Dialect::sinumerik, block);
  Block again;
  RC_ASSERT(!parse_block(Dialect::sinumerik, once, again));
  RC_ASSERT(again == block);
  RC_ASSERT(print(Dialect::sinumerik, again) == once);
}

// Words lie behind each other in the line, their terms in `terms`.
void assert_words_in_order(std::string_view line, const Block& block) {
  std::uint32_t behind = 0;
  std::uint32_t terms = 0;
  for (const NamedWord& word : block.named) {
    RC_ASSERT(word.where.begin >= behind);
    RC_ASSERT(word.where.begin < word.where.end);
    RC_ASSERT(word.first_term == terms);
    for (std::uint32_t i = 0; i < word.terms; ++i) {
      const Span where = block.terms.at(terms + i).where;
      RC_ASSERT(where.begin >= word.where.begin && where.begin < where.end &&
                where.end <= word.where.end);
    }
    behind = word.where.end;
    terms += word.terms;
  }
  if (block.outside) {
    RC_ASSERT(block.outside->where.begin >= behind);
    RC_ASSERT(block.outside->where.begin < block.outside->where.end);
    behind = block.outside->where.end;
  }
  RC_ASSERT(behind <= line.size());
  RC_ASSERT(terms == block.terms.size());
  RC_ASSERT(block.words.empty());
}

void assert_outcome_is_located(std::string_view line) {
  Block block;
  const auto error = parse_block(Dialect::sinumerik, line, block);
  RC_TAG(error ? name(error->code) : "well formed");
  if (!error) return assert_words_in_order(line, block);
  RC_ASSERT(error->where.begin <= error->where.end);
  RC_ASSERT(error->where.end <= line.size());
  RC_ASSERT(!error->expected.empty());
  const std::string picture = render(*error, "f", 1, line);
  RC_ASSERT(std::count(picture.begin(), picture.end(), '\n') == 3);
}

RC_GTEST_PROP(SinumerikOutcome, OfMostlyWellFormedTextIsLocated, ()) {
  assert_outcome_is_located(*any_sinumerik_line());
}

RC_GTEST_PROP(SinumerikOutcome, OfAnyBytesIsLocated, ()) {
  assert_outcome_is_located(*rc::gen::container<std::string>(rc::gen::arbitrary<char>()));
}

// Case and blanks between items carry no meaning.
RC_GTEST_PROP(SinumerikOutcome, OfALineInLowerCaseIsTheSameTree, ()) {
  const std::string line = *any_sinumerik_line();
  Block block;
  const bool good = !parse_block(Dialect::sinumerik, line, block);
  RC_PRE(good && line.find(';') == std::string::npos);
  std::string lower = line;
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  Block again;
  RC_ASSERT(!parse_block(Dialect::sinumerik, lower, again));
  RC_ASSERT(again == block);
}

}  // namespace
}  // namespace gonogo::grammar
