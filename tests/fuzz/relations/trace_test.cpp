// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference/reading_literal.hpp"
#include "related.hpp"

namespace gonogo::relations::testing {
namespace {

Trace trace_of_text(const std::string& text) {
  generate::GeneratedProgram program = program_of("rs274", text);
  program.profile.readings.set("ngc.program-end=free"_reading);
  return trace_of(oracle::run_reference(program.profile, program.text, 100));
}

Related same(std::size_t lines) {
  Related related;
  for (std::size_t i = 1; i <= lines; ++i) related.lines.push_back(i);
  return related;
}

std::optional<Difference> difference(const std::string& first, const std::string& other,
                                     const Related& related, const Number& tolerance = 0) {
  return first_difference(trace_of_text(first), trace_of_text(other), related, tolerance);
}

TEST(Traces, OfOneProgramDoNotDiffer) {
  EXPECT_FALSE(difference("G0 X1\nG1 X2 F9", "G0 X1\nG1 X2 F9", same(2)));
}

TEST(Traces, DifferInTheFirstRecordThatIsNotAsked) {
  const auto found = difference("G0 X1\nX2", "G0 X1\nX3", same(2));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->record, 2U);
  EXPECT_EQ(found->block, 2U);
  EXPECT_EQ(found->want, R"({"k":"rapid","b":2,"to":{"x":"2"},"clause":"NGC-G0-01"})");
}

TEST(Traces, DifferWhereARecordIsMissingOrTooMany) {
  EXPECT_TRUE(difference("G0 X1\nX2", "G0 X1\n", same(2)));
  EXPECT_TRUE(difference("G0 X1\n", "G0 X1\nX2", same(2)));
}

TEST(Traces, AgreeWithinTheTolerance) {
  const Number tolerance = Number::millionths(1000);
  EXPECT_FALSE(difference("G0 X1", "G0 X1.001", same(1), tolerance));
  EXPECT_TRUE(difference("G0 X1", "G0 X1.0011", same(1), tolerance));
}

TEST(Traces, AreHeldAgainstEachOtherWhereTheyAreMovedTo) {
  Related related = same(1);
  related.shift = {Number(5), Number(0), Number(7)};
  const std::string arc = "G2 X10 I5 F9";
  generate::GeneratedProgram there = program_of("rs274", "G2 X15 I5 F9");
  there.profile.readings.set("ngc.program-end=free"_reading);
  there.profile.initial.at[reference::Axis::x] = 5;
  there.profile.initial.at[reference::Axis::z] = 7;
  const Trace other = trace_of(oracle::run_reference(there.profile, there.text, 100));
  EXPECT_FALSE(first_difference(trace_of_text(arc), other, related, 0));
  related.shift[2] = 6;
  EXPECT_TRUE(first_difference(trace_of_text(arc), other, related, 0));  // the end is elsewhere
}

TEST(Traces, FollowTheLinesOfTheOtherProgram) {
  Related related;
  related.lines = {1, 3};
  EXPECT_FALSE(difference("G0 X1\nX2", "G0 X1\n\nX2", related));
  EXPECT_TRUE(difference("G0 X1\nX2", "G0 X1\nX2", related));
}

TEST(Traces, DifferInTheirAlarms) {
  EXPECT_FALSE(difference("G1 X1", "G1 X1", same(1)));
  EXPECT_TRUE(difference("G1 X1", "G0 X1", same(1)));
  EXPECT_TRUE(difference("G0 X1\nG1 X2", "G0 X1\nG2 F9 X3", same(2)));
}

TEST(Traces, OfABeginningHaveTheMotionsOfItsLinesAlone) {
  Related related;
  related.lines = {1, 0};
  related.is_beginning = true;
  EXPECT_FALSE(difference("G0 X1\nX2", "G0 X1", related));
  EXPECT_FALSE(difference("G0 X1\nX2 X3", "G0 X1", related));  // the alarm comes later
  EXPECT_TRUE(difference("G0 X1\nX2", "G0 X2", related));
}

}  // namespace
}  // namespace gonogo::relations::testing
