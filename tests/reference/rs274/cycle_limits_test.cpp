// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limits of cycles and threads, one least increment below, on and above each; and what holds
// between the blocks of a program.
#include <gtest/gtest.h>

#include "ngc_trace.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

std::string at(const std::string& blocks) {
  return trace("F100\n" + blocks + "\nM2");
}

TEST(NgcCycleLimits, RAndWhereTheToolIs) {
  EXPECT_EQ(at("G0 Z2\nG99 G81 X1 Z1 R1.9999"), "R0,0,2 R1,0,2 R1,0,1.9999 F1,0,1 R1,0,1.9999");
  EXPECT_EQ(at("G0 Z2\nG99 G81 X1 Z1 R2"), "R0,0,2 R1,0,2 F1,0,1 R1,0,2");
  EXPECT_EQ(at("G0 Z2\nG99 G81 X1 Z1 R2.0001"),
            "R0,0,2 R0,0,2.0001 R1,0,2.0001 F1,0,1 R1,0,2.0001");
}

TEST(NgcCycleLimits, RAndTheBottom) {
  EXPECT_EQ(at("G99 G82 X1 Z1 R1.0001 P1"), "R0,0,1.0001 R1,0,1.0001 F1,0,1 D1 R1,0,1.0001");
  EXPECT_EQ(at("G99 G82 X1 Z1 R1 P1"), "R0,0,1 R1,0,1 D1");
  EXPECT_EQ(at("G99 G82 X1 Z1 R0.9999 P1"), "!b2:reference-plane");
  EXPECT_EQ(at("G99 G83 X1 Z1 R1 Q1"), "R0,0,1 R1,0,1");
}

TEST(NgcCycleLimits, RAndTheInitialLevel) {
  EXPECT_EQ(at("G0 Z2\nG98 G81 X0 Z1 R1.9999"), "R0,0,2 R0,0,1.9999 F0,0,1 R0,0,2");
  EXPECT_EQ(at("G0 Z2\nG98 G81 X0 Z1 R2"), "R0,0,2 F0,0,1 R0,0,2");
  EXPECT_EQ(at("G0 Z2\nG98 G81 X0 Z1 R2.0001"), "R0,0,2 R0,0,2.0001 F0,0,1 R0,0,2.0001");
}

// N = 3 where the depth is no more than 3 Q.
TEST(NgcCycleLimits, PecksAndTheDepth) {
  const std::string two = "F0,0,-3 R0,0,-2.746 F0,0,-6 R0,0,-5.746 ";
  EXPECT_EQ(at("G99 G73 X0 Z-8.9999 R0 Q3"), two + "F0,0,-8.9999 R0,0,0");
  EXPECT_EQ(at("G99 G73 X0 Z-9 R0 Q3"), two + "F0,0,-9 R0,0,0");
  EXPECT_EQ(at("G99 G73 X0 Z-9.0001 R0 Q3"), two + "F0,0,-9 R0,0,-8.746 F0,0,-9.0001 R0,0,0");
  // Tenths, of which no number of binary ones is whole.
  EXPECT_EQ(at("G99 G73 X0 Z-0.3 R0 Q0.1"),
            "F0,0,-0.1 R0,0,0.154 F0,0,-0.2 R0,0,0.054 F0,0,-0.3 R0,0,0");
  // Q 3 of a depth of 3: one peck.
  EXPECT_EQ(at("G99 G83 X0 Z-3 R0 Q3"), "F0,0,-3 R0,0,0");
  EXPECT_EQ(at("G99 G83 X0 Z-3 R0 Q2.9999"), "F0,0,-2.9999 R0,0,0 R0,0,-2.7459 F0,0,-3 R0,0,0");
}

// The way back ends below R, on it, or above it.
TEST(NgcCycleLimits, AFirstPeckAndTheClearance) {
  EXPECT_EQ(at("G99 G83 X0 Z-0.3 R0 Q0.2541"), "F0,0,-0.2541 R0,0,0 R0,0,-0.0001 F0,0,-0.3 R0,0,0");
  EXPECT_EQ(at("G99 G83 X0 Z-0.3 R0 Q0.254"), "F0,0,-0.254 R0,0,0 F0,0,-0.3 R0,0,0");
  EXPECT_EQ(at("G99 G83 X0 Z-0.3 R0 Q0.2539"), "F0,0,-0.2539 R0,0,0 R0,0,0.0001 F0,0,-0.3 R0,0,0");
}

