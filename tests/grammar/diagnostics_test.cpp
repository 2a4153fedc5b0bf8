// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines that are not well formed: the code and the place of the fault.
#include "grammar/line_source.hpp"
#include "tests/grammar/trees.hpp"

namespace gonogo::grammar {
namespace {

struct FaultCase {
  std::string line;
  SyntaxCode code;
  Span where;
};

void expect_fault(const SyntaxError& error, const FaultCase& expected) {
  EXPECT_EQ(name(error.code), name(expected.code)) << expected.line;
  EXPECT_EQ(error.where, expected.where) << expected.line;
  EXPECT_FALSE(error.expected.empty()) << expected.line;
}

// In every dialect.
void expect_faults(const std::vector<FaultCase>& cases) {
  for (const FaultCase& expected : cases) expect_fault(fault(expected.line), expected);
}
void expect_faults(Dialect dialect, const std::vector<FaultCase>& cases) {
  for (const FaultCase& expected : cases) expect_fault(fault(dialect, expected.line), expected);
}

TEST(Fault, AnAddressWithoutANumber) {
  const auto code = SyntaxCode::number_expected;
  expect_faults({{"X", code, {1, 1}},
                 {"G1 X Z5", code, {5, 6}},
                 {"X-", code, {2, 2}},
                 {"X-.", code, {3, 3}},
                 {"X.", code, {2, 2}},
                 {"X--5", code, {2, 3}},
                 {"X(c)5", code, {1, 2}},
                 {"X;5", code, {1, 2}},
                 {"X]", code, {1, 2}},
                 {"IFX1", code, {1, 2}},
                 {"X N10", code, {2, 3}},
                 {"N", code, {1, 1}},
                 {"N-5", code, {1, 2}},
                 {"N#5", code, {1, 2}}});
  for (const Dialect dialect : kLathes) {
    expect_faults(dialect, {{"O.5", code, {1, 2}}, {"X- 5", code, {2, 3}}});
  }
  expect_faults(Dialect::rs274, {{"x", code, {1, 1}},
                                 {"g1 x z5", code, {5, 6}},
                                 {"xsine[1]", code, {1, 2}},
                                 {"nx", code, {1, 2}}});
}

TEST(Fault, TheMissingNumberIsNamedAfterItsAddress) {
  for (const Dialect dialect : kLathes) {
    EXPECT_EQ(fault(dialect, "G1 X- Z5").expected, "a number after X");
  }
  EXPECT_EQ(fault(Dialect::rs274, "g1 x- z5").expected, "a number after x");
  EXPECT_EQ(fault("N G1").expected, "a whole number without a sign after N");
}

TEST(Fault, ACharacterThatMayNotStandWhereItStands) {
  const auto code = SyntaxCode::unexpected_character;
  expect_faults({{"5", code, {0, 1}},
                 {"X1.2.3", code, {4, 5}},
                 {"X5-3", code, {2, 3}},
                 {"N10.", code, {3, 4}},
                 {"N10/G1", code, {3, 4}},
                 {"//X1", code, {1, 2}},
                 {"X1)", code, {2, 3}},
                 {"G1 %", code, {3, 4}},
                 {"/%", code, {1, 2}},
                 {"[1]", code, {0, 1}}});
  for (const Dialect dialect : kLathes) {
    expect_faults(dialect,
                  {{"G1 #1=5", code, {3, 4}}, {"X5 6", code, {3, 4}}, {"N10.5", code, {3, 4}}});
  }
}

// NGC-COM-04, NGC-COM-05: the place is that of the line as it is written.
TEST(Fault, InRs274ALineIsReadWithoutItsBlanks) {
  expect_faults(Dialect::rs274, {{"G1 X- Z5", SyntaxCode::number_expected, {6, 7}},
                                 {"X 1 . 5 . 3", SyntaxCode::unexpected_character, {8, 9}},
                                 {"X 1 (a b) 5", SyntaxCode::unexpected_character, {10, 11}},
                                 {"N 1 0 . 5 . 5", SyntaxCode::unexpected_character, {10, 11}},
                                 {"N10 N20", SyntaxCode::misplaced_number_word, {4, 5}},
                                 {" X1 ( open", SyntaxCode::unclosed_comment, {4, 10}}});
}

TEST(Fault, BehindATapeMarkIsTheEndOfTheLine) {
  const auto code = SyntaxCode::unexpected_character;
  for (const Dialect dialect : kLetterAddress) {
    expect_faults(dialect, {{"%%", code, {1, 2}},
                            {"%-5", code, {1, 2}},
                            {"%O1", code, {1, 2}},
                            {" % x", code, {3, 4}}});
  }
  for (const Dialect dialect : {Dialect::gsk988ta, Dialect::rs274}) {
    expect_faults(dialect, {{"%1234", code, {1, 2}}});
    EXPECT_EQ(fault(dialect, "%G1").expected, "the end of the line after '%'");
  }
  // In RS274/NGC not even a comment.
  expect_faults(Dialect::rs274,
                {{"% (c)", code, {2, 3}}, {"%;", code, {1, 2}}, {"(c) %", code, {4, 5}}});
  EXPECT_EQ(fault(Dialect::hnc21t, "%G1").expected,
            "a program number or the end of the line after '%'");
}

TEST(Fault, InHncAProgramHeadWithAPercentSignStandsFirstAndIsWhole) {
  const auto code = SyntaxCode::unexpected_character;
  expect_faults(Dialect::hnc21t, {{"/%1", code, {1, 2}},
                                  {"G1 %1", code, {3, 4}},
                                  {"%1.5", code, {2, 3}},
                                  {"%1 2", code, {3, 4}},
                                  {"%1 %", code, {3, 4}},
                                  {"%1 N2", SyntaxCode::misplaced_number_word, {3, 4}},
                                  {"%1 O2", SyntaxCode::misplaced_number_word, {3, 4}},
                                  {"%1 X", SyntaxCode::number_expected, {4, 4}}});
}

TEST(Fault, AKeywordOfTheOtherMakerIsAnAddressWithoutANumber) {
  const auto code = SyntaxCode::number_expected;
  expect_faults(Dialect::gsk988ta, {{"ENDW", code, {1, 2}}, {"ENDIF", code, {1, 2}}});
  expect_faults(Dialect::hnc21t, {{"END1", code, {1, 2}}, {"DO 1", code, {1, 2}}});
}

TEST(Fault, ACharacterThatNoBlockHas) {
  const auto code = SyntaxCode::unexpected_character;
  expect_faults({{"X=5", code, {1, 2}},
                 {"X1,", code, {2, 3}},
                 {"$", code, {0, 1}},
                 {"X\x01", code, {1, 2}},
                 {std::string("G1\0X1", 5), code, {2, 3}},
                 {"G1\nX1", code, {2, 3}},
                 {"G1\xA0X1", code, {2, 3}},      // Latin-1 no-break space
                 {"G1\xC2\xA0X1", code, {2, 4}},  // the same in UTF-8
                 {"X\xFF"
                  "5",
                  code,
                  {1, 2}},
                 {"X1 \xE8\xBD\xAE", code, {3, 6}},     // 轮
                 {"X1 \xE8\xBD", code, {3, 4}},         // cut short: not UTF-8
                 {"X1\xC0\xAF", code, {2, 3}},          // an overlong '/'
                 {"X1\xED\xA0\x80", code, {2, 3}},      // a surrogate
                 {"X1\xE0\x80\xAF", code, {2, 3}},      // '/' in three bytes
                 {"X1\xF4\x90\x80\x80", code, {2, 3}},  // above U+10FFFF
                 {"X1\xF9\x80\x80\x80", code, {2, 3}},  // no such first byte
                 {"X1\xF0\x9F\x94\xA7", code, {2, 6}}});
}

TEST(Fault, LowerCaseAsksForTheCapitalLetter) {
  for (const char* line : {"g1", "Xx", "X1 z5", "X[sin[1]]"}) {
    const SyntaxError error = fault(kLathes, line);
    EXPECT_EQ(error.code, SyntaxCode::unexpected_character) << line;
    EXPECT_NE(error.expected.find("capital letter"), std::string::npos) << line;
  }
  EXPECT_NE(fault(kLathes, "X1 z5").expected.find("'Z'"), std::string::npos);
  EXPECT_EQ(fault(kLathes, "X1 z5").where, (Span{3, 4}));
}

struct LookalikeCase {
  std::string line;
  const char* ascii;
  Span where;
};

TEST(Fault, ALookalikeNamesTheAsciiCharacterThatIsMeant) {
  const LookalikeCase cases[] = {
      {"I\xE2\x80\x93"
       "17.5",
       "'-'",
       {1, 4}},  // en dash
      {"X\xE2\x88\x92"
       "5",
       "'-'",
       {1, 4}},                          // U+2212
      {"X\xEF\xBC\x95", "'5'", {1, 4}},  // fullwidth 5
      {"\xEF\xBC\xB8"
       "5",
       "'X'",
       {0, 3}},  // fullwidth X
      {"\xEF\xBD\x98"
       "5",
       "'X'",
       {0, 3}},                           // fullwidth x
      {"X5\xEF\xBC\x9B", "';'", {2, 5}},  // fullwidth semicolon
      {"\xEF\xBC\x88"
       "c)",
       "'('",
       {0, 3}},  // fullwidth parenthesis
      {"X1 \xD0\x95"
       "30",
       "'E'",
       {3, 5}},                                 // Cyrillic
      {"X1\xE3\x80\x80Z2", "a blank", {2, 5}},  // ideographic space
      {"X1\xC2\xA0Z2", "a blank", {2, 4}},      // no-break space
      {"\xE2\x80\x9CX1", "'\"'", {0, 3}},       // curly quote
      {"X5\xA3\xBB", "';'", {2, 3}},            // fullwidth semicolon in GBK
  };
  for (const LookalikeCase& expected : cases) {
    const SyntaxError error = fault(expected.line);
    EXPECT_EQ(error.code, SyntaxCode::unexpected_character) << expected.line;
    EXPECT_EQ(error.where, expected.where) << expected.line;
    EXPECT_EQ(error.expected.find(expected.ascii), 0U) << expected.line << ": " << error.expected;
  }
}

TEST(Fault, AByteOrderMarkIsCalledByItsName) {
  EXPECT_NE(fault("\xEF\xBB\xBFG1").expected.find("byte order mark"), std::string::npos);
}

TEST(Fault, AnUnclosedCommentSpansTheRestOfTheLine) {
  const auto code = SyntaxCode::unclosed_comment;
  expect_faults({{"(", code, {0, 1}},
                 {"G1 (a X1", code, {3, 8}},
                 {"(a) (b;)(", code, {8, 9}}});
  for (const Dialect dialect : kLathes) expect_faults(dialect, {{"X[1 (a]", code, {4, 7}}});
}

TEST(Fault, NumberWordsBehindTheHead) {
  const auto code = SyntaxCode::misplaced_number_word;
  expect_faults({{"G1 N10", code, {3, 4}}, {"N1 N2", code, {3, 4}}});
  for (const Dialect dialect : kLathes) {
    expect_faults(dialect,
                  {{"X1O5", code, {2, 3}}, {"N1 O2", code, {3, 4}}, {"O2 N1", code, {3, 4}}});
  }
  expect_faults(Dialect::rs274,
                {{"g1 n10", code, {3, 4}}, {"(c) N1", code, {4, 5}}, {"/(c) N1", code, {5, 6}}});
}

TEST(Fault, OutsideConstructsCloseTheirBrackets) {
  const auto code = SyntaxCode::unexpected_character;
  expect_faults({{"X[1", code, {3, 3}},
                 {"X[1;]", code, {3, 4}},
                 {"X[[1]", code, {5, 5}},
                 {"X[1]]", code, {4, 5}},
                 {"#1=5]", code, {4, 5}},
                 {"#1=\xE2\x88\x92"
                  "5",
                  code,
                  {3, 6}}});
  for (const Dialect dialect : kLathes) expect_faults(dialect, {{"#1=(a))", code, {6, 7}}});
  EXPECT_EQ(fault("X[1").expected, "']'");
}

TEST(Fault, ALineAboveTheLimit) {
  const std::string line(kMaximumLine + 1, ' ');
  const SyntaxError error = fault(line);
  EXPECT_EQ(error.code, SyntaxCode::line_too_long);
  EXPECT_EQ(error, line_too_long());
  EXPECT_EQ(parsed(std::string_view(line).substr(1)), Block{});
}

TEST(Message, NamesAreStable) {
  EXPECT_EQ(name(SyntaxCode::unexpected_character), "unexpected-character");
  EXPECT_EQ(name(SyntaxCode::number_expected), "number-expected");
  EXPECT_EQ(name(SyntaxCode::unclosed_comment), "unclosed-comment");
  EXPECT_EQ(name(SyntaxCode::misplaced_number_word), "misplaced-number-word");
  EXPECT_EQ(name(SyntaxCode::line_too_long), "line-too-long");
  EXPECT_EQ(name(SyntaxCode::nested_too_deep), "nested-too-deep");
}

TEST(Message, IsAWholeSentenceWithWhatWasExpected) {
  const std::string text = message(fault("G1 X Z5"));
  EXPECT_NE(text.find("a number after X"), std::string::npos);
  EXPECT_EQ(text.back(), '.');
}

}  // namespace
}  // namespace gonogo::grammar
