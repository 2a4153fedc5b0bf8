// SPDX-License-Identifier: GPL-3.0-or-later
//
// Under which other reading a NO-GO would be GO.
#include <gtest/gtest.h>

#include "own_outcome.hpp"

namespace gonogo::oracle {
namespace {

// What explains the outcome that the reference shows under `follows`, judged under `says`.
std::string explained(std::string_view program, std::string_view dialect, ReadingValues says,
                      ReadingValues follows) {
  const reference::Profile profile = profile_of(dialect, says);
  const OwnOutcome own = own_outcome(program, profile_of(dialect, follows));
  const Tolerances tolerances = exact_terms(profile);
  const Verdict verdict = judge_outcome(profile, program, tolerances, own.records, own.end).verdict;
  EXPECT_EQ(decision(verdict.kind), Decision::no_go) << verdict.message;
  return explaining_reading(profile, program, tolerances, own.records, own.end);
}

TEST(ExplainingReading, IsTheOneThatTheSubjectFollows) {
  EXPECT_EQ(explained("G70 G1 X1 F5\n", "sinumerik840d", {}, {{"sie.g70.f", "inch"}}),
            "sie.g70.f=inch");
  EXPECT_EQ(explained("F9\nG2 X10.008 I5\n", "sinumerik840d", {{"sie.arc.correct", "project"}},
                      {{"sie.arc.correct", "programmed"}}),
            "sie.arc.correct=programmed");
}

// With the radius of the start this arc alarms and ends the program; projected it does not, and
// then comes a block under G70.
TEST(ExplainingReading, MayBeOneThatOnlyAnotherAssignmentTouches) {
  EXPECT_EQ(
      explained("F9\nG2 X9.995 I5\nG70 G1 X1 F5\n", "sinumerik840d", {{"sie.arc.correct", "any"}},
                {{"sie.arc.correct", "project"}, {"sie.g70.f", "inch"}}),
      "sie.g70.f=inch");
}

// A pocket of 60 by 40, 7.5 deep by 4: levels of 3.75, or of 4 and 3.5.
constexpr std::string_view kRectangularPocket =
    "T4 M3 S500 F100\nR101=5 R102=2 R103=0 R104=-7.5 R116=60 R117=40 R118=60 R119=40 R120=8\n"
    "R121=4 R122=100 R123=200 R124=0 R125=0 R126=2 R127=1\nLCYC75\n";

reference::Profile with_tool(reference::Profile profile) {
  profile.tools["4"].radius = 5;
  return profile;
}

TEST(ExplainingReading, MayBeOneThatIsJudgedByProperties) {
  const reference::Profile says = with_tool(profile_of("sinumerik802s", {{"sie.infeed", "equal"}}));
  const reference::Profile follows =
      with_tool(profile_of("sinumerik802s", {{"sie.infeed", "max-rest"}}));
  const OwnOutcome own = own_outcome(kRectangularPocket, follows);
  const Tolerances tolerances = exact_terms(says);
  EXPECT_EQ(
      decision(
          judge_outcome(says, kRectangularPocket, tolerances, own.records, own.end).verdict.kind),
      Decision::no_go);
  EXPECT_EQ(explaining_reading(says, kRectangularPocket, tolerances, own.records, own.end),
            "sie.infeed=max-rest");
}

TEST(ExplainingReading, IsNoneWhereNoReadingExplainsIt) {
  const reference::Profile profile = profile_of("sinumerik840d");
  OwnOutcome own = own_outcome("G1 X2 F5\n", profile);
  EXPECT_EQ(explaining_reading(profile, "G1 X1 F5\n", exact_terms(profile), own.records, own.end),
            "");
}

// One judging costs 1,000 and its records.
TEST(ExplainingReading, GivesUpWhereItWouldCostTooMuch) {
  const reference::Profile profile = profile_of("sinumerik840d");
  const std::string_view program = "G70 G1 X1 F5\n";
  const OwnOutcome own = own_outcome(program, profile_of("sinumerik840d", {{"sie.g70.f", "inch"}}));
  const Tolerances tolerances = exact_terms(profile);
  EXPECT_EQ(explaining_reading(profile, program, tolerances, own.records, own.end, 1'000), "");
  EXPECT_EQ(explaining_reading(profile, program, tolerances, own.records, own.end, 100'000),
            "sie.g70.f=inch");
}

}  // namespace
}  // namespace gonogo::oracle
