// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/reduce.hpp"
#include "reference/reading_literal.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "fuzz/program/text.hpp"
#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

constexpr const char* kLong =
    "N1 G00 X100. Z5.000 (start)\r\nM3\nG94 X50.125 Z-10.5 R-2.5 F100\nX40\nG01 X3 Z7\n\nM30\n";

bool holds(const Reproducer& reproducer, const char* text) {
  return reproducer.program.text.find(text) != std::string::npos;
}

Reduced reduced(const Reproducer& reproducer, const StillShows& shows, std::size_t runs = 2'000) {
  ReduceLimits limits;
  limits.runs = runs;
  return reduce(reproducer, shows, limits);
}

TEST(Reduce, OnlyWhatIsNeededStays) {
  const Reduced result = reduced(
      {{}, gsk(kLong)}, [](const Reproducer& reproducer) { return holds(reproducer, "G94"); });
  EXPECT_EQ(result.reproducer.program.text, "G94\n");
  EXPECT_TRUE(result.finished);
}

TEST(Reduce, PartsOfSeveralBlocksStay) {
  const Reduced result = reduced({{}, gsk(kLong)}, [](const Reproducer& reproducer) {
    return holds(reproducer, "M3\n") && holds(reproducer, "F100");
  });
  EXPECT_EQ(result.reproducer.program.text, "M3\nF100\n");
}

TEST(Reduce, NumbersBecomeShort) {
  const Reduced result = reduced({{}, gsk("X50.125\n")}, [](const Reproducer& reproducer) {
    const std::vector<program::TextLine> lines = program::lines_of(reproducer.program.text);
    if (lines.empty() || lines[0].words.empty()) return false;
    const auto value = value_of(lines[0].words[0]);
    if (!value) return false;
    const auto [found, fifty] = same_scale(*value, {50, 0});
    return found >= fifty;
  });
  EXPECT_EQ(result.reproducer.program.text, "X50\n");
}

TEST(Reduce, SettingsGoBackToTheirDefaults) {
  generate::GeneratedProgram program = gsk("G00\n");
  program.profile.units = reference::Units::inch;
  program.profile.block_skip = true;
  program.profile.readings.set("gsk.zero-depth=alarm"_reading);
  program.profile.parameters["5920"] = reference::Number(45);
  const Reduced result = reduced({{}, program}, [](const Reproducer& reproducer) {
    return reproducer.program.profile.units == reference::Units::inch;
  });
  EXPECT_EQ(reference::profile_json(result.reproducer.program.profile), R"({"units":"inch"})");
}

TEST(Reduce, TheMachineStartsElsewhereAlongNeededAxesAlone) {
  generate::GeneratedProgram program = gsk("G00\n");
  program.profile.initial.at[reference::Axis::x] = 5;
  program.profile.initial.at[reference::Axis::z] = 3;
  const Reduced result = reduced({{}, program}, [](const Reproducer& reproducer) {
    return reproducer.program.profile.initial.at[reference::Axis::z] == 3;
  });
  EXPECT_EQ(reference::profile_json(result.reproducer.program.profile), R"({"initial":{"z":"3"}})");
}

// The X of both lines stay or go, and none stays without its start.
TEST(Reduce, WordsThatNeedEachOtherGoTogether) {
  generate::GeneratedProgram program = gsk("G00 X10 Z5\nG01 Z2 X20\n");
  program.profile.initial.at[reference::Axis::x] = 5;
  const Reduced result = reduced({{}, program}, [](const Reproducer& reproducer) {
    const std::string& text = reproducer.program.text;
    const bool starts = reproducer.program.profile.initial.at[reference::Axis::x] != 0;
    const auto count = std::ranges::count(text, 'X');
    return holds(reproducer, "Z2") && (count == 2 ? starts : count == 0 && !starts);
  });
  EXPECT_EQ(result.reproducer.program.text, "Z2\n");
}

TEST(Reduce, ANumberOfSeveralWordsBecomesShortInAll) {
  const Reduced result = reduced({{}, gsk("R-1.75 Z-1.75\n")}, [](const Reproducer& reproducer) {
    const std::string& text = reproducer.program.text;
    const std::size_t z = text.find(" Z");
    return text.starts_with("R-") && z != std::string::npos &&
           text.substr(1, z - 1) + "\n" == text.substr(z + 2);
  });
  EXPECT_EQ(result.reproducer.program.text, "R-1 Z-1\n");
}

