// SPDX-License-Identifier: GPL-3.0-or-later
// Every planted fault of the expander of sinumerik840d shows on the program that is meant for it.
#include <gtest/gtest.h>

#include <set>

#include "expanders/registry.hpp"
#include "fault_example.hpp"

namespace gonogo::expanders::testing {
namespace {

// What each fault must lead to follows from its description and the program by hand.
const FaultExample kPathFaultExamples[] = {
    {"g18-sense-flipped", "G18 G2 Z4 K2 F9\nG17 G2 X4 I2\n",
     "1 arc18 c=2,0 rot=1 x=0 z=4 f=9\n2 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"cr-sign-swapped", "G2 X6 CR=5 F9\nG3 X0 CR=-5\n",
     "1 arc17 c=3,4 rot=-1 x=6 y=0 f=9\n2 arc17 c=3,-4 rot=1 x=0 y=0 f=9\n"},
    {"cr-semicircle-refused", "G2 X6 CR=3 F9\n", "alarm arc-radius in 1\n"},
    {"centre-absolute", "G0 X2\nG2 X6 I4 J0 F9\n",
     "1 rapid x=2\n2 arc17 c=4,0 rot=-1 x=6 y=0 f=9\n"},
    {"centre-ac-ignored", "G0 X2\nG2 X6 I=AC(2) F9\n",
     "1 rapid x=2\n2 arc17 c=4,0 rot=-1 x=6 y=0 f=9\n"},
    {"ar-centre-other-side", "G3 X2 AR=90 F9\n", "1 arc17 c=1,-1 rot=1 x=2 y=0 f=9\n"},
    {"ar-complement", "G3 I1 AR=90 F9\n", "1 arc17 c=1,0 rot=1 x=1 y=1 f=9\n"},
    {"ar-360-accepted", "G2 I1 AR=360 F9\n", "1 arc17 c=1,0 rot=-1 x=0 y=0 f=9\n"},
    {"full-circle-dropped", "G2 I2 F9\n", ""},
    {"end-point-unchecked", "G2 X9 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=9 y=0 f=9\n"},
    // Radii 1000 and 999: 1 is 1/1000 of the first, more of the second.
    {"tolerance-of-end-radius", "G2 X1000 Y999 I1000 F9\n", "alarm arc-end-point in 1\n"},
    {"tolerance-constant-only", "G2 X100 Y100.05 I100 F9\n", "alarm arc-end-point in 1\n"},
    {"tolerance-equality-refused", "G2 X2 Y2.01 I2 F9\n", "alarm arc-end-point in 1\n"},
    // The radius of the end, 4.996, is below half the chord: its middle. With that of the start the
    // centre moves by 0.2, too far.
    {"correction-keeps-end-radius", "G2 X10 I5.004 F9\n", "1 arc17 c=5,0 rot=-1 x=10 y=0 f=9\n"},
    {"end-onto-circle", "G2 X4.001 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"helix-third-axis-z", "G18 G2 X0 Z4 Y5 K2 F9\n", "1 arc18 c=2,0 rot=-1 x=0 y=0 z=5 f=9\n"},
    {"helix-flat", "G2 X4 Y0 Z5 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 z=0 f=9\n"},
    {"turn-ignored", "G2 X4 I2 TURN=2 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"turn-extra", "G2 X4 I2 TURN=2 F9\n", "1 arc17 c=2,0 rot=-4 x=4 y=0 f=9\n"},
    {"end-point-plane-ignored", "G2 X4 Z0 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 z=0 f=9\n"},
    {"cip-sense-flipped", "CIP X2 I1=1 J1=1 F9\n", "1 arc3 via=1,-1,0 x=2 y=0 z=0 f=9\n"},
    {"cip-intermediate-absolute", "G0 X5\nG91 CIP X2 I1=1 J1=1 F9\n",
     "1 rapid x=5\n2 arc3 via=1,1,0 x=7 y=0 z=0 f=9\n"},
    {"cip-straight-refused", "CIP X2 I1=1 F9\n", "alarm arc-intermediate-point in 1\n"},
    {"ct-other-side", "G1 X1 F9\nCT X2 Y1\n", "1 feed x=1 f=9\n2 arc17 c=2,0 rot=-1 x=2 y=1 f=9\n"},
    // Half a circle: down at its start, up at its end.
    {"ct-tangent-of-start", "G3 X2 I1 F9\nCT X4\n",
     "1 arc17 c=1,0 rot=1 x=2 y=0 f=9\n2 arc17 c=3,0 rot=1 x=4 y=0 f=9\n"},
    {"ct-skips-rapids", "G1 X1 F9\nG0 Y1\nCT X2 Y2\n",
     "1 feed x=1 f=9\n2 rapid y=1\n3 arc17 c=1,2 rot=1 x=2 y=2 f=9\n"},
    {"ct-behind-accepted", "G1 X2 F9\nCT X1\n", "1 feed x=2 f=9\n2 feed x=1 f=9\n"},
    {"g110-as-g111", "G0 X5\nG110 X1\nRP=1 AP=90\n", "1 rapid x=5\n3 rapid x=1 y=1\n"},
    {"g112-as-g110", "G0 X5\nG112 X1\nRP=1 AP=90\n", "1 rapid x=5\n3 rapid x=6 y=1\n"},
    {"pole-kept-by-plane", "G111 X5\nG17 G0 RP=1 AP=90\n", "2 rapid x=5 y=1\n"},
    {"ap-swapped-in-g18", "G18 G0 RP=1 AP=90\n", "1 rapid x=0 z=1\n"},
    {"rp-forgotten-after-g0", "G0 RP=1 AP=90\nAP=0\n",
     "1 rapid x=0 y=1\nalarm missing-word in 2\n"},
    {"ap-follows-g91", "G0 RP=1 AP=90\nG91 AP=90\n", "1 rapid x=0 y=1\n2 rapid x=-1 y=0\n"},
    {"ac-ignored", "G91 G0 X1\nX=AC(1)\n", "1 rapid x=1\n2 rapid x=2\n"},
    {"ic-ignored", "G0 X1\nX=IC(2)\n", "1 rapid x=1\n2 rapid x=2\n"},
    {"inch-feed-scaled", "G70\nG1 X1 F10\n", "2 feed x=25.4 f=254\n"},
    {"inch-centre-unscaled", "G70\nG2 I2 F9\n", "2 arc17 c=2,0 rot=-1 x=0 y=0 f=9\n"},
    {"inch-rotary-scaled", "G70\nG0 A1\n", "2 rapid a=25.4\n"},
    {"rotary-feed-scaled", "G70\nG1 A1 F10\n", "2 feed a=1 f=254\n"},
    {"dwell-revolutions-as-seconds", "S120\nG4 S2\n", "2 dwell 2\n"},
    {"cutting-speed-feeds-per-minute", "G96 S9\nG1 X1 F9\n", "2 feed x=1 f=9\n"},
    {"dwell-feed-kept", "G1 X1 F9\nG4 F2\nX2\n", "1 feed x=1 f=9\n2 dwell 2\n3 feed x=2 f=2\n"},
    {"arc-not-modal", "G2 X2 I1 F9\nX4 I1\n",
     "1 arc17 c=1,0 rot=-1 x=2 y=0 f=9\nalarm conflicting-words in 2\n"},
    {"assignment-late", "G0 R1=5 X=R1\nX=R1+1\n", "2 rapid x=6\n"},
    {"left-to-right", "G0 X=1+2*3\n", "1 rapid x=9\n"},
    {"block-skip-always", "G0 X1\n/X2\n", "1 rapid x=1\n"},
    {"capitals-only", "G0 X1\nx2\n", "1 rapid x=1\nalarm syntax in 2\n"},
    {"end-ignored", "G0 X1 M2\nX2\n", "1 rapid x=1\n1 m 2\n2 rapid x=2\n"},
    {"alarm-next-block", "G999\n", "alarm undefined-code in 2\n"},
    {"cr-lf-counted-twice", "G0\r\nX1\r\n", "4 rapid x=1\n"},
    {"parameters-survive-reset", "G0 X1 R1=7\n", "1 rapid x=1\n"},
};

class PlantedSinumerikFault : public ::testing::TestWithParam<FaultExample> {};

TEST_P(PlantedSinumerikFault, Shows) {
  // After the reset with a parameter that has no value of its own.
  expect_shown(GetParam(), "sinumerik", "G0 Z=R1\n");
}

TEST_P(PlantedSinumerikFault, IsTheOneThatItsNameSays) {
  const FaultExample& example = GetParam();
  EXPECT_EQ(run_sinumerik(example.program, "{}", example.fault).trace(), example.want);
}

INSTANTIATE_TEST_SUITE_P(Sinumerik, PlantedSinumerikFault, ::testing::ValuesIn(kPathFaultExamples),
                         FaultName());

TEST(PlantedSinumerikFaults, EachHasItsProgram) {
  std::set<std::string_view> shown;
  for (const FaultExample& example : kPathFaultExamples) shown.insert(example.fault);
  std::set<std::string_view> known;
  std::set<std::string_view> names;
  for (const FaultDescription& fault : faults("sinumerik")) {
    EXPECT_FALSE(fault.what.empty() || fault.clause.empty() || fault.models.empty());
    EXPECT_TRUE(names.insert(fault.name).second) << fault.name;
    // Those of frames and cycles are shown in a file of their own.
    const bool own = !fault.clause.starts_with("SIE-FRM") && !fault.clause.starts_with("SIE-LC");
    if (own) known.insert(fault.name);
  }
  EXPECT_EQ(shown, known);
}

}  // namespace
}  // namespace gonogo::expanders::testing