// Half a million of them: the last is as exact as the first.
TEST(NgcCycleLimits, ManyPecksAreAsExactAsOne) {
  const auto items = expand("F100\nG99 G73 X0 Z-50 R0 Q0.0001\nM2", ngc());
  ASSERT_EQ(items.size(), 2 * 500'000 + 2U);
  const auto& last = std::get<Record>(items[items.size() - 6]);
  EXPECT_EQ(last.to[Axis::z], num("-49.9999"));
  EXPECT_EQ(std::get<Record>(items[items.size() - 5]).to[Axis::z], num("-49.7459"));
}

TEST(NgcCycleLimits, ManyHolesAreAsExactAsOne) {
  const auto items = expand("F100\nG91 G99 G81 X0.1 Z-1 R0 L100000\nM2", ngc());
  ASSERT_EQ(items.size(), 3 * 100'000 + 2U);
  EXPECT_EQ(line_of(items.back()), "end x10000 y0 z0 a0 c0");
  EXPECT_EQ(std::get<Record>(items[std::size_t{3} * 99'998]).to[Axis::x], num("9999.9"));
}

// As many as a program likes come one by one.
TEST(NgcCycleLimits, AnyNumberOfHolesStreams) {
  const std::string program = "F100\nG91 G99 G81 X0 Y0 Z-1 R0 L9000000\nM2";
  grammar::MemorySource bytes(program);
  grammar::LineSource source(bytes);
  const Profile profile = ngc();
  Expander expander(profile, source, OpenPaths::shown);
  for (int i = 0; i < 1'000; ++i) ASSERT_NE(expander.next(), nullptr);
}

std::size_t cuts_of(const std::string& words) {
  std::size_t cuts = 0;
  for (const TraceStep& step : trace_steps("G18 M3\nG76 P1 Z-20 I-1 " + words + "\nM2")) {
    if (step.kind == 'T') ++cuts;
  }
  return cuts;
}

// Passes n with n^v < (K/J)^u, and the full one.
TEST(NgcThreadLimits, PassesAndTheDepth) {
  // R = 1: n < K/J.
  EXPECT_EQ(cuts_of("J1 K2.9999"), 3U);
  EXPECT_EQ(cuts_of("J1 K3"), 3U);
  EXPECT_EQ(cuts_of("J1 K3.0001"), 4U);
  // No binary number is a whole seventh of a tenth: 0.7, 1.4, 2.1.
  EXPECT_EQ(cuts_of("J0.7 K2.1"), 3U);
  // R = 2: n < (K/J)^2.
  EXPECT_EQ(cuts_of("J1 K1.9999 R2"), 4U);
  EXPECT_EQ(cuts_of("J1 K2 R2"), 4U);
  EXPECT_EQ(cuts_of("J1 K2.0001 R2"), 5U);
  // R = 3/2: n^2 < (K/J)^3 = 64.
  EXPECT_EQ(cuts_of("J1 K3.9999 R1.5"), 8U);
  EXPECT_EQ(cuts_of("J1 K4 R1.5"), 8U);
  EXPECT_EQ(cuts_of("J1 K4.0001 R1.5"), 9U);
  EXPECT_EQ(cuts_of("J1 K2 H3"), 5U);
}

// NGC-G76-05: (K/J)^R may be of thirty digits. J 0.001 and K 10 are 10,000 passes.
TEST(NgcThreadLimits, PassesThatTheGaugeDoesNotFollow) {
  EXPECT_EQ(cuts_of("J0.001 K10"), 10'000U);
  EXPECT_EQ(cuts_of("J9 K10 H9998"), 10'000U);
  for (const char* words : {"J0.001 K10.0001", "J0.25 K0.5495 R90", "J9 K10 H10000"}) {
    const auto items = expand("G18 M3\nG76 P1 Z-20 I-1 " + std::string(words) + "\nM2", ngc());
    EXPECT_TRUE(std::holds_alternative<NotCovered>(items.back())) << words;
    EXPECT_LT(items.size(), 3U) << words;
  }
}

// d_4 = 2 and d_9 = 3 of R 2 are rational; d_8 = 4 of R 3/2.
TEST(NgcThreadLimits, DepthsThatAreRationalAreSo) {
  const auto depth = [](const std::string& words, std::size_t pass) {
    std::vector<Number> x;
    for (const TraceStep& step : trace_steps("G18 M3\nG76 P1 Z-20 I-1 " + words + "\nM2")) {
      if (step.kind == 'T') x.push_back(step.at[0]);
    }
    return -1 - x.at(pass - 1);
  };
  EXPECT_EQ(depth("J1 K5 R2", 4), Number(2));
  EXPECT_EQ(depth("J1 K5 R2", 9), Number(3));
  EXPECT_EQ(depth("J1 K5 R2", 8), Number::root(0, 2, 2));
  EXPECT_EQ(depth("J1 K5 R1.5", 8), Number(4));
  EXPECT_EQ(depth("J1 K3 R4", 4), Number::root(0, 1, 2));
  // 2^(2/3), to seven digits.
  EXPECT_EQ(depth("J1 K5 R1.5", 2).decimal_text(6), "1.587401");
  EXPECT_EQ(depth("J0.5 K5 R1.5", 2).form(), Number::Form::enclosure);
}

TEST(NgcThreadLimits, TapersAndTheLength) {
  const auto end = [](const std::string& words) {
    return ending_of("G18 M3\nG76 P1 Z-20 I-1 J1 K2 " + words + "\nM2");
  };
  EXPECT_EQ(end("L3 E10"), "end x0 y0 z-20 a0 c0");
  EXPECT_EQ(end("L3 E10.0001"), "alarm b2 value-out-of-range");
  EXPECT_EQ(end("L2 E10.0001"), "alarm b2 value-out-of-range");
  EXPECT_EQ(end("L0 E10.0001"), "end x0 y0 z-20 a0 c0");
  EXPECT_EQ(end("E10.0001"), "end x0 y0 z-20 a0 c0");
}

// P K/E below K, P from there on.
TEST(NgcThreadLimits, TheLeadOfATaper) {
  const auto lead = [](const std::string& taper) {
    for (const TraceStep& step :
         trace_steps("G18 M3\nG76 P3 Z-20 I-1 J1 K2 L2 E" + taper + "\nM2")) {
      if (step.kind == 'T' && step.at[2] == -20) return step.value;
    }
    return Number(0);
  };
  EXPECT_EQ(lead("1.6"), num("3.75"));
  EXPECT_EQ(lead("2"), Number(3));
  EXPECT_EQ(lead("2.5"), Number(3));
}

TEST(NgcCycleModes, AProfileMayHaveASpindleThatTurns) {
  Profile profile = ngc();
  profile.initial.spindle = 3;
  EXPECT_EQ(trace("F100\nG99 G84 X0 Z-1 R0\nM2", profile), "F0,0,-1 M5 M4 F0,0,0 M5 M3");
  EXPECT_EQ(trace("G33 Z-1 K1\nM2", profile), "T0,0,-1@1");
}

TEST(NgcCycleModes, WhatEndsASeries) {
  const std::string start = "G0 Z10\nG99 G81 X1 Z-1 R2\n";
  const std::string hole = "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 ";
  // Neither of these does: the initial level is 10.
  for (const char* block : {"F50", "S5 T1", "(a comment)", "G4 P0", "G21", "G40 G49 G54 G61",
                            "G64 G94", "G90", "G98", "G17", "/N5"}) {
    EXPECT_EQ(at(start + block + "\nG98 X2"), hole + "R2,0,2 F2,0,-1 R2,0,10") << block;
  }
  for (const char* block : {"G80", "G1", "G0", "G1 X1.5", "G2 I1"}) {
    std::string trace_of = at(start + block + "\nG98 G81 X1 Z-1 R2");
    EXPECT_TRUE(trace_of.ends_with("F1,0,-1 R1,0,2")) << block << ": " << trace_of;
  }
  EXPECT_EQ(at(start + "M3 G33 Z0 K1\nG98 G81 X1 Z-1 R0"), hole + "M3 T1,0,0@1 F1,0,-1 R1,0,0");
}

TEST(NgcCycleModes, AnotherCycleForgetsTheWords) {
  EXPECT_EQ(at("G99 G81 X0 Z-1 R0\nG85 X1 Z-1"), "F0,0,-1 R0,0,0 !b3:missing-word");
  EXPECT_EQ(at("G99 G83 X0 Z-1 R0 Q1\nG73 X1 Z-1 R0"), "F0,0,-1 R0,0,0 !b3:missing-word");
  // The same code again does not.
  EXPECT_EQ(at("G99 G81 X0 Z-1 R0\nG81 X1"), "F0,0,-1 R0,0,0 R1,0,0 F1,0,-1 R1,0,0");
  EXPECT_EQ(at("G99 G81 X0 Z-1 R0\nG80\nG81 X1"), "F0,0,-1 R0,0,0 !b4:missing-word,missing-word");
}

TEST(NgcCycleModes, WordsActInTheirOrderWhateverTheLine) {
  EXPECT_EQ(trace("R0 Z-1 X0 G82 P2 F100 G99 G4 M3\nM2"), "M3 D2 F0,0,-1 D2 R0,0,0");
  EXPECT_EQ(trace("M30 X0 Z-1 R0 G81 F100 G99"), "F0,0,-1 R0,0,0 M30");
  EXPECT_EQ(trace("Y-1 R0 X0 G81 F100 G99 G18\nM2"), "F0,-1,0 R0,0,0");
}

TEST(NgcCycleModes, G4HasThePOfACycleThatHasNone) {
  EXPECT_EQ(at("G99 G81 X0 Z-1 R0 G4 P2"), "D2 F0,0,-1 R0,0,0");
  EXPECT_EQ(at("G99 G82 X0 Z-1 R0 P1\nX0 G4 P2\nX0"),
            "F0,0,-1 D1 R0,0,0 D2 F0,0,-1 D2 R0,0,0 F0,0,-1 D2 R0,0,0");
}

TEST(NgcCycleModes, ANumberInForceIsOneOfTheThirdAxisInForce) {
  // Z-1 and R0 become Y-1 and R0 of G18.
  EXPECT_EQ(at("G99 G81 X0 Z-1 R0\nG18 X1"), "F0,0,-1 R0,0,0 R1,0,0 F1,-1,0 R1,0,0");
}

TEST(NgcCycleModes, EveryRecordNamesItsClause) {
  const auto names = [](const std::string& blocks) {
    Lines all = clauses("F100\n" + blocks);
    std::erase(all, "NGC-COM-01");
    return all;
  };
  EXPECT_EQ(names("G91 G98 G81 X1 Z-1 R2 L2"),
            (Lines{"NGC-CYC-11", "NGC-CYC-12", "NGC-G81-01", "NGC-G81-01", "NGC-CYC-13",
                   "NGC-G81-01", "NGC-G81-01"}));
  EXPECT_EQ(names("G0 Z5\nG98 G83 X0 Z-1 R2 Q2 L2"),
            (Lines{"NGC-G0-01", "NGC-CYC-12", "NGC-G83-01", "NGC-G83-02", "NGC-G83-03",
                   "NGC-G83-01", "NGC-G83-06", "NGC-CYC-14", "NGC-G83-01", "NGC-G83-02",
                   "NGC-G83-03", "NGC-G83-01", "NGC-G83-06"}));
  EXPECT_EQ(names("M3 G99 G84 X0 Z-1 R0"), (Lines{"NGC-G84-02", "NGC-G84-02", "NGC-G84-02",
                                                  "NGC-G84-02", "NGC-G84-03", "NGC-G84-03"}));
}

// NGC-CYC-28: those of a cycle have a place; NGC-MOD-01: and so have those of words.
TEST(NgcCycleModes, MFunctionsHaveTheirPlacesAmongTheMotions) {
  std::vector<std::pair<int, bool>> functions;
  for (const Item& item : expand("M3 F100\nG99 G86 X0 Z-1 R0 P1\nM3 G33.1 Z-1 K1 M8\nM2", ngc())) {
    const Record* record = std::get_if<Record>(&item);
    if (record != nullptr && record->kind == RecordKind::m) {
      functions.emplace_back(record->m, record->among_motions);
    }
  }
  EXPECT_EQ(
      functions,
      (std::vector<std::pair<int, bool>>{
          {3, true}, {5, true}, {3, true}, {3, true}, {8, true}, {4, true}, {3, true}, {2, true}}));
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
