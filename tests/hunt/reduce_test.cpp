// SPDX-License-Identifier: GPL-3.0-or-later
#include "hunt/reduce.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hunting.hpp"
#include "program/text.hpp"

namespace gonogo::hunt::testing {
namespace {

constexpr const char* kLong =
    "N1 G00 X100. Z5.000 (start)\r\nM3\nG94 X50.125 Z-10.5 R-2.5 F100\nX40\nG01 X3 Z7\n\nM30\n";

bool holds(const Exhibit& exhibit, const char* text) {
  return exhibit.program.text.find(text) != std::string::npos;
}

Reduced reduced(const Exhibit& exhibit, const StillShows& shows, std::size_t runs = 2'000) {
  ReduceLimits limits;
  limits.runs = runs;
  return reduce(exhibit, shows, limits);
}

TEST(Reduce, OnlyWhatIsNeededStays) {
  const Reduced result =
      reduced({{}, gsk(kLong)}, [](const Exhibit& exhibit) { return holds(exhibit, "G94"); });
  EXPECT_EQ(result.exhibit.program.text, "G94\n");
  EXPECT_TRUE(result.finished);
}

TEST(Reduce, PartsOfSeveralBlocksStay) {
  const Reduced result = reduced({{}, gsk(kLong)}, [](const Exhibit& exhibit) {
    return holds(exhibit, "M3\n") && holds(exhibit, "F100");
  });
  EXPECT_EQ(result.exhibit.program.text, "M3\nF100\n");
}

TEST(Reduce, NumbersBecomeShort) {
  const Reduced result = reduced({{}, gsk("X50.125\n")}, [](const Exhibit& exhibit) {
    const std::vector<program::TextLine> lines = program::lines_of(exhibit.program.text);
    if (lines.empty() || lines[0].words.empty()) return false;
    const auto value = value_of(lines[0].words[0]);
    if (!value) return false;
    const auto [found, fifty] = same_scale(*value, {50, 0});
    return found >= fifty;
  });
  EXPECT_EQ(result.exhibit.program.text, "X50\n");
}

TEST(Reduce, SettingsGoBackToTheirDefaults) {
  generate::GeneratedProgram program = gsk("G00\n");
  program.profile.units = reference::Units::inch;
  program.profile.block_skip = true;
  program.profile.readings.set(reference::ReadingKey::zero_depth, "alarm");
  program.profile.parameters["5920"] = reference::Number(45);
  const Reduced result = reduced({{}, program}, [](const Exhibit& exhibit) {
    return exhibit.program.profile.units == reference::Units::inch;
  });
  EXPECT_EQ(reference::profile_json(result.exhibit.program.profile), R"({"units":"inch"})");
}

TEST(Reduce, ProgramsBeforeItGo) {
  const Exhibit exhibit{{gsk("G0\n"), gsk("F100 (x)\n"), gsk("G1\n")}, gsk("G1 X1\n")};
  const Reduced result = reduced(exhibit, [](const Exhibit& candidate) {
    for (const generate::GeneratedProgram& program : candidate.before) {
      if (program.text.find("F100") != std::string::npos) return holds(candidate, "X1");
    }
    return false;
  });
  ASSERT_EQ(result.exhibit.before.size(), 1U);
  EXPECT_EQ(result.exhibit.before[0].text, "F100\n");
  EXPECT_EQ(result.exhibit.program.text, "X1\n");
}

TEST(Reduce, WhatCannotBecomeSmallerStays) {
  const Exhibit exhibit{{}, gsk(kLong)};
  const Reduced result = reduced(exhibit, [](const Exhibit&) { return false; });
  EXPECT_EQ(result.exhibit.program.text, kLong);
  EXPECT_TRUE(result.finished);
}

TEST(Reduce, TheTimeEndsIt) {
  ReduceLimits limits;
  limits.time = std::chrono::milliseconds(0);
  const Reduced result = reduce(
      {{}, gsk(kLong)}, [](const Exhibit&) { return true; }, limits);
  EXPECT_EQ(result.runs, 0U);
  EXPECT_FALSE(result.finished);
}

// Whatever is asked: the answer still holds, in no more runs than allowed, and no larger.
RC_GTEST_PROP(Reduce, KeepsWhatIsShownWithinItsRuns, (std::uint64_t seed)) {
  generate::Choices choices(seed);
  const generate::GeneratedProgram program =
      generate::find_generator("gsk")->generate(choices, nullptr);
  const auto runs = *rc::gen::inRange<std::size_t>(0, 200);
  const char needed = *rc::gen::elementOf(program.text);
  std::size_t calls = 0;
  auto shows = [&](const Exhibit& exhibit) {
    ++calls;
    return exhibit.program.text.find(needed) != std::string::npos;
  };
  const Reduced result = reduced({{}, program}, shows, runs);
  RC_ASSERT(calls <= runs);
  RC_ASSERT(result.runs == calls);
  RC_ASSERT(result.exhibit.program.text.find(needed) != std::string::npos);
  RC_ASSERT(program::count_blocks(result.exhibit.program.text) <=
            program::count_blocks(program.text));
}

}  // namespace
}  // namespace gonogo::hunt::testing
