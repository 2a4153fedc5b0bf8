// SPDX-License-Identifier: GPL-3.0-or-later
//
// What alarms in a cycle or a thread, and of which class; what LinuxCNC 2.9 and NIST's interpreter
// make of it as measured.
#include <gtest/gtest.h>

#include "ngc_trace.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

constexpr const char* kSame = "same";
constexpr const char* kUnknown = "";  // a defect, or a code that the machine lacks

struct Row {
  std::string blocks;  // F100 is in force before them
  const char* want;
  const char* linuxcnc = kSame;
  const char* nist = kSame;
};

void expect_rows(const std::vector<Row>& rows, const std::string& head = "F100\n") {
  for (const Row& row : rows) {
    const std::string program = head + row.blocks + "\nM2";
    EXPECT_EQ(trace(program), row.want) << row.blocks;
    const auto known = [&](std::string_view machine) {
      return machine == kSame ? std::string_view(row.want) : machine;
    };
    if (row.linuxcnc != kUnknown) {
      EXPECT_EQ(trace(program, column("linuxcnc")), known(row.linuxcnc)) << row.blocks;
    }
    if (row.nist != kUnknown) {
      EXPECT_EQ(trace(program, column("nist")), known(row.nist)) << row.blocks;
    }
  }
}

TEST(NgcCycleAlarms, OfWordsThatAreMissing) {
  expect_rows({
      {"G81 X4 Y5 Z1.5", "!b2:missing-word"},
      {"G81 X4 Y5 R2", "!b2:missing-word"},
      {"G81 R2", "!b2:missing-word,missing-word"},
      {"G81 X1 Z-1 R2\nG81", "R0,0,2 R1,0,2 F1,0,-1 R1,0,2 !b3:missing-word"},
      {"G81 X1 Z-1 R2\nG82 X2",
       "R0,0,2 R1,0,2 F1,0,-1 R1,0,2 !b3:missing-word,missing-word,missing-word"},
      {"G82 X1 Z-1 R2 P1\nG81 X2 Z-1 R2\nG82 X3 Z-1 R2",
       "R0,0,2 R1,0,2 F1,0,-1 D1 R1,0,2 R2,0,2 F2,0,-1 R2,0,2 !b4:missing-word"},
      // Found late: after the lift to R.
      {"G82 X1 Z1 R2", "!b2:missing-word", "R0,0,2 !b2:missing-word", "R0,0,2 !b2:missing-word"},
      {"G83 X1 Z1 R2", "!b2:missing-word", "R0,0,2 !b2:missing-word", "R0,0,2 !b2:missing-word"},
      {"G73 X1 Z1 R2", "!b2:missing-word", "R0,0,2 !b2:missing-word", kUnknown},
      {"G86 X1 Z1 R2 M3", "!b2:missing-word", "R0,0,2 !b2:missing-word", "R0,0,2 !b2:missing-word"},
      {"G89 X1 Z1 R2", "!b2:missing-word", "R0,0,2 !b2:missing-word", "R0,0,2 !b2:missing-word"},
  });
}

TEST(NgcCycleAlarms, OfAFeedThatIsMissing) {
  expect_rows({{"G81 X4 Y5 Z1 R2", "!b2:feed-missing", kSame, "R0,0,2 R4,5,2 F4,5,1 R4,5,2"}},
              "G17\n");
}

TEST(NgcCycleAlarms, OfLevels) {
  expect_rows({
      {"G81 X1 Z3 R2", "!b2:reference-plane"},
      {"G91 G81 X1 Z1 R-2", "!b2:reference-plane"},
      // r -5 lies below z -3 as coordinates.
      {"G91 G81 X1 Z-3 R-5\nG90 X5", "R1,0,0 R1,0,-5 F1,0,-8 R1,0,-5 !b3:reference-plane"},
  });
}

TEST(NgcCycleAlarms, OfValues) {
  expect_rows({
      {"G81 X1 Z-1 R2 L0", "!b2:value-out-of-range"},
      {"G81 X1 Z-1 R2 L-1", "!b2:value-sign"},
      {"G81 X1 Z-1 R2 L1.5", "!b2:not-an-integer"},
      {"G81 X1 Z-1 R2 L-1.5", "!b2:not-an-integer,value-sign"},
      {"G82 X1 Z1 R2 P-0.5", "!b2:value-sign", kUnknown},
      {"G82 X1 Z1 R2 P-1", "!b2:value-sign", kUnknown},
      {"G83 X1 Z1 R2 Q-1", "!b2:value-sign", kUnknown, kUnknown},
      {"G83 X1 Z1 R2 Q0", "!b2:value-sign", "R0,0,2 R1,0,2 !b2:value-sign", kUnknown},
      {"G83 X1 Z1 R2 Q-0.5", "!b2:value-sign", "R0,0,2 R1,0,2 !b2:value-sign", kUnknown},
      {"G83 X1 Z1 R2 Q1\nX2 Q0", "R0,0,2 R1,0,2 F1,0,1 R1,0,2 !b3:value-sign",
       "R0,0,2 R1,0,2 F1,0,1 R1,0,2 R2,0,2 !b3:value-sign", kUnknown},
  });
}

