// SPDX-License-Identifier: GPL-3.0-or-later
//
// G80. Points of the sources are diameters; records are radii: X40.5 is x20.25.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// The path of one block from A to B, C and D and back.
Lines turning_rectangle(const std::string& b, const std::string& c_x, const std::string& c_z,
                        const std::string& a_x, const std::string& a_z, const std::string& f) {
  return {"rapid x" + b, "feed x" + c_x + " z" + c_z + " f" + f, "feed x" + a_x + " f" + f,
          "rapid z" + a_z};
}

// The textbook's example 9, A X50 Z4, I -8.5: B at X 23.5, 19, 14.5, 10, 8 as diameters.
TEST(G80, CutsTheTaperOfTheTextbook) {
  Lines want;
  for (const Lines& block : {turning_rectangle("11.75", "20.25", "-30", "25", "4", "100"),
                             turning_rectangle("9.5", "18", "-30", "25", "4", "100"),
                             turning_rectangle("7.25", "15.75", "-30", "25", "4", "100"),
                             turning_rectangle("5", "13.5", "-30", "25", "4", "100"),
                             turning_rectangle("4", "12.5", "-30", "25", "4", "40")}) {
    want.insert(want.end(), block.begin(), block.end());
  }
  want.push_back("rapid x25 z50");
  EXPECT_EQ(cycle("T0101\nG90 G00 X50 Z4 M03",
                  "G80 X40.5 Z-30I-8.5 F100\nX36 Z-30I-8.5\nX31.5 Z-30I-8.5\nX27 Z-30I-8.5\n"
                  "X25 Z-30I-8.5 F 40\nG00 X50 Z50\nM05\nM30"),
            want);
}

// A X90 Z4: B at X59.245.
TEST(G80, CutsASlightTaper) {
  EXPECT_EQ(cycle("G00 X90 Z4", "G80 X61.125 Z-30 I-0.94 F80"),
            turning_rectangle("29.6225", "30.5625", "-30", "45", "4", "80"));
}

TEST(G80, CutsABore) {
  EXPECT_EQ(cycle("G00 X28 Z2", "G80 X34 Z-25 F80"),
            turning_rectangle("17", "17", "-25", "14", "2", "80"));
}

// From A: B 21 below on the diameter, C 10 below.
TEST(G80, TakesIncrementsFromA) {
  const Lines want = turning_rectangle("-10.5", "-5", "-33", "0", "0", "100");
  EXPECT_EQ(path("G91 G80 X-10 Z-33 I-5.5 F100"), want);
  EXPECT_EQ(path("G80 U-10 W-33 I-5.5 F100"), want);
  EXPECT_EQ(path("G91 G80 U-10 W-33 I-5.5 F100"), want);
  EXPECT_EQ(path("G80 X-10 W-33 I-5.5 F100"), want);
}

// Three passes, each measured from the same A.
TEST(G80, RepeatsFromA) {
  EXPECT_EQ(path("G91 G80 X-10 Z-33 I-5.5 F100\nX-13 Z-33").at(4), "rapid x-12");
  EXPECT_EQ(path("G91 G80 X-10 Z-33 I-5.5 F100\nX-13 Z-33").at(5), "feed x-6.5 z-33 f100");
}

TEST(G80, NothingLimitsI) {
  EXPECT_EQ(path("G00 X100 Z0\nG80 X60 Z-10 I90 F100").at(1), "rapid x120");
}

// I is a true length under G36 and G37, in inches under G20.
TEST(G80, IIsARadius) {
  EXPECT_EQ(path("G37 G80 X10 Z-10 I2 F100").at(0), "rapid x12");
  EXPECT_EQ(path("G36 G80 X10 Z-10 I2 F100").at(0), "rapid x7");
  EXPECT_EQ(path("G20 G80 X1 Z-1 I1 F1").at(0), "rapid x38.1");
}

TEST(G80, NamesItsClause) {
  EXPECT_EQ(clauses("G80 X60 Z-10 F100"),
            (Lines{"HNC-G80-01", "HNC-G80-01", "HNC-G80-01", "HNC-G80-01"}));
}

TEST(G80, EndsAtA) {
  EXPECT_EQ(ending_of("G00 X50 Z4\nG80 X40 Z-30 I-8 F100"), "end x25 y0 z4 a0 c0");
}

TEST(G80, NeedsAFeed) {
  EXPECT_EQ(ending_of("G80 X60 Z-10"), "alarm b1 feed-missing");
  EXPECT_EQ(ending_of("G80 X60 Z-10 F0"), "alarm b1 feed-missing");
  EXPECT_EQ(ending_of("G80 X60 Z-10 F-1"), "alarm b1 value-sign feed-missing");
}

TEST(G80, TakesInItsWordsWithoutAnAxisWord) {
  EXPECT_EQ(path("G80 I-5 F100"), Lines{});
  EXPECT_EQ(path("G80 I-5 F100\nX20 Z-10"), turning_rectangle("5", "10", "-10", "0", "0", "100"));
}

TEST(G80, PutsItsMFunctionBeforeTheMotions) {
  EXPECT_EQ(lines("G80 X20 Z-10 F100 M08", hnc()).front(), "m8");
}

// HNC-MOD-03
TEST(G80, RefusesABlockWithOneAxis) {
  EXPECT_EQ(ending_of("G80 X60 F100"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G80 Z-60 F100"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G80 X60 Z-60 F100\nX50"), "alarm b2 missing-word");
  EXPECT_EQ(ending_of("G80 X60 Z-60 F100\nW-5"), "alarm b2 missing-word");
}

TEST(G80, KeepsTheMissingAxisUnderItsReading) {
  const Profile keep = hnc({{"hnc.missing-axis", "keep"}});
  EXPECT_EQ(cycle("G00 X50 Z4", "G80 X40 Z-30 F100\nX30", keep).at(5), "feed x15 z-30 f100");
  EXPECT_EQ(cycle("G00 X50 Z4", "G80 U-10 W-34 F100\nW-20", keep).at(5), "feed x20 z-16 f100");
  EXPECT_EQ(ending_of("G80 X40 F100", keep), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G80 X40 Z-30 F100\nG81 X30", keep), "alarm b2 missing-word");
  EXPECT_EQ(ending_of("G80 X40 Z-30 F100\nG00 X50\nG80 X30", keep), "alarm b3 missing-word");
}

TEST(G80, TravelsNotAtAllAlongTheMissingAxisUnderItsReading) {
  const Profile none = hnc({{"hnc.missing-axis", "none"}});
  EXPECT_EQ(cycle("G00 X50 Z4", "G80 X40 F100", none),
            turning_rectangle("20", "20", "4", "25", "4", "100"));
  EXPECT_EQ(cycle("G00 X50 Z4", "G80 X40 Z-30 F100\nX30", none).at(5), "feed x15 z4 f100");
}

TEST(G80, AsksItsReadingsOnlyWhereTheyMatter) {
  EXPECT_EQ(touched("G80 X40 Z-30 F100"), Lines{});
  EXPECT_EQ(touched("G80 X40 F100"), Lines{"hnc.missing-axis"});
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
