// SPDX-License-Identifier: GPL-3.0-or-later
// Every planted fault of the expander of hnc21t shows on the program that is meant for it.
#include <gtest/gtest.h>

#include <set>

#include "expanders/registry.hpp"
#include "fault_example.hpp"

namespace gonogo::expanders::testing {
namespace {

// Ten times 0.1 summed in binary64 stays below 1.
constexpr const char* kTenthsPeck = "G74 Z-1 R0.05 Q0.1 F9\n";
constexpr const char* kUnevenPeck = "G74 Z-5 R1 Q2 F9\n";
constexpr const char* kThirds = "G75 X-2 Z-1 I3 F9\n";
constexpr const char* kTurn = "G80 X-4 Z-5 I-1 F9\n";
constexpr const char* kFace = "G81 X-4 Z-5 K-1 F9\n";
constexpr const char* kRunOut = "G82 X-4 Z-5 R-1 E2 F2\n";
constexpr const char* kStarts = "G82 X-4 Z-5 C3 P100 F2\n";
constexpr const char* kOffset = R"({"offsets":{"G54":{"x":"1","z":"2"}}})";

const ProfiledFaultExample kHncFaultExamples[] = {
    {"peck-running-sum", kTenthsPeck},
    {"withdrawal-twice", kUnevenPeck},
    {"extra-peck-at-multiple", "G74 Z-4 R1 Q2 F9\n"},
    {"last-peck-overshoots", kUnevenPeck},
    {"withdrawal-at-bottom", kUnevenPeck},
    {"withdrawal-at-feed", kUnevenPeck},
    {"endless-pecks", "G74 Z-1 R0.001 Q0.002 F9\n"},
    {"withdrawal-sign-unchecked", "G74 Z-5 R-1 Q2 F9\n"},
    {"groove-depth-diameter", "G75 X-8 R1 Q2 F9\n"},
    {"groove-step-short", kThirds},
    {"groove-running-sum", kThirds},
    {"groove-count-unchecked", "G75 X-2 Z-1 I1.5 F9\n"},
    {"g80-taper-diameter", kTurn},
    {"g80-taper-sign", kTurn},
    {"g80-as-g81", kTurn},
    {"g80-rapid-retract", kTurn},
    {"g80-taper-lost", "G80 X-4 Z-5 I-1 F9\nX-6 Z-5\n"},
    {"g81-taper-ignored", kFace},
    {"g81-taper-sign", kFace},
    {"run-out-before-end", kRunOut},
    {"run-out-diameter", kRunOut},
    {"run-out-sign", kRunOut},
    {"ratio-equality-refused", "G82 X-4 Z-5 R-1 E20 F2\n"},
    {"ratio-unchecked", "G82 X-4 Z-5 R-1 E20.001 F2\n"},
    {"pair-unchecked", "G82 X-4 Z-5 R-1 F2\n"},
    {"starts-from-circle", kStarts},
    {"starts-at-zero", kStarts},
    {"start-short", kStarts},
    {"threads-out", kStarts},
    {"inch-lead-as-millimetres", "G82 X-4 Z-5 J2\n"},
    {"feed-serves-as-lead", "G01 X1 F9\nG82 X-4 Z-5\n"},
    {"taper-leaks-past-rapid", "G80 X-4 Z-5 I-1 F9\nG00 X0\nG80 X-4 Z-5\n"},
    {"withdrawal-leaks-into-groove", "G74 Z-5 R1 Q2 F9\nG75 X-8\n"},
    {"cycle-survives-rapid", "G80 X-4 Z-5 F9\nG00 X2 Z2\n"},
    {"cycle-feed-stuck", "G80 X-4 Z-5 F9\nX-6 Z-5 F8\n"},
    {"thread-lead-forgotten", "G32 Z-5 F2\nZ-9\n"},
    {"offset-ignored-in-cycle", kTurn, kOffset},
    {"rename-ignores-offset", "G92 X8\nG91 G00 X1\n", kOffset},
    {"incremental-z-ignored", "G00 Z3\nG91 G80 X-4 Z-5 F9\n"},
    {"increment-as-radius", "G00 U2\n"},
    {"increment-as-diameter", "G37 G00 U2\n"},
    {"centre-as-diameter", "G02 X10 Z5 I5 F9\n"},
    {"revolution-ignored", "G95 G01 X2 F0.1\n"},
    {"inch-feed", "G20 G01 X1 F9\n"},
    {"late-alarm", "G82 X-4 Z-5 R-1 E21 F2\n"},
    {"alarm-next-block", "G999\n"},
    {"blank-lines-not-counted", "\nG00 X1\n"},
    {"feed-survives-reset", "G01 X1 F9\n"},
};

class PlantedHncFault : public ::testing::TestWithParam<ProfiledFaultExample> {};

TEST_P(PlantedHncFault, Shows) {
  // After the reset without a feed of its own.
  expect_shown(GetParam(), "hnc", "G01 Z1\n");
}

INSTANTIATE_TEST_SUITE_P(Hnc, PlantedHncFault, ::testing::ValuesIn(kHncFaultExamples), FaultName());

TEST(PlantedHncFaults, EachHasItsProgram) {
  std::set<std::string_view> shown;
  for (const ProfiledFaultExample& example : kHncFaultExamples) shown.insert(example.fault);
  std::set<std::string_view> known;
  for (const FaultDescription& fault : faults("hnc")) {
    known.insert(fault.name);
    EXPECT_FALSE(fault.what.empty() || fault.clause.empty() || fault.models.empty());
  }
  EXPECT_EQ(shown, known);
  EXPECT_EQ(known.size(), faults("hnc").size());
}

}  // namespace
}  // namespace gonogo::expanders::testing
