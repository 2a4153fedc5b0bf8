// SPDX-License-Identifier: GPL-3.0-or-later
//
// G75. The sources give X as a diameter; the lists below do too, and records are radii.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// F46 is a feed to X46, x23 as a radius; R47 a rapid; z-22 a rapid along Z.
Lines groove(std::initializer_list<const char*> points, const std::string& f = "30") {
  Lines want;
  for (const std::string point : points) {
    if (point[0] == 'z') {
      want.push_back("rapid " + point);
      continue;
    }
    const std::string x = (num(point.substr(1)) / 2).text();
    want.push_back(point[0] == 'F' ? "feed x" + x + " f" + f : "rapid x" + x);
  }
  return want;
}

// A X50 Z-20: 10 of radius in pecks of 2, nine points and then straight out.
TEST(G75, PecksToTheBottom) {
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 R0.5 Q2 F30"),
            groove({"F46", "R47", "F42", "R43", "F38", "R39", "F34", "R35", "F30", "R50"}));
}

TEST(G75, TheLastPeckMayBeShort) {
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X38 R0.5 Q2.5 F30"),
            groove({"F45", "R46", "F40", "R41", "F38", "R50"}));
}

TEST(G75, GroovesABore) {
  EXPECT_EQ(cycle("G00 X30 Z-10", "G75 X40 R0.5 Q2 F30"),
            groove({"F34", "R33", "F38", "R37", "F40", "R30"}));
}

TEST(G75, PlungesInOneWithoutAWithdrawal) {
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 F30"), groove({"F30", "R50"}));
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 R0 Q2 F30"), groove({"F30", "R50"}));
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 U-20 Q2 F30"), groove({"F30", "R50"}));
}

TEST(G75, PecksAcrossAWidth) {
  const Lines want = groove({"F44", "R45", "F42", "R50", "z-22",  //
                             "F44", "R45", "F42", "R50", "z-24",  //
                             "F44", "R45", "F42", "R50", "z-26",  //
                             "F44", "R45", "F42", "R50", "z-20"});
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X42 Z-26 R0.5 Q3 I3 F30"), want);
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X42 W-6 R0.5 Q3 I3 F30"), want);
  EXPECT_EQ(cycle("G00 X50 Z-20", "G91 G75 X-8 Z-6 R0.5 Q3 I3 F30"), want);
}

TEST(G75, PlungesAcrossAWidth) {
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 Z-26 I3 F30"),
            groove({"F30", "R50", "z-22", "F30", "R50", "z-24", "F30", "R50", "z-26", "F30", "R50",
                    "z-20"}));
}

TEST(G75, EndsAtA) {
  EXPECT_EQ(ending_of("G00 X50 Z-20\nG75 X30 Z-26 I3 F30"), "end x25 y0 z-20 a0 c0");
}

// Places of a width of 1 in 3 steps do not terminate; the last one is the width itself.
TEST(G75, StepsAreExactQuotients) {
  const Lines got = path("G75 X-10 Z1 I3 F30");
  EXPECT_EQ(got.at(2), "rapid z1/3");
  EXPECT_EQ(got.at(5), "rapid z2/3");
  EXPECT_EQ(got.at(8), "rapid z1");
}

TEST(G75, TheCountIsAPositiveWholeNumber) {
  for (const char* count : {"I0", "I-1", "I1.5", "I0.5"}) {
    EXPECT_EQ(ending_of(fmt::format("G75 X30 Z-26 {} F30", count)), "alarm b1 not-an-integer");
    EXPECT_EQ(ending_of(fmt::format("G75 {} F30", count)), "alarm b1 not-an-integer");
  }
  EXPECT_EQ(ending_of("G75 X30 Z-26 I3.0 F30"), "end x0 y0 z0 a0 c0");
}

TEST(G75, AWidthAndACountNeedEachOther) {
  EXPECT_EQ(ending_of("G75 X30 Z-26 F30"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G75 X30 I3 F30"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G75 I3 F30\nX30 Z-26"), "end x0 y0 z0 a0 c0");
}

