// SPDX-License-Identifier: GPL-3.0-or-later
//
// Threads that were derived by hand; LinuxCNC 2.9 as measured makes the same.
#include <gtest/gtest.h>

#include "ngc_trace.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

constexpr std::string_view kDrive = "G18 S100 M3\nG0 X20 Z2\n";

std::string threads(const std::string& blocks, const Profile& profile = ngc()) {
  return trace(std::string(kDrive) + blocks + "\nM2", profile);
}

std::vector<Record> records(std::string_view program, RecordKind kind,
                            const Profile& profile = ngc()) {
  std::vector<Record> found;
  for (const Item& item : expand(program, profile)) {
    const Record* record = std::get_if<Record>(&item);
    if (record != nullptr && record->kind == kind) found.push_back(*record);
  }
  return found;
}

// W41: three passes, d = 0.5, 1, 1.5.
TEST(NgcWorkedThreads, EqualDepthsUpToTheFullOne) {
  const std::string want =
      "M3 R20,0,2 R21,0,2 R18.5,0,2 T18.5,0,-20@2 R21,0,-20 R20.5,0,2 R18,0,2 T18,0,-20@2 "
      "R20.5,0,-20 R20,0,2 R17.5,0,2 T17.5,0,-20@2 R20,0,-20";
  EXPECT_EQ(threads("G76 P2 Z-20 I-1 J0.5 K1.5"), want);
  EXPECT_EQ(threads("G76 P2 Z-20 I-1 J0.5 K1.5", column("linuxcnc")), want);
}

// LinuxCNC's page of G76: I, J and K are diameters under G7, as X is.
TEST(NgcWorkedThreads, LengthsAcrossAreDiametersUnderG7) {
  EXPECT_EQ(trace("G7\nG18 S100 M3\nG0 X40 Z2\nG76 P2 Z-20 I-2 J1 K3\nM2", ngc()),
            threads("G76 P2 Z-20 I-1 J0.5 K1.5"));
}

// W42: d = 0.5 sqrt n while n < (K/J)^2 = 4, so 0.5, sqrt(2)/2, sqrt(3)/2; then 1 twice.
TEST(NgcWorkedThreads, DepthsByTheRootOfTheNumberOfThePass) {
  const std::string program = std::string(kDrive) + "G76 P2 Z-20 I-1 J0.5 K1 R2 H1\nM2";
  const Number half = num("1/2");
  const std::vector<Number> depths = {half, Number::root(0, half, 2), Number::root(0, half, 3), 1,
                                      1};
  const std::vector<Record> cuts = records(program, RecordKind::thread);
  ASSERT_EQ(cuts.size(), depths.size());
  const std::vector<Record> rapids = records(program, RecordKind::rapid);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    EXPECT_EQ(cuts[i].to[Axis::x], 19 - depths[i]);
    EXPECT_EQ(cuts[i].to[Axis::z], -20);
    EXPECT_EQ(cuts[i].lead, 2);
    // After the traverse to the drive line, each pass has three.
    EXPECT_EQ(rapids[1 + 3 * i].to[Axis::x], 21 - depths[i]);
    EXPECT_EQ(rapids[1 + 3 * i].to[Axis::z], 2);
    EXPECT_EQ(rapids[3 + 3 * i].to[Axis::x], 21 - depths[i]);
  }
  EXPECT_EQ(ending_of(program), "end x20 y0 z-20 a0 c0");
  EXPECT_EQ(cuts[1].to[Axis::x].decimal_text(6), "18.292893");
  EXPECT_EQ(cuts[2].to[Axis::x].decimal_text(6), "18.133975");
}

// W43: inside, tapers at both ends; the way in has the path lead 2 sqrt(5)/2 of the taper.
TEST(NgcWorkedThreads, TapersAtBothEnds) {
  const std::string want =
      "M3 R20,0,2 R19.5,0,2 T20.5,0,2@sqrt(5) T21.5,0,0@2 T21.5,0,-18@2 T20.5,0,-20@2 "
      "R19.5,0,-20 R20,0,2 T21,0,2@sqrt(5) T22,0,0@2 T22,0,-18@2 T21,0,-20@2 R20,0,-20";
  EXPECT_EQ(threads("G76 P2 Z-20 I1 J0.5 K1 L3 E2"), want);
  EXPECT_EQ(threads("G76 P2 Z-20 I1 J0.5 K1 L3 E2", column("linuxcnc")), want);
}

