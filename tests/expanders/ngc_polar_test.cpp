// SPDX-License-Identifier: GPL-3.0-or-later
// Words @ and ^ of the expander of rs274 (NGC-POL-01 to 04).
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// LinuxCNC's page: a square, by four times 90 degrees.
TEST(NgcPolar, AnglesAddUnderG91) {
  EXPECT_EQ(run_ngc("F9 G1 @.5 ^90\nG91 ^90\n^90\n^90\n").motions(),
            "feed x=0 y=0.5 f=9\nfeed x=-0.5 y=0 f=9\nfeed x=0 y=-0.5 f=9\nfeed x=0.5 y=0 f=9\n");
}

// 3-4-5
TEST(NgcPolar, WhatIsLeftOutStays) {
  EXPECT_EQ(run_ngc("G0 X3 Y4\n@10\n^0\nG91 @-5\n").motions(),
            "rapid x=3 y=4\nrapid x=6 y=8\nrapid x=10 y=0\nrapid x=5 y=0\n");
}

TEST(NgcPolar, HolesTurnOn) {
  EXPECT_EQ(run_ngc("F9 G0 X10\nG91 G99 G81 ^90 L2 R0 Z-1\n").motions(),
            "rapid x=10\nrapid x=0 y=10\nfeed z=-1 f=9\nrapid z=0\nrapid x=-10 y=0\nfeed z=-1 f=9\n"
            "rapid z=0\n");
}

TEST(NgcPolar, NeedADirectionAndNeitherXNorY) {
  EXPECT_EQ(run_ngc("G91 G0 ^30\n").trace(), "alarm missing-word in 1\n");
  EXPECT_EQ(run_ngc("G0 @5 ^30 Y2\n").trace(), "alarm conflicting-words in 1\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