// HNC-G75-05
TEST(G75, AnInheritedCountRestsWithoutAWidth) {
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 Z-22 I1 F30\nX40"),
            groove({"F30", "R50", "z-22", "F30", "R50", "z-20", "F40", "R50"}));
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 Z-22 I1 F30\nX40\nX30 Z-21").at(10), "rapid z-21");
}

TEST(G75, AWidthOfZeroPlungesAtOnePlace) {
  EXPECT_EQ(path("G75 X-10 W0 I2 F30"),
            groove({"F-10", "R0", "z0", "F-10", "R0", "z0", "F-10", "R0", "z0"}));
}

// The count is no length.
TEST(G75, TheCountIsTheSameInInches) {
  EXPECT_EQ(path("G20 G75 X-1 Z-2 I1 F1").at(2), "rapid z-50.8");
}

TEST(G75, NeedsXAndAFeed) {
  EXPECT_EQ(ending_of("G75 Z-26 I3 F30"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G75 X30"), "alarm b1 feed-missing");
  EXPECT_EQ(ending_of("G75 X30 R1 F30"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G75 X30 R-1 Q0 F30"), "alarm b1 value-sign value-sign");
}

TEST(G75, TakesTheMissingXByItsReading) {
  EXPECT_EQ(path("G75 X-10 F30\nZ-2 I1", hnc({{"hnc.missing-axis", "keep"}})),
            groove({"F-10", "R0", "F-10", "R0", "z-2", "F-10", "R0", "z0"}));
  EXPECT_EQ(path("G75 Z-2 I1 F30", hnc({{"hnc.missing-axis", "none"}})),
            groove({"F0", "R0", "z-2", "F0", "R0", "z0"}));
}

TEST(G75, NamesTheClauseOfEachMotion) {
  EXPECT_EQ(clauses("G75 X-8 R1 Q2 F30"),
            (Lines{"HNC-G75-02", "HNC-G75-02", "HNC-G75-02", "HNC-G75-02"}));
  EXPECT_EQ(clauses("G75 X-8 Z-1 I1 F30"), (Lines{"HNC-G75-03", "HNC-G75-03", "HNC-G75-04",
                                                  "HNC-G75-03", "HNC-G75-03", "HNC-G75-04"}));
}

TEST(G75, CountsByPUnderItsReading) {
  const Profile by_p = hnc({{"hnc.g75.i", "P"}});
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 Z-26 P3 F30", by_p),
            cycle("G00 X50 Z-20", "G75 X30 Z-26 I3 F30"));
  EXPECT_EQ(ending_of("G75 X30 Z-26 I3 F30", by_p), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G75 X30 P3 F30", by_p), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G75 X30 I1.5 F30", by_p), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G75 P1.5 F30", by_p), "alarm b1 not-an-integer");
  EXPECT_EQ(ending_of("G75 X30 P1.5 F30"), "end x0 y0 z0 a0 c0");
}

// Found by generated programs (seeds 1281 and 24635): equal counts in I and P are not one word.
TEST(G75, AnEqualCountInTheOtherAddressIsNoWordOfTheBlock) {
  const Profile by_p = hnc({{"hnc.g75.i", "P"}});
  EXPECT_EQ(ending_of("G75 X30 Z-6 P4 F30\nX30 I4", by_p), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G75 X30 I4 F30\nX30 P4", by_p), "alarm b2 missing-word");
  EXPECT_EQ(ending_of("G75 X30 Z-6 I4 F30\nX30 P4"), "end x0 y0 z0 a0 c0");
}

TEST(G75, CutsAsManyPlungesAsStepsUnderItsReading) {
  const Profile as_many = hnc({{"hnc.g75.steps", "i"}});
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 Z-26 I3 F30", as_many),
            groove({"F30", "R50", "z-23", "F30", "R50", "z-26", "F30", "R50", "z-20"}));
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 Z-26 I1 F30", as_many),
            groove({"z-26", "F30", "R50", "z-20"}));
}

TEST(G75, StaysAtTheLastPlaceUnderItsReading) {
  const Profile last = hnc({{"hnc.g75.end", "last"}});
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X30 Z-26 I1 F30", last),
            groove({"F30", "R50", "z-26", "F30", "R50"}));
  EXPECT_EQ(ending_of("G00 X50 Z-20\nG75 X30 Z-26 I1 F30", last), "end x25 y0 z-26 a0 c0");
  EXPECT_EQ(ending_of("G00 X50 Z-20\nG75 X30 F30", last), "end x25 y0 z-20 a0 c0");
}

// To X34 at a traverse, then 2 of radius further.
TEST(G75, ApproachesAtATraverseUnderItsReading) {
  const Profile on = hnc({{"hnc.g75.mode3", "on"}});
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X34 Z-26 Q2 I3 F30", on),
            groove({"R34", "F30", "R50", "z-22", "R34", "F30", "R50", "z-24", "R34", "F30", "R50",
                    "z-26", "R34", "F30", "R50", "z-20"}));
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X34 F30", on), groove({"F34", "R50"}));
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X34 R1 Q100 F30", on), groove({"F34", "R50"}));
  EXPECT_EQ(ending_of("G00 X50 Z-20\nG75 X50 Z-26 Q2 I3 F30", on), "alarm b2 direction-conflict");
}

