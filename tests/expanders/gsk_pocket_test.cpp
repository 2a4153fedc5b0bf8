// SPDX-License-Identifier: GPL-3.0-or-later
// G110 and G111. Profiles with x_diameter = false unless a test is about diameters.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// The concentric path at one depth in G18 about (Z, X) = centre: each circle from its +Z point.
std::string circles(double z, const std::string& x, std::initializer_list<int> radii,
                    const std::string& rot, const std::string& feed) {
  std::string text;
  const auto centre = static_cast<int>(z);
  for (const int radius : radii) {
    const std::string end = std::to_string(centre + radius);
    text += "feed z=" + end + " f=" + feed + "\narc18 c=" + std::to_string(centre) + "," + x +
            " rot=" + rot + " x=" + x + " z=" + end + " f=" + feed + "\n";
  }
  return text;
}

TEST(GskPocket, ManualExampleMillsFiveLayers) {
  // Initial Y50, R plane Y45, bottom Y20: layers Y40 to Y20; I - D = 12; circles 3, 6, 9, 12.
  const Outcome outcome = run(
      "N100 G18 G0 X70 Z70 Y50\nN110 G110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\n", kRadiusProfile);
  std::string expected = "rapid x=70 y=50 z=70\nrapid x=50 z=50\nrapid y=45\n";
  const int depths[] = {40, 35, 30, 25, 20};
  for (const int depth : depths) {
    if (depth != 40) expected += "rapid y=" + std::to_string(depth + 6) + "\n";
    expected += "feed y=" + std::to_string(depth) + " f=800\n";
    expected += circles(50, "50", {3, 6, 9, 12}, "-1", "800");
    expected += "rapid y=45\nrapid x=50 z=50\n";
  }
  EXPECT_EQ(outcome.motions(), expected + "rapid y=50\n");
  EXPECT_EQ(outcome.blocks.back(), 2u);
}

TEST(GskPocket, CentreInXIsADiameter) {
  const Outcome outcome = run("G110 X50 Z50 Y-2 I3 L3 Q5 D2 F800\n");
  EXPECT_EQ(outcome.motions(), "rapid x=25 z=50\nfeed y=-2 f=800\n" +
                                   circles(50, "25", {1}, "-1", "800") +
                                   "rapid y=0\nrapid x=25 z=50\n");
}

TEST(GskPocket, LastCircleTakesWhatRemains) {
  // I10 D2: 8 = 3, 6, 8.
  const Outcome outcome = run("G111 X0 Z20 Y-1 I10 L3 Q5 D2 F100\n", kRadiusProfile);
  EXPECT_EQ(outcome.motions(), "rapid x=0 z=20\nfeed y=-1 f=100\n" +
                                   circles(20, "0", {3, 6, 8}, "1", "100") +
                                   "rapid y=0\nrapid x=0 z=20\n");
}

TEST(GskPocket, LastLayerTakesWhatRemains) {
  // R plane 45, bottom 22: 40 35 30 25 22. P omitted is 0: the rapid goes to the last depth.
  const Outcome outcome = run("G0 Y50\nG110 X0 Z0 Y22 R-5 I3 L3 Q5 D2 F100\n", kRadiusProfile);
  std::string plunges;
  for (const std::string& record : outcome.records) {
    if (record.find(" y=") != std::string::npos && record[0] != 'e') plunges += record + "\n";
  }
  EXPECT_EQ(plunges,
            "rapid y=50\nrapid y=45\nfeed y=40 f=100\nrapid y=45\nrapid y=40\nfeed y=35 f=100\n"
            "rapid y=45\nrapid y=35\nfeed y=30 f=100\nrapid y=45\nrapid y=30\nfeed y=25 f=100\n"
            "rapid y=45\nrapid y=25\nfeed y=22 f=100\nrapid y=45\nrapid y=50\n");
}