TEST(NgcCycleAlarms, OfAxesAndWordsThatACycleLacks) {
  expect_rows({
      {"G81 X1 Z-1 R2 A5", "!b2:axis-not-in-plane"},
      {"G81 X1 Z-1 R2 C5", "!b2:axis-not-in-plane"},
      {"G81 X1 Z-1 R2\nA5", "R0,0,2 R1,0,2 F1,0,-1 R1,0,2 !b3:axis-not-in-plane", kSame, kUnknown},
      {"G93 G81 X1 Z-1 R2 F1", "!b2:conflicting-words,feed-missing", kSame,
       "!b2:conflicting-words"},
      {"G93 G81 X1 Z-1 R2 L0.5 F1", "!b2:conflicting-words,not-an-integer,feed-missing", kSame,
       "!b2:conflicting-words,not-an-integer"},
      {"G41 G81 X1 Z-1 R2", "?b2:G41"},
      {"G53 G81 X1 Z-1 R2", "!b2:conflicting-words"},
      {"G81 X1 Z-1 R2 B1", "?b2:B"},
      {"G17.1 G81 X1 Z-1 R2", "?b2:G17.1"},
      {"G87 X1 Y1 Z-5 R2 I3 J4 K-2", "?b2:G87"},
      {"G88 X1 Z-5 R2 P1", "?b2:G88"},
      {"G81 X1 Z-1 R2 P1", "!b2:unused-word"},
      {"G81 X1 Z-1 R2 Q1", "!b2:unused-word"},
      {"G81 X1 Z-1 R2 D1", "!b2:unused-word"},
      {"G81 X1 Z-1 R2 I1", "!b2:unused-word"},
      {"G81 X1 Z-1 R2 H1", "!b2:unused-word"},
      {"G81 X1 Z-1 R2 E1", "!b2:unused-word"},
      {"G83 X1 Z-1 R2 Q1 D1", "!b2:unused-word"},
      {"G73 X1 Z-1 R2 Q1 P1", "!b2:unused-word", kSame, kUnknown},
      {"G85 X1 Z-1 R2 P1", "!b2:unused-word"},
      {"G82 X1 Z-1 R2 P1 Q1", "!b2:unused-word"},
      // Without an axis word nothing takes them.
      {"G81 X1 Z-1 R2\nR3 L2", "R0,0,2 R1,0,2 F1,0,-1 R1,0,2 !b3:unused-word,unused-word"},
  });
}

TEST(NgcCycleAlarms, OfTheSpindle) {
  expect_rows({
      {"G86 X1 Z-1 R2 P1", "!b2:spindle-stopped", "R0,0,2 R1,0,2 !b2:spindle-stopped",
       "R0,0,2 R1,0,2 !b2:spindle-stopped"},
      {"M3\nG86 X1 Z-1 R2 P1 M5", "M3 !b3:spindle-stopped", "M3 R0,0,2 R1,0,2 !b3:spindle-stopped",
       "M3 R0,0,2 R1,0,2 !b3:spindle-stopped"},
      {"M4\nG84 X1 Z-1 R2", "M4 !b3:direction-conflict", "M4 R0,0,2 R1,0,2 !b3:direction-conflict",
       "M4 R0,0,2 R1,0,2 !b3:direction-conflict"},
      {"M3\nG74 X1 Z-1 R2", "M3 !b3:direction-conflict", "M3 R0,0,2 R1,0,2 !b3:direction-conflict",
       kUnknown},
      {"G84 X1 Z-1 R2", "!b2:spindle-stopped", "R0,0,2 R1,0,2 !b2:spindle-stopped",
       "R0,0,2 R1,0,2 !b2:spindle-stopped"},
      {"G74 X1 Z-1 R2", "!b2:spindle-stopped", "R0,0,2 R1,0,2 !b2:spindle-stopped", kUnknown},
      {"M4\nG84 X1 Z-1 R2 M3", "M4 M3 R0,0,2 R1,0,2 F1,0,-1 M5 M4 F1,0,2 M5 M3"},
  });
}

TEST(NgcCycleAlarms, OfTwoCodes) {
  expect_rows({
      {"G81 X1 Z-1 R2 G98 G99", "!b2:duplicate-word"},
      {"G81 X1 Z-1 R2 G0", "!b2:duplicate-word"},
      {"G81 G82 X1 Z-1 R2 P1", "!b2:duplicate-word"},
      {"G81 X1 Z-1 R2 G80", "!b2:duplicate-word", "R0,0,2 R1,0,2 F1,0,-1 R1,0,2"},
      {"G81 X1 Z-1 R2\nG80 X2", "R0,0,2 R1,0,2 F1,0,-1 R1,0,2 !b3:missing-word"},
      {"G81 X1 Z-1 R2\nG80\nX2", "R0,0,2 R1,0,2 F1,0,-1 R1,0,2 !b4:missing-word"},
  });
}

