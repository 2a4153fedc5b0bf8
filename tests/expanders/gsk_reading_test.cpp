// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the machine: each reading against the standard outcome on one program.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(GskReading, PocketEnd) {
  const std::string program = "G0 Y50\nG110 X0 Z0 Y40 R-5 I3 L3 Q9 D2 F100\n";
  EXPECT_EQ(run_with_reading("gsk.pocket.end", "initial", program).records.back(),
            "end x=0 y=50 z=0 a=0 c=0");
  EXPECT_EQ(run_with_reading("gsk.pocket.end", "r-plane", program).records.back(),
            "end x=0 y=45 z=0 a=0 c=0");
}

TEST(GskReading, PocketEndKeepsTheInitialPlane) {
  // The next pocket still counts R from Y50.
  const Outcome outcome = run_with_reading(
      "gsk.pocket.end", "r-plane", "G0 Y50\nG110 X0 Z0 Y40 R-5 I3 L3 Q9 D2 F100\nX9 Z9 Y40 R-3\n");
  EXPECT_EQ(outcome.records.back(), "end x=9 y=47 z=9 a=0 c=0");
}

TEST(GskReading, G94Rewrite) {
  const std::string program = "G94 X-8 Z-9 R-5 F50\nG94 X-6\n";
  EXPECT_EQ(run_with_reading("gsk.g94.rewrite", "keep", program).records[4], "rapid z=-14");
  EXPECT_EQ(run_with_reading("gsk.g94.rewrite", "clear", program).records[4], "rapid z=-9");
  // Z has no travel then: nothing leads to it.
  EXPECT_EQ(run_with_reading("gsk.g94.rewrite", "clear-all", program).records[4],
            "feed x=-6 z=0 f=50");
}

TEST(GskReading, G94AfterNonModalCode) {
  const std::string program = "G94 X-8 Z-9 F50\nG28\nX-6\n";
  EXPECT_EQ(run_with_reading("gsk.g94.after-00", "stays", program).records[4],
            "feed x=-6 z=0 f=50");
  EXPECT_EQ(run_with_reading("gsk.g94.after-00", "cancelled", program).records[4], "rapid x=-6");
}

TEST(GskReading, G94EmptyBlock) {
  const std::string program = "G94 X-8 Z-9 F50\nF60\n\nG04 P1\n";
  EXPECT_EQ(run_with_reading("gsk.g94.empty-block", "none", program).records.size(), 6u);
  EXPECT_EQ(run_with_reading("gsk.g94.empty-block", "repeat", program).records.size(), 10u);
}

TEST(GskReading, G94EmptyBlockNeedsTheCodeOrAWordOfTheCycle) {
  const auto motions = [](const std::string& block) {
    return run_with_reading("gsk.g94.empty-block", "repeat", "G94 X-8 Z-9 F50\n" + block + "\n")
        .motions();
  };
  const std::string once = "rapid z=-9\nfeed x=-8 z=-9 f=50\nfeed z=0 f=50\nrapid x=0\n";
  for (const char* block : {"S300", "T0202", "G97"}) EXPECT_EQ(motions(block), once) << block;
  EXPECT_EQ(motions("M05"), once + "m 5\n");
  EXPECT_EQ(motions("G94"), once + once);
}

TEST(GskReading, G92EmptyBlockTakesTheWordsOfItsRunOut) {
  const std::string program = "G92 X-8 Z-9 F2\nJ0\n";
  EXPECT_EQ(run_with_reading("gsk.g94.empty-block", "none", program).records.size(), 5u);
  EXPECT_EQ(run_with_reading("gsk.g94.empty-block", "repeat", program).records.size(), 9u);
}

TEST(GskReading, G80Motion) {
  const std::string line = "G01 X5 F50\nG80\nX8\n";
  EXPECT_EQ(run_with_reading("gsk.g80.motion", "traverse", line).records[1], "rapid x=8");
  EXPECT_EQ(run_with_reading("gsk.g80.motion", "kept", line).records[1], "feed x=8 f=50");
  const std::string cycle = "G01 X5 F50\nG94 X2 Z-9\nG80 X8\n";
  EXPECT_EQ(run_with_reading("gsk.g80.motion", "traverse", cycle).records[5], "rapid x=8");
  EXPECT_EQ(run_with_reading("gsk.g80.motion", "kept", cycle).records[5], "feed x=8 f=50");
  const std::string arc = "G03 X4 R2 F50\nG80 X8\n";
  EXPECT_EQ(run_with_reading("gsk.g80.motion", "kept", arc).alarm, "missing-word");
}

