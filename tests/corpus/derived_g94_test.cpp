// SPDX-License-Identifier: GPL-3.0-or-later
//
// G94 derived by hand from the manual, against the vectors. In G18, the power-on plane, p is Z
// and q is X; B = C + R on p; X words are diameters and records hold radii.
#include <gtest/gtest.h>

#include "derived.hpp"

namespace gonogo::testing {
namespace {

TEST(DerivedG94, TheExampleOfTheManual) {
  // X130 is radius 65. Line 4 moves A to (60, 0). R is kept in units of length: B_z = -30 + R.
  const Lines want = {"1 m 3",
                      "1 rapid x65 z5",
                      "2 rapid z0",
                      "2 feed x0 z0 f200",
                      "2 feed z5 f200",
                      "2 rapid x65",
                      "3 rapid z-110",
                      "3 feed x60 z-110 f300",
                      "3 feed z5 f300",
                      "3 rapid x65",
                      "4 rapid x60 z0",
                      "5 rapid z-40",
                      "5 feed x54 z-30 f300",
                      "5 feed z0 f300",
                      "5 rapid x60",
                      "6 rapid z-50",
                      "6 feed x48 z-30 f300",
                      "6 feed z0 f300",
                      "6 rapid x60",
                      "7 rapid z-60",
                      "7 feed x42 z-30 f300",
                      "7 feed z0 f300",
                      "7 rapid x60",
                      "8 rapid z-70",
                      "8 feed x36 z-30 f300",
                      "8 feed z0 f300",
                      "8 rapid x60",
                      "9 rapid z-80",
                      "9 feed x30 z-30 f300",
                      "9 feed z0 f300",
                      "9 rapid x60",
                      "10 m 30",
                      "end x60 y0 z0 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000001"), want);
}

// Line 2 of the programs that begin "G00 X100 Z5 / G94 X60 Z-5 R-2 F100": A (50, 5), C (30, -5),
// B_z = -5 - 2.
const Lines kTapered = {"1 rapid x50 z5", "2 rapid z-7", "2 feed x30 z-5 f100", "2 feed z5 f100",
                        "2 rapid x50"};

TEST(DerivedG94, XAloneKeepsZAndR) {
  const Lines want = kTapered + Lines{"3 rapid z-7", "3 feed x25 z-5 f100", "3 feed z5 f100",
                                      "3 rapid x50", "end x50 y0 z5 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000088"), want);
}

TEST(DerivedG94, ADwellByXIsNoEndPoint) {
  // B_z = -8 - 2.
  const Lines want = kTapered + Lines{"3 dwell 2.5",    "4 rapid z-10", "4 feed x30 z-8 f100",
                                      "4 feed z5 f100", "4 rapid x50",  "end x50 y0 z5 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000099"), want);
}

TEST(DerivedG94, AfterTheReferencePointTheWordsAreGone) {
  // G28 by (60, 10) to (0, 0); X-20 is radius -10, Z without travel, R 0.
  const Lines home = kTapered + Lines{"3 rapid x60 z10", "3 rapid x0 z0"};
  const Lines stays = home + Lines{"4 rapid z0", "4 feed x-10 z0 f100", "4 feed z0 f100",
                                   "4 rapid x0", "end x0 y0 z0 a0 c0"};
  const Lines cancelled = home + Lines{"4 rapid x-10", "end x-10 y0 z0 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000100", 0), stays);
  EXPECT_EQ(records_of("gsk.g94.000100", 1), cancelled);
}

TEST(DerivedG94, AfterG00TheTaperIsGone) {
  const Lines want = kTapered + Lines{"3 rapid x50 z5", "4 rapid z-5", "4 feed x25 z-5 f100",
                                      "4 feed z5 f100", "4 rapid x50", "end x50 y0 z5 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000102"), want);
}

TEST(DerivedG94, IncrementsAreTakenFromAAgain) {
  // U-40 is 20 of radius, U-50 is 25; W-10 and W-12 from Z5.
  const Lines want = {"1 rapid x50 z5",      "2 rapid z-5",         "2 feed x30 z-5 f100",
                      "2 feed z5 f100",      "2 rapid x50",         "3 rapid z-5",
                      "3 feed x25 z-5 f100", "3 feed z5 f100",      "3 rapid x50",
                      "4 rapid z-7",         "4 feed x25 z-7 f100", "4 feed z5 f100",
                      "4 rapid x50",         "end x50 y0 z5 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000095"), want);
}

TEST(DerivedG94, InG17PIsXAndRATrueLength) {
  // X10 is radius 5, X-10 radius -5; B_x = -5 + 6.5.
  const Lines want = {"1 rapid x5 y60", "2 rapid x1.5", "2 feed x-5 y40 f200", "2 feed x5 f200",
                      "2 rapid y60",    "3 m 30",       "end x5 y60 z0 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000007"), want);
}

TEST(DerivedG94, InG19PIsYAndQIsZ) {
  // B_y = -5 + 6.5.
  const Lines want = {"1 rapid y5 z60", "2 rapid y1.5", "2 feed y-5 z40 f200", "2 feed y5 f200",
                      "2 rapid z60",    "3 m 30",       "end x0 y5 z60 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000031"), want);
}

TEST(DerivedG94, InInch) {
  // X4 is radius 2 in = 50.8, Z0.2 = 5.08, X2 = 25.4, Z-0.5 = -12.7, R-0.1 = -2.54, F8 = 203.2.
  const Lines want = {"2 rapid x50.8 z5.08", "3 rapid z-15.24", "3 feed x25.4 z-12.7 f203.2",
                      "3 feed z5.08 f203.2", "3 rapid x50.8",   "end x50.8 y0 z5.08 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000119"), want);
}

TEST(DerivedG94, InInchToTheLastIncrement) {
  // X4.0001 is 4.0001 * 12.7 = 50.80127 of radius, Z0.0003 is 0.00762, X2.0001 is 25.40127.
  const Lines want = {
      "1 rapid x50.80127 z0.00762", "2 rapid z-12.7",    "2 feed x25.40127 z-12.7 f203.2",
      "2 feed z0.00762 f203.2",     "2 rapid x50.80127", "end x50.80127 y0 z0.00762 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000120"), want);
}

TEST(DerivedG94, UnitsDoNotChangeRetainedLengths) {
  // X2 under G20 is radius 25.4; Z-5 and R-2 stay millimetres.
  const Lines want = kTapered + Lines{"4 rapid z-7", "4 feed x25.4 z-5 f100", "4 feed z5 f100",
                                      "4 rapid x50", "end x50 y0 z5 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000121"), want);
}

TEST(DerivedG94, ARetainedWordWaitsForItsPlane) {
  // Z30 is C_p in G18 and C_q in G19; X is retained through G19.
  const Lines want = {"1 rapid x50 y10 z50", "2 rapid z30",          "2 feed x40 z30 f100",
                      "2 feed z50 f100",     "2 rapid x50",          "3 rapid y5",
                      "3 feed y5 z30 f100",  "3 feed y10 f100",      "3 rapid z50",
                      "4 rapid z30",         "4 feed x45 z30 f100",  "4 feed z50 f100",
                      "4 rapid x50",         "end x50 y10 z50 a0 c0"};
  EXPECT_EQ(records_of("gsk.g94.000114"), want);
}

}  // namespace
}  // namespace gonogo::testing
