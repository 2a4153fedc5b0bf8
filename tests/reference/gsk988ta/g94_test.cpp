// SPDX-License-Identifier: GPL-3.0-or-later
//
// G94, clause by clause. A is where the cycle starts, C the programmed end point; X words are
// diameters, records are true lengths.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

// From A = (X120, Z0), a radius of 60.
const std::string kFromA = "G0 X120 Z0\n";
const std::string kAtA = "rapid x60 z0";

TEST(G94, TheWorkedExampleOfTheManual) {
  // Straight: A(130, 5) to B(130, C_z), C, D(C_x, 5), A. Taper: B_z = -30 + R.
  const Lines want = {
      "rapid x65 z5",                                                              //
      "rapid z0",     "feed x0 z0 f200",     "feed z5 f200", "rapid x65",          // X0 Z0
      "rapid z-110",  "feed x60 z-110 f300", "feed z5 f300", "rapid x65",          // X120 Z-110
      "rapid x60 z0",                                                              //
      "rapid z-40",   "feed x54 z-30 f300",  "feed z0 f300", "rapid x60",          // X108 R-10
      "rapid z-50",   "feed x48 z-30 f300",  "feed z0 f300", "rapid x60",          // X96 R-20
      "rapid z-60",   "feed x42 z-30 f300",  "feed z0 f300", "rapid x60",          // X84 R-30
      "rapid z-70",   "feed x36 z-30 f300",  "feed z0 f300", "rapid x60",          // X72 R-40
      "rapid z-80",   "feed x30 z-30 f300",  "feed z0 f300", "rapid x60", "m30"};  // X60 R-50
  EXPECT_EQ(lines("G00 X130 Z5\nG94 X0 Z0 F200\nX120 Z-110 F300\nG00 X120 Z0\n"
                  "G94 X108 Z-30 R-10\nX96 R-20\nX84 R-30\nX72 R-40\nX60 R-50\nM30\n"),
            want);
}

TEST(G94, Clause01InG17XIsPositionedAndYCuts) {
  // A(60, 10), C(50, 5): the travel of X is that of a radius.
  const Lines want = {"rapid x60 y10", "rapid x50", "feed x50 y5 f100", "feed x60 f100",
                      "rapid y10"};
  EXPECT_EQ(lines("G17 G0 X120 Y10\nG94 X100 Y5 F100"), want);
}

TEST(G94, Clause01InG18ZIsPositionedAndXCuts) {
  const Lines want = {"rapid x60 z10", "rapid z5", "feed x50 z5 f100", "feed z10 f100",
                      "rapid x60"};
  EXPECT_EQ(lines("G18 G0 X120 Z10\nG94 X100 Z5 F100"), want);
}

TEST(G94, Clause01InG19YIsPositionedAndZCuts) {
  const Lines want = {"rapid y10 z20", "rapid y5", "feed y5 z15 f100", "feed y10 f100",
                      "rapid z20"};
  EXPECT_EQ(lines("G19 G0 Y10 Z20\nG94 Y5 Z15 F100"), want);
}

TEST(G94, Clause02TheTaperStartsRBeyondTheEndPoint) {
  const Lines want = {kAtA, "rapid z-35", "feed x50 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G94 X100 Z-30 R-5 F100"), want);
}

TEST(G94, Clause03IncrementsCountFromA) {
  // U-20 is a radius of 10: C = (50, -30).
  const Lines want = {kAtA, "rapid z-25", "feed x50 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G94 U-20 W-30 R5 F100"), want);
}

TEST(G94, Clause03OneAxisMayBeAnIncrementAndTheOtherNot) {
  const Lines want = {kAtA, "rapid z-30", "feed x50 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G94 U-20 Z-30 F100"), want);
}

TEST(G94, Clause05TheCycleEndsWhereItBegan) {
  EXPECT_EQ(ending(kFromA + "G94 X100 Z-30 R-5 F100"), "end x60 y0 z0 a0 c0");
}

TEST(G94, EachMotionNamesItsClause) {
  const Lines want = {"GSK-COM-05", "GSK-G94-02", "GSK-G94-03", "GSK-G94-04", "GSK-G94-05"};
  EXPECT_EQ(clauses_of(kFromA + "G94 X100 Z-30 F100"), want);
}