TEST(Reduce, WordsAreSpelledPlainly) {
  const Reduced result = reduced({{}, gsk("g0  1 x 2\n")}, [](const Reproducer& reproducer) {
    const std::vector<program::TextLine> lines = program::lines_of(reproducer.program.text);
    return lines.size() == 1 && lines[0].words.size() == 2 && code_of(lines[0].words[0]) == "G1" &&
           value_of(lines[0].words[1])->text() == "2";
  });
  EXPECT_EQ(result.reproducer.program.text, "G1 X2\n");
}

TEST(Reduce, TablesKeepTheEntriesAndAxesThatAreNeeded) {
  generate::GeneratedProgram program = gsk("G00\n");
  program.profile.offsets["G54"][reference::Axis::x] = reference::Number::parse("-10.66").value();
  program.profile.offsets["G54"][reference::Axis::z] = 7;
  program.profile.offsets["G55"][reference::Axis::x] = 3;
  program.profile.parameters["5920"] = 45;
  const Reduced result = reduced({{}, program}, [](const Reproducer& reproducer) {
    const auto& offsets = reproducer.program.profile.offsets;
    return offsets.contains("G54") && offsets.at("G54").at[0] < 0;
  });
  reference::Profile wanted = gsk("").profile;
  wanted.offsets["G54"][reference::Axis::x] = -1;
  EXPECT_EQ(reference::profile_json(result.reproducer.program.profile),
            reference::profile_json(wanted));
}

TEST(Reduce, TheStartBecomesAShortNumber) {
  generate::GeneratedProgram program = gsk("G00\n");
  program.profile.initial.at[reference::Axis::z] = reference::Number::parse("44.4995").value();
  const Reduced result = reduced({{}, program}, [](const Reproducer& reproducer) {
    return reproducer.program.profile.initial.at[reference::Axis::z] > 3;
  });
  EXPECT_EQ(reference::profile_json(result.reproducer.program.profile), R"({"initial":{"z":"5"}})");
}

TEST(Reduce, ProgramsBeforeItGo) {
  const Reproducer reproducer{{gsk("G0\n"), gsk("F100 (x)\n"), gsk("G1\n")}, gsk("G1 X1\n")};
  const Reduced result = reduced(reproducer, [](const Reproducer& candidate) {
    for (const generate::GeneratedProgram& program : candidate.before) {
      if (program.text.find("F100") != std::string::npos) return holds(candidate, "X1");
    }
    return false;
  });
  ASSERT_EQ(result.reproducer.before.size(), 1U);
  EXPECT_EQ(result.reproducer.before[0].text, "F100\n");
  EXPECT_EQ(result.reproducer.program.text, "X1\n");
}

TEST(Reduce, WhatCannotBecomeSmallerStays) {
  const Reproducer reproducer{{}, gsk(kLong)};
  const Reduced result = reduced(reproducer, [](const Reproducer&) { return false; });
  EXPECT_EQ(result.reproducer.program.text, kLong);
  EXPECT_TRUE(result.finished);
}

TEST(Reduce, TheTimeEndsIt) {
  ReduceLimits limits;
  limits.time = std::chrono::milliseconds(0);
  const Reduced result = reduce(
      {{}, gsk(kLong)}, [](const Reproducer&) { return true; }, limits);
  EXPECT_EQ(result.runs, 0U);
  EXPECT_FALSE(result.finished);
}

// For any question: the answer still holds, in no more runs than allowed, and no larger.
RC_GTEST_PROP(Reduce, KeepsWhatIsShownWithinItsRuns, (std::uint64_t seed)) {
  generate::Choices choices(seed);
  const generate::GeneratedProgram program =
      generate::find_generator("gsk")->generate(choices, nullptr);
  const auto runs = *rc::gen::inRange<std::size_t>(0, 200);
  const char needed = *rc::gen::elementOf(program.text);
  std::size_t calls = 0;
  auto shows = [&](const Reproducer& reproducer) {
    ++calls;
    return reproducer.program.text.find(needed) != std::string::npos;
  };
  const Reduced result = reduced({{}, program}, shows, runs);
  RC_ASSERT(calls <= runs);
  RC_ASSERT(result.runs == calls);
  RC_ASSERT(result.reproducer.program.text.find(needed) != std::string::npos);
  RC_ASSERT(program::count_blocks(result.reproducer.program.text) <=
            program::count_blocks(program.text));
}

}  // namespace
}  // namespace gonogo::hunt::testing