TEST(GskReading, WordOfAnAxisOutsideThePlaneThatMovesNothing) {
  const auto said = [](const std::string& value, const std::string& word) {
    const Outcome outcome = run_with_reading("gsk.g94.still-axis", value,
                                             "G00 Y2\nG94 X-8 Z-9 F50 " + word + "\nG00 X1\n");
    return outcome.alarms != 0 ? outcome.alarm : outcome.records.at(1);
  };
  for (const char* word : {"V0", "Y2", "C0", "H0"}) {
    EXPECT_EQ(said("alarm", word), "axis-not-in-plane") << word;
    EXPECT_EQ(said("ignored", word), "rapid z=-9") << word;
  }
  for (const char* word : {"V1", "Y3", "C1", "H1"}) {
    EXPECT_EQ(said("ignored", word), "axis-not-in-plane") << word;
  }
  const Outcome alone = run_with_reading("gsk.g94.still-axis", "ignored", "G94 X-8 Z-9 F50\nV0\n");
  EXPECT_EQ(alone.records.size(), 5u);
}

TEST(GskReading, ArcWithoutCentre) {
  const std::string program = "G02 X4 Z3 F50\n";
  EXPECT_EQ(run_with_reading("gsk.arc.no-centre", "alarm", program).alarm, "missing-word");
  EXPECT_EQ(run_with_reading("gsk.arc.no-centre", "line", program).motions(),
            "feed x=4 z=3 f=50\n");
  EXPECT_EQ(run_with_reading("gsk.arc.no-centre", "line", "G02 X4 Z3\n").alarm, "feed-missing");
}

// Half the chord may be longer than R by 0.01.
TEST(GskReading, ArcWithASmallRadius) {
  const std::string program = "G02 Z10.02 R5 F50\n";
  EXPECT_EQ(run_with_reading("gsk.arc.small-radius", "alarm", program).alarm, "arc-radius");
  EXPECT_EQ(run_with_reading("gsk.arc.small-radius", "semicircle", program).motions(),
            "arc18 c=5.01,0 rot=-1 x=0 z=10.02 f=50\n");
  EXPECT_EQ(run_with_reading("gsk.arc.small-radius", "semicircle", "G02 Z10.021 R5 F50\n").alarm,
            "arc-radius");
}

// 0.5 inch are 12.7 mm.
TEST(GskReading, Retained) {
  const std::string program = "G20 G94 X-1 Z-0.5 F9\nG21 X-8 F50\n";
  EXPECT_EQ(run_with_reading("gsk.retained", "keep", program).records[5], "feed x=-8 z=-12.7 f=50");
  EXPECT_EQ(run_with_reading("gsk.retained", "clear", program).records[4], "feed x=-8 z=0 f=50");
  EXPECT_EQ(run_with_reading("gsk.retained", "number", program).records[5],
            "feed x=-8 z=-0.5 f=50");
}

// I0.5 and D0.25 of inches are 12.7 and 6.35 mm, so that the helix has the radius 6.35; or 0.25 mm.
TEST(GskReading, RetainedByAMillingCycle) {
  const std::string program = "G20 G112 I0.5 D0.25 F10\nG21 X0 Z0 Y-3\n";
  EXPECT_EQ(run_with_reading("gsk.pocket.retained", "length", program).records[1],
            "arc18 c=0,0 rot=-1 x=-6.35 y=-3 z=0 f=254");
  EXPECT_EQ(run_with_reading("gsk.pocket.retained", "number", program).records[1],
            "arc18 c=0,0 rot=-1 x=-0.25 y=-3 z=0 f=254");
}

TEST(GskReading, FeedChange) {
  const std::string program = "F50\nG99 G1 X20\n";
  EXPECT_EQ(run_with_reading("gsk.feed-change", "kept", program).answer, GONOGO_OK);
  EXPECT_EQ(run_with_reading("gsk.feed-change", "deleted", program).alarm, "feed-missing");
  EXPECT_EQ(run_with_reading("gsk.feed-change", "deleted", "F50\nG98 G1 X20\n").answer, GONOGO_OK);
}

