// SPDX-License-Identifier: GPL-3.0-or-later
// Every planted fault of frames and cycles shows on the program that is meant for it.
#include <gtest/gtest.h>

#include <set>

#include "expanders/registry.hpp"
#include "fault_example.hpp"
#include "sinumerik_motions.hpp"

namespace gonogo::expanders::testing {
namespace {

constexpr const char* kToolsProfile = R"({"tools":{"1":{"radius":"5"},"2":{"radius":"1"}}})";

// Three lines. With tool 1 the pocket leaves the tool its centre only.
const std::string kPoint =
    "G1 F9 T1 S1 M3\n"
    "R101=5 R102=1 R104=-2 R118=10 R119=10 R120=5 R121=2 R122=20 R123=30 R126=2 R127=1\n"
    "R125=0 ";
// Two lines.
const std::string kDrill = "G1 F9\nR101=5 R102=1 R104=-2 R105=3\n";

// What each fault must lead to follows from its description and the program by hand. With tool 1,
// radius 5, a pocket of 12 x 12 leaves a square of half side 1, one of 14 x 14 of half side 2.
const FaultExample kCycleFaultExamples[] = {
    {"g158-adds", "G158 X1\nG158 X2\nG0 X0\n", "rapid x=3\n"},
    // Under the rotation the tool stands at (0, 1).
    {"g158-keeps-rotation", "G258 RPL=90\nG158 X1\nG0 X2\n", "rapid y=2\n"},
    {"g259-replaces", "G258 RPL=90\nG259 RPL=90\nG0 X1\n", "rapid y=1\n"},
    {"rotation-flipped-in-g18", "G18\nG258 RPL=90\nG0 Z1\n", "rapid x=-1\n"},
    {"rotation-about-base", "G158 X1\nG259 RPL=90\nG0 X0 Y0\n", "rapid y=1\n"},
    {"drill-dwell-ms", kDrill + "LCYC82\n", "rapid z=1\nfeed z=-2 f=9\ndwell 0.003\nrapid z=5\n"},
    {"drill-dwell-forgotten", kDrill + "LCYC82\n", "rapid z=1\nfeed z=-2 f=9\nrapid z=5\n"},
    {"drill-retract-to-clearance", kDrill + "LCYC82\n",
     "rapid z=1\nfeed z=-2 f=9\ndwell 3\nrapid z=1\n"},
    {"cycle-plane-equality-refused", kPoint + "R101=1\nLCYC75\n", "alarm reference-plane in 4\n"},
    {"cycle-feed-stays", kPoint + "\nLCYC75\nX1\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\nfeed x=1 f=30\n"},
    {"cycle-g0-stays", kPoint + "\nLCYC75\nX1\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\nrapid x=1\n"},
    {"cycle-parameter-lost", kPoint + "R104=-3\nLCYC75\nG0 X=R121\n",
     "rapid z=5\nrapid z=1\nfeed z=-1.5 f=20\nfeed z=-3 f=20\nrapid z=5\nrapid x=1.5\n"},
    {"pocket-centre-in-base", kPoint + "R116=3\nG158 X10\nLCYC75\n",
     "rapid x=3 z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\n"},
    {"pocket-sides-swapped", kPoint + "R118=12 G18\nLCYC75\n",
     "rapid y=5\nrapid y=1\nfeed y=-2 f=20\nfeed x=1 f=30\nfeed x=-1 f=30\n"
     "feed x=0 f=30\nrapid y=5\n"},
    {"pocket-depth-from-clearance", kPoint + "\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-0.5 f=20\nfeed z=-2 f=20\nrapid z=5\n"},
    {"pocket-infeeds-rounded-down", kPoint + "R104=-3\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-3 f=20\nrapid z=5\n"},
    {"pocket-last-level-missed", kPoint + "R104=-4\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\n"},
    {"pocket-plane-allowance-forgotten", kPoint + "R118=12 R119=12 R124=1\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-1 f=30\nfeed x=-1 f=30\nfeed y=1 f=30\n"
     "feed x=1 f=30\nfeed y=-1 f=30\nfeed x=0 f=30\nfeed y=0 f=30\nrapid z=5\n"},
    {"pocket-depth-allowance-forgotten", kPoint + "R125=1\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\n"},
    {"pocket-sense-flipped", kPoint + "R118=12 R119=12\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-1 f=30\nfeed x=1 f=30\nfeed y=1 f=30\n"
     "feed x=-1 f=30\nfeed y=-1 f=30\nfeed x=0 f=30\nfeed y=0 f=30\nrapid z=5\n"},
    {"pocket-finishing-sense-ignored", kPoint + "R118=12 R119=12 R127=2\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-1 f=30\nfeed x=1 f=30\nfeed y=1 f=30\n"
     "feed x=-1 f=30\nfeed y=-1 f=30\nfeed x=0 f=30\nfeed y=0 f=30\nrapid z=5\n"},
    {"pocket-feeds-swapped", kPoint + "\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=30\nrapid z=5\n"},
    {"pocket-plunge-off-centre", kPoint + "R118=14\nLCYC75\n",
     "rapid z=5\nrapid z=1\nrapid x=1\nfeed z=-2 f=20\nfeed x=2 f=30\nfeed x=-2 f=30\n"
     "feed x=0 f=30\nrapid z=5\n"},
    // Lines 2.9 apart; tool 2 is 2 wide.
    {"pocket-step-too-wide", kPoint + "T2 R118=8 R119=8 R120=1\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed x=-2.9 y=-2.9 f=30\nfeed x=2.9 f=30\n"
     "feed y=0 f=30\nfeed x=-2.9 f=30\nfeed y=2.9 f=30\nfeed x=2.9 f=30\nfeed x=0 y=0 f=30\n"
     "feed y=-3 f=30\nfeed x=-3 f=30\nfeed y=3 f=30\nfeed x=3 f=30\nfeed y=-3 f=30\n"
     "feed x=0 f=30\nfeed y=0 f=30\nrapid z=5\n"},
    {"pocket-corner-gouged", kPoint + "R118=14 R119=14 R120=6\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-2 f=30\nfeed x=-2 f=30\nfeed y=2 f=30\n"
     "feed x=2 f=30\nfeed y=-2 f=30\nfeed x=0 f=30\nfeed y=0 f=30\nrapid z=5\n"},
    {"pocket-corner-left", kPoint + "R118=14 R119=14 R120=6\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-2 f=30\n"
     "arc17 c=0,0 rot=-1 x=-2 y=0 f=30\narc17 c=0,0 rot=-1 x=0 y=2 f=30\n"
     "arc17 c=0,0 rot=-1 x=2 y=0 f=30\narc17 c=0,0 rot=-1 x=0 y=-2 f=30\nfeed y=0 f=30\n"
     "rapid z=5\n"},
    {"pocket-strip-left", kPoint + "R118=14 R119=14 R124=1 R127=2\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-1 f=30\nfeed x=-1 f=30\nfeed y=1 f=30\n"
     "feed x=1 f=30\nfeed y=-1 f=30\nfeed x=0 f=30\nfeed y=0 f=30\nrapid z=5\n"},
    {"pocket-contour-only-by-r125", kPoint + "T2 R118=8 R119=8 R120=1 R127=2\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-3 f=30\nfeed x=-3 f=30\nfeed y=3 f=30\n"
     "feed x=3 f=30\nfeed y=-3 f=30\nfeed x=0 f=30\nfeed y=0 f=30\nrapid z=5\n"},
    {"pocket-ends-off-centre", kPoint + "R118=12 R119=12\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-1 f=30\nfeed x=-1 f=30\nfeed y=1 f=30\n"
     "feed x=1 f=30\nfeed y=-1 f=30\nfeed x=0 f=30\nfeed y=0 f=30\nfeed y=1 f=30\n"
     "rapid z=5\n"},
    {"pocket-retract-to-clearance", kPoint + "\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=1\n"},
    {"pocket-tool-unchecked", kPoint + "R118=8\nLCYC75\n",
     "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\n"},
    {"pocket-tool-equality-refused", kPoint + "\nLCYC75\n", "alarm tool-too-large in 4\n"},
};

/// Moving records, with the axes that move only.
std::string trace(const Outcome& outcome) {
  std::string text = moving(outcome);
  if (outcome.alarms != 0) {
    text += "alarm " + outcome.alarm + " in " + std::to_string(outcome.alarm_block) + "\n";
  }
  return text;
}

class PlantedCycleFault : public ::testing::TestWithParam<FaultExample> {};

TEST_P(PlantedCycleFault, Shows) {
  const FaultExample& example = GetParam();
  const Outcome sound = run_sinumerik802s(example.program, kToolsProfile);
  EXPECT_NE(run_sinumerik802s(example.program, kToolsProfile, example.fault).all(), sound.all());
}

TEST_P(PlantedCycleFault, IsTheOneThatItsNameSays) {
  const FaultExample& example = GetParam();
  EXPECT_EQ(trace(run_sinumerik802s(example.program, kToolsProfile, example.fault)), example.want);
}

INSTANTIATE_TEST_SUITE_P(Sinumerik, PlantedCycleFault, ::testing::ValuesIn(kCycleFaultExamples),
                         FaultName());

TEST(PlantedCycleFaults, EachHasItsProgram) {
  std::set<std::string_view> shown;
  for (const FaultExample& example : kCycleFaultExamples) shown.insert(example.fault);
  std::set<std::string_view> known;
  for (const FaultDescription& fault : faults("sinumerik")) {
    const bool path = !fault.clause.starts_with("SIE-FRM") && !fault.clause.starts_with("SIE-LC");
    if (!path) known.insert(fault.name);
  }
  EXPECT_EQ(shown, known);
}

}  // namespace
}  // namespace gonogo::expanders::testing
