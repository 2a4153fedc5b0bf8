// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cycles of the HNC-21T derived by hand from the manual and the examples of its time,
// against the vectors. A is where the tool stands, C the programmed end point, B where the cut
// begins. X words are diameters unless G37 holds; records hold radii, as I, E, K, R and Q do.
#include <gtest/gtest.h>

#include "corpus_testing.hpp"
#include "derived.hpp"

namespace gonogo::testing {
namespace {

struct At {
  std::string x, z;
};

// G80: along X to B, to C, out to D along X, back to A along Z.
Lines turned(const std::string& block, const std::string& b_x, const At& c, const At& a,
             const std::string& feed) {
  return {block + " rapid x" + b_x, block + " feed x" + c.x + " z" + c.z + " f" + feed,
          block + " feed x" + a.x + " f" + feed, block + " rapid z" + a.z};
}

// G81: along Z to B, to C, out to D along Z, back to A along X.
Lines faced(const std::string& block, const std::string& b_z, const At& c, const At& a,
            const std::string& feed) {
  return {block + " rapid z" + b_z, block + " feed x" + c.x + " z" + c.z + " f" + feed,
          block + " feed z" + a.z + " f" + feed, block + " rapid x" + a.x};
}

// G82 without a run-out.
Lines threaded(const std::string& block, const std::string& b_x, const At& c, const At& a,
               const std::string& lead) {
  return {block + " rapid x" + b_x, block + " thread x" + c.x + " z" + c.z + " lead" + lead,
          block + " rapid x" + a.x, block + " rapid z" + a.z};
}

// Feeds and traverses in turn along one axis, with the feed of their block: "2", "x", {"23", ...}.
Lines in_and_out(const std::string& block, const std::string& axis, const Lines& places,
                 const std::string& feed) {
  Lines out;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::string to = " " + axis + places[k];
    out.push_back(k % 2 == 0 ? block + " feed" + to + " f" + feed : block + " rapid" + to);
  }
  return out;
}

Lines end(const std::string& x, const std::string& z) {
  return {"end x" + x + " y0 z" + z + " a0 c0"};
}

// The spindle angles of the thread records, in their order.
Lines starts_of(const std::string& id) {
  Lines starts;
  for (const reference::Record& record : checked_in_expectation(id).records) {
    if (record.kind == reference::RecordKind::thread) starts.push_back(record.start.text());
  }
  return starts;
}

TEST(DerivedHncG80, FivePassesOfATaperInDiameters) {
  // A (25, 4); I-8.5: B lies at C_X / 2 - 8.5. The slope passes Z0 at radius 5 with X25.
  const At a{"25", "4"};
  const Lines want =
      Lines{"4 m 3", "4 rapid x25 z4"} + turned("5", "11.75", {"20.25", "-30"}, a, "100") +
      turned("6", "9.5", {"18", "-30"}, a, "100") +
      turned("7", "7.25", {"15.75", "-30"}, a, "100") +
      turned("8", "5", {"13.5", "-30"}, a, "100") + turned("9", "4", {"12.5", "-30"}, a, "40") +
      Lines{"10 rapid x25 z50", "11 m 5", "12 m 30"} + end("25", "50");
  EXPECT_EQ(records_of("hnc.programs.000018"), want);
}

TEST(DerivedHncG80, OnePassOfAShortTaper) {
  // 61.125 / 2 = 30.5625, less 0.94 is 29.6225.
  const Lines want = Lines{"3 rapid x50 z100", "4 m 3", "5 rapid x45 z4"} +
                     turned("6", "29.6225", {"30.5625", "-30"}, {"45", "4"}, "80") +
                     Lines{"7 rapid x50 z100", "7 m 5", "8 m 30"} + end("50", "100");
  EXPECT_EQ(records_of("hnc.programs.000020"), want);
}

TEST(DerivedHncG80, ABoreIsCutOutward) {
  const Lines want = Lines{"1 rapid x14 z2"} + turned("2", "17", {"17", "-25"}, {"14", "2"}, "80") +
                     end("14", "2");
  EXPECT_EQ(records_of("hnc.programs.000021"), want);
}

TEST(DerivedHncG80, IncrementsAreFromAInEachBlock) {
  // A (0, 0): X-10 is a radius of -5, B 5.5 below it; the tool is back at A each time.
  const At a{"0", "0"};
  const Lines want = Lines{"2 m 3"} + turned("3", "-10.5", {"-5", "-33"}, a, "100") +
                     turned("4", "-12", {"-6.5", "-33"}, a, "100") +
                     turned("5", "-13.5", {"-8", "-33"}, a, "100") + Lines{"6 m 30"} +
                     end("0", "0");
  EXPECT_EQ(records_of("hnc.programs.000022"), want);
}

TEST(DerivedHncG81, FourPassesOfATaperFace) {
  // A (28, 45); K-6: B lies 6 below C.
  const At a{"28", "45"};
  const Lines want = Lines{"4 m 3", "4 rapid x28 z45"} + faced("5", "31", {"10", "37"}, a, "100") +
                     faced("6", "28", {"10", "34"}, a, "100") +
                     faced("7", "25", {"10", "31"}, a, "100") +
                     faced("8", "24", {"10", "30"}, a, "40") +
                     Lines{"9 rapid x40 z100", "10 m 5", "11 m 30"} + end("40", "100");
  EXPECT_EQ(records_of("hnc.programs.000023"), want);
}

TEST(DerivedHncG81, TheCodeAgainKeepsItsFeed) {
  const At a{"30", "45"};
  const Lines want =
      Lines{"2 m 3", "2 rapid x30 z45"} + faced("3", "28", {"12.5", "31.5"}, a, "100") +
      faced("4", "26", {"12.5", "29.5"}, a, "100") + faced("5", "24", {"12.5", "27.5"}, a, "100") +
      faced("6", "22", {"12.5", "25.5"}, a, "100") + Lines{"7 m 5", "8 m 30"} + end("30", "45");
  EXPECT_EQ(records_of("hnc.programs.000024"), want);
}

TEST(DerivedHncG81, ThreeIncrementalPassesAreThreeMillimetresApart) {
  const At a{"0", "0"};
  const Lines want = Lines{"1 m 3"} + faced("1", "-8", {"-7.5", "-8"}, a, "37") +
                     faced("2", "-11", {"-7.5", "-11"}, a, "37") +
                     faced("3", "-14", {"-7.5", "-14"}, a, "37") + Lines{"4 m 5", "5 m 30"} +
                     end("0", "0");
  EXPECT_EQ(records_of("hnc.programs.000025"), want);
}

TEST(DerivedHncG82, FivePassesWithTheCodeOnce) {
  const At a{"30", "-24"};
  const Lines want = Lines{"3 m 3", "4 rapid x30", "5 rapid z-24"} +
                     threaded("6", "24.55", {"24.55", "-46"}, a, "2") +
                     threaded("7", "24.25", {"24.25", "-46"}, a, "2") +
                     threaded("8", "23.95", {"23.95", "-46"}, a, "2") +
                     threaded("9", "23.75", {"23.75", "-46"}, a, "2") +
                     threaded("10", "23.7", {"23.7", "-46"}, a, "2") +
                     Lines{"11 rapid x50 z80", "12 m 5", "13 m 30"} + end("50", "80");
  EXPECT_EQ(records_of("hnc.programs.000026"), want);
}

TEST(DerivedHncG82, FourPassesWithTheCodeInEachBlock) {
  const At a{"17.5", "104"};
  const Lines want = Lines{"2 m 3", "2 rapid x17.5 z104"} +
                     threaded("3", "14.6", {"14.6", "56"}, a, "1.5") +
                     threaded("4", "14.3", {"14.3", "56"}, a, "1.5") +
                     threaded("5", "14.1", {"14.1", "56"}, a, "1.5") +
                     threaded("6", "14.02", {"14.02", "56"}, a, "1.5") + Lines{"7 m 5", "8 m 30"} +
                     end("17.5", "104");
  EXPECT_EQ(records_of("hnc.programs.000027"), want);
}

TEST(DerivedHncG82, FiveIncrementalPassesOfATaperThread) {
  // From G92 X80 Z62: 40 - 31.9 / 2 = 24.05, B 5 below it; then 23.75, 23.45, 23.25, 23.2.
  const At a{"40", "62"};
  const Lines want = Lines{"3 m 3"} + threaded("4", "19.05", {"24.05", "12"}, a, "2") +
                     threaded("5", "18.75", {"23.75", "12"}, a, "2") +
                     threaded("6", "18.45", {"23.45", "12"}, a, "2") +
                     threaded("7", "18.25", {"23.25", "12"}, a, "2") +
                     threaded("8", "18.2", {"23.2", "12"}, a, "2") + Lines{"9 m 5", "10 m 30"} +
                     end("40", "62");
  EXPECT_EQ(records_of("hnc.programs.000028"), want);
}

TEST(DerivedHncG82, TheRunOutGoesBeyondC) {
  // C (14.6, -40), R-2 E1.3: the thread ends at (15.9, -42), X31.8 as a diameter.
  const Lines want = Lines{"1 rapid x17.5 z5",
                           "2 rapid x14.6",
                           "2 thread x14.6 z-40 lead1.5",
                           "2 thread x15.9 z-42 lead1.5",
                           "2 rapid x17.5",
                           "2 rapid z5"} +
                     end("17.5", "5");
  EXPECT_EQ(records_of("hnc.programs.000031"), want);
}

TEST(DerivedHncG82, TheRunOutOfATaper) {
  // B 13.75, X27.5 as a diameter; the thread ends at 16.3, X32.6.
  const Lines want = Lines{"1 rapid x18 z4",
                           "2 rapid x13.75",
                           "2 thread x15 z-40 lead1.5",
                           "2 thread x16.3 z-42 lead1.5",
                           "2 rapid x18",
                           "2 rapid z4"} +
                     end("18", "4");
  EXPECT_EQ(records_of("hnc.programs.000032"), want);
}

TEST(DerivedHncG82, TwoStartsAreTwoWholePassesABlock) {
  const At a{"17.5", "104"};
  Lines want = Lines{"2 rapid x17.5 z104", "3 m 3"};
  const At passes[] = {{"4", "14.6"}, {"5", "14.3"}, {"6", "14.1"}, {"7", "14.02"}};
  for (const auto& [block, x] : passes) {
    want = want + threaded(block, x, {x, "18.5"}, a, "3") + threaded(block, x, {x, "18.5"}, a, "3");
  }
  EXPECT_EQ(records_of("hnc.programs.000030"), want + Lines{"8 m 30"} + end("17.5", "104"));
  EXPECT_EQ(starts_of("hnc.programs.000030"),
            (Lines{"0", "180", "0", "180", "0", "180", "0", "180"}));
}

TEST(DerivedHncG82, StartAnglesAreReducedToOneTurn) {
  EXPECT_EQ(starts_of("hnc.g82.000110"), (Lines{"0", "200", "40"}));  // 0, 200, 400
  EXPECT_EQ(starts_of("hnc.g82.000104"), Lines{"270"});               // -90
}

TEST(DerivedHncG82, EachStartHasItsRunOut) {
  // C (14.5, -40), B 13.25, the end of the run-out (15.8, -42); each thread keeps its start.
  const Lines pass = {"2 rapid x13.25", "2 thread x14.5 z-40 lead3", "2 thread x15.8 z-42 lead3",
                      "2 rapid x17.5", "2 rapid z5"};
  EXPECT_EQ(records_of("hnc.g82.000113"),
            Lines{"1 rapid x17.5 z5"} + pass + pass + end("17.5", "5"));
  EXPECT_EQ(starts_of("hnc.g82.000113"), (Lines{"0", "0", "180", "180"}));
}

TEST(DerivedHncG82, JIsALeadInInches) {
  // 25.4 * 0.090909 = 2.3090886
  const Lines want = Lines{"1 rapid x17.5 z5"} +
                     threaded("2", "14.5", {"14.5", "-40"}, {"17.5", "5"}, "2.3090886") +
                     end("17.5", "5");
  EXPECT_EQ(records_of("hnc.g82.000138"), want);
}

TEST(DerivedHncG74, PecksAreMultiplesFromAAndTheLastEndsOnZ) {
  const Lines want =
      Lines{"1 rapid x0 z2"} +
      in_and_out("2", "z", {"-4", "-3", "-10", "-9", "-16", "-15", "-17", "2"}, "50") +
      end("0", "2");
  EXPECT_EQ(records_of("hnc.programs.000033"), want);
}

TEST(DerivedHncG74, WithoutAWithdrawalOneFeedAndBack) {
  const Lines want =
      Lines{"1 rapid x0 z2"} + in_and_out("2", "z", {"-17", "2"}, "50") + end("0", "2");
  EXPECT_EQ(records_of("hnc.programs.000034"), want);
}

TEST(DerivedHncG74, FourteenPecksHaveThirteenWithdrawals) {
  // From Z10 by 5 to Z-60, which is the fourteenth multiple exactly.
  Lines places;
  for (int bottom = 5; bottom > -60; bottom -= 5) {
    places.push_back(std::to_string(bottom));
    places.push_back(std::to_string(bottom + 1));
  }
  const Lines want = Lines{"1 feed x0 z10 f1000"} +
                     in_and_out("2", "z", places + Lines{"-60", "10"}, "1000") + end("0", "10");
  EXPECT_EQ(records_of("hnc.programs.000035"), want);
}

TEST(DerivedHncG74, AWithdrawalMayRiseAboveA) {
  // From Z2 by 6, withdrawals of 13: -4 to 9, -10 to 3, -16 to -3.
  const Lines want = Lines{"1 rapid x0 z2"} +
                     in_and_out("2", "z", {"-4", "9", "-10", "3", "-16", "-3", "-17", "2"}, "50") +
                     end("0", "2");
  EXPECT_EQ(records_of("hnc.g74.000037"), want);
}

TEST(DerivedHncG74, FromTheWithdrawnPointAPeckGoesItsDepthLessE) {
  // From Z5 by 6 to -1; withdrawn to 0, by 6 to -6; -5, -11; -10, -16; -15, and -21 is beyond -20.
  const Lines want =
      Lines{"1 rapid x25 z5"} +
      in_and_out("2", "z", {"-1", "0", "-6", "-5", "-11", "-10", "-16", "-15", "-20", "5"}, "60") +
      end("25", "5");
  EXPECT_EQ(records_of("hnc.readings.000039"), want);
}

TEST(DerivedHncG74, AClampedWithdrawalEndsAtA) {
  // From Z5 by 6: -1 and 7 up is 6, above A; -7 to 0, -13 to -6, -19 to -12.
  const Lines want =
      Lines{"1 rapid x25 z5"} +
      in_and_out("2", "z", {"-1", "5", "-7", "0", "-13", "-6", "-19", "-12", "-20", "5"}, "60") +
      end("25", "5");
  EXPECT_EQ(records_of("hnc.readings.000060"), want);
}

TEST(DerivedHncG75, FivePecksFourWithdrawalsThenStraightOut) {
  // Radii: 25 down to 15 by 2, 0.5 back each time; in diameters 46, 47, 42, 43, ... 30, 50.
  const Lines want =
      Lines{"1 rapid x25 z-20"} +
      in_and_out("2", "x", {"23", "23.5", "21", "21.5", "19", "19.5", "17", "17.5", "15", "25"},
                 "30") +
      end("25", "-20");
  EXPECT_EQ(records_of("hnc.programs.000036"), want);
}

TEST(DerivedHncG75, ALastPeckThatIsShorter) {
  // 6 deep by 2.5.
  const Lines want = Lines{"1 rapid x25 z-20"} +
                     in_and_out("2", "x", {"22.5", "23", "20", "20.5", "19", "25"}, "30") +
                     end("25", "-20");
  EXPECT_EQ(records_of("hnc.programs.000037"), want);
}

TEST(DerivedHncG75, AWidthInThreeStepsHasFourPlunges) {
  const Lines plunge = in_and_out("2", "x", {"22", "22.5", "21", "25"}, "30");
  const Lines want = Lines{"1 rapid x25 z-20"} + plunge + Lines{"2 rapid z-22"} + plunge +
                     Lines{"2 rapid z-24"} + plunge + Lines{"2 rapid z-26"} + plunge +
                     Lines{"2 rapid z-20"} + end("25", "-20");
  EXPECT_EQ(records_of("hnc.programs.000038"), want);
}

TEST(DerivedHncG75, AWidthWithoutWithdrawals) {
  const Lines plunge = in_and_out("2", "x", {"15", "25"}, "30");
  const Lines want = Lines{"1 rapid x25 z-20"} + plunge + Lines{"2 rapid z-22"} + plunge +
                     Lines{"2 rapid z-24"} + plunge + Lines{"2 rapid z-26"} + plunge +
                     Lines{"2 rapid z-20"} + end("25", "-20");
  EXPECT_EQ(records_of("hnc.programs.000039"), want);
}

TEST(DerivedHncG75, AGrooveInABore) {
  const Lines want = Lines{"1 rapid x15 z-10"} +
                     in_and_out("2", "x", {"17", "16.5", "19", "18.5", "20", "15"}, "30") +
                     end("15", "-10");
  EXPECT_EQ(records_of("hnc.programs.000040"), want);
}

TEST(DerivedHncG75, StepsThatDoNotEndAreKeptExactly) {
  // A width of 10 in three: -20 - 10 / 3, -20 - 20 / 3, -30.
  const Lines plunge = in_and_out("2", "x", {"23", "25"}, "30");
  const Lines want = Lines{"1 rapid x25 z-20"} + plunge + Lines{"2 rapid z-70/3"} + plunge +
                     Lines{"2 rapid z-80/3"} + plunge + Lines{"2 rapid z-30"} + plunge +
                     Lines{"2 rapid z-20"} + end("25", "-20");
  EXPECT_EQ(records_of("hnc.g75.000050"), want);
}

TEST(DerivedHncG75, TheThirdModeTraversesToXAndCutsTheRest) {
  // X34 is radius 17; 2 further is 15. Z5 to Z-1 in three steps of 2.
  const Lines plunge = {"2 rapid x17", "2 feed x15 f60", "2 rapid x25"};
  const Lines want = Lines{"1 rapid x25 z5"} + plunge + Lines{"2 rapid z3"} + plunge +
                     Lines{"2 rapid z1"} + plunge + Lines{"2 rapid z-1"} + plunge +
                     Lines{"2 rapid z5"} + end("25", "5");
  EXPECT_EQ(records_of("hnc.readings.000102"), want);
}

TEST(DerivedHncG75, TheThirdModeIsOfAGrooveWithAWidth) {
  const Lines want = Lines{"1 rapid x25 z5", "2 feed x17 f60", "2 rapid x25"} + end("25", "5");
  EXPECT_EQ(records_of("hnc.readings.000101"), want);
}

TEST(DerivedHncG74, AThirdModeTraversesToZAndCutsTheRest) {
  // Z-12 and 3 further.
  const Lines want =
      Lines{"1 rapid x5 z5", "2 rapid z-12", "2 feed z-15 f60", "2 rapid z5"} + end("5", "5");
  EXPECT_EQ(records_of("hnc.readings.000203"), want);
}

TEST(DerivedHncG75, AsManyPlungesAsTheCount) {
  // Z5 to Z-1 in two steps of 3.
  const Lines plunge = in_and_out("2", "x", {"21", "25"}, "60");
  const Lines want = Lines{"1 rapid x25 z5"} + plunge + Lines{"2 rapid z2"} + plunge +
                     Lines{"2 rapid z-1"} + plunge + Lines{"2 rapid z5"} + end("25", "5");
  EXPECT_EQ(records_of("hnc.readings.000084"), want);
}

TEST(DerivedHncG32, FourPassesAndTheLastByIncrements) {
  // 28.2 - 11.96 is not the last pass: U is from X40, which is 28.04. Z101.5 - 82.5 = 19.
  Lines want = {"4 rapid x25 z120", "5 m 3", "6 rapid x14.6 z101.5", "7 thread z19 lead1.5"};
  want = want + Lines{"8 rapid x20", "9 rapid z101.5", "10 rapid x14.3", "11 thread z19 lead1.5"} +
         Lines{"12 rapid x20", "13 rapid z101.5", "14 rapid x14.1", "15 thread z19 lead1.5"} +
         Lines{"16 rapid x20", "17 rapid z101.5", "18 rapid x14.02", "19 thread z19 lead1.5"} +
         Lines{"20 rapid x20", "21 rapid x25 z120", "22 m 5", "23 m 30"} + end("25", "120");
  EXPECT_EQ(records_of("hnc.programs.000016"), want);
}

TEST(DerivedHncBasic, DiametersAndRadiiGiveOneContour) {
  // G92 names A (90, 254); W-44 is Z210; U30 (U15 under G37) is 15 outward.
  const Lines want =
      Lines{"3 feed x10 z210 f100", "4 feed x25 z50 f100", "5 rapid x90 z254", "6 m 30"} +
      end("90", "254");
  EXPECT_EQ(records_of("hnc.programs.000002"), want);
  EXPECT_EQ(records_of("hnc.programs.000003"), want);
}

TEST(DerivedHncBasic, AWorkOffsetIsAddedToTheWords) {
  // G54 (12.5, -30): X40 Z30 is (32.5, 0). G59 (-4, 110): X30 Z30 is (11, 140).
  const Lines want = Lines{"2 rapid x32.5 z0", "4 rapid x11 z140", "5 m 30"} + end("11", "140");
  EXPECT_EQ(records_of("hnc.programs.000014"), want);
}

TEST(DerivedHncBasic, G92AddsTheOffsetInForce) {
  // G55 (-2.5, 7.25): X50 Z5 is (22.5, 12.25). X0 Z0 names (-2.5, 7.25); X10 Z10 is (2.5, 17.25).
  const Lines want = Lines{"1 rapid x22.5 z12.25", "3 rapid x2.5 z17.25"} + end("2.5", "17.25");
  EXPECT_EQ(records_of("hnc.offsets.000035"), want);
}

TEST(DerivedHncBasic, ABallByR15AndAFilletByR5) {
  // From (Z0, X0) to (-24, 12), counterclockwise: the centre is (-15, 0), as 9^2 + 12^2 = 15^2.
  // Then from there to (-31, 13), clockwise by 5: (-27, 16), as 3^2 + 4^2 = 4^2 + 3^2 = 5^2.
  const Lines want = Lines{"3 m 3",
                           "4 rapid x20 z5",
                           "5 rapid x0",
                           "6 feed z0 f60",
                           "7 arc G18 1 cx0 cz-15 x12 z-24 f60",
                           "8 arc G18 -1 cx16 cz-27 x13 z-31 f60",
                           "9 feed z-40 f60",
                           "10 rapid x20 z5",
                           "11 m 5",
                           "12 m 30"} +
                     end("20", "5");
  EXPECT_EQ(records_of("hnc.programs.000015"), want);
}

}  // namespace
}  // namespace gonogo::testing
