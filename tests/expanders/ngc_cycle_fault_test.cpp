// SPDX-License-Identifier: GPL-3.0-or-later
// Every planted fault of the cycles of rs274 shows on the program that is meant for it, and is
// counted there.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "expanders/registry.hpp"
#include "fault_example.hpp"
#include "short_form.hpp"

namespace gonogo::expanders::testing {
namespace {

const std::string kTap = "F9 M3/G84 Z-1 R0 P1";
const std::string kG86 = "F9 M3/G86 Z-1 R0 P1";
// Pecks of 2 from 0 to -3.
const std::string kG73 = "F9/G73 Z-3 R0 Q2";
const std::string kG83 = "F9/G83 Z-3 R0 Q2";
// The drive line, 22 long.
const std::string kLine = "G18 M3/G0 X20 Z2/";

// What each fault must lead to follows from its description and the program by hand; '/' stands for
// the end of a line.
const FaultExample kNgcCycleFaultExamples[] = {
    {"cycle-plane-ignored", "F9/G18/G81 X1 Y-1 Z-1 R2", "R0,0,2 R1,-1,2 F1,-1,-1 R1,-1,2"},
    {"depth-from-tool", "F9/G0 Z10/G91 G81 Z-7 R-5", "R0,0,10 R0,0,5 F0,0,3 R0,0,5"},
    {"stale-step", "F9/G0 X1 Y2 Z10/G91 G81 X1 Z-1 R-2", "R1,2,10 R2,4,10 R2,4,8 F2,4,7 R2,4,8"},
    {"levels-drift", "F9/G91 G81 X1 Z-1 R2 L2",
     "R0,0,2 R1,0,2 F1,0,1 R1,0,2 R2,0,2 R2,0,4 F2,0,3 R2,0,4"},
    {"reference-equality-refused", "F9/G81 X1 Z2 R2", "alarm reference-plane"},
    {"reference-plane-silent", "F9/G81 X1 Z3 R2", ""},
    {"g98-retracts-to-r", "F9/G0 Z5/G98 G81 X1 Z-1 R2", "R0,0,5 R1,0,5 R1,0,2 F1,0,-1 R1,0,2"},
    {"g98-g99-swapped", "F9/G0 Z5/G99 G81 X1 Z-1 R2", "R0,0,5 R1,0,5 R1,0,2 F1,0,-1 R1,0,5"},
    {"g98-below-r", "F9/G98 G81 X1 Z-1 R2", "R0,0,2 R1,0,2 F1,0,-1 R1,0,0"},
    {"g99-lost-outside-cycles", "F9/G99 G0 Z5/G81 X1 Z-1 R2",
     "R0,0,5 R1,0,5 R1,0,2 F1,0,-1 R1,0,5"},
    {"initial-renewed-by-cycle", "F9/G0 Z5/G99 G81 Z-1 R2/G98 G85 Z-1 R2",
     "R0,0,5 R0,0,2 F0,0,-1 R0,0,2 F0,0,-1 F0,0,2"},
    {"initial-survives-g80", "F9/G0 Z5/G99 G81 Z-1 R2/G80/G98 G81 Z-1 R2",
     "R0,0,5 R0,0,2 F0,0,-1 R0,0,2 F0,0,-1 R0,0,5"},
    {"rapid-through-stock", "F9/G81 X1 Z-1 R2", "R1,0,0 R1,0,2 F1,0,-1 R1,0,2"},
    {"diagonal-approach", "F9/G0 Z5/G81 X1 Z-1 R2", "R0,0,5 R1,0,2 F1,0,-1 R1,0,2"},
    {"drop-before-crossing", "F9/G0 Z5/G81 X1 Z-1 R2", "R0,0,5 R0,0,2 R1,0,2 F1,0,-1 R1,0,2"},
    {"repeat-drops-holes", "F9/G81 X1 Z-1 R2/X3", "R0,0,2 R1,0,2 F1,0,-1 R1,0,2 R3,0,2"},
    {"l-ignored", "F9/G91 G81 X1 Z-1 R0 L2", "R1,0,0 F1,0,-1 R1,0,0"},
    {"l-sticky", "F9/G91 G81 X1 Z-1 R0 L2/X1",
     "R1,0,0 F1,0,-1 R1,0,0 R2,0,0 F2,0,-1 R2,0,0 R3,0,0 F3,0,-1 R3,0,0 R4,0,0 F4,0,-1 R4,0,0"},
    {"l-zero-passed", "F9/G81 X1 Z-1 R0 L0", ""},
    {"l-in-place", "F9/G91 G81 X1 Z-1 R0 L2", "R1,0,0 F1,0,-1 R1,0,0 F1,0,-1 R1,0,0"},
    {"l-steps-under-g90", "F9/G81 X1 Z-1 R0 L2", "R1,0,0 F1,0,-1 R1,0,0 R2,0,0 F2,0,-1 R2,0,0"},
    {"r-not-sticky", "F9/G81 X1 Z-1 R0/X2", "R1,0,0 F1,0,-1 R1,0,0 alarm missing-word"},
    {"q-not-sticky", "F9/G83 X1 Z-1 R0 Q1/X2", "R1,0,0 F1,0,-1 R1,0,0 alarm missing-word"},
    {"p-not-sticky", "F9/G82 X1 Z-1 R0 P2/X2", "R1,0,0 F1,0,-1 D2 R1,0,0 R2,0,0 F2,0,-1 R2,0,0"},
    {"sticky-survives-cycle", "F9/G81 X1 Z-1 R0/G85 X2",
     "R1,0,0 F1,0,-1 R1,0,0 R2,0,0 F2,0,-1 F2,0,0"},
    {"cycle-needs-no-axis", "F9/G81 X1 Z-1 R0/G81", "R1,0,0 F1,0,-1 R1,0,0 F1,0,-1 R1,0,0"},
    {"cycle-takes-any-word", "F9/G81 Z-1 R0 P1", "F0,0,-1 R0,0,0"},
    {"rotary-passed-in-repeat", "F9/G81 Z-1 R0/A5", "F0,0,-1 R0,0,0 F0,0,-1 R0,0,0"},
    {"inch-r-unscaled", "G20/F9/G81 Z-1 R1", "R0,0,1 F0,0,-25.4 R0,0,1"},
    {"inch-q-unscaled", "G20/F9/G73 Z-1 R0 Q13", "F0,0,-13 R0,0,-12.746 F0,0,-25.4 R0,0,0"},
    {"cycle-feed-lost", "F0/G81 Z-1 R0 F9/G1 X1", "F0,0,-1 R0,0,0 alarm feed-missing"},
    {"cycle-dwell-milliseconds", "F9/G82 Z-1 R0 P0.5", "F0,0,-1 D500 R0,0,0"},
    {"negative-dwell-passed", "F9/G82 Z-1 R0 P-0.5", "F0,0,-1 D0.5 R0,0,0"},
    {"minus-one-unwritten", "F9/G82 Z-1 R0 P1/P-1 X0", "F0,0,-1 D1 R0,0,0 F0,0,-1 D1 R0,0,0"},
    {"missing-q-whole-depth", "F9/G83 Z-1 R0", "F0,0,-1 R0,0,0"},
    {"g83-without-pecks", kG83, "F0,0,-3 R0,0,0"},
    // 1 - 0.1 - 0.1 - 0.1 is above 0.7 in binary64.
    {"peck-binary-sum", "F9/G0 Z1/G73 Z0.7 R1 Q0.1",
     "R0,0,1 F0,0,0.9 R0,0,1.154 F0,0,0.8 R0,0,1.054 F0,0,0.7 R0,0,0.954 F0,0,0.7 R0,0,1"},
    {"last-peck-whole", kG73, "F0,0,-2 R0,0,-1.746 F0,0,-4 R0,0,0"},
    {"remainder-dropped", kG73, "F0,0,-2 R0,0,0"},
    {"empty-last-peck", "F9/G73 Z-2 R0 Q2", "F0,0,-2 R0,0,-1.746 F0,0,-2 R0,0,0"},
    {"equal-pecks", kG73, "F0,0,-1.5 R0,0,-1.246 F0,0,-3 R0,0,0"},
    {"pecks-from-clear-level", "F9/G0 Z1/G98 G83 Z-3 R0 Q2",
     "R0,0,1 R0,0,0 F0,0,-1 R0,0,0 R0,0,-0.746 F0,0,-3 R0,0,1"},
    {"return-without-clearance", kG83, "F0,0,-2 R0,0,0 R0,0,-2 F0,0,-3 R0,0,0"},
    {"clearance-in-program-unit", kG83, "F0,0,-2 R0,0,0 R0,0,-1.99 F0,0,-3 R0,0,0"},
    {"return-not-above-r", "F9/G83 Z-0.2 R0 Q0.1", "F0,0,-0.1 R0,0,0 F0,0,-0.2 R0,0,0"},
    {"g73-full-retract", kG73, "F0,0,-2 R0,0,0 R0,0,-1.746 F0,0,-3 R0,0,0"},
    {"levels-in-single-precision", "F9/G0 Z0.3/G81 Z-0.2 R0.3",
     "R0,0,0.3 F0,0,-0.2 R0,0,0.3 F0,0,-0.2 R0,0,0.3"},
    {"dwell-after-retract", "F9/G82 Z-1 R0 P2", "F0,0,-1 R0,0,0 D2"},
    {"g85-g89-silent", "F9/G85 X1 Z-1 R0/G91 G0 Z2", "R0,0,1"},
    {"g85-rapid-out", "F9/G85 Z-1 R0", "F0,0,-1 R0,0,0"},
    {"g89-out-to-r", "F9/G0 Z5/G98 G89 Z-1 R0 P1", "R0,0,5 R0,0,0 F0,0,-1 D1 F0,0,0 R0,0,5"},
    {"g86-without-dwell", kG86, "M3 F0,0,-1 M5 R0,0,0 M3"},
    {"g86-without-restart", kG86, "M3 F0,0,-1 D1 M5 R0,0,0"},
    {"g86-late-stop", kG86, "M3 F0,0,-1 D1 R0,0,0 M5 M3"},
    {"g86-stopped-passed", "F9/G86 Z-1 R0 P1", "F0,0,-1 D1 M5 R0,0,0 M5"},
    {"g74-as-g84", "F9 M4/G74 Z-1 R0", "M4 alarm direction-conflict"},
    {"tap-without-reversal", kTap, "M3 F0,0,-1 D1 F0,0,0"},
    {"tap-without-restart", kTap, "M3 F0,0,-1 M5 M4 D1 F0,0,0"},
    {"tap-dwell-first", kTap, "M3 F0,0,-1 D1 M5 M4 F0,0,0 M5 M3"},
    {"tap-direction-passed", "F9 M4/G84 Z-1 R0", "M4 F0,0,-1 M5 M4 F0,0,0 M5 M3"},
    {"tap-direction-class", "F9 M4/G84 Z-1 R0", "M4 alarm spindle-stopped"},
    {"tap-axes-twice", "F9 M3/G18/G0 Y10/G98 G84 X1 Z2 Y-3 R5",
     "M3 R0,10,0 R1,10,2 R1,5,2 F-3,2,1 M5 M4 F10,2,1 M5 M3"},
    {"g33-lead-along-axis", "M3/G33 X3 Z4 K1.5", "M3 T3,0,4@1.5"},
    {"g33-lead-along-z", "M3/G33 X4 Z3 K1.5", "M3 T4,0,3@0.9"},
    {"g33-k-sticky", "M3/G33 Z-1 K1/Z-2", "M3 T0,0,-1@1 T0,0,-2@1"},
    {"g33-feed-passed", "M3/G33 Z-1 K1 F9", "M3 T0,0,-1@1"},
    {"g33-stopped-passed", "G33 Z-1 K1", "T0,0,-1@1"},
    {"g331-ends-at-bottom", "M3/G33.1 Z-1 K1", "M3 T0,0,-1@1"},
    {"g331-without-reversal", "M3/G33.1 Z-1 K1", "M3 T0,0,-1@1 T0,0,0@1"},
    {"g76-equal-infeed", kLine + "G76 P2 Z-20 I-1 J0.5 K1 R2",
     "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-20@2 R20.5,0,-20 R20,0,2 R18,0,2 T18,0,-20@2 "
     "R20,0,-20"},
    // 0.7 + 0.7 + 0.7 is below 2.1 in binary64.
    {"g76-binary-sum", kLine + "G76 P2 Z-20 I-0.5 J0.7 K2.1",
     "M3 R20,0,2 R21.4,0,2 R18.8,0,2 T18.8,0,-20@2 R21.4,0,-20 R20.7,0,2 R18.1,0,2 "
     "T18.1,0,-20@2 R20.7,0,-20 R20,0,2 R17.4,0,2 T17.4,0,-20@2 R20,0,-20 R20,0,2 R17.4,0,2 "
     "T17.4,0,-20@2 R20,0,-20"},
    {"g76-h-total", kLine + "G76 P2 Z-20 I-1 J0.9 K1 H1",
     "M3 R20,0,2 R20.1,0,2 R18.1,0,2 T18.1,0,-20@2 R20.1,0,-20 R20,0,2 R18,0,2 T18,0,-20@2 "
     "R20,0,-20"},
    {"g76-from-drive-line", kLine + "G76 P2 Z-20 I-1 J0.5 K1",
     "M3 R20,0,2 R20.5,0,2 R19.5,0,2 T19.5,0,-20@2 R20.5,0,-20 R20,0,2 R19,0,2 T19,0,-20@2 "
     "R20,0,-20"},
    {"g76-inside-out", kLine + "G76 P2 Z-20 I1 J0.5 K1",
     "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-20@2 R20.5,0,-20 R20,0,2 R18,0,2 T18,0,-20@2 "
     "R20,0,-20"},
    {"g76-plain-withdrawal", kLine + "G76 P2 Z-20 I-1 J0.5 K1",
     "M3 R20,0,2 R18.5,0,2 T18.5,0,-20@2 R20,0,-20 R20,0,2 R18,0,2 T18,0,-20@2 R20,0,-20"},
    {"g76-slide-backwards", "G18 M3/G0 X20 Z-20/G76 P2 Z2 I-1 J0.5 K1 Q45",
     "M3 R20,0,-20 R20.5,0,-20.5 R18.5,0,-20.5 T18.5,0,2.5@2 R20.5,0,2.5 R20,0,-21 R18,0,-21 "
     "T18,0,2@2 R20,0,2"},
    {"g76-taper-ends-swapped", kLine + "G76 P2 Z-20 I-1 J0.9 K1 L2 E2",
     "M3 R20,0,2 R20.1,0,2 T19.1,0,2@2.236067977 T18.1,0,0@2 T18.1,0,-20@2 R20.1,0,-20 R20,0,2 "
     "T19,0,2@2.236067977 T18,0,0@2 T18,0,-20@2 R20,0,-20"},
    {"g76-taper-lead-plain", kLine + "G76 P2 Z-20 I-1 J0.9 K1 L2 E0.5",
     "M3 R20,0,2 R20.1,0,2 R18.1,0,2 T18.1,0,-19.5@2 T19.1,0,-20@2 R20.1,0,-20 R20,0,2 R18,0,2 "
     "T18,0,-19.5@2 T19,0,-20@2 R20,0,-20"},
    {"g76-ends-at-start", kLine + "G76 P2 Z-20 I-1 J0.9 K1",
     "M3 R20,0,2 R20.1,0,2 R18.1,0,2 T18.1,0,-20@2 R20.1,0,-20 R20,0,2 R18,0,2 T18,0,-20@2 "
     "R20,0,-20 R20,0,2"},
    {"g76-equal-k-passed", kLine + "G76 P2 Z-20 I-1 J1 K1",
     "M3 R20,0,2 R18,0,2 T18,0,-20@2 R20,0,-20"},
    {"g76-lead-class", kLine + "G76 Z-20 I-1 J0.5 K1", "M3 R20,0,2 alarm feed-missing"},
    // I-2.54, J12.7, K25.4 mm.
    {"g76-inch-lead-unscaled", kLine + "G20 G76 P2 Z-1 I-0.1 J0.5 K1",
     "M3 R20,0,2 R32.7,0,2 R4.76,0,2 T4.76,0,-25.4@2 R32.7,0,-25.4 R20,0,2 R-7.94,0,2 "
     "T-7.94,0,-25.4@2 R20,0,-25.4"},
};

// Where no program of the default profile shows it, or none that ends.
const ProfiledFaultExample kNgcCycleProfiled[] = {
    {"cycle-ignores-offset", "F9\nG81 X1 Z-1 R0\n", R"({"initial":{"x":"3"}})"},
    {"endless-pecks", "F9\nG83 Z-1 R0 Q0.005\n"},
};

std::string lines_of(std::string program) {
  std::replace(program.begin(), program.end(), '/', '\n');
  return program + "\n";
}

std::string shown_by(const FaultExample& example, const char* fault) {
  std::string text;
  for (const std::string& record : short_form(run_ngc(lines_of(example.program), "{}", fault))) {
    text += (text.empty() ? "" : " ") + record;
  }
  return text;
}

class PlantedNgcCycleFault : public ::testing::TestWithParam<FaultExample> {};
class PlantedNgcCycleProfiled : public ::testing::TestWithParam<ProfiledFaultExample> {};

TEST_P(PlantedNgcCycleFault, Shows) {
  const FaultExample& example = GetParam();
  const std::string program = lines_of(example.program);
  EXPECT_NE(run_ngc(program, "{}", example.fault).all(), run_ngc(program).all());
}

TEST_P(PlantedNgcCycleFault, IsTheOneThatItsNameSays) {
  EXPECT_EQ(shown_by(GetParam(), GetParam().fault), GetParam().want);
}

TEST_P(PlantedNgcCycleFault, IsCountedWhereItIsMet) {
  const FaultCount before = count("ngc", GetParam().fault).value();
  shown_by(GetParam(), "");
  EXPECT_EQ(count("ngc", GetParam().fault)->reached, before.reached);
  shown_by(GetParam(), GetParam().fault);
  const FaultCount after = count("ngc", GetParam().fault).value();
  EXPECT_GT(after.reached, before.reached);
  EXPECT_GT(*after.triggered, *before.triggered);
}

INSTANTIATE_TEST_SUITE_P(Ngc, PlantedNgcCycleFault, ::testing::ValuesIn(kNgcCycleFaultExamples),
                         FaultName());

TEST_P(PlantedNgcCycleProfiled, Shows) {
  expect_shown(GetParam(), "ngc", "M2\n");
}

INSTANTIATE_TEST_SUITE_P(Ngc, PlantedNgcCycleProfiled, ::testing::ValuesIn(kNgcCycleProfiled),
                         FaultName());

TEST(PlantedNgcCycleFaults, EachHasItsProgram) {
  std::set<std::string_view> shown;
  for (const FaultExample& example : kNgcCycleFaultExamples) shown.insert(example.fault);
  for (const ProfiledFaultExample& example : kNgcCycleProfiled) shown.insert(example.fault);
  std::set<std::string_view> known;
  for (const FaultDescription& fault : faults("ngc")) {
    const bool of_cycle = fault.clause.starts_with("NGC-CYC") ||
                          (fault.clause.starts_with("NGC-G") && fault.clause != "NGC-G4-01");
    if (of_cycle) known.insert(fault.name);
  }
  EXPECT_EQ(shown, known);
}

// Reached, and its answer the right one: no triggering.
TEST(FaultCounts, TellReachedFromTriggered) {
  const FaultCount before = count("ngc", "g98-below-r").value();
  run_ngc("F9\nG0 Z5\nG98 G81 Z-1 R2\n", "{}", "g98-below-r");
  const FaultCount after = count("ngc", "g98-below-r").value();
  EXPECT_EQ(after.reached, before.reached + 1);
  EXPECT_EQ(*after.triggered, *before.triggered);
}

TEST(FaultCounts, OfWhatIsNotThere) {
  EXPECT_FALSE(count("ngc", "no-such-fault"));
  EXPECT_FALSE(count("acme", "taper-sign"));
}

}  // namespace
}  // namespace gonogo::expanders::testing
