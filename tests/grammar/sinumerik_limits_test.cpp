// SPDX-License-Identifier: GPL-3.0-or-later
//
// SINUMERIK: long lines, deep brackets, many words; and that a block which is reused allocates
// nothing.
#include "grammar/line_source.hpp"
#include "tests/grammar/counting_new.hpp"
#include "tests/grammar/sinumerik_trees.hpp"

namespace gonogo::grammar {
namespace {

std::string repeated(std::string_view piece, std::size_t count) {
  std::string out;
  out.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) out += piece;
  return out;
}

// As many pieces as a line can have behind `begin`.
std::string full_line(std::string_view begin, std::string_view piece) {
  return std::string(begin) + repeated(piece, (kMaximumLine - begin.size()) / piece.size());
}

constexpr std::string_view kTooDeep = "a value of at most 64 brackets in each other";

TEST(SinumerikNesting, SixtyFourBracketsAndNotOneMore) {
  const std::string deepest = "X=" + repeated("(", 64) + "1" + repeated(")", 64);
  EXPECT_EQ(words_of(deepest), "X={1}");
  const SyntaxError error =
      fault(Dialect::sinumerik, "X=" + repeated("(", 65) + "1" + repeated(")", 65));
  EXPECT_EQ(error.expected, kTooDeep);
  EXPECT_EQ(error.where, (Span{66, 67}));
}

TEST(SinumerikNesting, CountsThoseOfFunctionsAndOfAcToo) {
  EXPECT_EQ(words_of("X=AC(" + repeated("ABS(", 63) + "1" + repeated(")", 64)),
            "X=AC{1" + repeated(" abs", 63) + "}");
  EXPECT_EQ(fault(Dialect::sinumerik, "X=AC(" + repeated("ABS(", 64) + "1").expected, kTooDeep);
}

TEST(SinumerikNesting, IsOfBracketsThatAreOpenAndNotOfAllInTheLine) {
  EXPECT_EQ(words_of("X=0" + repeated("+(1)", 200)), "X={0" + repeated(" 1 +", 200) + "}");
  EXPECT_EQ(parsed(Dialect::sinumerik, repeated("X=((1))", 200)).named.size(), 200U);
}

TEST(SinumerikLimits, AMebibyteOfBracketsNeedsNoStack) {
  EXPECT_EQ(fault(Dialect::sinumerik, full_line("X=", "(")).expected, kTooDeep);
  EXPECT_EQ(fault(Dialect::sinumerik, full_line("X=", "SIN(")).expected, kTooDeep);
  EXPECT_EQ(fault(Dialect::sinumerik, full_line("X=", "-(")).expected, kTooDeep);
  EXPECT_EQ(fault(Dialect::sinumerik, full_line("X=", "[")).where.begin, 2U);
  EXPECT_EQ(fault(Dialect::sinumerik, full_line("MSG", "(")).where.begin, kMaximumLine);
  EXPECT_TRUE(parsed(Dialect::sinumerik, full_line("X=POT", "(")).outside);
  const std::size_t half = kMaximumLine / 2 - 3;
  EXPECT_EQ(words_of("MSG" + repeated("(", half) + repeated(")", half)), "MSG()");
}

TEST(SinumerikLimits, AMebibyteOfOneValueIsReadAndPrinted) {
  const std::string line = full_line("X=1", "+R1*2");
  const Block block = parsed(Dialect::sinumerik, line);
  EXPECT_EQ(block.terms.size(), 1 + 4 * ((kMaximumLine - 3) / 5));
  EXPECT_EQ(print(Dialect::sinumerik, block), line);
}

TEST(SinumerikLimits, AMebibyteOfWords) {
  EXPECT_EQ(parsed(Dialect::sinumerik, full_line("", "X1")).named.size(), kMaximumLine / 2);
  EXPECT_EQ(parsed(Dialect::sinumerik, full_line("", "R1=2")).named.size(), kMaximumLine / 4);
  EXPECT_EQ(parsed(Dialect::sinumerik, full_line("", "CT ")).named.size(), kMaximumLine / 3);
}

TEST(SinumerikLimits, AMebibyteOfOneNameOrNumberOrSign) {
  EXPECT_EQ(words_of(full_line("", "A")).size(), kMaximumLine);
  EXPECT_EQ(parsed(Dialect::sinumerik, full_line("X", "1")).terms[0].number.long_digits.size(),
            kMaximumLine - 1);
  EXPECT_EQ(fault(Dialect::sinumerik, full_line("X=", "-")).where.begin, 3U);
  EXPECT_EQ(fault(Dialect::sinumerik, full_line("R", "1")).where.begin, kMaximumLine);
}

TEST(SinumerikLimits, ABlockOfMoreThan512CharactersIsLegal) {
  EXPECT_EQ(parsed(Dialect::sinumerik, repeated("X1 ", 400)).named.size(), 400U);
}

TEST(SinumerikEveryByte, AloneInALine) {
  const std::string_view alone = " \t;%/$&";
  for (int value = 0; value < 256; ++value) {
    const std::string line(1, static_cast<char>(value));
    // SIE-LEX-01: a character that is not printed is a blank.
    const bool is_printed = value >= 32 && value != 127;
    Block block;
    const auto error = parse_block(Dialect::sinumerik, line, block);
    EXPECT_EQ(error.has_value(), is_printed && alone.find(line) == std::string_view::npos) << value;
    if (!error) continue;
    const bool lacks_number = (value | 0x20) >= 'a' && (value | 0x20) <= 'z' && value < 128;
    EXPECT_EQ(error->where.begin, lacks_number || value == ':' ? 1U : 0U) << value;
  }
}

TEST(SinumerikAllocation, ABlockThatIsReusedAllocatesNothing) {
  Block block;
  const auto run = [&block] {
    bool good = true;
    for (const char* line :
         {"N10 G01 X12.345 Z-6.789 F200", "/N20 G2 X=AC(5) Y=R1*(2+SIN(30)) CR=-5 TURN=2", "",
          "R1=5 R2=R1 STOPRE MSG(\"short\") ;tail", "%_N_PART_MPF", ":5 AB: CIP I1=IC(3)"}) {
      good = !parse_block(Dialect::sinumerik, line, block) && good;
    }
    return good;
  };
  ASSERT_TRUE(run());
  const std::size_t before = allocation_count();
  const bool good = run();
  const std::size_t after = allocation_count();
  EXPECT_TRUE(good);
  EXPECT_EQ(after - before, 0U);
}

}  // namespace
}  // namespace gonogo::grammar
