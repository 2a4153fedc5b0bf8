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

std::string_view decided(std::string_view program, const std::string& trace) {
  const Answer answer =
      decide(program, trace, {.dialect = "gsk988ta", .reading = {}, .tool = {}, .m = false});
  return oracle::name(answer.kind);
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

}  // namespace
}  // namespace gonogo::relation::thread_steps