// The text has the third way for a groove with a width: no traverse to the bottom of another.
TEST(G75, WithoutAWidthItCutsToXUnderThatReadingToo) {
  const Profile on = hnc({{"hnc.g75.mode3", "on"}});
  EXPECT_EQ(cycle("G00 X50 Z5", "G75 X30 Q3 F50", on), groove({"F30", "R50"}, "50"));
  EXPECT_EQ(cycle("G00 X50 Z5", "G75 U-20 R0 Q3 F50", on), groove({"F30", "R50"}, "50"));
  EXPECT_EQ(ending_of("G00 X50 Z-20\nG75 X50 Q2 F30", on), "end x25 y0 z-20 a0 c0");
  // The width of the block before is none of this one.
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X34 Z-22 Q2 I1 F30\nX40", on),
            groove({"R34", "F30", "R50", "z-22", "R34", "F30", "R50", "z-20", "F40", "R50"}));
}

// Q 4 and R 1 as diameters are 2 and 0.5 of radius.
TEST(G75, TakesPecksAsDiametersUnderItsReading) {
  const Profile diameter = hnc({{"hnc.g75.depth-scale", "diameter"}});
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X42 R1 Q4 F30", diameter),
            groove({"F46", "R47", "F42", "R50"}));
  EXPECT_EQ(cycle("G37 G00 X25 Z-20", "G75 X21 R0.5 Q2 F30", diameter),
            groove({"F46", "R47", "F42", "R50"}));
  EXPECT_EQ(path("G74 Z-4 R1 Q2 F30", diameter).at(0), "feed z-2 f30");  // no length along X
  const Profile both = hnc({{"hnc.g75.depth-scale", "diameter"}, {"hnc.g75.mode3", "on"}});
  EXPECT_EQ(cycle("G00 X50 Z-20", "G75 X34 Z-21 Q4 I1 F30", both),
            groove({"R34", "F30", "R50", "z-21", "R34", "F30", "R50", "z-20"}));
}

TEST(G75, AsksItsReadingsOnlyWhereTheyMatter) {
  EXPECT_EQ(touched("G75 X30 F30"), Lines{});
  EXPECT_EQ(touched("G75 X30 Q2 F30"), Lines{});
  EXPECT_EQ(touched("G75 X30 Z-26 Q2 I3 P3 F30"),
            (Lines{"hnc.g75.steps", "hnc.g75.end", "hnc.g75.mode3"}));
  EXPECT_EQ(touched("G75 X-30 R1 Q30 F30"), Lines{});
  EXPECT_EQ(touched("G75 X-30 R1 Q15 F30"), Lines{"hnc.g75.depth-scale"});
  EXPECT_EQ(touched("G37 G75 X-30 R1 Q30 F30"), Lines{});
  EXPECT_EQ(touched("G75 X30 Z-26 I3 P3 F30"), (Lines{"hnc.g75.steps", "hnc.g75.end"}));
  EXPECT_EQ(touched("G75 X30 Z-26 I3 F30"), (Lines{"hnc.g75.i", "hnc.g75.steps", "hnc.g75.end"}));
  EXPECT_EQ(touched("G75 X30 W0 I3 P3 F30"), (Lines{"hnc.g75.steps", "hnc.g75.zero-width"}));
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