TEST(GskPocket, ReentryNeverGoesBeyondTheRPlane) {
  // P9 above depth 5 would be 4 above the R plane; P is taken by its size.
  for (const char* p : {"P9", "P-9"}) {
    const Outcome outcome =
        run(std::string("G110 X0 Z0 Y-10 I3 L3 Q5 D2 F100 ") + p + "\n", kRadiusProfile);
    EXPECT_EQ(outcome.motions(), "feed y=-5 f=100\n" + circles(0, "0", {1}, "-1", "100") +
                                     "rapid y=0\nrapid x=0 z=0\nfeed y=-10 f=100\n" +
                                     circles(0, "0", {1}, "-1", "100") +
                                     "rapid y=0\nrapid x=0 z=0\n")
        << p;
  }
}

TEST(GskPocket, IncrementalDepthCountsFromTheRPlane) {
  const Outcome outcome = run("G0 Y50\nG110 X0 Z0 V-5 R-5 I3 L3 Q5 D2 F100\n", kRadiusProfile);
  EXPECT_EQ(outcome.records[2], "feed y=40 f=100");
}

TEST(GskPocket, MillsUpwardsToo) {
  const Outcome outcome = run("G110 X0 Z0 Y8 R2 I3 L3 Q4 P1 D2 F100\n", kRadiusProfile);
  EXPECT_EQ(outcome.motions(), "rapid y=2\nfeed y=6 f=100\n" + circles(0, "0", {1}, "-1", "100") +
                                   "rapid y=2\nrapid x=0 z=0\nrapid y=5\nfeed y=8 f=100\n" +
                                   circles(0, "0", {1}, "-1", "100") +
                                   "rapid y=2\nrapid x=0 z=0\nrapid y=0\n");
}

TEST(GskPocket, G17MillsAlongZ) {
  const Outcome outcome = run("G17 G110 X5 Y6 Z-2 I3 L3 Q5 D2 F100\n", kRadiusProfile);
  EXPECT_EQ(outcome.motions(),
            "rapid x=5 y=6\nfeed z=-2 f=100\nfeed x=6 f=100\n"
            "arc17 c=5,6 rot=-1 x=6 y=6 f=100\nrapid z=0\nrapid x=5 y=6\n");
}

TEST(GskPocket, G19DepthInXIsADiameter) {
  // U-20 is 10 deep; R and Q are true lengths.
  const Outcome outcome = run("G19 G110 Y5 Z6 U-20 R-1 I3 L3 Q50 D2 F100\n");
  EXPECT_EQ(outcome.motions(),
            "rapid y=5 z=6\nrapid x=-1\nfeed x=-11 f=100\nfeed y=6 f=100\n"
            "arc19 c=5,6 rot=-1 y=6 z=6 f=100\nrapid x=-1\nrapid y=5 z=6\nrapid x=0\n");
}

TEST(GskPocket, RotaryAxisIsPositionedWithTheCentre) {
  const Outcome outcome = run("G110 X1 Z2 Y-1 C30 I3 L3 Q5 D2 F100\n", kRadiusProfile);
  EXPECT_EQ(outcome.records[0], "rapid x=1 z=2 c=30");
}

TEST(GskPocket, ZeroDepthPositionsOnlyAndNeedsNoFeed) {
  const Outcome outcome = run("G0 Y50\nG110 X1 Z2 Y45 R-5 I3 L3 Q5 D2\n", kRadiusProfile);
  EXPECT_EQ(outcome.motions(), "rapid y=50\nrapid x=1 z=2\nrapid y=45\nrapid y=50\n");
}

TEST(GskPocket, InchWordsAreConverted) {
  // D0.05 in = 1.27, I0.1 = 2.54; F10 in/min = 254.
  const Outcome outcome = run("G20 G110 X1 Z0 Y-0.1 I0.1 L0.09 Q1 D0.05 F10\n", kRadiusProfile);
  EXPECT_EQ(outcome.motions(),
            "rapid x=25.4 z=0\nfeed y=-2.54 f=254\nfeed z=1.27 f=254\n"
            "arc18 c=0,25.4 rot=-1 x=25.4 z=1.27 f=254\nrapid y=0\nrapid x=25.4 z=0\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
