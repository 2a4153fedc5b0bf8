// SPDX-License-Identifier: GPL-3.0-or-later
// The readings of the hole cycles and threads that the worked examples leave out, by hand.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// After a feed of 100.
std::string with(const std::string& readings, const std::string& program) {
  const std::string profile = R"({"readings":{)" + readings + "}}";
  return run_ngc("F100\n" + program, profile).motions();
}

TEST(NgcCycleReading, RetractBeforeG98AndG99) {
  const std::string program = "G0 Z5\nG81 Z1 R2\n";
  EXPECT_EQ(with("", program), "rapid z=5\nrapid z=2\nfeed z=1 f=100\nrapid z=2\n");
  EXPECT_EQ(with(R"("ngc.cycle.retract-start":"initial")", program),
            "rapid z=5\nrapid z=2\nfeed z=1 f=100\nrapid z=5\n");
}

TEST(NgcCycleReading, FeedOfNoWord) {
  EXPECT_EQ(with(R"("ngc.cycle.feed":"free")", "F0 G81 Z-1 R0\n"), "feed z=-1 f=0\nrapid z=0\n");
}

TEST(NgcCycleReading, AbsoluteRUnderG91) {
  EXPECT_EQ(with(R"("ngc.cycle.g91-r":"absolute")", "G0 Z9\nG91 G81 Z-1 R2\n"),
            "rapid z=9\nrapid z=2\nfeed z=1 f=100\nrapid z=2\n");
}

// Sticky under G91: the number is added anew, or the level stays.
TEST(NgcCycleReading, StickyLevels) {
  const std::string program = "G0 Z9\nG91 G99 G81 X1 Z-1 R-2\nX1\nX1 Z-3\n";
  const std::string first = "rapid z=9\nrapid x=1 y=0\nrapid z=7\nfeed z=6 f=100\nrapid z=7\n";
  EXPECT_EQ(with("", program), first +
                                   "rapid x=2 y=0\nrapid z=5\nfeed z=4 f=100\nrapid z=5\n"
                                   "rapid x=3 y=0\nrapid z=3\nfeed z=0 f=100\nrapid z=3\n");
  EXPECT_EQ(with(R"("ngc.cycle.sticky":"level")", program),
            first +
                "rapid x=2 y=0\nfeed z=6 f=100\nrapid z=7\n"
                "rapid x=3 y=0\nfeed z=4 f=100\nrapid z=7\n");
}

// 10 mm is 10 inches, 254 mm, after the change of units.
TEST(NgcCycleReading, InitialLevelKeptAsANumber) {
  const std::string program = "G0 Z10\nG98 G81 X1 Z-1 R2\nG20\nX2 R0.1 Z0\n";
  const std::string first = "rapid z=10\nrapid x=1 y=0\nrapid z=2\nfeed z=-1 f=100\nrapid z=10\n";
  EXPECT_EQ(with("", program),
            first + "rapid x=50.8 y=0\nrapid z=2.54\nfeed z=0 f=100\nrapid z=10\n");
  EXPECT_EQ(with(R"("ngc.cycle.initial-kept":"number")", program),
            first + "rapid x=50.8 y=0\nrapid z=2.54\nfeed z=0 f=100\nrapid z=254\n");
  // And back: 1 inch is 1 mm.
  const std::string back = "G20\nG0 Z1\nG98 G81 Z0 R0.01\nG21\nX2 R0.5\n";
  EXPECT_EQ(with(R"("ngc.cycle.initial-kept":"number")", back),
            "rapid z=25.4\nrapid z=0.254\nfeed z=0 f=100\nrapid z=25.4\n"
            "rapid x=2 y=0\nrapid z=0.5\nfeed z=0 f=100\nrapid z=1\n");
}

// A change of plane begins a new series; as a number the level is that of the new axis.
TEST(NgcCycleReading, InitialLevelInAnotherPlane) {
  const std::string program = "G0 X5 Z10\nG98 G81 Z1 R2\nG19 G99\nG98 Y1 X1 R3\n";
  const std::string first = "rapid x=5 z=10\nrapid z=2\nfeed z=1 f=100\nrapid z=10\n";
  EXPECT_EQ(with("", program), first + "rapid y=1 z=10\nrapid x=3\nfeed x=1 f=100\nrapid x=5\n");
  EXPECT_EQ(with(R"("ngc.cycle.initial-kept":"number")", program),
            first + "rapid y=1 z=10\nrapid x=3\nfeed x=1 f=100\nrapid x=10\n");
}