TEST(G94, Clause06ABlockWithOneAxisKeepsTheOtherAndR) {
  const std::string first = kFromA + "G94 X100 Z-30 R-5 F100\n";
  const Lines cycle = lines(first + "X80");
  ASSERT_EQ(cycle.size(), 9U);
  // Z-30 and R-5 stay.
  const Lines want = {"rapid z-35", "feed x40 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(Lines(cycle.begin() + 5, cycle.end()), want);
}

TEST(G94, Clause06ABlockWithRAloneRepeatsWithTheNewTaper) {
  const Lines cycle = lines(kFromA + "G94 X100 Z-30 R-5 F100\nR-8 F50");
  ASSERT_EQ(cycle.size(), 9U);
  const Lines want = {"rapid z-38", "feed x50 z-30 f50", "feed z0 f50", "rapid x60"};
  EXPECT_EQ(Lines(cycle.begin() + 5, cycle.end()), want);
}

TEST(G94, Clause06R0MakesItStraightAgain) {
  const Lines cycle = lines(kFromA + "G94 X100 Z-30 R-5 F100\nX80 R0");
  ASSERT_EQ(cycle.size(), 9U);
  EXPECT_EQ(cycle[5], "rapid z-30");
}

TEST(G94, ReadingRewriteKeepKeepsR) {
  const std::string program = kFromA + "G94 X100 Z-30 R-5 F100\nG94 X80";
  const Lines kept = lines(program);
  ASSERT_EQ(kept.size(), 9U);
  EXPECT_EQ(kept[5], "rapid z-35");
  EXPECT_EQ(lines(program, profile_with({{"gsk.g94.rewrite", "keep"}})), kept);
}

TEST(G94, ReadingRewriteClearMakesItStraight) {
  const Lines cleared = lines(kFromA + "G94 X100 Z-30 R-5 F100\nG94 X80\nX70",
                              profile_with({{"gsk.g94.rewrite", "clear"}}));
  ASSERT_EQ(cleared.size(), 13U);
  const Lines want = {"rapid z-30", "feed x40 z-30 f100", "feed z0 f100", "rapid x60",
                      "rapid z-30", "feed x35 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(Lines(cleared.begin() + 5, cleared.end()), want);
}

// Note 2 has the end point and R together: what the block does not give is as if never given.
TEST(G94, ReadingRewriteClearAllBeginsAnew) {
  const Profile all = profile_with({{"gsk.g94.rewrite", "clear-all"}});
  const Lines again = lines(kFromA + "G94 X100 Z-30 R-5 F100\nG94 X80\nZ-10", all);
  ASSERT_EQ(again.size(), 13U);
  const Lines want = {"rapid z0",   "feed x40 z0 f100",   "feed z0 f100", "rapid x60",
                      "rapid z-10", "feed x40 z-10 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(Lines(again.begin() + 5, again.end()), want);
  // The code alone leaves nothing to repeat.
  EXPECT_EQ(lines(kFromA + "G94 X100 Z-30 R-5 F100\nG94", all).size(), 5U);
  EXPECT_EQ(touched_readings(kFromA + "G94 X100 Z-30 F100\nG94 X80"), Lines{"gsk.g94.rewrite"});
  EXPECT_EQ(touched_readings(kFromA + "G94 X100 Z-30 F100\nG94 X80 Z-20"), Lines{});
}

TEST(G94, Clause07AnotherCodeOfGroup01ClearsTheEndPointAndR) {
  for (const char* other : {"G0 X120 Z0", "G1 X120 Z0", "G0", "G1", "G2", "G3"}) {
    const Lines cycle = lines(kFromA + "G94 X100 Z-30 R-5 F100\n" + other + "\nG94 X80\nM0");
    ASSERT_GE(cycle.size(), 5U) << other;
    // Z has no travel and R is 0.
    const Lines want = {"rapid z0", "feed x40 z0 f100", "feed z0 f100", "rapid x60", "m0"};
    EXPECT_EQ(Lines(cycle.end() - 5, cycle.end()), want) << other;
  }
}

TEST(G94, Clause07G04ClearsNothing) {
  const Lines cycle = lines(kFromA + "G94 X100 Z-30 R-5 F100\nG4 P500\nX80");
  ASSERT_EQ(cycle.size(), 10U);
  const Lines want = {"dwell 0.5", "rapid z-35", "feed x40 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(Lines(cycle.begin() + 5, cycle.end()), want);
}

// A code of group 00 that changes nothing else: the position keeps its name.
const std::string kAfter00 = kFromA + "G94 X100 Z-30 R-5 F100\nG50 X120 Z0\nX80";

TEST(G94, Clause07ACodeOfGroup00ClearsTheEndPointAndR) {
  const Lines cycle = lines(kAfter00, profile_with({{"gsk.g94.after-00", "stays"}}));
  ASSERT_EQ(cycle.size(), 10U);
  const Lines want = {"rapid z0", "feed x40 z0 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(Lines(cycle.begin() + 6, cycle.end()), want);
}

TEST(G94, Clause07G28ClearsTheEndPointAndR) {
  // W0: Z goes to the point where it stands, 0, and to the reference point, 0.
  const Lines cycle = lines(kFromA + "G94 X100 Z-30 R-5 F100\nG28 W0\nX80");
  ASSERT_EQ(cycle.size(), 11U);
  const Lines want = {"rapid z0", "feed x40 z0 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(Lines(cycle.begin() + 7, cycle.end()), want);
}

TEST(G94, ReadingAfter00StaysIsTheDefault) {
  EXPECT_EQ(lines(kAfter00), lines(kAfter00, profile_with({{"gsk.g94.after-00", "stays"}})));
}

TEST(G94, ReadingAfter00CancelledEndsTheCycle) {
  const Lines cycle = lines(kAfter00, profile_with({{"gsk.g94.after-00", "cancelled"}}));
  ASSERT_EQ(cycle.size(), 7U);
  EXPECT_EQ(cycle[6], "rapid x40");
}

TEST(G94, ReadingAfter00IsNotAskedAfterG04) {
  const std::string program = kFromA + "G94 X100 Z-30 R-5 F100\nG4 P500\nX80";
  EXPECT_EQ(lines(program, profile_with({{"gsk.g94.after-00", "cancelled"}})), lines(program));
}

TEST(G94, Clause08AWordOfAnAxisOutsideThePlaneIsAnAlarm) {
  const std::pair<std::string, std::string> cases[] = {{"G17 G94 X10 Y10 F100 ", "Z W C H"},
                                                       {"G18 G94 X10 Z10 F100 ", "Y V C H"},
                                                       {"G19 G94 Y10 Z10 F100 ", "X U C H"}};
  for (const auto& [block, addresses] : cases) {
    for (const char address : addresses) {
      if (address == ' ') continue;
      const std::string program = block + address + "5";
      EXPECT_EQ(ending(program), "alarm b1 axis-not-in-plane") << program;
    }
  }
}

TEST(G94, Clause08HoldsInARepeatedBlockAndForAnIncrementOfZero) {
  EXPECT_EQ(ending(kFromA + "G94 X100 Z-30 F100\nV0"), "alarm b3 axis-not-in-plane");
}

// Note 1 speaks of the motion of such an axis.
TEST(G94, Clause08AWordThatMovesNothingIsIgnoredUnderItsReading) {
  const Profile ignored = profile_with({{"gsk.g94.still-axis", "ignored"}});
  const std::string from = "G0 X120 Y20 Z0\n";
  for (const char* cycle : {"G94 X100 Z-30 F100", "G90 X100 Z-30 F100", "G92 X100 Z-30 F2"}) {
    for (const char* word : {" V0", " Y20", " C0", " H0"}) {
      EXPECT_EQ(lines(from + cycle + word, ignored), lines(from + cycle)) << cycle << word;
      EXPECT_EQ(touched_readings(from + cycle + word).front(), "gsk.g94.still-axis");
    }
    for (const char* word : {" V1", " Y0", " C5"}) {
      EXPECT_EQ(ending(from + cycle + word, ignored), "alarm b2 axis-not-in-plane")
          << cycle << word;
    }
  }
  // Alone it is no word of the cycle.
  const Lines cycle = lines(from + "G94 X100 Z-30 F100");
  EXPECT_EQ(lines(from + "G94 X100 Z-30 F100\nV0", ignored), cycle);
}

// A control that looks at the limit of GSK-G94-09.
Profile limited() {
  return profile_with({{"gsk.g94.taper-limit", "alarm"}});
}

// Travel of Z from A to C: -30.
std::string taper(const std::string& r) {
  return ending(kFromA + "G94 X100 Z-30 R" + r + " F100", limited());
}
constexpr std::string_view kBackAtA = "end x60 y0 z0 a0 c0";

TEST(G94, Clause09AnOppositeRMayBeAsLargeAsTheTravel) {
  EXPECT_EQ(taper("29.999"), kBackAtA);
  EXPECT_EQ(taper("30"), kBackAtA);
  EXPECT_EQ(taper("30.001"), "alarm b2 taper-limit");
}

TEST(G94, Clause09ALargerROnlyRunsAsItStandsUnderItsReading) {
  const Profile run = profile_with({{"gsk.g94.taper-limit", "run"}});
  // A(60, 0), C(50, -30): B lies 40 beyond C, which is 10 on the other side of A.
  const Lines want = {kAtA, "rapid z10", "feed x50 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G94 X100 Z-30 R40 F100", run), want);
}

TEST(G94, Clause09HoldsForATravelUpwardsToo) {
  EXPECT_EQ(ending(kFromA + "G94 X100 Z30 R-30 F100"), kBackAtA);
  EXPECT_EQ(ending(kFromA + "G94 X100 Z30 R-30.001 F100", limited()), "alarm b2 taper-limit");
}

TEST(G94, Clause09ThereIsNoLimitWhereTheSignsAgree) {
  EXPECT_EQ(taper("-30.001"), kBackAtA);
  EXPECT_EQ(taper("-500"), kBackAtA);
}

TEST(G94, Clause09ThereIsNoLimitWithoutTravel) {
  for (const char* r : {"0.001", "-0.001", "500", "-500"}) {
    EXPECT_EQ(ending(kFromA + "G94 X100 Z0 R" + r + " F100"), kBackAtA) << r;
  }
}

TEST(G94, Clause09IsSeenWithARetainedR) {
  // R25 is kept; the travel shrinks from -30 to -25 and then to -24.999.
  EXPECT_EQ(ending(kFromA + "G94 X100 Z-30 R25 F100\nZ-25"), kBackAtA);
  EXPECT_EQ(ending(kFromA + "G94 X100 Z-30 R25 F100\nZ-24.999", limited()), "alarm b3 taper-limit");
}

TEST(G94, Clause10EachMotionBelongsToTheBlockOfTheCycle) {
  std::vector<std::uint64_t> blocks;
  for (const Item& item : expand(kFromA + "\nG94 X100 Z-30 R-5 F100\nX80")) {
    blocks.push_back(std::get<Record>(item).block);
  }
  const std::vector<std::uint64_t> want = {1, 3, 3, 3, 3, 4, 4, 4, 4, 0};  // 0: the end
  EXPECT_EQ(blocks, want);
}

TEST(G94, Clause11InG17RIsATrueLengthOnADiameter) {
  // C_x = 40 true, R10: B_x = 50, in words X100 = X80 + 2 x 10.
  const Lines want = {"rapid x60 y0", "rapid x50", "feed x40 y-5 f100", "feed x60 f100",
                      "rapid y0"};
  EXPECT_EQ(lines("G17 G0 X120 Y0\nG94 X80 Y-5 R10 F100"), want);
}

TEST(G94, Clause11InG17TheTravelIsHalfTheDifferenceOfDiameters) {
  // From X120 to X60: 30 true, not 60.
  EXPECT_EQ(ending("G17 G0 X120 Y0\nG94 X60 Y-5 R30 F100"), "end x60 y0 z0 a0 c0");
  EXPECT_EQ(ending("G17 G0 X120 Y0\nG94 X60 Y-5 R30.001 F100", limited()), "alarm b2 taper-limit");
  EXPECT_EQ(ending("G17 G0 X120 Y0\nG94 U-60 Y-5 R30.001 F100", limited()), "alarm b2 taper-limit");
}

TEST(G94, Clause11InRadiusProgrammingTheTravelIsNotHalved) {
  Profile profile = limited();
  profile.x_diameter = false;
  EXPECT_EQ(ending("G17 G0 X120 Y0\nG94 X60 Y-5 R60 F100", profile), "end x120 y0 z0 a0 c0");
  EXPECT_EQ(ending("G17 G0 X120 Y0\nG94 X60 Y-5 R60.001 F100", profile), "alarm b2 taper-limit");
}

TEST(G94, Clause12AMissingAxisOfTheEntryBlockHasNoTravel) {
  const Lines only_x = {kAtA, "rapid z0", "feed x50 z0 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G94 X100 F100"), only_x);
  const Lines only_z = {kAtA, "rapid z-30", "feed x60 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G94 Z-30 F100"), only_z);
}

TEST(G94, Clause12RAloneRunsTheCycleWithCAtA) {
  const Lines want = {kAtA, "rapid z5", "feed x60 z0 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G94 R5 F100"), want);
}

TEST(G94, Clause12NeitherAxisNorRMovesNothing) {
  const Lines want = {kAtA};
  EXPECT_EQ(lines(kFromA + "G94 F100"), want);
  EXPECT_EQ(lines(kFromA + "G94"), want);  // and needs no feed
}

TEST(G94, Clause12AfterAnEntryWithoutWordsTheNextBlockRuns) {
  const Lines want = {kAtA, "rapid z-30", "feed x50 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G94 F100\nX100 Z-30"), want);
}

const std::string kThenFeedAlone = kFromA + "G94 X100 Z-30 R-5 F100\nF50\nM0";

TEST(G94, ReadingEmptyBlockNoneMovesNothing) {
  const Lines cycle = lines(kThenFeedAlone);
  ASSERT_EQ(cycle.size(), 6U);
  EXPECT_EQ(cycle[5], "m0");
  EXPECT_EQ(lines(kThenFeedAlone, profile_with({{"gsk.g94.empty-block", "none"}})), cycle);
}

TEST(G94, ReadingEmptyBlockRepeatRunsTheCycleAgain) {
  const Lines cycle = lines(kFromA + "G94 X100 Z-30 R-5 F100\nF50",
                            profile_with({{"gsk.g94.empty-block", "repeat"}}));
  ASSERT_EQ(cycle.size(), 9U);
  const Lines want = {"rapid z-35", "feed x50 z-30 f50", "feed z0 f50", "rapid x60"};
  EXPECT_EQ(Lines(cycle.begin() + 5, cycle.end()), want);
}

TEST(G94, ReadingEmptyBlockRepeatHasNothingToRepeatAtTheEntry) {
  const Lines want = {kAtA};
  EXPECT_EQ(lines(kFromA + "G94 F100", profile_with({{"gsk.g94.empty-block", "repeat"}})), want);
}

// GSK-G94-12: what the block has is none of the cycle.
TEST(G94, ReadingEmptyBlockRepeatsNothingInABlockOfAnotherMatter) {
  const Profile repeat = profile_with({{"gsk.g94.empty-block", "repeat"}});
  const std::string cycle = kFromA + "G94 X100 Z-30 R-5 F100\n";
  for (const char* block : {"S300", "T0202", "G97", "G40", "G54 S300"}) {
    EXPECT_EQ(lines(cycle + block, repeat), lines(cycle)) << block;
    EXPECT_EQ(touched_readings(cycle + block), Lines{}) << block;
  }
  Lines stopped = lines(cycle);
  stopped.emplace_back("m5");
  EXPECT_EQ(lines(cycle + "M05", repeat), stopped);
  stopped.back() = "m30";
  EXPECT_EQ(lines(cycle + "M30", repeat), stopped);
}

TEST(G94, ReadingEmptyBlockRepeatTakesTheCodeAlone) {
  const Lines cycle = lines(kFromA + "G94 X100 Z-30 R-5 F100\nG94",
                            profile_with({{"gsk.g94.empty-block", "repeat"}}));
  ASSERT_EQ(cycle.size(), 9U);
  const Lines want = {"rapid z-35", "feed x50 z-30 f100", "feed z0 f100", "rapid x60"};
  EXPECT_EQ(Lines(cycle.begin() + 5, cycle.end()), want);
}

TEST(G94, TheCycleNeedsAFeed) {
  EXPECT_EQ(ending(kFromA + "G94 X100 Z-30"), "alarm b2 feed-missing");
}

TEST(G94, InFeedPerRevolutionBothCutsHaveIt) {
  const Lines want = {kAtA, "rapid z-30", "feed x50 z-30 f0.2/rev", "feed z0 f0.2/rev",
                      "rapid x60"};
  EXPECT_EQ(lines(kFromA + "G99 G94 X100 Z-30 F0.2"), want);
}

TEST(G94, InInchesRIsInInches) {
  // A(1 in radius, 0); X1 is 12.7, Z-1 is -25.4, R-0.5 is -12.7; F10 is 254.
  const Lines want = {"rapid x25.4 z0", "rapid z-38.1", "feed x12.7 z-25.4 f254", "feed z0 f254",
                      "rapid x25.4"};
  EXPECT_EQ(lines("G20 G0 X2 Z0\nG94 X1 Z-1 R-0.5 F10"), want);
}

TEST(G94, BrokenRulesOfOneBlockAreAllReported) {
  // Y outside the plane, R 31 against -30, no feed: in the order of their words.
  EXPECT_EQ(ending(kFromA + "G94 Y1 R31 X100 Z-30", limited()),
            "alarm b2 axis-not-in-plane taper-limit feed-missing");
}

}  // namespace
}  // namespace gonogo::reference::testing