// A block with several: each of them is admissible.
TEST(NgcCycleAlarms, AllThatABlockBreaksAreNamed) {
  expect_rows({{"G83 X1 Z3 R2 Q-1 L0 A1 I1 P1",
                "!b2:reference-plane,value-sign,value-out-of-range,axis-not-in-plane,unused-word,"
                "unused-word"}});
}

constexpr const char* kSpindle = "S100 M3\nG0 X20 Z2\n";

TEST(NgcThreadAlarms, OfG33) {
  const auto after = [](const std::string& end) { return "M3 R20,0,2 " + end; };
  const auto at = [&](const std::string& block) {
    return trace(std::string(kSpindle) + block + "\nM2");
  };
  EXPECT_EQ(at("G33 K2"), after("!b3:missing-word"));
  EXPECT_EQ(at("G33.1 K2"), after("!b3:missing-word"));
  EXPECT_EQ(at("G33 Z-20"), after("!b3:lead-missing"));
  EXPECT_EQ(at("G33.1 Z-20"), after("!b3:lead-missing"));
  EXPECT_EQ(at("G33 Z-20 K2 F100"), after("!b3:conflicting-words"));
  EXPECT_EQ(at("G33 Z-20 K2 M5"), after("!b3:spindle-stopped"));
  EXPECT_EQ(at("G33 Z-20 K0"), after("!b3:value-sign"));
  EXPECT_EQ(at("G33.1 Z-20 K-2"), after("!b3:value-sign"));
  EXPECT_EQ(at("G33 Z-20 K2 A5"), after("?b3:G33"));
  EXPECT_EQ(at("G33.1 Z-20 K2 C5"), after("?b3:G33.1"));
  for (const char* word : {"R1", "I1", "J1", "L1", "P1", "Q1", "D1", "H1"}) {
    EXPECT_EQ(at(std::string("G33 Z-20 K2 ") + word), after("!b3:unused-word")) << word;
  }
  for (const char* word : {"R1", "J1", "L1", "P1", "Q1", "D1", "H1"}) {
    EXPECT_EQ(at(std::string("G33.1 Z-20 K2 ") + word), after("!b3:unused-word")) << word;
  }
  EXPECT_EQ(at("G33.1 Z-20 K2 I0.5"), after("T20,0,-20@2 M4 T20,0,2@2 M3"));
}

TEST(NgcThreadAlarms, OfG76) {
  // The words without those that the case is about.
  const auto at = [](const std::string& words) {
    return ending_of(std::string("G18 ") + kSpindle + "G76 " + words + "\nM2");
  };
  EXPECT_EQ(at("P2 Z-20 I-1 J0.5"), "alarm b3 missing-word");
  EXPECT_EQ(at("P2 Z-20 I-1 K1"), "alarm b3 missing-word");
  EXPECT_EQ(at("P2 Z-20 J0.5 K1"), "alarm b3 missing-word");
  EXPECT_EQ(at("P2 I-1 J0.5 K1"), "alarm b3 missing-word");
  EXPECT_EQ(at("Z-20 I-1 J0.5 K1"), "alarm b3 lead-missing");
  const std::string good = "P2 Z-20 I-1 J0.5 K1";
  EXPECT_EQ(at(good), "end x20 y0 z-20 a0 c0");
  EXPECT_EQ(at(good + " G17"), "alarm b3 plane-not-allowed");
  EXPECT_EQ(ending_of("G17 S1 M3\nG76 " + good), "alarm b2 plane-not-allowed");
  EXPECT_EQ(at(good + " X18"), "alarm b3 axis-not-in-plane");
  EXPECT_EQ(at(good + " Y3"), "alarm b3 axis-not-in-plane");
  EXPECT_EQ(at(good + " A5"), "alarm b3 axis-not-in-plane");
  EXPECT_EQ(at(good + " R0.5"), "alarm b3 value-out-of-range");
  EXPECT_EQ(at("P-2 Z-20 I-1 J0.5 K1"), "alarm b3 value-sign");
  EXPECT_EQ(at("P0 Z-20 I-1 J0.5 K1"), "alarm b3 value-sign");
  EXPECT_EQ(at(good + " H-1"), "alarm b3 value-sign");
  EXPECT_EQ(at(good + " H0.5"), "alarm b3 not-an-integer");
  EXPECT_EQ(at(good + " E15 L1"), "alarm b3 value-out-of-range");
  EXPECT_EQ(at(good + " E-2 L1"), "alarm b3 value-sign");
  EXPECT_EQ(at(good + " L4"), "alarm b3 value-out-of-range");
  EXPECT_EQ(at(good + " L0.5"), "alarm b3 not-an-integer");
  EXPECT_EQ(at("P2 Z-20 I0 J0.5 K1"), "alarm b3 value-out-of-range");
  EXPECT_EQ(at("P2 Z-20 I-1 J-0.5 K1"), "alarm b3 value-sign");
  EXPECT_EQ(at("P2 Z-20 I-1 J0.5 K0.5"), "alarm b3 value-out-of-range");
  EXPECT_EQ(at("P2 Z-20 I-1 J0.5 K-1"), "alarm b3 value-sign value-out-of-range");
  EXPECT_EQ(at(good + " D1"), "alarm b3 unused-word");
  EXPECT_EQ(at(good + " M5"), "alarm b3 spindle-stopped");
  EXPECT_EQ(at(good + "\nZ-30"), "alarm b4 lead-missing missing-word missing-word missing-word");
}