TEST(NgcCycleReading, ClearanceOfPecks) {
  const auto back = [](const std::string& readings, const char* cycle, const char* profile = "") {
    const std::string keys = std::string("{") + profile + R"("readings":{)" + readings + R"(}})";
    const std::string program = "F100\nG21 " + std::string(cycle) + " Z-4 R0 Q2\n";
    // feed z=-2, [rapid z=0], rapid
    const Outcome outcome = run_ngc(program, keys);
    return outcome.records.at(std::string_view(cycle).starts_with("G83") ? 2 : 1);
  };
  EXPECT_EQ(back("", "G83"), "rapid z=-1.746");
  EXPECT_EQ(back(R"("ngc.peck.clearance":"one-mm")", "G83"), "rapid z=-1");
  EXPECT_EQ(back(R"("ngc.peck.clearance":"one-mm")", "G73", R"("units":"inch",)"), "rapid z=-1.95");
  EXPECT_EQ(back(R"("ngc.peck.clearance":"tenth-mm")", "G73"), "rapid z=-1.9");
  EXPECT_EQ(back(R"("ngc.peck.clearance":"tenth-mm")", "G83"), "rapid z=-1.9");
  EXPECT_EQ(back(R"("ngc.peck.clearance":"twentieth")", "G83"), "rapid z=-1.9");
  EXPECT_EQ(back(R"("ngc.peck.d":"clearance")", "G83 D0.5"), "rapid z=-1.5");
  EXPECT_EQ(run_ngc("F9\nG83 Z-4 R0 Q2 D-1\n", R"({"readings":{"ngc.peck.d":"clearance"}})").alarm,
            "value-sign");
}

// One millimetre of a metric machine is one inch under G20.
TEST(NgcCycleReading, ClearanceInTheUnitInForce) {
  EXPECT_EQ(with(R"("ngc.peck.clearance":"one-mm")", "G20\nG73 Z-2 R0 Q1\n"),
            "feed z=-25.4 f=100\nrapid z=0\nfeed z=-50.8 f=100\nrapid z=0\n");
}

// As grblHAL: withdrawal to the clear level, feed back, a quarter of a second at each peck.
TEST(NgcCycleReading, PecksOfGrblhal) {
  EXPECT_EQ(with(R"("ngc.g83.retract":"clear","ngc.g83.return":"feed","ngc.peck.dwell":"quarter",
                    "ngc.cycle.retract-start":"initial")",
                 "G0 Z5\nG83 Z-3 R0 Q2\n"),
            "rapid z=5\nrapid z=0\nfeed z=-2 f=100\ndwell 0.25\nrapid z=5\nfeed z=-3 f=100\n"
            "dwell 0.25\nrapid z=5\n");
}

TEST(NgcCycleReading, EndOfG73) {
  const std::string program = "G0 Z5\nG98 G73 Z-1 R0 Q2\n";
  const std::string first = "rapid z=5\nrapid z=0\nfeed z=-1 f=100\n";
  EXPECT_EQ(with("", program), first + "rapid z=0\n");
  EXPECT_EQ(with(R"("ngc.g73.end":"both")", program), first + "rapid z=0\nrapid z=5\n");
}

TEST(NgcCycleReading, DwellOfTaps) {
  const std::string needed = R"({"readings":{"ngc.tap.p":"needed"}})";
  EXPECT_EQ(run_ngc("F9 M3\nG84 Z-1 R0\n", needed).alarm, "missing-word");
  EXPECT_EQ(run_ngc("F9 M3\nG84 Z-1 R0 P1\nX1\n", needed).alarm, "");
  const std::string barred = R"({"readings":{"ngc.tap.p":"barred"}})";
  EXPECT_EQ(run_ngc("F9 M3\nG84 Z-1 R0 P1\n", barred).alarm, "unused-word");
  EXPECT_EQ(run_ngc("F9 M3\nG84 Z-1 R0 P1 G4\n", barred).motions(),
            "m 3\ndwell 1\nfeed z=-1 f=9\nm 5\nm 4\nfeed z=0 f=9\nm 5\nm 3\n");
}

// Depths 0.5 and 1 of K1, slide 45 degrees: the first pass begins 0.5 before Z2.
TEST(NgcCycleReading, SlideFromTheEnd) {
  EXPECT_EQ(with(R"("ngc.g76.slide":"end")", "G18 M3\nG0 X20 Z2\nG76 P2 Z-20 I-1 J0.5 K1 Q45\n"),
            "m 3\nrapid x=20 z=2\nrapid x=20.5 z=2.5\nrapid x=18.5 z=2.5\n"
            "thread x=18.5 z=-19.5 lead=2 start=0\nrapid x=20.5 z=-19.5\nrapid x=20 z=2\n"
            "rapid x=18 z=2\nthread x=18 z=-20 lead=2 start=0\nrapid x=20 z=-20\n");
}

