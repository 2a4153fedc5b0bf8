// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of letter-address programs that are well formed, and their trees; in every such dialect
// where the name does not tell.
#include "tests/grammar/trees.hpp"

namespace gonogo::grammar {
namespace {

TEST(Block, WordsStandInTheOrderWritten) {
  EXPECT_EQ(parsed("G01 X12.345 Z-6.789 F200"),
            block_of({word('G', 1), word('X', 12345, 3), word('Z', -6789, 3), word('F', 200)}));
}

TEST(Block, WordsMayRunTogether) {
  EXPECT_EQ(parsed("G90X1Z-2"), block_of({word('G', 90), word('X', 1), word('Z', -2)}));
}

TEST(Block, BlanksMayStandBetweenAddressAndNumberAndAround) {
  EXPECT_EQ(parsed(" \tX 50 Z\t-1.5  "), block_of({word('X', 50), word('Z', -15, 1)}));
}

TEST(Block, OneAddressMayStandTwice) {  // whether that is an alarm is not a matter of grammar
  EXPECT_EQ(parsed("G18 G0 X1 X2"),
            block_of({word('G', 18), word('G', 0), word('X', 1), word('X', 2)}));
}

TEST(Block, EveryCapitalButNAndOIsAnAddress) {
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (letter == 'N' || letter == 'O') continue;
    EXPECT_EQ(parsed(std::string{letter} + "7"), block_of({word(letter, 7)}));
  }
}

TEST(Block, SpansAreBytesOfTheWord) {
  const Block block = parsed(" G1 X -2.5(c)");
  ASSERT_EQ(block.words.size(), 2U);
  EXPECT_EQ(block.words[0].where, (Span{1, 3}));
  EXPECT_EQ(block.words[1].where, (Span{4, 10}));
  ASSERT_EQ(block.comments.size(), 1U);
  EXPECT_EQ(block.comments[0].where, (Span{10, 13}));
}

TEST(Block, NIsTheSequenceNumberAndNoWord) {
  Block want = block_of({word('G', 0)});
  want.sequence_number = decimal(10);
  EXPECT_EQ(parsed("N00010 G00"), want);
  EXPECT_EQ(parsed("N 10G0"), want);
}

TEST(Block, OIsTheProgramNumberAndMayCarryAComment) {
  Block want;
  want.program_number = decimal(1234);
  want.comments = {comment("O1234")};
  EXPECT_EQ(parsed(kLathes, "O1234(O1234)"), want);
}

TEST(Block, ASlashAtTheHeadAsksForSkipping) {
  Block want = block_of({word('X', 1)});
  want.skip = true;
  EXPECT_EQ(parsed("/X1"), want);
  want.sequence_number = decimal(5);
  EXPECT_EQ(parsed(" / N5 X1"), want);
}

TEST(Block, CommentsStandBesideATapeMarkAndBeforeAHead) {
  for (const Dialect dialect : {Dialect::gsk988ta, Dialect::hnc21t}) {
    for (const char* line : {"% (c)", "(c) %", "%;c", " (a) % (b) ;c"}) {
      const Block block = parsed(dialect, line);
      EXPECT_TRUE(block.tape_mark && block.words.empty()) << line;
    }
    for (const char* line : {"(c) N10 G0", "(c) / N10 G0", "/ (c) N10 G0"}) {
      const Block block = parsed(dialect, line);
      EXPECT_TRUE(block.sequence_number.has_value() && block.words.size() == 1) << line;
    }
  }
  EXPECT_TRUE(parsed(Dialect::hnc21t, "(c) % 12 G0").program_number.has_value());
}

TEST(Block, APercentSignAloneIsATapeMark) {
  Block want;
  want.tape_mark = true;
  EXPECT_EQ(parsed("%"), want);
  EXPECT_EQ(parsed("\t% "), want);
}

TEST(Block, InHncAPercentSignWithANumberIsAProgramHeadAsOIs) {
  for (const char* line : {"%1234", " % 1234 ", "O1234", "%01234"}) {
    Block want;
    want.program_number = decimal(1234);
    EXPECT_EQ(parsed(Dialect::hnc21t, line), want) << line;
  }
  for (const char* tail : {"(part)", "G90 X1;top", "#1=5"}) {
    EXPECT_EQ(parsed(Dialect::hnc21t, std::string("%7") + tail),
              parsed(kLathes, std::string("O7") + tail));
  }
}

TEST(Block, NothingAndBlanksAreBlocksWithoutWords) {
  EXPECT_EQ(parsed(""), Block{});
  EXPECT_EQ(parsed(std::string_view{}), Block{});
  EXPECT_EQ(parsed(" \t "), Block{});
  EXPECT_EQ(parsed(";"), Block{});
}

TEST(Block, AnEarlierBlockLeavesNothingBehind) {
  for (const Dialect dialect : kLetterAddress) {
    Block block;
    for (const char* line : {"/N1 G1 X1 (a) ;b", "O5 X#1", "%", ""}) {
      EXPECT_FALSE(parse_block(dialect, line, block)) << line;
    }
    EXPECT_EQ(block, Block{});
    EXPECT_TRUE(parse_block(dialect, "/N1 G1 (a) X", block));
    EXPECT_FALSE(parse_block(dialect, "X1", block));
    EXPECT_EQ(block, block_of({word('X', 1)}));
  }
}

TEST(Number, SignPointAndZerosAsWritten) {
  EXPECT_EQ(parsed("X+5").words[0].value, decimal(5));
  EXPECT_EQ(parsed("X5.").words[0].value, decimal(5));
  EXPECT_EQ(parsed("X.5").words[0].value, decimal(5, 1));
  EXPECT_EQ(parsed("X+.50").words[0].value, decimal(50, 2));
  EXPECT_EQ(parsed("X-.5").words[0].value, decimal(-5, 1));
  EXPECT_EQ(parsed("X-005.0").words[0].value, decimal(-50, 1));
  EXPECT_EQ(parsed("X0.005").words[0].value, decimal(5, 3));
  EXPECT_EQ(parsed("X0.000").words[0].value, decimal(0, 3));
}

TEST(Number, MinusZeroKeepsItsSign) {
  EXPECT_EQ(parsed("X-0").words[0].value, (Decimal{true, 0, 0, {}}));
}

TEST(Number, EighteenDigitsAreAMagnitudeAndNineteenAreText) {
  EXPECT_EQ(parsed("X999999999999.999999").words[0].value, decimal(999999999999999999, 6));
  EXPECT_EQ(parsed("X-1000000000000000000").words[0].value,
            (Decimal{true, 0, 0, "1000000000000000000"}));
  EXPECT_EQ(parsed("X1.000000000000000000").words[0].value,
            (Decimal{false, 18, 0, "1000000000000000000"}));
}

TEST(Number, LeadingZerosDoNotCountAsDigits) {
  EXPECT_EQ(parsed("X0000000000000000000000012.5").words[0].value, decimal(125, 1));
  EXPECT_EQ(parsed("X.0000000000000000000001").words[0].value, decimal(1, 22));
  EXPECT_EQ(parsed("N000000000000000000000007").sequence_number, decimal(7));
  EXPECT_EQ(parsed("X0000000000000000000000").words[0].value, decimal(0));
}

TEST(Comment, StandsAnywhereBetweenWords) {
  Block want = block_of({word('G', 1), word('X', 2)});
  want.comments = {comment("a"), comment(""), comment("b c")};
  EXPECT_EQ(parsed("(a)G1()X2 (b c)"), want);
}

TEST(Comment, EndsAtTheFirstClosingParenthesis) {
  EXPECT_EQ(parsed("(a (b)").comments[0].text, "a (b");
  EXPECT_EQ(fault(kLathes, "(a (b) c)").where.begin, 7U);         // the lower case c
  EXPECT_EQ(fault(Dialect::rs274, "(a (b) c)").where.begin, 8U);  // an address without a number
}

TEST(Comment, HoldsTextOfAnyEncoding) {
  const std::string utf8 = "\xE8\xBD\xAE\xE5\xBB\x93";  // 轮廓
  const std::string gbk = "\xC2\xD6\xC0\xAA\x81\x40";   // the same, and a trail byte of 0x40
  const std::string latin1 =
      "Z\xFC"
      "ge";
  for (const std::string& text : {utf8, gbk, latin1}) {
    EXPECT_EQ(parsed("X1(" + text + ")").comments[0].text, text);
    EXPECT_EQ(parsed("X1;" + text).comments[0].text, text);
  }
}

TEST(Comment, AfterASemicolonTheRestOfTheLineIsAComment) {
  Block want = block_of({word('G', 0)});
  EXPECT_EQ(parsed("G0;"), want);
  want.comments = {line_comment(" (open; \xFF x")};
  EXPECT_EQ(parsed("G0; (open; \xFF x"), want);
}

struct OutsideCase {
  const char* line;
  const char* name;
  std::size_t words;
  Span where;
};

void expect_outside(Dialect dialect, const std::vector<OutsideCase>& cases) {
  for (const OutsideCase& expected : cases) {
    const Block block = parsed(dialect, expected.line);
    ASSERT_TRUE(block.outside) << expected.line;
    EXPECT_EQ(block.outside->name, expected.name) << expected.line;
    EXPECT_EQ(block.outside->where, expected.where) << expected.line;
    EXPECT_EQ(block.words.size(), expected.words) << expected.line;
  }
}

TEST(Outside, ConstructsOfTheMacroLanguageAreNoted) {
  for (const Dialect dialect : kLathes) {
    expect_outside(dialect, {{"#100=5", "variable", 0, {0, 6}},
                             {"N1 #100=[#1+2]*3 ", "variable", 0, {3, 16}},
                             {"(depth) #100=5", "variable", 0, {8, 14}},
                             {"G1 X#100 Y5", "variable", 1, {3, 11}},
                             {"G1 X -#100", "variable", 1, {3, 10}},
                             {"G1 F[25.4/2] X1", "expression", 1, {3, 15}},
                             {"G1 X-[[1]+[2]];tail", "expression", 1, {3, 14}},
                             {"G90 G1 X1 Z2 F[#3]", "expression", 4, {13, 18}},
                             {"M98 P[#100]", "expression", 1, {4, 11}}});
  }
}

TEST(Outside, OfTheLathesAreControlStatements) {
  for (const Dialect dialect : kLathes) {
    expect_outside(dialect, {{"IF[#1EQ2]GOTO20", "control-statement", 0, {0, 15}},
                             {"N10 WHILE [#1 LT 5]", "control-statement", 0, {4, 19}},
                             {"ELSE", "control-statement", 0, {0, 4}},
                             {"M99 GOTO 5", "control-statement", 1, {4, 10}}});
  }
}

TEST(Block, OfRs274HaveValuesSettingsAndOWords) {
  const Block block = parsed(Dialect::rs274, "g1 x[#1 + 2] #<Depth>=-5");
  ASSERT_EQ(block.words.size(), 2U);
  EXPECT_EQ(block.words[1].terms, (TermRange{0, 4}));
  EXPECT_EQ(block.words[1].where, (Span{3, 12}));
  EXPECT_EQ(block.terms.at(1).kind, TermKind::numbered);
  EXPECT_EQ(block.terms.at(3).kind, TermKind::add);
  ASSERT_EQ(block.assignments.size(), 1U);
  EXPECT_EQ(block.assignments[0].name, "depth");
  EXPECT_EQ(block.assignments[0].value, (TermRange{4, 1}));
  const Block loop = parsed(Dialect::rs274, "N5 o<Drill> Call [1] [2]");
  ASSERT_TRUE(loop.control);
  EXPECT_EQ(loop.control->kind, ControlKind::call);
  EXPECT_EQ(loop.control->label, "<drill>");
  EXPECT_EQ(loop.control->values.size(), 2U);
  EXPECT_EQ(loop.control->where, (Span{3, 24}));
}

TEST(Outside, OfRs274AreOtherOWords) {
  expect_outside(Dialect::rs274, {{"o100 jump", "o-word", 0, {0, 9}},
                                  {"O1234 (name) G0", "o-word", 0, {0, 15}},
                                  {"N5 O1234", "o-word", 0, {3, 8}},
                                  {"(a) O1234", "o-word", 0, {4, 9}}});
}

TEST(Outside, OfRs274AreSpindles) {
  expect_outside(Dialect::rs274, {{"G33 K1 Z-5 $1", "spindle-word", 3, {11, 13}}});
}

// NGC-POL-01
TEST(Block, OfRs274HasWordsWithAnAtSignAndACaret) {
  EXPECT_EQ(parsed(Dialect::rs274, "G0 @5 ^ - 3 0.5"),
            block_of({word('G', 0), word('@', 5), word('^', -305, 1)}));
  const Block calculated = parsed(Dialect::rs274, "@[1+2]^#<a>");
  ASSERT_EQ(calculated.words.size(), 2U);
  EXPECT_EQ(calculated.words[0].address, '@');
  EXPECT_EQ(calculated.words[1].terms.count, 1U);
}

// NGC-COM-04: LinuxCNC and NIST's interpreter take `X 1 5` as X15 and `N 1 0` as N10.
TEST(Block, InRs274BlanksMeanNothingOutsideComments) {
  Block want = block_of({word('G', 1), word('X', -155, 1)});
  want.sequence_number = decimal(10);
  want.comments = {comment(" a  b ")};
  const Block block = parsed(Dialect::rs274, "N 1 0 G\t1 X - 1 5 . 5 ( a  b )");
  EXPECT_EQ(block, want);
  EXPECT_EQ(block.words[0].where, (Span{6, 9}));
  EXPECT_EQ(block.words[1].where, (Span{10, 21}));
  EXPECT_EQ(block.comments[0].where, (Span{22, 30}));
  EXPECT_EQ(block.number_place.span, (Span{2, 5}));
}

// NGC-COM-05
TEST(Block, InRs274ALineNumberMayBeTwoNumbersWithAPointBetween) {
  EXPECT_EQ(parsed(Dialect::rs274, "N56.78").sequence_number, decimal(5678, 2));
}

// NGC-COM-06
TEST(Block, InRs274OAndANumberAloneNameTheProgram) {
  for (const char* line : {"O0002 (TEXT)", "o2", " o 0 2 (a) (b) ; c", " O2;"}) {
    const Block block = parsed(Dialect::rs274, line);
    EXPECT_EQ(block.program_number->magnitude, 2U) << line;
    EXPECT_FALSE(block.outside) << line;
  }
}

TEST(Block, InRs274LettersStandInEitherCase) {
  Block want = block_of({word('G', 1), word('X', -15, 1), word('F', 200)});
  want.sequence_number = decimal(10);
  want.comments = {comment("Kept")};
  EXPECT_EQ(parsed(Dialect::rs274, "n10 g1x-1.5(Kept)f 200"), want);
  for (char letter = 'a'; letter <= 'z'; ++letter) {
    if (letter == 'n' || letter == 'o') continue;
    const char capital = static_cast<char>(letter - 'a' + 'A');
    EXPECT_EQ(parsed(Dialect::rs274, std::string{letter} + "7"), block_of({word(capital, 7)}));
  }
}

TEST(Outside, OfGskAreLoopsWithDoAndEndAndFileNames) {
  expect_outside(Dialect::gsk988ta, {{"N5 WHILE [#1 LT 5] DO1", "control-statement", 0, {3, 22}},
                                     {"END1", "control-statement", 0, {0, 4}},
                                     {"DO 1", "control-statement", 0, {0, 4}},
                                     {"THEN #1=2", "control-statement", 0, {0, 9}},
                                     {"M98 P[T123]", "file-name", 1, {4, 11}},
                                     {"M98 P[TAN[1]]", "expression", 1, {4, 13}}});
}

TEST(Outside, OfHncAreStatementsThatEndWithAWordOfTheirOwn) {
  expect_outside(Dialect::hnc21t, {{"WHILE #1 LE 5", "control-statement", 0, {0, 13}},
                                   {"N8 ENDW", "control-statement", 0, {3, 7}},
                                   {"IF [AR[#24] EQ 90] ;x", "control-statement", 0, {0, 18}},
                                   {"ENDIF (done)", "control-statement", 0, {0, 12}},
                                   {"G0 X1 ENDW", "control-statement", 2, {6, 10}},
                                   {"M98 P[T123]", "expression", 1, {4, 11}}});
}

TEST(Outside, CommentsWithinAreKept) {
  const Block block = parsed(kLathes, "X[1+(])2] (b);c");
  ASSERT_EQ(block.comments.size(), 3U);
  EXPECT_EQ(block.comments[0], comment("]"));
  EXPECT_EQ(block.comments[1], comment("b"));
  EXPECT_EQ(block.comments[2], line_comment("c"));
}

}  // namespace
}  // namespace gonogo::grammar