TEST(GskReading, MissingAxis) {
  const std::string program = "G110 I3 L3 Q9 D2 F100 X5 Y-3\n";
  EXPECT_EQ(run_with_reading("gsk.missing-axis", "skip", program).motions(), "");
  EXPECT_EQ(run_with_reading("gsk.missing-axis", "position", program).motions(), "rapid x=5\n");
  const auto milled = [](const char* block) {
    return run_with_reading("gsk.missing-axis", "current", block).motions();
  };
  // The plane is that of Z and X; the helix has the radius 1.
  const std::string here = milled("G112 I3 D2 F100 X5 Y-3\n");
  EXPECT_EQ(here.substr(0, here.find("arc")), "rapid x=5\n") << here;
  EXPECT_NE(here.find("arc18 c=0,5 rot=-1 x=4 y=-3 z=0 f=100\n"), std::string::npos) << here;
  const std::string depth = milled("G112 I3 D2 F100 Y-3\n");
  EXPECT_EQ(depth.substr(0, 3), "arc") << depth;
  EXPECT_EQ(milled("G112 I3 D2 F100 X5 Z3\n"), "");
}

TEST(GskReading, ZeroDepth) {
  const std::string program = "G110 X5 Y0 Z0 I3 L3 Q9 D2\n";
  EXPECT_EQ(run_with_reading("gsk.zero-depth", "no-cut", program).motions(), "rapid x=5 z=0\n");
  EXPECT_EQ(run_with_reading("gsk.zero-depth", "alarm", program).alarm, "value-out-of-range");
}

TEST(GskReading, PocketPair) {
  const std::string program = "G110 I3 L3 Q9 D2 F100\nG111 X0 Z0 Y-1\n";
  EXPECT_EQ(run_with_reading("gsk.pocket.pair", "shared", program).answer, GONOGO_OK);
  EXPECT_EQ(run_with_reading("gsk.pocket.pair", "each", program).alarm, "missing-word");
}

TEST(GskReading, PocketR) {
  const std::string program = "G110 X0 Z0 Y-9 R-2 I3 L3 Q9 D2 F100\nX9 Z0 Y-9\n";
  EXPECT_EQ(run_with_reading("gsk.pocket.R", "per-block", program).records[8], "feed y=-9 f=100");
  EXPECT_EQ(run_with_reading("gsk.pocket.R", "modal", program).records[8], "rapid y=-2");
}

TEST(GskReading, XDepth) {
  const std::string program = "G19 G110 Y0 Z0 U-8 I3 L3 Q9 D2 F100\n";
  const std::string profile = R"({"readings":{"gsk.x-depth":")";
  EXPECT_EQ(run(program, profile + "diameter\"}}").records[0], "feed x=-4 f=100");
  EXPECT_EQ(run(program, profile + "radius\"}}").records[0], "feed x=-8 f=100");
}

TEST(GskReading, Duplicate) {
  EXPECT_EQ(run_with_reading("gsk.duplicate", "alarm", "G01 G00 X1 X2\n").alarm, "duplicate-word");
  EXPECT_EQ(run_with_reading("gsk.duplicate", "last", "G01 G00 X1 X2\n").motions(), "rapid x=2\n");
}

TEST(GskReading, Decimals) {
  EXPECT_EQ(run_with_reading("gsk.decimals", "keep", "G0 Z1.0005\n").motions(), "rapid z=1.0005\n");
  EXPECT_EQ(run_with_reading("gsk.decimals", "nearest", "G0 Z1.0005\n").motions(),
            "rapid z=1.001\n");
  EXPECT_EQ(run_with_reading("gsk.decimals", "nearest", "G20 G0 Z1.00014\n").motions(),
            "rapid z=25.40254\n");
  EXPECT_EQ(run_with_reading("gsk.decimals", "alarm", "G0 Z1.0005\n").alarm, "value-out-of-range");
  EXPECT_EQ(run_with_reading("gsk.decimals", "alarm", "G0 Z1.001\n").answer, GONOGO_OK);
}

TEST(GskReading, DecimalsThatAreZeroDoNotCount) {
  EXPECT_EQ(run_with_reading("gsk.decimals", "alarm", "G0 Z1.001000\n").answer, GONOGO_OK);
  EXPECT_EQ(run_with_reading("gsk.decimals", "alarm", "G0 Z1.000000000000\n").answer, GONOGO_OK);
  EXPECT_EQ(run_with_reading("gsk.decimals", "alarm", "G0 Z1.000000000001\n").alarm,
            "value-out-of-range");
}

