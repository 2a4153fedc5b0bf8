// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of SINUMERIK in postfix order, and the brackets of their printed text. SIE-LEX-01.
#include "tests/grammar/sinumerik_trees.hpp"

namespace gonogo::grammar {
namespace {

std::string value_of(std::string_view text) {
  return words_of("X=" + std::string(text));
}

std::string printed(std::string_view text) {
  return print(Dialect::sinumerik, parsed(Dialect::sinumerik, "X=" + std::string(text)));
}

TEST(SinumerikValue, ProductsBindMoreTightlyThanSums) {
  EXPECT_EQ(value_of("1+2*3"), "X={1 2 3 * +}");
  EXPECT_EQ(value_of("1*2+3"), "X={1 2 * 3 +}");
  EXPECT_EQ(value_of("1-2/3-4"), "X={1 2 3 / - 4 -}");
}

TEST(SinumerikValue, EqualOperatorsActFromLeftToRight) {
  EXPECT_EQ(value_of("1-2-3+4"), "X={1 2 - 3 - 4 +}");
  EXPECT_EQ(value_of("1/2/3*4"), "X={1 2 / 3 / 4 *}");
}

TEST(SinumerikValue, BracketsComeFirst) {
  EXPECT_EQ(value_of("(1+2)*3"), "X={1 2 + 3 *}");
  EXPECT_EQ(value_of("1-(2-3)"), "X={1 2 3 - -}");
  EXPECT_EQ(value_of("((7))"), "X={7}");
}

TEST(SinumerikValue, ASignBelongsToTheOperandBehindIt) {
  EXPECT_EQ(value_of("-R1*2"), "X={R1 neg 2 *}");
  EXPECT_EQ(value_of("-(1+2)"), "X={1 2 + neg}");
  EXPECT_EQ(value_of("-SIN(30)"), "X={30 sin neg}");
  EXPECT_EQ(value_of("+R1-+R2"), "X={R1 R2 -}");
  EXPECT_EQ(value_of("2*-R1"), "X={2 R1 neg *}");
}

TEST(SinumerikValue, ASignOfANumberIsPartOfIt) {
  EXPECT_EQ(value_of("-5"), "X={-5}");
  EXPECT_EQ(value_of("- 5"), "X={-5}");
  EXPECT_EQ(value_of("5--3"), "X={5 -3 -}");
  EXPECT_EQ(value_of("5-3"), "X={5 3 -}");
  EXPECT_EQ(value_of("-(5)"), "X={5 neg}");
}

TEST(SinumerikValue, FunctionsTakeTheirBracket) {
  EXPECT_EQ(value_of("SIN(1)+COS(2)*TAN(3)"), "X={1 sin 2 cos 3 tan * +}");
  EXPECT_EQ(value_of("SQRT(R1*R1+R2*R2)"), "X={R1 R1 * R2 R2 * + sqrt}");
  EXPECT_EQ(value_of("abs( sqrt (2) )"), "X={2 sqrt abs}");
}

TEST(SinumerikValue, RParametersAreReadByTheirNumber) {
  EXPECT_EQ(value_of("R0+R 999"), "X={R0 R999 +}");
  EXPECT_EQ(value_of("R1000000"), "X={R1000000}");  // whether there is one is not for the grammar
}

TEST(SinumerikValue, EachWordHasItsTerms) {
  const Block block = parsed(Dialect::sinumerik, "R1=2+3 X=R1 CIP Y=IC(4)");
  ASSERT_EQ(block.named.size(), 4U);
  EXPECT_EQ(block.terms.size(), 5U);
  EXPECT_EQ(block.named[1].first_term, 3U);
  EXPECT_EQ(block.named[2].terms, 0U);
  EXPECT_EQ(block.named[3].first_term, 4U);
}

TEST(SinumerikPrint, WritesTheFewestBrackets) {
  EXPECT_EQ(printed("((1+2)*3)"), "X=(1+2)*3");
  EXPECT_EQ(printed("(1*2)*3"), "X=1*2*3");
  EXPECT_EQ(printed("1*(2*3)"), "X=1*(2*3)");
  EXPECT_EQ(printed("(1-2)-3"), "X=1-2-3");
  EXPECT_EQ(printed("1-(2-3)"), "X=1-(2-3)");
  EXPECT_EQ(printed("1+(2*3)"), "X=1+2*3");
  EXPECT_EQ(printed("SIN((1+2))"), "X=SIN(1+2)");
  EXPECT_EQ(printed("- R1"), "X=-R1");
  EXPECT_EQ(printed("-(5)"), "X=-(5)");  // without them the sign would be the number's
  EXPECT_EQ(printed("-(-(R1))"), "X=-(-R1)");
  EXPECT_EQ(printed("2*(-3)"), "X=2*-3");
}

TEST(SinumerikPrint, WritesWordsInTheirOrder) {
  const Block block = parsed(Dialect::sinumerik, "/3:10 AB: g1x.5i1=ac(2)r5=1cip msg(\"a\");b");
  EXPECT_EQ(print(Dialect::sinumerik, block), "/N10 G1 X0.5 I1=AC(2) R5=1 CIP MSG();b");
}

}  // namespace
}  // namespace gonogo::grammar