// LinuxCNC runs what it does not look at.
TEST(NgcThreadAlarms, OfG76ThatLinuxcncForgives) {
  const Profile profile = ngc({{"ngc.g76.checks", "linuxcnc"}});
  const auto at = [&](const std::string& words, const char* plane = "G18 ") {
    return trace(plane + std::string(kSpindle) + "G76 " + words + "\nM2", profile);
  };
  const std::string good = "P2 Z-20 I-1 J0.5 K1";
  const std::string path =
      "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-20@2 R20.5,0,-20 R20,0,2 R18,0,2 T18,0,-20@2 "
      "R20,0,-20";
  EXPECT_EQ(at(good), path);
  EXPECT_EQ(at(good, "G17 "), path);
  EXPECT_EQ(at(good + " R0.5"), path);
  EXPECT_EQ(at(good + " Q-1"), path);
  EXPECT_EQ(at(good + " E-2 L3"), path);
  EXPECT_EQ(at(good + " L4"), path);
  EXPECT_EQ(at(good + " X18 Y3"), path + " R18,3,-20");
  EXPECT_EQ(at("P-2 Z-20 I-1 J0.5 K1"),
            "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-20@-2 R20.5,0,-20 R20,0,2 R18,0,2 "
            "T18,0,-20@-2 R20,0,-20");
  // No full pass.
  EXPECT_EQ(at(good + " H-1"),
            "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-20@2 R20.5,0,-20 R20,0,-20");
  EXPECT_EQ(at(good + " H-2"), "M3 R20,0,2 !b3:value-sign");
  // The end is where it begins: nothing is cut.
  EXPECT_EQ(at("X20 P2 I-1 J0.5 K1"),
            "M3 R20,0,2 R20.5,0,2 R18.5,0,2 R20.5,0,2 R20,0,2 R18,0,2 R20,0,2");
  EXPECT_EQ(at("P2 I-1 J0.5 K1"), "M3 R20,0,2 !b3:missing-word");
  EXPECT_EQ(at("P2 Z-20 I0 J0.5 K1"), "M3 R20,0,2 !b3:value-out-of-range");
  EXPECT_EQ(at("P2 Z-20 I-1 J-0.5 K1"), "M3 R20,0,2 !b3:value-sign");
  EXPECT_EQ(at("P2 Z-20 I-1 J1 K1"), "M3 R20,0,2 !b3:value-out-of-range");
  EXPECT_EQ(at(good + " A5"), "M3 R20,0,2 !b3:axis-not-in-plane");
  EXPECT_EQ(at(good + " M5"), "M3 R20,0,2 !b3:spindle-stopped");
}

TEST(NgcThreadAlarms, WhatG76IsNotReadFor) {
  const auto at = [](const std::string& words) {
    return ending_of(std::string("G18 ") + kSpindle + "G76 P2 Z-20 I-1 " + words);
  };
  EXPECT_EQ(at("J0.5 K1 Q90"), "not-covered b3 G76");
  EXPECT_EQ(at("J0.5 K1 Q-270"), "not-covered b3 G76");
  EXPECT_EQ(at("J0.5 K1 R1.00001"), "not-covered b3 G76");
  EXPECT_EQ(at("J0.5 K1 R10001"), "not-covered b3 G76");
  EXPECT_EQ(at("J0.5 K1 R1.0001"), "not-covered b3 G76");
  // (K/J)^R is about 2.718, 4 and 8.
  EXPECT_EQ(at("R10000 J1 K1.0001"), "end x20 y0 z-20 a0 c0");
  EXPECT_EQ(at("R1.9998 J0.5 K1"), "end x20 y0 z-20 a0 c0");
  EXPECT_EQ(at("R3 J0.5 K1"), "end x20 y0 z-20 a0 c0");
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
