// SPDX-License-Identifier: GPL-3.0-or-later
// The other codes of GSK-COM-05.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(GskBasic, RapidAndFeed) {
  EXPECT_EQ(run("G0 X10 Y1 Z2\nG1 X8 F120\nZ3\n").motions(),
            "rapid x=5 y=1 z=2\nfeed x=4 f=120\nfeed z=3 f=120\n");
}

TEST(GskBasic, IncrementsAndTheRotaryAxis) {
  EXPECT_EQ(run("G0 U10 V1 W2 C90\nU10 H-30\n").motions(),
            "rapid x=5 y=1 z=2 c=90\nrapid x=10 c=60\n");
}

TEST(GskBasic, MotionWithoutLengthSendsNothing) {
  EXPECT_EQ(run("G0 X0\n").motions(), "");
}

TEST(GskBasic, DwellInMillisecondsOrSeconds) {
  EXPECT_EQ(run("G04 P1500\nG04 X2\nG04 U0.25\nG20 G04 X2\n").motions(),
            "dwell 1.5\ndwell 2\ndwell 0.25\ndwell 2\n");
}

TEST(GskBasic, FeedPerRevolution) {
  EXPECT_EQ(run("G99 G1 X2 F0.2\nG98 Z1 F50\n").motions(), "feed x=1 f=0.2/rev\nfeed z=1 f=50\n");
}

TEST(GskBasic, InchLengthsAndFeeds) {
  EXPECT_EQ(run("G20 G1 X1 Z0.0001 F2\nG21 X1\n").motions(),
            "feed x=12.7 z=0.00254 f=50.8\nfeed x=0.5 f=50.8\n");
}

TEST(GskBasic, HomeGoesByThePointOfTheBlock) {
  EXPECT_EQ(run("G0 X10 Y5 Z20\nG28 X30 Z30\n").motions(),
            "rapid x=5 y=5 z=20\nrapid x=15 z=30\nrapid x=0 z=0\n");
}

TEST(GskBasic, HomeIsTheProfilesReferencePoint) {
  EXPECT_EQ(run("G28 U0 W0\n", R"({"reference_point":{"x":"100","z":"200"}})").motions(),
            "rapid x=100 z=200\n");
}

TEST(GskBasic, RenamingSendsNothingAndCountsOnFromThere) {
  // X50 (diameter) becomes the name of the position; W5 adds to Z.
  EXPECT_EQ(run("G0 X10 Z20\nG50 X50 W5 S2000\nU2 W1\n").motions(),
            "rapid x=5 z=20\nrapid x=26 z=26\n");
}

TEST(GskBasic, CodesWithoutEffect) {
  EXPECT_EQ(run("G40 G54 G64 G97 G0 X2 T0101 S500\nG96 G61\n").motions(), "rapid x=1\n");
}

TEST(GskBasic, FunctionsBeforeAndAfterTheMotion) {
  EXPECT_EQ(run("G0 X2 M3\nX4 M5\n").motions(), "m 3\nrapid x=1\nrapid x=2\nm 5\n");
}

TEST(GskBasic, NothingRunsAfterTheEnd) {
  for (const char* m : {"2", "17", "30"}) {
    const Outcome outcome = run(std::string("G0 X2 M") + m + "\nX4\nG999\n");
    EXPECT_EQ(outcome.all(),
              std::string("answer 0\n1 rapid x=1\n1 m ") + m + "\n1 end x=1 y=0 z=0 a=0 c=0\n");
  }
}

TEST(GskBasic, EmptyProgramEnds) {
  EXPECT_EQ(run("").all(), "answer 0\n0 end x=0 y=0 z=0 a=0 c=0\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
