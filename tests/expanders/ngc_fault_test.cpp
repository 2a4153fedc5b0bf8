// SPDX-License-Identifier: GPL-3.0-or-later
// Every planted fault of the expander of rs274 shows on the program that is meant for it.
#include <gtest/gtest.h>

#include <set>

#include "expanders/registry.hpp"
#include "fault_example.hpp"

namespace gonogo::expanders::testing {
namespace {

// What each fault must lead to follows from its description and the program by hand.
const FaultExample kNgcFaultExamples[] = {
    {"g18-sense-flipped", "G18 G2 Z4 K2 F9\nG17 G2 X4 I2\n",
     "1 arc18 c=2,0 rot=1 x=0 z=4 f=9\n2 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"g3-clockwise", "G3 X4 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"radius-sign-ignored", "G2 X6 R-5 F9\n", "1 arc17 c=3,-4 rot=-1 x=6 y=0 f=9\n"},
    {"radius-centre-left", "G2 X6 R5 F9\nG3 X0 R5\n",
     "1 arc17 c=3,4 rot=-1 x=6 y=0 f=9\n2 arc17 c=3,-4 rot=1 x=0 y=0 f=9\n"},
    {"short-radius-forgiven", "G2 X6 R2 F9\n", "1 arc17 c=3,0 rot=-1 x=6 y=0 f=9\n"},
    {"offsets-absolute", "G0 X2\nG2 X6 I4 J0 F9\n",
     "1 rapid x=2\n2 arc17 c=4,0 rot=-1 x=6 y=0 f=9\n"},
    {"absolute-centre-ignored", "G0 X2\nG90.1 G2 X6 I2 J0 F9\n",
     "1 rapid x=2\n2 arc17 c=4,0 rot=-1 x=6 y=0 f=9\n"},
    {"g18-offsets-swapped", "G18 G2 Z4 I2 F9\n", "1 arc18 c=2,0 rot=-1 x=0 z=4 f=9\n"},
    {"full-circle-dropped", "G2 I2 F9\n", ""},
    {"end-point-unchecked", "G2 X9 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=9 y=0 f=9\n"},
    {"end-point-equality-refused", "G2 X4.002 I2 F9\n", "alarm arc-end-point in 1\n"},
    {"inch-tolerance-millimetres", "G20 G2 X2.0001 I1 F9\n", "alarm arc-end-point in 1\n"},
    {"end-onto-circle", "G2 X4.001 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"helix-flat", "G2 X4 Z5 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 z=0 f=9\n"},
    {"helix-z-in-g18", "G18 G2 Z4 Y5 K2 F9\n", "1 arc18 c=2,0 rot=-1 x=0 y=0 z=5 f=9\n"},
    {"arc-rotary-dropped", "G2 X4 I2 A5 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"turns-ignored", "G2 X4 I2 P3 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"turn-extra", "G3 X4 I2 P3 F9\n", "1 arc17 c=2,0 rot=4 x=4 y=0 f=9\n"},
    {"turns-unchecked", "G2 X4 I2 P1.5 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"g91-ignored-after-g90", "G91 G0 X1\nX1\nG90 X3\nG91 X1\n",
     "1 rapid x=1\n2 rapid x=2\n3 rapid x=3\n4 rapid x=1\n"},
    {"feed-survives-its-mode", "G1 X1 F9\nG95 X2\n", "1 feed x=1 f=9\n2 feed x=2 f=9/rev\n"},
    {"spindle-turns-after-change", "M3\nT1 M6\nG96 S9 F9 G1 X1\n",
     "1 m 3\n2 m 6\n3 feed x=1 f=9\n"},
    {"inverse-time-of-all-axes", "G93 G1 X3 A4 F2\n", "1 feed x=3 a=4 f=10\n"},
    {"inverse-time-of-chord", "G93 G2 X4 I2 F9\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=36\n"},
    {"x-never-halved", "G7\nG0 X4\n", "2 rapid x=4\n"},
    {"feed-not-restored", "F9 G1 M70\nF5\nM72\nX1\n", "1 m 70\n3 m 72\n4 feed x=1 f=5\n"},
    {"inch-feed-unscaled", "G20\nG1 X1 F9\n", "2 feed x=25.4 f=9\n"},
    {"inch-offsets-unscaled", "G20\nG2 I2 F9\n", "2 arc17 c=2,0 rot=-1 x=0 y=0 f=228.6\n"},
    {"inch-rotary-scaled", "G20\nG0 A1\n", "2 rapid a=25.4\n"},
    {"rotary-feed-scaled", "G20\nG1 A1 F9\n", "2 feed a=1 f=228.6\n"},
    {"g80-keeps-motion", "G0 X1\nG80\nX2\n", "1 rapid x=1\n3 rapid x=2\n"},
    {"motion-lost-after-dwell", "G0 X1\nG4 P1\nX2\n",
     "1 rapid x=1\n2 dwell 1\nalarm missing-word in 3\n"},
    {"feed-after-motion", "F5\nG1 X1 F9\nX2\n", "2 feed x=1 f=5\n3 feed x=2 f=9\n"},
    {"plane-after-motion", "G18 G2 X4 I2 F9\nG2 I1\n",
     "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n2 arc18 c=0,5 rot=-1 x=4 z=0 f=9\n"},
    {"dwell-in-milliseconds", "G4 P2\n", "1 dwell 0.002\n"},
    {"last-motion-wins", "G80 G0 X1\n", "1 rapid x=1\n"},
    {"bare-feed-unchecked", "G1\n", ""},
    {"arc-words-need-code", "G2 X4 I2 F9\nI1\n", "1 arc17 c=2,0 rot=-1 x=4 y=0 f=9\n"},
    {"unused-word-passed", "G0 X1 I2\n", "1 rapid x=1\n"},
    {"unused-alone-passed", "I2\nG0 X1\n", "2 rapid x=1\n"},
    {"polar-clockwise", "G0 @5 ^90\n", "1 rapid x=0 y=-5\n"},
    // The second ^90 leads to where the tool stands, which is no motion.
    {"polar-absolute", "G0 @5 ^0\nG91 ^90\n^90\n", "1 rapid x=5 y=0\n2 rapid x=0 y=5\n"},
    {"polar-angle-needed", "G0 X3 Y4\n@10\n", "1 rapid x=3 y=4\n2 rapid x=10 y=0\n"},
    {"polar-inch-unscaled", "G20\nG0 @2 ^0\n", "2 rapid x=2 y=0\n"},
    {"polar-beside-x-passed", "G0 @5 ^90 X1\n", "1 rapid x=0 y=5\n"},
    {"polar-origin-passed", "G91 G0 @5 ^90\n", "1 rapid x=0 y=5\n"},
    {"polar-row-in-place", "F9 G0 X10\nG91 G99 G81 ^90 L2 R0 Z-1\n",
     "1 rapid x=10\n2 rapid x=0 y=10\n2 feed z=-1 f=9\n2 rapid z=0\n2 feed z=-1 f=9\n"
     "2 rapid z=0\n"},
    {"blanks-end-numbers", "G0 X1\nX 1 5\n", "1 rapid x=1\nalarm syntax in 2\n"},
    {"open-line-numbers", "N1. G0 X1\n", "1 rapid x=1\n"},
    {"name-ends-program", "G0 X1\nO2\nX2\n", "1 rapid x=1\n"},
    {"tape-mark-anywhere", "G0 X1\n%\nX2\n", "1 rapid x=1\n"},
    {"tape-mark-after-comment", "(a)\n%\nG0 X1\n%\n", "3 rapid x=1\n"},
    {"block-delete-always", "G0 X1\n/X2\n", "1 rapid x=1\n"},
    {"capitals-only", "G0 X1\nx2\n", "1 rapid x=1\nalarm syntax in 2\n"},
    {"tape-mark-ignored", "%\nG0 X1\n%\nX2\n", "2 rapid x=1\n4 rapid x=2\n"},
    {"end-ignored", "G0 X1 M2\nX2\n", "1 rapid x=1\n1 m 2\n2 rapid x=2\n"},
    {"alarm-next-block", "G999\n", "alarm undefined-code in 2\n"},
    {"cr-lf-counted-twice", "G0\r\nX1\r\n", "4 rapid x=1\n"},
    {"feed-survives-reset", "G1 X1 F9\n", "1 feed x=1 f=9\n"},
};

// Those of numbers that must be whole show where they need not be so exactly, that of the end where
// there must be one.
constexpr const char* kNearIsWhole = R"({"readings":{"ngc.whole":"nist"}})";
const ProfiledFaultExample kNgcReadingFaultExamples[] = {
    {"second-tape-mark-optional", "%\nG0 X1\n"},
    {"whole-limit-refused", "G2 X4 I2 P3.0001 F9\n", kNearIsWhole},
    {"near-whole-cut", "M7.99995\n", kNearIsWhole},
    {"code-limit-unscaled", "G0.0001 X1\n", kNearIsWhole},
};

// The same, and that what the expander says of it tells so.
template <typename AnyFaultExample>
void expect_shown_and_counted(const AnyFaultExample& example, const char* after_reset) {
  const FaultCount before = count("ngc", example.fault).value();
  expect_shown(example, "ngc", after_reset);
  const FaultCount after = count("ngc", example.fault).value();
  EXPECT_GT(after.reached, before.reached);
  EXPECT_GT(*after.triggered, *before.triggered);
}

class PlantedNgcFault : public ::testing::TestWithParam<FaultExample> {};
class PlantedNgcReadingFault : public ::testing::TestWithParam<ProfiledFaultExample> {};

TEST_P(PlantedNgcReadingFault, Shows) {
  expect_shown_and_counted(GetParam(), "G0 X1\n");
}

INSTANTIATE_TEST_SUITE_P(Ngc, PlantedNgcReadingFault, ::testing::ValuesIn(kNgcReadingFaultExamples),
                         FaultName());

TEST_P(PlantedNgcFault, Shows) {
  // After the reset without a feed of its own.
  expect_shown_and_counted(GetParam(), "G1 Z1\n");
}

TEST_P(PlantedNgcFault, IsTheOneThatItsNameSays) {
  const FaultExample& example = GetParam();
  EXPECT_EQ(run_ngc(example.program, "{}", example.fault).trace(), example.want);
}

INSTANTIATE_TEST_SUITE_P(Ngc, PlantedNgcFault, ::testing::ValuesIn(kNgcFaultExamples), FaultName());

TEST(PlantedNgcFaults, EachHasItsProgram) {
  std::set<std::string_view> shown;
  for (const FaultExample& example : kNgcFaultExamples) shown.insert(example.fault);
  for (const ProfiledFaultExample& example : kNgcReadingFaultExamples) shown.insert(example.fault);
  std::set<std::string_view> known;
  for (const FaultDescription& fault : faults("ngc")) {
    // Those of the cycles are shown in a file of their own.
    const bool of_cycle = fault.clause.starts_with("NGC-CYC") ||
                          (fault.clause.starts_with("NGC-G") && fault.clause != "NGC-G4-01");
    if (!of_cycle) known.insert(fault.name);
    EXPECT_FALSE(fault.what.empty() || fault.clause.empty() || fault.models.empty());
  }
  EXPECT_EQ(shown, known);
}

}  // namespace
}  // namespace gonogo::expanders::testing
