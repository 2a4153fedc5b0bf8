// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/program_vector.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace gonogo::hunt {
namespace {

// Radii of 0.0022 at the start and 0.0054 at the end: as programmed the arc is made, under the
// other two readings of sie.arc.correct it is an alarm, and the pocket behind it never asks where
// its infeeds are measured from (sie.infeed-from).
constexpr const char* kArcBeforePocket =
    "G90 F265 S1200 M3\nG2 X0.006 Y0 I0.001 J0.002\n"
    "R101=5 R102=1 R103=0 R104=-4 R116=0 R117=0 R118=40 R119=30 R120=5 R121=2 R122=100 R123=200 "
    "R124=0.1 R125=0.1 R126=2 R127=1\nT3 D1\nLCYC75\nM2\n";

TEST(ProgramVector, NamesOnlyReadingsThatAnAssignmentComesTo) {
  generate::GeneratedProgram program;
  program.profile = std::get<reference::Profile>(reference::default_profile("sinumerik802s"));
  program.profile.tools["3"].radius = exact::Number(5);
  ASSERT_EQ(reference::set_reading(program.profile, "sie.infeed", "equal"), std::nullopt);
  program.text = kArcBeforePocket;
  const oracle::Case test = vector_of(program, "drawn");
  std::size_t alarms = 0;
  for (const oracle::Expectation& expectation : test.expect) {
    for (const auto& [reading, value] : expectation.when) EXPECT_NE(value, "any") << reading;
    if (expectation.alarms.empty()) continue;
    ++alarms;
    EXPECT_EQ(expectation.when.size(), 1U);
    EXPECT_EQ(expectation.when.front().first, "sie.arc.correct");
  }
  EXPECT_EQ(alarms, 2U);
  EXPECT_TRUE(std::ranges::any_of(
      test.expect, [](const oracle::Expectation& one) { return one.when.size() > 1; }));
}

}  // namespace
}  // namespace gonogo::hunt
