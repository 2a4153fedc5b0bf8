// SPDX-License-Identifier: GPL-3.0-or-later
//
// G82, its paths. Points of the sources are diameters; records are radii.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// An older text: A X35 Z104, passes at X 29.2, 28.6, 28.2, 28.04 to Z56, lead 1.5.
TEST(G82, CutsTheStraightThreadOfTheManual) {
  Lines want;
  for (const char* x : {"14.6", "14.3", "14.1", "14.02"}) {
    want.push_back(std::string("rapid x") + x);
    want.push_back(std::string("thread x") + x + " z56 lead1.5 start0");
    want.push_back("rapid x17.5");
    want.push_back("rapid z104");
  }
  EXPECT_EQ(cycle("G55 G90 G00 X35 Z104 M03",
                  "G82 X29.2 Z56 F1.5\nG82 X28.6 Z56 F1.5\nG82 X28.2 Z56 F1.5\n"
                  "G82 X28.04 Z56 F1.5\nM05\nM30"),
            want);
}

// The textbook's shaft: A X60 Z-24, later passes by X and Z alone.
TEST(G82, RepeatsWithoutItsCode) {
  Lines want;
  for (const char* x : {"24.55", "24.25", "23.95", "23.75", "23.7"}) {
    want.push_back(std::string("rapid x") + x);
    want.push_back(std::string("thread x") + x + " z-46 lead2 start0");
    want.push_back("rapid x30");
    want.push_back("rapid z-24");
  }
  want.push_back("rapid x50 z80");
  const Lines got = path(
      "M03 S300\nG00 X60\nZ-24\nG82 X49.1 Z-46 F2\nX48.5 Z-46\nX47.9 Z-46\nX47.5 Z-46\n"
      "X47.4 Z-46\nG00 X100 Z80");
  EXPECT_EQ(Lines(got.begin() + 2, got.end()), want);
}

// A X80 Z62, I -5: B at X 38.1, 37.5, 36.9, 36.5, 36.4 and C at X 48.1, 47.5, 46.9, 46.5, 46.4 as
// diameters, Z 12.
TEST(G82, CutsATaperThreadInIncrements) {
  Lines want;
  for (const auto& [b, c] :
       {std::pair{"19.05", "24.05"}, std::pair{"18.75", "23.75"}, std::pair{"18.45", "23.45"},
        std::pair{"18.25", "23.25"}, std::pair{"18.2", "23.2"}}) {
    want.push_back(std::string("rapid x") + b);
    want.push_back(std::string("thread x") + c + " z12 lead2 start0");
    want.push_back("rapid x40");
    want.push_back("rapid z62");
  }
  const Lines got = cycle("G92 X80 Z62",
                          "M03\nG91 G82 X-31.9 Z-50 I-5 F2\nG82 X-32.5 Z-50 I-5 F2\n"
                          "G82 X-33.1 Z-50 I-5 F2\nG82 X-33.5 Z-50 I-5 F2\nG82 X-33.6 Z-50 I-5 F2");
  EXPECT_EQ(got, want);
}

// A X35 Z5: the run-out ends at X31.8 Z-42.
TEST(G82, RunsOutBeyondC) {
  EXPECT_EQ(cycle("G00 X35 Z5", "G82 X29.2 Z-40 R-2 E1.3 F1.5"),
            (Lines{"rapid x14.6", "thread x14.6 z-40 lead1.5 start0",
                   "thread x15.9 z-42 lead1.5 start0", "rapid x17.5", "rapid z5"}));
}

// A X36 Z4, I -1.25: B X27.5, the run-out ends at X32.6 Z-42.
TEST(G82, RunsOutOfATaper) {
  EXPECT_EQ(cycle("G00 X36 Z4", "G82 X30 Z-40 I-1.25 R-2 E1.3 F1.5"),
            (Lines{"rapid x13.75", "thread x15 z-40 lead1.5 start0",
                   "thread x16.3 z-42 lead1.5 start0", "rapid x18", "rapid z4"}));
}

// M30x1.5 with two starts, 180 degrees apart.
TEST(G82, CutsEveryStartInItsOwnPass) {
  EXPECT_EQ(
      cycle("G00 X35 Z104", "G82 X29.2 Z18.5 C2 P180 F3"),
      (Lines{"rapid x14.6", "thread x14.6 z18.5 lead3 start0", "rapid x17.5", "rapid z104",
             "rapid x14.6", "thread x14.6 z18.5 lead3 start180", "rapid x17.5", "rapid z104"}));
}

// Angles 0, 250, 500 - 360, 750 - 720.
TEST(G82, StartAnglesAreModulo360) {
  const Lines got = path("G82 X20 Z-10 C4 P250 F3");
  EXPECT_EQ(got.at(1), "thread x10 z-10 lead3 start0");
  EXPECT_EQ(got.at(5), "thread x10 z-10 lead3 start250");
  EXPECT_EQ(got.at(9), "thread x10 z-10 lead3 start140");
  EXPECT_EQ(got.at(13), "thread x10 z-10 lead3 start30");
}

// The run-out of pass k keeps the start of pass k.
TEST(G82, ARunOutKeepsTheStart) {
  EXPECT_EQ(path("G82 X20 Z-10 R-1 E1 C2 P90 F3").at(7), "thread x11 z-11 lead3 start90");
}

