// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of SINUMERIK that are well formed: heads, items, comments. SIE-LEX-01.
#include "tests/grammar/sinumerik_trees.hpp"

namespace gonogo::grammar {
namespace {

Block sinumerik_block(std::string_view line) {
  return parsed(Dialect::sinumerik, line);
}

TEST(SinumerikWord, ALetterAndANumberNeedNoEqualsSign) {
  EXPECT_EQ(words_of("G1 X10 Y-.5 Z+2. F100"), "G{1} X{10} Y{-0.5} Z{2} F{100}");
  EXPECT_EQ(words_of("X=10 F=100 M=3"), "X={10} F={100} M={3}");
  EXPECT_EQ(words_of("T1 D2 H12 L100 P3"), "T{1} D{2} H{12} L{100} P{3}");
}

TEST(SinumerikWord, AmpersandsAndWhatIsNotPrintedAreBlanks) {
  using namespace std::string_view_literals;
  for (const std::string_view line :
       {"G1&X10"sv, "&G1 X&10"sv, "G1\x02X10\x03"sv, "\x7FG1\0X10\x1A"sv, "G1 X=&10&"sv}) {
    EXPECT_EQ(words_of(line), line.find('=') == line.npos ? "G{1} X{10}" : "G{1} X={10}");
  }
  const Block block = sinumerik_block("N5\vG1 ; a&b\x01");
  EXPECT_EQ(block.other_blank.span, (Span{2, 3}));
  EXPECT_EQ(block.comments.at(0).text, " a&b\x01");
  // They stay in strings and comments, and part a name.
  EXPECT_EQ(sinumerik_block("MSG(\"A&B;\x01\") G1 ;&").other_blank.span, Span{});
  EXPECT_EQ(words_of("CT&X5"), "CT X{5}");
}

TEST(SinumerikWord, LettersStandInEitherCaseAndNamesAreCapitals) {
  EXPECT_EQ(words_of("g1 x10 cr=5 cIp r1=r2 Stopre"), "G{1} X{10} CR={5} CIP R1={R2} STOPRE");
  EXPECT_EQ(words_of("x=ac(sin(r1))"), "X=AC{R1 sin}");
}

TEST(SinumerikWord, EveryLetterButNIsAnAddress) {
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (letter == 'N') continue;
    const std::string name(1, letter);
    const std::string value = letter == 'R' ? "1=7" : "7";  // an R parameter is assigned to
    EXPECT_EQ(words_of(name + value), letter == 'R' ? "R1={7}" : name + "{7}");
  }
}

TEST(SinumerikWord, ALetterWithANumberAndEqualsSignHasAnIndex) {
  EXPECT_EQ(words_of("R101=5 I1=3 H5=12 S2=500 M2=3 X1=4"),
            "R101={5} I1={3} H5={12} S2={500} M2={3} X1={4}");
  EXPECT_EQ(sinumerik_block("R0=1").named[0].index, 0U);
  EXPECT_EQ(sinumerik_block("R=R").outside->name, "expression");  // no index
}

TEST(SinumerikWord, AnIndexAbove64BitsIsTheLargest) {
  EXPECT_EQ(sinumerik_block("R18446744073709551615=1").named[0].index, UINT64_MAX);
  EXPECT_EQ(sinumerik_block("R18446744073709551616=1").named[0].index, UINT64_MAX);
  EXPECT_EQ(sinumerik_block("R99999999999999999999999=1").named[0].index, UINT64_MAX);
  EXPECT_EQ(sinumerik_block("R000000000000000000000000000012=1").named[0].index, 12U);
}

TEST(SinumerikWord, NamesOfSeveralLettersTakeAValueBehindAnEqualsSign) {
  EXPECT_EQ(words_of("CR=5 AR=30 AP=45 RP=20 TURN=2 LIMS=3000"),
            "CR={5} AR={30} AP={45} RP={20} TURN={2} LIMS={3000}");
}

TEST(SinumerikWord, NamesStandAlone) {
  EXPECT_EQ(words_of("CIP"), "CIP");
  EXPECT_EQ(words_of("CT X5 LCYC75 G1 SOFT"), "CT X{5} LCYC75 G{1} SOFT");
}

TEST(SinumerikWord, NamesAreReadAsFarAsTheyGo) {
  EXPECT_EQ(words_of("CIPX10"), "CIPX10");
  EXPECT_EQ(words_of("X_1 A_B=2"), "X_1 A_B={2}");
  EXPECT_EQ(words_of("NORM"), "NORM");        // no block number
  EXPECT_EQ(words_of("RPLX=1"), "RPLX={1}");  // not RPL
  EXPECT_EQ(words_of("IFX"), "IFX");          // not IF
}

TEST(SinumerikWord, ItemsNeedNoBlankBetweenThem) {
  EXPECT_EQ(words_of("X10Y20"), "X{10} Y{20}");
  EXPECT_EQ(words_of("R125=0R126=0"), "R125={0} R126={0}");
  EXPECT_EQ(words_of("CR=5F100"), "CR={5} F{100}");
  EXPECT_EQ(words_of("G1X10CR=5"), "G{1} X{10} CR={5}");
  EXPECT_EQ(words_of("X=R1Y2CIP"), "X={R1} Y{2} CIP");
  EXPECT_EQ(words_of("X=(1)Y=SIN(2)Z3"), "X={1} Y={2 sin} Z{3}");
}

TEST(SinumerikWord, BlanksAndTabsStandBehindALetterAndRoundTheEqualsSign) {
  EXPECT_EQ(words_of(" \tX 10  Y\t=\t-5 CR = 3\t"), "X{10} Y={-5} CR={3}");
  EXPECT_EQ(words_of("R 101 = 5 I 1 =AC ( 2 )"), "R101={5} I1=AC{2}");
  EXPECT_EQ(words_of("X = ( 1 + R 2 ) * SIN ( 30 )"), "X={1 R2 + 30 sin *}");
}

TEST(SinumerikWord, AbsoluteAndIncrementalValuesBelongToPositionsAndCentres) {
  for (const char* name : {"X", "Y", "Z", "A", "C", "I", "J", "K", "I1", "J1", "K1", "AP"}) {
    EXPECT_EQ(words_of(std::string(name) + "=AC(5)"), std::string(name) + "=AC{5}");
    EXPECT_EQ(words_of(std::string(name) + "=IC(-R1)"), std::string(name) + "=IC{R1 neg}");
  }
}

TEST(SinumerikWord, ACallKeepsNothingOfItsArguments) {
  EXPECT_EQ(words_of("MSG(\"G1 X5 ; (\") X1"), "MSG() X{1}");
  EXPECT_EQ(words_of("CYCLE82(1, -2.5, (R1), , \"a\", $P)"), "CYCLE82()");
  EXPECT_EQ(words_of("MSG ( ) STOPRE"), "MSG() STOPRE");
}

TEST(SinumerikWord, RplMayLackItsEqualsSign) {
  EXPECT_EQ(words_of("G258 RPL45"), "G{258} RPL{45}");
  EXPECT_EQ(words_of("RPL -.5F3"), "RPL{-0.5} F{3}");
  EXPECT_EQ(words_of("RPL=45"), "RPL={45}");
  EXPECT_EQ(words_of("RPL"), "RPL");
}

TEST(SinumerikWord, OneAddressMayStandTwice) {  // whether that is an alarm is not for the grammar
  EXPECT_EQ(words_of("X1 X=AC(2) G1 G1"), "X{1} X=AC{2} G{1} G{1}");
}

TEST(SinumerikWord, SpansAreBytesOfTheWordWithoutBlanksBehindIt) {
  const Block block = sinumerik_block(" G1 X = R1 * 2  CIP ;c");
  ASSERT_EQ(block.named.size(), 3U);
  EXPECT_EQ(block.named[0].where, (Span{1, 3}));
  EXPECT_EQ(block.named[1].where, (Span{4, 14}));
  EXPECT_EQ(block.named[2].where, (Span{16, 19}));
  ASSERT_EQ(block.terms.size(), 4U);
  EXPECT_EQ(block.terms[1].where, (Span{8, 10}));   // R1
  EXPECT_EQ(block.terms[2].where, (Span{13, 14}));  // 2
  EXPECT_EQ(block.terms[3].where, (Span{11, 12}));  // *
}

TEST(SinumerikNumber, IsKeptAsWritten) {
  EXPECT_EQ(sinumerik_block("X1.50").terms[0].number, decimal(150, 2));
  EXPECT_EQ(sinumerik_block("X-0").terms[0].number, (Decimal{true, 0, 0, {}}));
  EXPECT_EQ(sinumerik_block("X=-0.0").terms[0].number, (Decimal{true, 1, 0, {}}));
  EXPECT_EQ(sinumerik_block("X1234567890123456789").terms[0].number,
            (Decimal{false, 0, 0, "1234567890123456789"}));
}

TEST(SinumerikHead, NOrAColonIsTheBlockNumber) {
  for (const char* line : {"N10 G0", "n10G0", "N 10 G0", ":10 G0", ": 10G0", " N0010 G0"}) {
    const Block block = sinumerik_block(line);
    EXPECT_EQ(block.sequence_number, decimal(10)) << line;
    EXPECT_EQ(short_form(block), "G{0}") << line;
  }
}

TEST(SinumerikHead, ASlashWithOrWithoutALevelAsksForSkipping) {
  for (const char* line : {"/N10 G0", "/ N10 G0", "/0N10G0", "/9 N10 G0", "/5 :10 G0"}) {
    const Block block = sinumerik_block(line);
    EXPECT_TRUE(block.skip) << line;
    EXPECT_EQ(block.sequence_number, decimal(10)) << line;
    EXPECT_EQ(short_form(block), "G{0}") << line;
  }
  EXPECT_FALSE(sinumerik_block("N10 G0").skip);
}

TEST(SinumerikHead, ALabelIsIgnored) {
  EXPECT_EQ(words_of("START: G0"), "G{0}");
  EXPECT_EQ(words_of("/N10 AB_1:X5"), "X{5}");
  EXPECT_EQ(words_of("LOOP:"), "");
  EXPECT_FALSE(sinumerik_block("LOOP: X1").outside);
  EXPECT_EQ(sinumerik_block("N10 END:").sequence_number, decimal(10));
}

TEST(SinumerikHead, ALineWithAPercentSignIsTheNameOfTheProgram) {
  Block want;
  want.tape_mark = true;
  for (const char* line : {"%", "%_N_SLOT_MPF", " % x", "%1234", "% (a) \"b"}) {
    EXPECT_EQ(sinumerik_block(line), want) << line;
  }
  want.comments = {line_comment("c")};
  EXPECT_EQ(sinumerik_block("%MPF1;c"), want);
}

TEST(SinumerikHead, NothingAndBlanksAreBlocksWithoutWords) {
  for (const char* line : {"", " \t", ";"}) EXPECT_EQ(sinumerik_block(line), Block{}) << line;
}

TEST(SinumerikComment, GoesFromASemicolonToTheEndOfTheLine) {
  const Block block = sinumerik_block("X5;(a; G1 \"");
  EXPECT_EQ(short_form(block), "X{5}");
  EXPECT_EQ(block.comments, (std::vector<Comment>{line_comment("(a; G1 \"")}));
}

TEST(SinumerikComment, AndStringsHoldEveryByte) {
  for (int value = 0; value < 256; ++value) {
    const std::string byte(1, static_cast<char>(value));
    EXPECT_EQ(sinumerik_block("X1;" + byte).comments, (std::vector<Comment>{line_comment(byte)}));
    if (byte == "\"") continue;
    EXPECT_EQ(words_of("MSG(\"" + byte + "\")X1"), "MSG() X{1}") << value;
  }
}

TEST(SinumerikBlock, AnEarlierBlockLeavesNothingBehind) {
  Block block;
  for (const char* line : {"/N1 X=R1+1 MSG(\"a\");b", "T=\"A\"", "%", "X=(1", ""}) {
    std::ignore = parse_block(Dialect::sinumerik, line, block);
  }
  EXPECT_EQ(block, Block{});
}

TEST(SinumerikPrograms, OfThePathCommandsAreRead) {
  EXPECT_EQ(words_of("N20 G3 X17.203 Y38.029 I=AC(50) J=AC(50)"),
            "G{3} X{17.203} Y{38.029} I=AC{50} J=AC{50}");
  EXPECT_EQ(words_of("N20 G3 I-17.5 J-30.211 AR=140.134 F500"),
            "G{3} I{-17.5} J{-30.211} AR={140.134} F{500}");
  EXPECT_EQ(words_of("N30 G3 RP=34.913 AP=200.052 F500"), "G{3} RP={34.913} AP={200.052} F{500}");
  EXPECT_EQ(words_of("N30 G2 X115 Y113.3 CR=-50"), "G{2} X{115} Y{113.3} CR={-50}");
}

}  // namespace
}  // namespace gonogo::grammar