TEST(GskReading, G94InMode) {
  const std::string program = "G94 X-8 Z-9 R-5 F50\nG110 I3 L3 Q9 D2\nG94 X-6\n";
  EXPECT_EQ(run_with_reading("gsk.g94.in-mode", "keep", program).records[4], "rapid z=-14");
  EXPECT_EQ(run_with_reading("gsk.g94.in-mode", "clear", program).records[4], "feed x=-6 z=0 f=50");
}

TEST(GskReading, ZeroDepthEndAppliesWherePocketsEndAtTheRPlane) {
  const std::string program = "G0 Y50\nG110 X5 Y45 Z0 R-5 I3 L3 Q9 D2\n";
  const auto ends = [&](const std::string& pocket, const std::string& zero) {
    return run(program, R"({"readings":{"gsk.pocket.end":")" + pocket +
                            R"(","gsk.zero-depth-end":")" + zero + "\"}}")
        .records.back();
  };
  EXPECT_EQ(ends("r-plane", "initial"), "end x=2.5 y=50 z=0 a=0 c=0");
  EXPECT_EQ(ends("r-plane", "r-plane"), "end x=2.5 y=45 z=0 a=0 c=0");
  EXPECT_EQ(ends("initial", "r-plane"), "end x=2.5 y=50 z=0 a=0 c=0");
}

TEST(GskReading, DwellWithoutWord) {
  EXPECT_EQ(run_with_reading("gsk.dwell-without-word", "alarm", "G04\n").alarm, "missing-word");
  EXPECT_EQ(run_with_reading("gsk.dwell-without-word", "alarm", "G04 P0\n").answer, GONOGO_OK);
  EXPECT_EQ(run_with_reading("gsk.dwell-without-word", "none", "G04\n").motions(), "");
}

TEST(GskReading, ArcZeroRadius) {
  EXPECT_EQ(run_with_reading("gsk.arc.zero-radius", "alarm", "G2 I0 K0 F9\n").alarm, "arc-radius");
  EXPECT_EQ(run_with_reading("gsk.arc.zero-radius", "alarm", "G2 X0.005 K0 F9\n").alarm,
            "arc-radius");
}

TEST(GskReading, ArcClosed) {
  EXPECT_EQ(run_with_reading("gsk.arc.closed", "alarm", "G2 X0 Z0 R5 F9\n").alarm, "arc-end-point");
  EXPECT_EQ(run_with_reading("gsk.arc.closed", "none", "G2 X0 Z0 R5 F9\nG0 X2\n").motions(),
            "rapid x=2\n");
  EXPECT_EQ(run_with_reading("gsk.arc.closed", "none", "G2 Y-3 R5 F9\n").motions(),
            "feed y=-3 f=9\n");
}

TEST(GskReading, ArcToleranceZero) {
  const auto answer = [](const std::string& reading, const std::string& program) {
    return run(program, R"({"x_diameter":false,"parameters":{"3410":"0"},"readings":{
                            "gsk.arc.tolerance-zero":")" +
                            reading + "\"}}")
        .alarm;
  };
  EXPECT_EQ(answer("off", "G2 X5 Z8 K5 F9\n"), "");
  EXPECT_EQ(answer("exact", "G2 X5 Z5.001 K5 F9\n"), "arc-end-point");
  EXPECT_EQ(answer("exact", "G2 X5 Z5 K5 F9\n"), "");
}

TEST(GskReading, G50InitialPlane) {
  // The initial plane Y0 becomes Y100, or stays where its number is.
  const std::string program = "G110 I3 L3 Q9 D2 F9\nG50 Y100\nX0 Z0 Y99\n";
  EXPECT_EQ(run_with_reading("gsk.g50.initial-plane", "shifted", program).records[0],
            "feed y=99 f=9");
  EXPECT_EQ(run_with_reading("gsk.g50.initial-plane", "kept", program).records[0], "rapid y=0");
}

TEST(GskReading, AnyTakesTheStandardOutcome) {
  EXPECT_EQ(run_with_reading("gsk.duplicate", "any", "G00 X1 X2\n").alarm, "duplicate-word");
}

}  // namespace
}  // namespace gonogo::expanders::testing