TEST(G82, ASingleStartBeginsAtP) {
  EXPECT_EQ(path("G82 X20 Z-10 P90 F3").at(1), "thread x10 z-10 lead3 start90");
  EXPECT_EQ(path("G82 X20 Z-10 C0 P90 F3").at(1), "thread x10 z-10 lead3 start90");
  EXPECT_EQ(path("G82 X20 Z-10 C1 P-90 F3").at(1), "thread x10 z-10 lead3 start270");
  EXPECT_EQ(path("G82 X20 Z-10 P720.5 F3").at(1), "thread x10 z-10 lead3 start0.5");
}

TEST(G82, CutsOneStartUnderItsReading) {
  const Profile one = hnc({{"hnc.g82.starts", "one"}});
  EXPECT_EQ(path("G82 X20 Z-10 C2 P180 F3", one),
            (Lines{"rapid x10", "thread x10 z-10 lead3 start0", "rapid x0", "rapid z0"}));
}

TEST(G82, GoesOutAsAThreadUnderItsReading) {
  const Profile feed = hnc({{"hnc.g82.exit", "feed"}});
  EXPECT_EQ(cycle("G00 X35 Z5", "G82 X29.2 Z-40 R-2 E1.3 P30 F1.5", feed),
            (Lines{"rapid x14.6", "thread x14.6 z-40 lead1.5 start30",
                   "thread x15.9 z-42 lead1.5 start30", "thread x17.5 z-42 lead1.5 start30",
                   "rapid z5"}));
}

// E 2.6 as a diameter is 1.3 along X; under G37 there are no diameters.
TEST(G82, TakesEAsADiameterUnderItsReading) {
  const Profile diameter = hnc({{"hnc.g82.e-scale", "diameter"}});
  EXPECT_EQ(cycle("G00 X35 Z5", "G82 X29.2 Z-40 R-2 E2.6 F1.5", diameter).at(2),
            "thread x15.9 z-42 lead1.5 start0");
  EXPECT_EQ(cycle("G37 G00 X17.5 Z5", "G82 X14.6 Z-40 R-2 E1.3 F1.5", diameter).at(2),
            "thread x15.9 z-42 lead1.5 start0");
}

TEST(G82, RetainsItsWords) {
  EXPECT_EQ(path("G82 X20 Z-10 I-1 R-2 E1 C1 P45 F3\nX18 Z-10").at(6),
            "thread x9 z-10 lead3 start45");
  EXPECT_EQ(path("G82 X20 Z-10 I-1 R-2 E1 C1 P45 F3\nX18 Z-10").at(7),
            "thread x10 z-12 lead3 start45");
}

// J1 is an inch, under G21 and G20; F is mm under both.
TEST(G82, TakesTheLeadInMmByFAndInInchesByJ) {
  EXPECT_EQ(path("G82 X20 Z-10 J1").at(1), "thread x10 z-10 lead25.4 start0");
  EXPECT_EQ(path("G20 G82 X20 Z-10 J1").at(1), "thread x254 z-254 lead25.4 start0");
  EXPECT_EQ(path("G20 G82 X20 Z-10 F2").at(1), "thread x254 z-254 lead2 start0");
}

TEST(G82, TakesFInTheUnitsInForceUnderItsReading) {
  const Profile units = hnc({{"hnc.lead.unit", "units"}});
  EXPECT_EQ(path("G20 G82 X20 Z-10 F2", units).at(1), "thread x254 z-254 lead50.8 start0");
  EXPECT_EQ(path("G20 G82 X20 Z-10 J2", units).at(1), "thread x254 z-254 lead50.8 start0");
  EXPECT_EQ(path("G21 G82 X20 Z-10 F2", units).at(1), "thread x10 z-10 lead2 start0");
}

TEST(G82, ALaterFReplacesJ) {
  EXPECT_EQ(path("G82 X20 Z-10 J1\nX18 Z-10 F2").at(5), "thread x9 z-10 lead2 start0");
}

TEST(G82, NamesTheClauseOfEachMotion) {
  EXPECT_EQ(clauses("G82 X20 Z-10 R-1 E1 F3"),
            (Lines{"HNC-G82-01", "HNC-G82-01", "HNC-G82-02", "HNC-G82-01", "HNC-G82-01"}));
}

TEST(G82, AsksItsReadingsOnlyWhereTheyMatter) {
  EXPECT_EQ(touched("G82 X20 Z-10 F3"), Lines{"hnc.g82.exit"});
  EXPECT_EQ(touched("G82 X20 Z-10 C2 P90 F3"),
            (Lines{"hnc.g82.exit", "hnc.g82.starts", "hnc.g82.order"}));
  EXPECT_EQ(touched("G82 X20 Z-10 R-1 E1 F3"), (Lines{"hnc.g82.exit", "hnc.g82.e-scale"}));
  EXPECT_EQ(touched("G37 G82 X20 Z-10 R-1 E1 F3"), Lines{"hnc.g82.exit"});
  EXPECT_EQ(touched("G20 G82 X20 Z-10 F3"), (Lines{"hnc.g82.exit", "hnc.lead.unit"}));
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