TEST(NgcCycleReading, EntryOfTapers) {
  const std::string program = "G18 M3\nG0 X20 Z2\nG76 P2 Z-20 I-1 J0.9 K1 L1 E2\n";
  const auto entry = [&](const char* choice) {
    const std::string profile =
        R"({"readings":{"ngc.g76.entry":")" + std::string(choice) + R"("}})";
    return run_ngc("F100\n" + program, profile).records.at(3);
  };
  EXPECT_EQ(entry("feed"), "feed x=19.1 z=2 f=100");
  EXPECT_EQ(entry("rapid"), "rapid x=19.1 z=2");
  EXPECT_EQ(run_ngc(program, R"({"readings":{"ngc.g76.entry":"feed"}})").alarm, "feed-missing");
}

// LinuxCNC's: X and Y move with the last rapid, H-1 leaves out the full passes, Q-1 is 0, L7 is 3.
TEST(NgcCycleReading, ChecksOfLinuxcnc) {
  constexpr const char* kLenient = R"("ngc.g76.checks":"linuxcnc")";
  EXPECT_EQ(with(kLenient, "M3\nG0 X20 Z2\nG76 P2 Z-20 I-1 J0.5 K1 H-1 Q-1 R0.1 X5 Y6\n"),
            "m 3\nrapid x=20 z=2\nrapid x=20.5 z=2\nrapid x=18.5 z=2\n"
            "thread x=18.5 z=-20 lead=2 start=0\nrapid x=20.5 z=-20\nrapid x=5 y=6 z=-20\n");
  const std::string words = "M3\nG0 X20 Z2\nG76 P2 Z-20 I-1 J0.5 K1 E2 ";
  EXPECT_EQ(with(kLenient, words + "L7\n"), with("", "G18\n" + words + "L3\n"));
  EXPECT_EQ(with(kLenient, "M3\nG0 X20 Z2\nG76 P2 X0 I-1 J0.9 K1\n"),
            "m 3\nrapid x=20 z=2\nrapid x=20.1 z=2\nrapid x=18.1 z=2\nrapid x=20.1 z=2\n"
            "rapid x=20 z=2\nrapid x=18 z=2\nrapid x=20 z=2\nrapid x=0 z=2\n");
}

// NGC-CYC-15, NGC-COM-01: L as near a whole number as an M function.
TEST(NgcCycleReading, NearWholeRepeats) {
  EXPECT_EQ(run_ngc("F9\nG81 Z-1 R0 L1.00005\n").alarm, "not-an-integer");
  EXPECT_EQ(with(R"("ngc.whole":"linuxcnc")", "G81 Z-1 R0 L1.00005\n"),
            "feed z=-1 f=100\nrapid z=0\n");
}

TEST(NgcCycleReading, SpindleAtPowerOn) {
  EXPECT_EQ(run_ngc("G33 Z-1 K1\n", R"({"initial":{"spindle":"M4"}})").motions(),
            "thread z=-1 lead=1 start=0\n");
}

// An irrational depth, a root or a tangent never decides a count: 3^(1/3) of depth 0.1 ...
TEST(NgcCycleReading, DegressionOfAPerfectPower) {
  // n^(1/3) 0.5 < 1 for n < 8: seven passes, and the full one.
  std::size_t cuts = 0;
  for (const std::string& record :
       run_ngc("G18 M3\nG0 X20 Z2\nG76 P2 Z-20 I-1 J0.5 K1 R3\n").records) {
    if (record.starts_with("thread")) ++cuts;
  }
  EXPECT_EQ(cuts, 8u);
}

TEST(NgcCycle, RepeatsThatDoNothingAreNotRun) {
  EXPECT_EQ(run_ngc("F9\nG81 X1 Z2 R2 L999999999\nM2\n").motions(),
            "rapid z=2\nrapid x=1 y=0\nm 2\n");
}

TEST(NgcCycle, EndlessRepeatsStream) {
  const Outcome outcome = Session("{}", {}, "ngc").run("F9\nG83 Z-9000 R0 Q0.000001\n", 1'000);
  EXPECT_EQ(outcome.answer, GONOGO_STOPPED);
  EXPECT_EQ(outcome.records.size(), 1'000u);
}

}  // namespace
}  // namespace gonogo::expanders::testing
