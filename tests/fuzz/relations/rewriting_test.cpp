// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PROP-11: programs in another unit, in another plane, by increments, in halves, and
// a block for each hole.
#include <gtest/gtest.h>

#include "related.hpp"
#include "fuzz/relations/related_lines.hpp"

namespace gonogo::relations::testing {
namespace {

std::string text_of(const std::optional<Related>& related) {
  return related ? related->program.text : "none";
}

// J-PROP-11: 1 inch is 127/5 = 25.4 mm; 2.54 mm is 0.1 inch.
TEST(Units, ConvertLengthsAndFeeds) {
  EXPECT_EQ(text_of(in_other_unit(program_of("rs274", "G20\nG1 X1 Y-.5 F10\nG4 P2\n"))),
            "G21\nG21\nG1 X25.4 Y-12.7 F254\nG4 P2\n");
  EXPECT_EQ(text_of(in_other_unit(program_of("gsk988ta", "G01 X2.54 W-25.4 F254\n"))),
            "G20\nG01 X0.1 W-1 F10\n");
}

TEST(Units, LeaveAloneWhatHasTooManyDecimals) {
  // 1 mm is 5/127 inch, which no decimal says; 0.0001 inch is 0.00254 mm.
  EXPECT_EQ(text_of(in_other_unit(program_of("rs274", "G0 X1\n"))), "none");
  EXPECT_EQ(text_of(in_other_unit(program_of("gsk988ta", "G20\nG00 X.0001\n"))), "none");
}

TEST(Units, LeaveAloneWhatAReadingDecides) {
  // F under G70 (sie.g70.f) stays, and feeds are not compared.
  const auto sinumerik = in_other_unit(program_of("sinumerik840d", "G70\nG1 X1 F100\n"));
  EXPECT_EQ(text_of(sinumerik), "G71\nG71\nG1 X25.4 F100\n");
  EXPECT_EQ(sinumerik->feeds, Feeds::any);
  // F beside the code that changes its unit, two units, the lead of a thread of the HNC-21T.
  EXPECT_EQ(text_of(in_other_unit(program_of("rs274", "G20 G1 X1 F10\n"))), "none");
  EXPECT_EQ(text_of(in_other_unit(program_of("rs274", "G0 X127\nG20\nX1\n"))), "none");
  EXPECT_EQ(text_of(in_other_unit(program_of("hnc21t", "G20\nG32 Z-1 F1\n"))), "none");
}

TEST(Units, MakeASimilarPartOfTheSameNumbers) {
  const auto related = same_numbers(program_of("rs274", "G0 X1.5\n"));
  EXPECT_EQ(text_of(related), "G20\nG0 X1.5\n");
  EXPECT_EQ(related->scale, Number(127) / 5);
}

// J-PROP-11: X to Y, Y to Z, Z to X; so G17 to G19, and G18 to G17.
TEST(Planes, ChangeInACycle) {
  EXPECT_EQ(text_of(in_other_plane(program_of("rs274", "G17 G2 X1 Y2 I3 J4 Z5 F9\n"), 1)),
            "G19\nG19 G2 Y1 Z2 J3 K4 X5 F9\n");
  EXPECT_EQ(text_of(in_other_plane(program_of("rs274", "G18 G2 X1 R4 F9\n"), 2)),
            "G18\nG19 G2 Z1 R4 F9\n");
}

// X of the GSK is a diameter: 10 on X is 5 on Y, and 3 on Z is 6 on X.
TEST(Planes, ChangeDiametersIntoRadii) {
  EXPECT_EQ(text_of(in_other_plane(program_of("gsk988ta", "G00 X10 W3\nG04 X2\n"), 1)),
            "G17\nG00 Y5 U6\nG04 X2\n");
}

TEST(Planes, LeaveAloneWhatKnowsAxesByTheirNames) {
  EXPECT_EQ(text_of(in_other_plane(program_of("hnc21t", "G00 X10\n"), 1)), "none");
  EXPECT_EQ(text_of(in_other_plane(program_of("rs274", "G18 G76 P1 Z-9 I-1 J1 K2\n"), 1)), "none");
}

// J-PROP-11
TEST(Increments, AreTheWaysFromWordToWord) {
  EXPECT_EQ(text_of(by_increments(program_of("gsk988ta", "G00 X10 Z5\nG01 X4 Z-2.5 F9\n"), 0)),
            "G00 U10 W5\nG01 U-6 W-7.5 F9\n");
  EXPECT_EQ(text_of(by_increments(program_of("rs274", "G0 X10\nX4 Z1\n"), 0)),
            "G91\nG0 X10\nG90\nG91\nX-6 Z1\n");
}

// Where the tool stands after a cycle, a dwell under which coordinates change, or IC( is not said.
TEST(Increments, AreLeftWhereThePlaceIsNotSaid) {
  EXPECT_EQ(text_of(by_increments(program_of("gsk988ta", "G50 X9\nG00 X10\nX4\n"), 0)),
            "G50 X9\nG00 X10\nU-6\n");
  EXPECT_EQ(text_of(by_increments(program_of("sinumerik840d", "G0 X=IC(2)\nX4\nX5\n"), 0)),
            "G0 X=IC(2)\nX4\nG91\nX1\n");
}

// J-PROP-11
TEST(Halves, OfAFeedEndInItsMiddle) {
  const auto related = in_halves(program_of("rs274", "G0 X10\nG1 X4 Z-1 F9\nG91 X3\nX.5\n"));
  EXPECT_EQ(text_of(related),
            "G0 X5\nG0 X10\nG1 X7 Z-0.5 F9\nG1 X4 Z-1\nG91 X1.5\nG1 X1.5\nX0.25\nG1 X0.25\n");
  EXPECT_EQ(related->lines, (std::vector<std::uint64_t>{1, 3, 5, 7}));
  EXPECT_EQ(related->counts_as, (std::vector<std::uint64_t>{1, 1, 3, 3, 5, 5, 7, 7}));
}

TEST(Halves, AreNotMadeOfTraversesAlongTwoAxes) {
  EXPECT_EQ(text_of(in_halves(program_of("rs274", "G0 X10 Y10\n"))), "none");
}

// From (0, 0): the record to (7, 0) has (3.5, 0) before it, and nothing else will do.
TEST(Halves, HaveToEndInTheMiddle) {
  const generate::GeneratedProgram program = program_of("rs274", "G1 X7 F9\nM2\n");
  const Related related = in_halves(program).value();
  const auto run = [](const generate::GeneratedProgram& one) {
    return trace_of(oracle::run_reference(one.profile, one.text, 10));
  };
  const Trace first = run(program);
  EXPECT_FALSE(first_difference(first, run(related.program), related, 0));
  EXPECT_TRUE(
      first_difference(first, run(program_of("rs274", "G1 X3 F9\nG1 X7\nM2\n")), related, 0));
  EXPECT_TRUE(first_difference(first, first, related, 0));
}

// J-PROP-11
TEST(Repeats, AreABlockForEachHole) {
  EXPECT_EQ(text_of(unrolled(program_of("rs274", "G98\nG91 G81 X1 R-2 Z-3 L2 F9\nM2\n"))),
            "G98\nG91 G81 X1 R-2 Z-3 F9\nG91 G81 X1 R-2 Z-3 F9\nM2\n");
}

// Under G99, from above R, in a series, of G73 and under G90 a block may begin elsewhere.
TEST(Repeats, AreLeftWhereTheNextBlockWouldBeginElsewhere) {
  for (const char* text :
       {"G99\nG91 G81 X1 R-2 Z-3 L2 F9\n", "G91 G81 X1 R-2 Z-3 L2 F9\n",
        "G98\nG91 G81 X1 R2 Z-3 L2 F9\n", "G98\nG91 G81 X1 R0 Z-1 F9\nG82 P1 X1 R-2 Z-3 L2\n",
        "G98\nG91 G73 Q1 X1 R-2 Z-3 L2 F9\n", "G98 G81 X1 R-2 Z-3 L2 F9\n"}) {
    EXPECT_EQ(text_of(unrolled(program_of("rs274", text))), "none") << text;
  }
}

}  // namespace
}  // namespace gonogo::relations::testing
