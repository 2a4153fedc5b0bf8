// SPDX-License-Identifier: GPL-3.0-or-later
// Holes of the expander of rs274 under G7 (NGC-DIA-01): the documents, X1 is 0.5 from the centre.
#include <gtest/gtest.h>

#include <string>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string drilled(const std::string& blocks) {
  return run_ngc("G18 G99 F9\nG7\n" + blocks).motions();
}

// A fuzzer's program, on which the two sides parted: X1 of its third block is 0.5.
TEST(NgcDiameter, HoldsForARepeatOfTheCycleBehindG7) {
  const std::string trace = run_ngc("G18 G83 Q1 R0 Y0 F1\nG7 G81 R0 Y0\nX1\n").trace();
  EXPECT_NE(trace.find("3 rapid x=0.5 z=0\n"), std::string::npos) << trace;
}

TEST(NgcDiameter, HoldsForTheBlockOfTheCycleAndItsRepeats) {
  EXPECT_EQ(drilled("G81 X8 Z3 Y-1 R0\nX-6\n"),
            "rapid x=4 z=3\nfeed y=-1 f=9\nrapid y=0\n"
            "rapid x=-3 z=3\nfeed y=-1 f=9\nrapid y=0\n");
}

// From X4, which is 2: two steps of X1, 0.5 each, and one of X-3.
TEST(NgcDiameter, HoldsForStepsOfL) {
  EXPECT_EQ(drilled("G0 X4\nG91 G81 X1 Y-1 R0 L2\nX-3\n"),
            "rapid x=2\nrapid x=2.5 z=0\nfeed y=-1 f=9\nrapid y=0\n"
            "rapid x=3 z=0\nfeed y=-1 f=9\nrapid y=0\n"
            "rapid x=1.5 z=0\nfeed y=-1 f=9\nrapid y=0\n");
}

// In inches: X2 is 25.4 mm from the centre.
TEST(NgcDiameter, HoldsInInches) {
  EXPECT_EQ(drilled("G81 X8 Y-1 R0\nG20 F1\nX2 Y0\n"),
            "rapid x=4 z=0\nfeed y=-1 f=9\nrapid y=0\nrapid x=25.4 z=0\n");
}

// X alone: Y of the depth, Z of the place and R are no diameters.
TEST(NgcDiameter, EndsWithG8) {
  EXPECT_EQ(drilled("G81 X8 Y-1 R0\nG8\nX8\nG91 X8\n"),
            "rapid x=4 z=0\nfeed y=-1 f=9\nrapid y=0\n"
            "rapid x=8 z=0\nfeed y=-1 f=9\nrapid y=0\n"
            "rapid x=16 z=0\nfeed y=-1 f=9\nrapid y=0\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
