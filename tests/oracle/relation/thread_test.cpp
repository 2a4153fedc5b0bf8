// SPDX-License-Identifier: GPL-3.0-or-later
//
// R8 of threads: a pass is an entry, an infeed, a helix, a run-out and the two ways back, and no
// more.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "deciding.hpp"

namespace gonogo::relation::thread_steps {
namespace {

// The bolt: middle X10 Y10, 15 before and 14 behind its one pass, three turns from Z8 to Z2, J2 and
// K30.
constexpr std::string_view kBolt =
    "G17 G00 X30 Y14 Z10\nG114 X20 Y10 W-6 R-2 I2 E24 J2 K30 P1 D3 F200\n";

std::string rapid(int line, std::string_view to) {
  return fmt::format(R"({{"k":"rapid","b":{},"to":{{{}}}}})"
                     "\n",
                     line, to);
}
std::string feed(std::string_view to) {
  return fmt::format(R"({{"k":"feed","b":2,"to":{{{}}},"f":"200"}})"
                     "\n",
                     to);
}
std::string arc(std::string_view centre, int rot, std::string_view to) {
  return fmt::format(
      R"({{"k":"arc","b":2,"plane":"G17","c":{{{}}},"rot":{},"to":{{{}}},"f":"200"}})"
      "\n",
      centre, rot, to);
}

const std::string kBegin = rapid(1, R"("x":"15","y":"14","z":"10")") +
                           rapid(2, R"("x":"10","y":"10")") + rapid(2, R"("z":"8")");
const std::string kEntry = arc(R"("x":"17.5","y":"10")", -1, R"("x":"25","y":"10")");
const std::string kInfeed = feed(R"("x":"24","y":"10")");
const std::string kHelix = arc(R"("x":"10","y":"10")", -3, R"("x":"24","y":"10","z":"2")");
// By 30 degrees to 16 from the middle.
const std::string kRunOut =
    arc(R"("x":"-198.923048454","y":"10")", -1, R"("x":"23.856406461","y":"2")");
const std::string kBack = rapid(2, R"("z":"8")");
const std::string kAway = rapid(2, R"("x":"27")") + rapid(2, R"("z":"10")");

std::string_view decided(std::string_view program, const std::string& trace, std::string chord = {},
                         std::string reading = {}) {
  Declared declared{.dialect = "gsk988ta", .reading = std::move(reading), .m = false};
  declared.chord = std::move(chord);
  return oracle::name(decide(program, trace, declared).kind);
}

constexpr std::string_view kGo = "pass-tolerance";
constexpr std::string_view kNoGo = "fail.region";

TEST(R8Thread, HasItsStepsInOrder) {
  EXPECT_EQ(decided(kBolt, kBegin + kEntry + kInfeed + kHelix + kRunOut + kBack + kAway), kGo);
}

TEST(R8Thread, IsNotEnteredIntoTheMaterialWithoutAnInfeed) {
  const std::string straight_in = arc(R"("x":"17","y":"10")", -1, R"("x":"24","y":"10")");
  EXPECT_EQ(decided(kBolt, kBegin + straight_in + kHelix + kRunOut + kBack + kAway), kNoGo);
  const std::string round_infeed = arc(R"("x":"24.5","y":"10")", -1, R"("x":"24","y":"10")");
  EXPECT_EQ(decided(kBolt, kBegin + kEntry + round_infeed + kHelix + kRunOut + kBack + kAway),
            kNoGo);
}

TEST(R8Thread, MakesNoRingBeforeItsRunOutAndNoHelixUp) {
  const std::string before = kBegin + kEntry + kInfeed + kHelix;
  const std::string ring = arc(R"("x":"10","y":"10")", -1, R"("x":"24","y":"10")");
  EXPECT_EQ(decided(kBolt, before + ring + kRunOut + kBack + kAway), kNoGo);
  const std::string up = arc(R"("x":"10","y":"10")", -1, R"("x":"23.856406461","y":"2","z":"8")");
  EXPECT_EQ(decided(kBolt, before + kRunOut + up + kAway), kNoGo);
}

TEST(R8Thread, TakesARunOutInPiecesOfOneArc) {
  // Its middle: the end is seen 2.0566 degrees back from the centre.
  const std::string half =
      arc(R"("x":"-198.923048454","y":"10")", -1, R"("x":"23.964098724","y":"5.999355705")") +
      arc(R"("x":"-198.923048454","y":"10")", -1, R"("x":"23.856406461","y":"2")");
  EXPECT_EQ(decided(kBolt, kBegin + kEntry + kInfeed + kHelix + half + kBack + kAway), kGo);
}

// G116: 9 before and 10 behind its pass. X3 lies 10.04 from the middle along the line of the way.
TEST(R8Thread, LeavesABoreAndNotThroughItsWall) {
  constexpr std::string_view kBore =
      "G17 G00 X30 Y14 Z10\nG116 X20 Y10 W-6 R-2 I2 E24 J2 K30 P1 D3 F200\n";
  const std::string trace =
      kBegin +
      arc(R"("x":"10.318317408","y":"5.51127256")", -1, R"("x":"10.636634815","y":"1.022545121")") +
      feed(R"("x":"10.707372017","y":"0.025050134")") +
      arc(R"("x":"10","y":"10")", -3, R"("x":"10.707372017","y":"0.025050134","z":"2")") +
      arc(R"("x":"10.414503213","y":"4.154916127")", -1, R"("x":"6.500101763","y":"2.806203205")") +
      kBack;
  const std::string out = rapid(2, R"("z":"10")");
  EXPECT_EQ(decided(kBore, trace + rapid(2, R"("x":"8")") + out), kGo);
  EXPECT_EQ(decided(kBore, trace + rapid(2, R"("x":"3")") + out), kNoGo);
}

// Corners of the circle of the pass at every quarter of a turn: 14 (1 - cos 45) = 4.10 off it.
TEST(R8Thread, AChordOfTheHelixIsNoFartherFromItThanIsGranted) {
  std::string helix;
  double height = 8;
  for (int turn = 0; turn < 3; ++turn) {
    for (const char* place : {R"("x":"10","y":"-4")", R"("x":"-4","y":"10")",
                              R"("x":"10","y":"24")", R"("x":"24","y":"10")"}) {
      height -= 0.5;
      helix += feed(fmt::format(R"({},"z":"{}")", place, height));
    }
  }
  const std::string trace = kBegin + kEntry + kInfeed + helix + kRunOut + kBack + kAway;
  EXPECT_EQ(decided(kBolt, trace, "4.2"), kGo);
  for (const char* chord : {"", "0.005", "2"}) EXPECT_EQ(decided(kBolt, trace, chord), kNoGo);
}

// Half of the circle about X17.5, of radius 7.5, by two cuts: 7.5 (1 - cos 45) = 2.197 off it.
TEST(R8Thread, AChordOfTheEntryIsNoFartherFromItThanIsGranted) {
  const std::string in = feed(R"("x":"17.5","y":"17.5")") + feed(R"("x":"25","y":"10")");
  const std::string rest = kHelix + kRunOut + kBack + kAway;
  EXPECT_EQ(decided(kBolt, kBegin + in + kInfeed + rest, "2.2"), kGo);
  for (const char* chord : {"", "0.005", "1"}) {
    EXPECT_EQ(decided(kBolt, kBegin + in + kInfeed + rest, chord), kNoGo);
  }
  // One straight cut is no arc; an infeed may have two.
  EXPECT_EQ(decided(kBolt, kBegin + feed(R"("x":"25","y":"10")") + kInfeed + rest, "0.005"), kNoGo);
  const std::string half = feed(R"("x":"24.5","y":"10")");
  EXPECT_EQ(decided(kBolt, kBegin + kEntry + half + kInfeed + rest, "0.005"), kGo);
}

// Two chords of 4 mm of an arc of radius 222.9: 4^2 / (8 * 222.9) = 0.009 off it. By X24.1 it is
// 0.17 off the line between the ends, on a circle of radius 47: 4^2 / (8 * 47) = 0.043.
TEST(R8Thread, AChordOfTheRunOutIsNoFartherFromItThanIsGranted) {
  const auto by = [](std::string_view place) {
    return kBegin + kEntry + kInfeed + kHelix + feed(place) +
           feed(R"("x":"23.856406461","y":"2")") + kBack + kAway;
  };
  const std::string on_arc = by(R"("x":"23.964098724","y":"5.999355705")");
  EXPECT_EQ(decided(kBolt, on_arc, "0.01"), kGo);
  EXPECT_EQ(decided(kBolt, on_arc, "0.005"), kNoGo);
  EXPECT_EQ(decided(kBolt, by(R"("x":"24.1","y":"6")"), "0.01"), kNoGo);
}

// A bore of rho_0 = 3 - 1.5 and a pass at 1.95, J 0.5 as long as the thread is deep and K 45. The
// polar run-out ends at 1.45 from the axis. The radial one ends sqrt(1.95^2 + 0.5^2 -
// 1.95 sqrt(0.5)) = 1.635 from it, in the material.
TEST(R8Thread, TheWayBackKeepsOffTheMaterial) {
  constexpr std::string_view kBore =
      "G17 G00 X2 Y1 Z3\nG116 X0 Y0 W-0.5 R-1 I0.5 E6 J0.5 K45 P0.45 D1.5 F200\n";
  const auto by = [](std::string_view place) {
    return rapid(1, R"("x":"1","y":"1","z":"3")") + rapid(2, R"("x":"0","y":"0")") +
           rapid(2, R"("z":"2")") + arc(R"("x":"0.75","y":"0")", -1, R"("x":"1.5","y":"0")") +
           feed(R"("x":"1.95")") +
           arc(R"("x":"0","y":"0")", -1, R"("x":"1.95","y":"0","z":"1.5")") + feed(place) +
           rapid(2, R"("z":"2")") + rapid(2, R"("x":"0.5")") + rapid(2, R"("z":"3")");
  };
  EXPECT_EQ(decided(kBore, by(R"("x":"1.025304833","y":"-1.025304833")")), kGo);
  EXPECT_EQ(decided(kBore, by(R"("x":"1.596446609","y":"-0.353553391")")), kNoGo);
}

// R9. A bore of rho_0 = 8 and a pass at 8.5: straight along the normal with K 180 are 6 mm into the
// wall; the polar run-out ends at 2.5.
TEST(R8Thread, ARunOutIntoTheWallIsUndecidedUnderItsReadingAlone) {
  constexpr std::string_view kBore =
      "G17 G00 X0 Y0 Z3\nG116 X0 Y0 W-1 R-1 I1 E20 J6 K180 P0.5 D2 F200\n";
  const auto to = [](std::string_view place) {
    return rapid(1, R"("x":"0","y":"0","z":"3")") + rapid(2, R"("z":"2")") +
           arc(R"("x":"4","y":"0")", -1, R"("x":"8","y":"0")") + feed(R"("x":"8.5")") +
           arc(R"("x":"0","y":"0")", -1, R"("x":"8.5","y":"0","z":"1")") + feed(place) +
           rapid(2, R"("z":"2")") + rapid(2, R"("x":"2")") + rapid(2, R"("z":"3")");
  };
  for (const char* reading : {"gsk.thread.runout=any", "gsk.thread.runout=polar"}) {
    EXPECT_EQ(decided(kBore, to(R"("x":"14.5")"), "", reading), kNoGo);
  }
  EXPECT_EQ(decided(kBore, to(R"("x":"14.5")"), "", "gsk.thread.runout=radial"), "oracle-gap");
  EXPECT_EQ(decided(kBore, to(R"("x":"12.5")"), "", "gsk.thread.runout=radial"), kNoGo);
}

// J-THR-05. A pass at 11.5 about the origin, J 2 and K 300: the arc that leaves it tangentially at
// Y11.5 turns about Y-5.263 with the radius 16.763, to 22.026 from the axis; its end is at 13.5.
TEST(R8Thread, ARunOutOverMoreThanHalfATurnGoesRoundItsArc) {
  constexpr std::string_view kWide =
      "G17 G00 X0 Y0 Z3\nG114 X0 Y0 W-1 R-1 I1 E20 J2 K300 P0.5 D2 F200\n";
  const std::string trace =
      rapid(1, R"("x":"0","y":"0","z":"3")") + rapid(2, R"("z":"2")") +
      arc(R"("x":"0","y":"6")", -1, R"("x":"0","y":"12")") + feed(R"("x":"0","y":"11.5")") +
      arc(R"("x":"0","y":"0")", -1, R"("x":"0","y":"11.5","z":"1")") +
      arc(R"("x":"0","y":"-5.263157895")", -1, R"("x":"-11.691342951","y":"6.75")") +
      rapid(2, R"("z":"2")") + rapid(2, R"("x":"-14")") + rapid(2, R"("z":"3")");
  EXPECT_EQ(decided(kWide, trace), kGo);
}

// The groove rises as over 30 degrees.
TEST(R8Thread, KBeyondATurnIsTheAngleWithinIt) {
  constexpr std::string_view kBeyond =
      "G17 G00 X30 Y14 Z10\nG114 X20 Y10 W-6 R-2 I2 E24 J2 K390 P1 D3 F200\n";
  const std::string away = rapid(2, R"("x":"28")") + rapid(2, R"("z":"10")");
  EXPECT_EQ(decided(kBeyond, kBegin + kEntry + kInfeed + kHelix + kRunOut + kBack + away, "",
                    "gsk.thread.k-range=table"),
            kGo);
}

// Arcs of one sense. A quarter that ends toward +X, and one that begins 41 degrees aside of that.
// Two semicircles in a row meet in a point, where the tool turns back.
TEST(R8Thread, AnEntryDoesNotTurnBackAtACorner) {
  const std::string rest = kInfeed + kHelix + kRunOut + kBack + kAway;
  const std::string aside = arc(R"("x":"11","y":"10")", -1, R"("x":"11","y":"11")") +
                            arc(R"("x":"17.5","y":"3.5")", -1, R"("x":"25","y":"10")");
  EXPECT_EQ(decided(kBolt, kBegin + aside + rest), kGo);
  const std::string back = arc(R"("x":"10.5","y":"10")", -1, R"("x":"11","y":"10")") +
                           arc(R"("x":"18","y":"10")", -1, R"("x":"25","y":"10")");
  EXPECT_EQ(decided(kBolt, kBegin + back + rest), kNoGo);
}

}  // namespace
}  // namespace gonogo::relation::thread_steps
