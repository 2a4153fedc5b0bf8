// SPDX-License-Identifier: GPL-3.0-or-later
// Every planted fault shows on the program below that is meant for it.
#include <gtest/gtest.h>

#include <set>

#include "expanders/registry.hpp"
#include "fault_example.hpp"

namespace gonogo::expanders::testing {
namespace {

constexpr const char* kTaper = "G0 X120 Z0\nG94 X108 Z-30 R-10 F300\n";
constexpr const char* kPocket = "G110 X50 Z50 Y-20 R-5 I16 L3 Q5 P1 D4 F800\n";
constexpr const char* kPocketTwice = "G110 X50 Z50 Y-20 R-5 I16 L3 Q5 P1 D4 F800\nX0 Z0 Y-20 R-5\n";
constexpr const char* kTenthsPocket = "G110 X0 Z0 Y-6.3 I9 L3 Q0.7 D4 F8\n";
constexpr const char* kUnevenPocket = "G110 X50 Z50 Y-18 I9 L3 Q5 P1 D2 F800\n";
constexpr const char* kHelix = "G113 X0 Z0 V-9 R-1 I5 L3 D2 F8\n";
constexpr const char* kThread = "G114 X0 Z0 V-11 R-5 I5 J2 K30 E30 P1.2 Q0.5 D3 F900\n";
constexpr const char* kWhole = "G115 X0 Z0 V-10 I5 J2 K30 E30 P1 Q0.5 D3 F900\n";
constexpr const char* kNoRunOut = "G116 X0 Z0 V-10 I5 E30 P1 D3 F900\n";
constexpr const char* kParameters = R"({"parameters":{"5920":"30","5921":"2"}})";

const ProfiledFaultExample kGskFaultExamples[] = {
    {"taper-sign", kTaper},
    {"taper-diameter", kTaper},
    {"taper-leaks-past-motion", "G0 X120 Z0\nG94 X108 Z-30 R-10 F300\nG0 X122\nG94 X100 Z-9\n"},
    {"taper-leaks-past-nonmodal", "G0 X120 Z0\nG94 X108 Z-30 R-10 F300\nG28 Y0\nX100\n"},
    {"taper-lost", "G0 X120 Z0\nG94 X108 Z-30 R-10 F300\nX96\n"},
    {"end-point-lost", "G0 X120 Z0\nG94 X108 Z-30 R-10 F300\nX96\n"},
    {"approach-takes-end", kTaper},
    {"ends-at-b", kTaper},
    {"rapid-retract", kTaper},
    {"feed-return", kTaper},
    {"taper-unchecked", "G94 X-8 Z-3 R3.001 F9\n"},
    {"taper-equality-refused", "G94 X-8 Z-3 R3 F9\n"},
    {"taper-zero-travel-refused", "G94 X-8 R3 F9\n"},
    {"dwell-clears-taper", "G0 X120 Z0\nG94 X108 Z-30 R-10 F300\nG04 P5\nX96\n"},
    {"off-plane-unchecked", "G94 X-8 Z-3 Y1 F9\n"},
    {"g80-keeps-g94", "G94 X-8 Z-3 F9\nG80\nX5\n"},
    {"tool-equality-accepted", "G110 X0 Z0 Y-2 I4 L3 Q5 D4 F8\n"},
    {"step-equality-accepted", "G110 X0 Z0 Y-2 I9 L8 Q5 D4 F8\n"},
    {"last-layer-dropped", kUnevenPocket},
    {"last-layer-overshoots", kUnevenPocket},
    // Nine times 0.7 summed in binary32 stays below 6.3; ten times 0.3 below 3.
    {"extra-layer", kTenthsPocket},
    {"endless-layers", kPocket},
    {"clearance-twice", kPocket},
    {"clearance-unclamped", "G110 X0 Z0 Y-9 I9 L3 Q5 P6 D4 F8\n"},
    {"clearance-signed", "G110 X0 Z0 Y-9 I9 L3 Q5 P-1 D4 F8\n"},
    {"r-plane-ignored", kPocket},
    {"depth-from-initial-plane", "G110 X0 Z0 V-9 R-5 I9 L3 Q5 D4 F8\n"},
    {"step-down-forgotten", kPocketTwice},
    {"missing-step-down-accepted", "G110 X0 Z0 Y-9 I9 L3 D4 F8\n"},
    {"closing-circle-missing", kUnevenPocket},
    {"gouge", kPocket},
    {"island", kPocket},
    {"sense-in-g18", kPocket},
    {"g111-as-g110", "G111 X0 Z0 Y-2 I9 L3 Q5 D4 F8\n"},
    {"pocket-leaks-past-motion", "G110 X0 Z0 Y-2 I9 L3 Q5 D4 F8\nG00 X9 Y9 Z9\n"},
    {"initial-plane-drifts", kPocketTwice},
    {"direction-unchecked", "G110 X0 Z0 Y-9 R1 I9 L3 Q5 D4 F8\n"},
    {"rounded-centre", "G110 X0 Z0.004 Y-9 I9 L3 Q5 D4 F8\n"},
    {"ends-at-r-plane", kPocket},
    {"no-retract", kPocket},
    {"g90-taper-sign", "G90 X-8 Z-3 R-1 F9\n"},
    {"g90-taper-diameter", "G90 X-8 Z-3 R-1 F9\n"},
    {"g90-as-g94", "G90 X-8 Z-3 F9\n"},
    {"g90-rapid-retract", "G90 X-8 Z-3 F9\n"},
    {"turning-words-leak", "G90 X-8 Z-3 F9\nG94 X-4\n"},
    {"g92-cuts-at-feed", "G92 X-8 Z-3 F9\n"},
    {"g92-lead-in-inches", "G20 G92 X-8 Z-3 F9\n"},
    {"g92-threads-retract", "G92 X-8 Z-3 F9\n"},
    {"helix-turn-short", kHelix},
    {"helix-depth-per-turn", kHelix},
    {"helix-depth-from-initial", kHelix},
    {"helix-entry-wrong-way", kHelix},
    {"helix-exit-radius", kHelix},
    {"helix-flat-circle", kHelix},
    {"helix-tool-equality-accepted", "G112 X0 Z0 V-9 I2 D2 F8\n"},
    {"helix-ends-at-r-plane", kHelix},
    {"g113-as-g112", kHelix},
    {"tool-leaks-into-helix", "G110 I5 L3 Q5 D2\nG112 I5\n"},
    {"clamp-late", "G112 X9 Z0 V-9 I5 D2 F8 M35\n"},
    {"clamp-dropped", "G112 X9 Z0 V-9 I5 D2 F8 M35\n"},
    {"g80-restores-motion", "G1 F9\nG112 I5 D2\nG80 X5\n"},
    {"thread-diameter-as-radius", kThread},
    {"thread-tool-side", kThread},
    {"thread-last-pass-too-deep", kThread},
    {"thread-extra-pass", kWhole},
    {"thread-turn-short", kWhole},
    {"thread-lead-off", kWhole},
    {"thread-partial-turn-dropped", kThread},
    {"g115-as-g114", kWhole},
    {"thread-no-retract", kThread},
    {"thread-ends-at-r-plane", kThread},
    {"run-out-into-wall", kThread},
    {"run-out-backwards", kThread},
    {"run-out-parameter-ignored", kNoRunOut, kParameters},
    {"angle-parameter-ignored", kNoRunOut, kParameters},
    {"thread-depth-from-initial", kThread},
    {"thread-height-equality-refused", "G114 X0 Z0 V-5 I5 E30 P3 D3 F9\n"},
    {"bore-unchecked", "G116 X0 Z0 V-5 I5 E5 P1 D3 F9\n"},
    {"thread-mode-lost", "G114\nX1 Y2 Z3 I5 E30 P1 D3 F9\n"},
    {"late-alarm", "G110 X1 Z0 Y-9 I3 L3 Q5 D4 F8\n"},
    {"alarm-next-block", "G999\n"},
    {"range-in-millimetres", "G20 G94 Z-100000 F9\n"},
    {"cycle-feed-stuck", "G94 X-8 Z-3 F9\nX-9 F8\n"},
    {"inch-feed", "G20 G1 X1 F9\n"},
    {"increment-as-radius", "G0 U9\n"},
    {"dwell-halved", "G04 X1\n"},
    {"blank-lines-not-counted", "\nG0 X1\n"},
    {"pairs-counted-twice", "G0 X1\r\nX2\r\n"},
    {"long-arc-short", "G2 X10 Z10 R-9 F9\n"},
    {"centre-swapped-in-g18", "G2 X10 Z5 K5 F9\n"},
    {"home-direct", "G28 X9\n"},
    {"feed-survives-reset", "G1 X1 F9\n"},
};

class PlantedFault : public ::testing::TestWithParam<ProfiledFaultExample> {};

TEST_P(PlantedFault, Shows) {
  // After the reset without a feed of its own.
  expect_shown(GetParam(), "gsk", "G1 Y1\n");
}

INSTANTIATE_TEST_SUITE_P(Gsk, PlantedFault, ::testing::ValuesIn(kGskFaultExamples), FaultName());

TEST(PlantedFaults, EachHasItsProgram) {
  std::set<std::string_view> shown;
  for (const ProfiledFaultExample& example : kGskFaultExamples) shown.insert(example.fault);
  std::set<std::string_view> known;
  for (const FaultDescription& fault : faults("gsk")) {
    known.insert(fault.name);
    EXPECT_FALSE(fault.what.empty() || fault.clause.empty() || fault.models.empty());
  }
  EXPECT_EQ(shown, known);
  EXPECT_EQ(known.size(), faults("gsk").size());
}

}  // namespace
}  // namespace gonogo::expanders::testing