// W44: E < K, so that X is the longer axis of the taper: P K/E = 4.
TEST(NgcWorkedThreads, ATaperThatIsSteep) {
  EXPECT_EQ(threads("G76 P2 Z-20 I-1 J0.5 K1 L2 E0.5"),
            "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-19.5@2 T19.5,0,-20@4 R20.5,0,-20 R20,0,2 "
            "R18,0,2 T18,0,-19.5@2 T19,0,-20@4 R20,0,-20");
}

std::vector<std::string> places(const std::string& program) {
  std::vector<std::string> found;
  Position at;
  for (const Item& item : expand(program, ngc())) {
    const Record* record = std::get_if<Record>(&item);
    if (record == nullptr || !is_motion(record->kind)) continue;
    for (const Axis axis : kAllAxes) {
      if (record->axes.has(axis)) at[axis] = record->to[axis];
    }
    found.push_back(at[Axis::x].decimal_text(6) + " " + at[Axis::z].decimal_text(6));
  }
  return found;
}

// W45: t = tan 30 = 1/sqrt(3).
TEST(NgcWorkedThreads, SlideAlongAnAngle) {
  const std::string program = std::string(kDrive) + "G76 P2 Z-20 I-1 J0.5 K1.5 Q30\nM2";
  EXPECT_EQ(places(program),
            (Lines{"20.000000 2.000000", "21.000000 1.711325", "18.500000 1.711325",
                   "18.500000 -19.422650", "21.000000 -19.422650", "20.500000 1.422650",
                   "18.000000 1.422650", "18.000000 -19.711325", "20.500000 -19.711325",
                   "20.000000 1.133975", "17.500000 1.133975", "17.500000 -20.000000",
                   "20.000000 -20.000000"}));
  const std::vector<Record> cuts = records(program, RecordKind::thread);
  const Number t = Number::root(0, num("1/3"), 3);
  EXPECT_EQ(cuts[0].to[Axis::z], t - 20);
  EXPECT_EQ(cuts[1].to[Axis::z], t / 2 - 20);
  EXPECT_EQ(cuts[2].to[Axis::z], -20);
}

// W46: towards +Z, with tapers.
TEST(NgcWorkedThreads, SlideTowardsPlusZ) {
  EXPECT_EQ(places("G18 S100 M3\nG0 X20 Z-20\nG76 P2 Z2 I-1 J0.5 K1 L3 E2 Q30\nM2"),
            (Lines{"20.000000 -20.000000", "20.500000 -19.711325", "19.500000 -19.711325",
                   "18.500000 -17.711325", "18.500000 -0.288675", "19.500000 1.711325",
                   "20.500000 1.711325", "20.000000 -19.422650", "19.000000 -19.422650",
                   "18.000000 -17.422650", "18.000000 0.000000", "19.000000 2.000000",
                   "20.000000 2.000000"}));
}

// W47: Z counts from where the block begins.
TEST(NgcWorkedThreads, UnderG91ZIsAStep) {
  EXPECT_EQ(trace("S100 M3\nG0 X20 Z2\nG91 G18 G76 P2 Z-20 I-1 J0.5 K1\nM2"),
            "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-18@2 R20.5,0,-18 R20,0,2 R18,0,2 "
            "T18,0,-18@2 R20,0,-18");
}

// W48: a line of 5 whose longer axis is Z: 1.5 * 4/5.
TEST(NgcWorkedThreads, TheLeadIsAlongThePath) {
  EXPECT_EQ(trace("S300 M3\nG0 X3 Z4\nG33 X6 Z0 K1.5\nM2"), "M3 R3,0,4 T6,0,0@1.2");
  EXPECT_EQ(trace("S300 M3\nG33 X4 Z3 K1.5\nM2"), "M3 T4,0,3@1.2");  // and X: the same
}

// W49: 2 * 22/sqrt(485) = 44/sqrt(485) = 44 sqrt(485)/485.
TEST(NgcWorkedThreads, KStandsInEveryBlock) {
  EXPECT_EQ(trace("S100 M3\nG0 X20 Z2\nG33 X21 Z-20 K2\nZ-30 K1\nZ-40\nM2"),
            "M3 R20,0,2 T21,0,-20@44/485*sqrt(485) T21,0,-30@1 !b5:lead-missing");
}

// W50.
TEST(NgcWorkedThreads, ARigidTapEndsWhereItBegan) {
  EXPECT_EQ(trace("S300 M3\nG0 X3 Z4\nG33.1 Z0 K1.5\nG0 X5\nM2"),
            "M3 R3,0,4 T3,0,0@1.5 M4 T3,0,4@1.5 M3 R5,0,4");
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
