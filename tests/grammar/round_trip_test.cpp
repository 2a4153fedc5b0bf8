// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties of parse_block and print over generated trees and texts of letter-address programs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cctype>

#include "tests/grammar/trees.hpp"

namespace gonogo::grammar {

// For counterexamples.
void showValue(const Block& block, std::ostream& out) {
  out << '"';
  PrintTo(block, &out);
  out << '"';
}

namespace {

rc::Gen<std::string> digits_without_leading_zero(int least, int most) {
  return rc::gen::exec([=] {
    const int size = *rc::gen::inRange(least, most + 1);
    std::string digits(1, *rc::gen::inRange('1', static_cast<char>('9' + 1)));
    while (static_cast<int>(digits.size()) < size) {
      digits.push_back(*rc::gen::inRange('0', static_cast<char>('9' + 1)));
    }
    return digits;
  });
}

// Numbers of every size: zero, short ones, the borders at 18 digits, long ones; any scale.
rc::Gen<Decimal> any_decimal(bool whole) {
  return rc::gen::exec([whole] {
    Decimal value;
    if (!whole) {
      value.negative = *rc::gen::arbitrary<bool>();
      value.scale = static_cast<std::uint32_t>(*rc::gen::inRange(0, 30));
    }
    const int kind = *rc::gen::inRange(0, 4);
    if (kind == 1) value.magnitude = *rc::gen::inRange<std::uint64_t>(1, 1000000);
    if (kind == 2) value.magnitude = std::stoull(*digits_without_leading_zero(15, 18));
    if (kind == 3) value.long_digits = *digits_without_leading_zero(19, 60);
    return value;
  });
}

rc::Gen<Word> any_word() {
  return rc::gen::exec([] {
    const char address = *rc::gen::suchThat(rc::gen::inRange('A', static_cast<char>('Z' + 1)),
                                            [](char c) { return c != 'N' && c != 'O'; });
    return Word{address, *any_decimal(false), {}};
  });
}

rc::Gen<Comment> any_comment() {
  const auto byte = rc::gen::suchThat(rc::gen::arbitrary<char>(), [](char c) { return c != ')'; });
  return rc::gen::map(rc::gen::container<std::string>(byte), [](std::string text) {
    return Comment{std::move(text), false, {}};
  });
}

rc::Gen<Dialect> any_dialect() {
  return rc::gen::elementOf(
      std::vector<Dialect>(std::begin(kLetterAddress), std::end(kLetterAddress)));
}

// A tree that lines of the dialect can have.
rc::Gen<Block> any_block(Dialect dialect) {
  return rc::gen::exec([dialect] {
    Block block;
    block.tape_mark = *rc::gen::weightedElement<bool>({{1, true}, {30, false}});
    if (block.tape_mark) return block;
    block.skip = *rc::gen::arbitrary<bool>();
    const int head = *rc::gen::inRange(0, 3);
    if (head == 1) block.sequence_number = *any_decimal(true);
    if (head == 2 && dialect != Dialect::rs274) block.program_number = *any_decimal(true);
    block.words = *rc::gen::container<std::vector<Word>>(any_word());
    block.comments = *rc::gen::container<std::vector<Comment>>(any_comment());
    std::vector<std::string> constructs{"", "", ""};
    if (dialect == Dialect::rs274) {
      constructs.emplace_back("o-word");
    } else {
      constructs.insert(constructs.end(), {"variable", "expression", "control-statement"});
    }
    if (dialect == Dialect::gsk988ta) constructs.push_back("file-name");
    if (dialect == Dialect::rs274) constructs.emplace_back("spindle-word");
    const std::string outside = *rc::gen::elementOf(constructs);
    if (!outside.empty()) block.outside = OutsideConstruct{outside, {}};
    const std::string tail = *rc::gen::arbitrary<std::string>();
    if (!tail.empty()) block.comments.push_back(line_comment(tail));
    return block;
  });
}

// Text of a program, more often well formed than not.
rc::Gen<std::string> any_line() {
  const auto piece = rc::gen::element<std::string>(
      "G1", "G 90", "X-1.50", "Z+.5", "F200.", " ", "\t", "(c)", "(\xD6\xD0)", "N10 ", "O7", "/",
      "%", "%12 ", ";", "-", "5", "X", ".", "X#1", "F[1/2]", "#2=3", "IF", "ENDW", "P[T1]", "]",
      "x", "\xE2\x88\x92", "(", "g0", "o1 sub", "Ysin[1]", "x#<a>", "#<b>=[1+2]", "z[#1 mod 2]",
      "o2 while [1 le 2]", "x-[1**2--3]", "yatan[1]/[2]", "o<c> call [1] [#2]", "g[exists[#<a>]+1]",
      "@2.5", "^[360/7]");
  const auto usual = rc::gen::element<std::string>("G1", "G 90", "X-1.50", "Z+.5", "F200.", " ",
                                                   "(c)", "X 00012.", "D99999999999999999999");
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(
                          rc::gen::weightedOneOf<std::string>({{12, usual}, {1, piece}})),
                      [](const std::vector<std::string>& pieces) {
                        std::string line;
                        for (const std::string& text : pieces) line += text;
                        return line;
                      });
}

std::string printed(const Decimal& value) {
  std::string out;
  print(value, out);
  return out;
}

TEST(Print, DecimalsKeepWhatWasWritten) {
  EXPECT_EQ(printed(decimal(-1250, 2)), "-12.50");
  EXPECT_EQ(printed(decimal(5, 1)), "0.5");
  EXPECT_EQ(printed(decimal(5, 3)), "0.005");
  EXPECT_EQ(printed(decimal(0, 2)), "0.00");
  EXPECT_EQ(printed(Decimal{true, 0, 0, {}}), "-0");
  EXPECT_EQ(printed(Decimal{false, 19, 0, "1234567890123456789"}), "0.1234567890123456789");
}

TEST(Print, AProgramNumberIsAnO) {
  EXPECT_EQ(print(parsed(Dialect::hnc21t, "%1234(a)")), "O1234 (a)");
}

TEST(Print, WordsComeBeforeComments) {
  EXPECT_EQ(print(parsed("/ N10(a)G1(b)X.5 ;c")), "/N10 G1 X0.5 (a) (b);c");
  EXPECT_EQ(print(parsed(kLathes, "O7 X#1*2")), "O7 X#1");
  EXPECT_EQ(print(parsed(Dialect::rs274, "n7 o<hole> call")), "N7 O<hole> call");
  EXPECT_EQ(print(parsed(" % ")), "%");
}

RC_GTEST_PROP(RoundTrip, APrintedTreeIsReadAsTheSameTree, ()) {
  const Dialect dialect = *any_dialect();
  const Block tree = *any_block(dialect);
  RC_TAG(std::string(name(dialect)));
  RC_TAG(tree.outside ? tree.outside->name : "read");
  const std::string text = print(tree);
  Block again;
  const auto error = parse_block(dialect, text, again);
  if (error) RC_FAIL(render(*error, text, 1, text));
  RC_ASSERT(again == tree);
}

RC_GTEST_PROP(RoundTrip, APrintedLineIsPrintedTheSameAgain, ()) {
  const Dialect dialect = *any_dialect();
  const std::string line = *any_line();
  Block block;
  const bool good = !parse_block(dialect, line, block);
  RC_PRE(good);
  const std::string once = print(block);
  Block again;
  RC_ASSERT(!parse_block(dialect, once, again));
  RC_ASSERT(again == block);
  RC_ASSERT(print(again) == once);
}

// Spans lie in the line; a word's span begins at its address and stands behind the one before.
void assert_spans_in_order(std::string_view line, const Block& block) {
  std::uint32_t behind = 0;
  for (const Word& word : block.words) {
    RC_ASSERT(word.where.begin >= behind);
    RC_ASSERT(word.where.begin < word.where.end);
    RC_ASSERT(std::toupper(line[word.where.begin]) == word.address);
    behind = word.where.end;
  }
  RC_ASSERT(behind <= line.size());
}

void assert_outcome_is_located(Dialect dialect, std::string_view line) {
  Block block;
  const auto error = parse_block(dialect, line, block);
  RC_TAG(error ? name(error->code) : "well formed");
  if (!error) return assert_spans_in_order(line, block);
  RC_ASSERT(error->where.begin <= error->where.end);
  RC_ASSERT(error->where.end <= line.size());
  RC_ASSERT(!error->expected.empty());
  const std::string picture = render(*error, "f", 1, line);
  RC_ASSERT(std::count(picture.begin(), picture.end(), '\n') == 3);
}

RC_GTEST_PROP(Outcome, OfMostlyWellFormedTextIsLocated, ()) {
  const Dialect dialect = *any_dialect();
  assert_outcome_is_located(dialect, *any_line());
}

RC_GTEST_PROP(Outcome, OfAnyBytesIsLocated, ()) {
  const Dialect dialect = *any_dialect();
  assert_outcome_is_located(dialect, *rc::gen::container<std::string>(rc::gen::arbitrary<char>()));
}

// What stands before a fault does not depend on what stands behind it.
RC_GTEST_PROP(Outcome, AFaultInTheMiddleStaysWhenTheRestOfTheLineChanges, ()) {
  const Dialect dialect = *any_dialect();
  const std::string line = *any_line();
  const std::string tail = *any_line();
  Block block;
  const auto error = parse_block(dialect, line, block);
  RC_PRE(error.has_value() && error->where.end < line.size());
  const auto longer = parse_block(dialect, line + tail, block);
  RC_ASSERT(longer == error);
}

}  // namespace
}  // namespace gonogo::grammar
