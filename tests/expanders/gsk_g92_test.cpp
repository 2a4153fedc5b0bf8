// SPDX-License-Identifier: GPL-3.0-or-later
// G92. X words are diameters: X65 is x=32.5.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(GskG92, GoesThePathOfG90WithASynchronousCut) {
  // A (65, 5), B (58.7, 5), C (58.7, -28), D (65, -28).
  const Outcome outcome = run("G0 X65 Z5\nG92 X58.7 Z-28 F3\nX57.7\n");
  EXPECT_EQ(outcome.motions(),
            "rapid x=32.5 z=5\n"
            "rapid x=29.35\nthread x=29.35 z=-28 lead=3 start=0\nrapid x=32.5\nrapid z=5\n"
            "rapid x=28.85\nthread x=28.85 z=-28 lead=3 start=0\nrapid x=32.5\nrapid z=5\n");
  EXPECT_EQ(outcome.records.back(), "end x=32.5 y=0 z=5 a=0 c=0");
}

TEST(GskG92, Taper) {
  // C (20, -10), R-2: B_x = 18.
  EXPECT_EQ(run("G0 X50\nG92 X40 Z-10 R-2 F1.5\n").motions(),
            "rapid x=25\nrapid x=18\nthread x=20 z=-10 lead=1.5 start=0\nrapid x=25\nrapid z=0\n");
}

TEST(GskG92, TaperLimit) {
  EXPECT_EQ(run("G92 U-20 Z-10 R10 F1\n").answer, GONOGO_OK);
  EXPECT_EQ(run("G92 U-20 Z-10 R10.001 F1\n").alarm, "taper-limit");
}

TEST(GskG92, LeadIsConvertedFromInchesInEitherFeedMode) {
  for (const char* mode : {"G98", "G99"}) {
    const Outcome outcome = run(std::string("G20 ") + mode + " G92 U-0.2 W-1 F0.05\n");
    EXPECT_EQ(outcome.records[1], "thread x=-2.54 z=-25.4 lead=1.27 start=0") << mode;
  }
}

TEST(GskG92, NeedsALead) {
  const Outcome outcome = run("G0 X9\nG92 X8 Z-9\n");
  EXPECT_EQ(outcome.alarm, "lead-missing");
  EXPECT_EQ(outcome.records.size(), 1u);
}

TEST(GskG92, RunOutWordsAreUnsupported) {
  for (const char* word : {"J3", "K1", "P1", "I8", "L2"}) {
    const Outcome outcome = run(std::string("G0 X9\nG92 X8 Z-9 F1 ") + word + "\n");
    EXPECT_EQ(outcome.answer, GONOGO_UNSUPPORTED) << word;
    EXPECT_NE(outcome.note, "");
    EXPECT_EQ(outcome.records.size(), 1u);
  }
}

TEST(GskG92, WordOffThePlaneAlarms) {
  EXPECT_EQ(run("G92 X8 Z-9 V1 F1\n").alarm, "axis-not-in-plane");
}

}  // namespace
}  // namespace gonogo::expanders::testing
