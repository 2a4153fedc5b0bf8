// SPDX-License-Identifier: GPL-3.0-or-later
//
// What SINUMERIK has and the gauge does not read: the block keeps the words before it and says
// where it begins.
#include "tests/grammar/sinumerik_trees.hpp"

namespace gonogo::grammar {
namespace {

struct SinumerikOutsideCase {
  const char* line;
  const char* name;
  const char* words;  // before it
  Span where;
};

void expect_outside(const std::vector<SinumerikOutsideCase>& cases) {
  for (const SinumerikOutsideCase& expected : cases) {
    const Block block = parsed(Dialect::sinumerik, expected.line);
    ASSERT_TRUE(block.outside) << expected.line;
    EXPECT_EQ(block.outside->name, expected.name) << expected.line;
    EXPECT_EQ(block.outside->where, expected.where) << expected.line;
    EXPECT_EQ(short_form(block), expected.words) << expected.line;
  }
}

TEST(SinumerikOutside, ExponentsAndOtherFunctionsAndOperatorsAreExpressions) {
  expect_outside({{"G1 X10EX5 Y2", "expression", "G{1}", {3, 12}},
                  {"X=1+2EX-3", "expression", "", {0, 9}},
                  {"L5EX1", "expression", "", {0, 5}},
                  {"X=1 Y=POT(2)+1 Z3", "expression", "X={1}", {4, 17}},
                  {"R1=(2*(3+ROUND(R2)", "expression", "", {0, 18}},
                  {"A=DC(90)", "expression", "", {0, 8}},
                  {"X=5 MOD 3", "expression", "", {0, 9}},
                  {"X=(R1 div R2)+1", "expression", "", {0, 15}},
                  {"R1=R2>3", "expression", "", {0, 7}},
                  {"R1=R2==3", "expression", "", {0, 8}},
                  {"X='HFF'", "expression", "", {0, 7}}});
}

TEST(SinumerikOutside, IndirectRParametersAreExpressions) {
  expect_outside({{"X1 R[R2]=5 ; c", "expression", "X{1}", {3, 10}},
                  {"R=R1", "expression", "", {0, 4}},
                  {"X=R[1]", "expression", "", {0, 6}},
                  {"X=SIN(R [1", "expression", "", {0, 10}}});
}

TEST(SinumerikOutside, VariablesAndElementsOfThem) {
  expect_outside({{"X=$AA_IM[X]", "variable", "", {0, 11}},
                  {"G0 $AC_TIMER[1]=0", "variable", "G{0}", {3, 17}},
                  {"X=DEPTH*2 Y1", "variable", "", {0, 12}},
                  {"X=-(_D)", "variable", "", {0, 7}},
                  {"FA[X]=100", "variable", "", {0, 9}},
                  {"X[1]=3", "variable", "", {0, 6}},
                  {"G[8]=1", "variable", "", {0, 6}}});
}

TEST(SinumerikOutside, StringsAsValues) {
  expect_outside({{"T=\"MILL \xC3\xA4;\" M6 ;c", "string", "", {0, 15}},
                  {"X1 T1 = \"A\"", "string", "X{1}", {3, 11}},
                  {"NAME=\"A\"", "string", "", {0, 8}}});
}

TEST(SinumerikOutside, ControlStatements) {
  for (const char* word :
       {"IF",      "ELSE",   "ENDIF", "WHILE",  "ENDWHILE", "FOR",   "ENDFOR", "LOOP",
        "ENDLOOP", "REPEAT", "UNTIL", "CASE",   "GOTO",     "GOTOF", "GOTOB",  "GOTOC",
        "GOTOS",   "DEF",    "PROC",  "EXTERN", "CALL",     "PCALL", "MCALL",  "RET"}) {
    const auto size = static_cast<std::uint32_t>(std::string_view(word).size());
    expect_outside({{word, "control-statement", "", {0, size}}});
    const std::string line = "N1 G1 " + std::string(word) + "(R1 == 1) GOTOF \"A;\" ]{!  ;c";
    const Block block = parsed(Dialect::sinumerik, line);
    EXPECT_EQ(block.outside->name, "control-statement") << line;
    EXPECT_EQ(block.outside->where, (Span{6, static_cast<std::uint32_t>(line.size() - 4)}));
    EXPECT_EQ(short_form(block), "G{1}");
    EXPECT_EQ(block.comments, (std::vector<Comment>{line_comment("c")}));
  }
}

TEST(SinumerikOutside, NothingOfItsOwnWordIsKept) {
  const Block block = parsed(Dialect::sinumerik, "R1=5 X=AC(1+R2*POT(2)) R1=6");
  EXPECT_EQ(short_form(block), "R1={5}");
  EXPECT_EQ(block.terms.size(), 1U);
}

TEST(SinumerikOutside, APrintedOneIsReadAsTheSame) {
  for (const char* line : {"G1 X=$A;c", "X=POT(1)", "T=\"A\"", "N5 GOTOF A"}) {
    const Block block = parsed(Dialect::sinumerik, line);
    EXPECT_EQ(parsed(Dialect::sinumerik, print(Dialect::sinumerik, block)), block) << line;
  }
}

}  // namespace
}  // namespace gonogo::grammar
