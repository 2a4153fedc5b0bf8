// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs that have to be valid: the reference refuses none, and every cycle is among them.
#include "fuzz/generate/valid_programs.hpp"
#include "reference/reading_literal.hpp"

#include <gtest/gtest.h>

#include "fuzz/program/features.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/dialect.hpp"
#include "reference/expander.hpp"

namespace gonogo::generate {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kPrograms = 1'500;

const reference::Dialect& dialect_of(const Generator& generator) {
  return *reference::find_dialect(generator.dialect);
}

// The codes of the blocks whose motions the reference puts out. Says so where it alarms, under the
// readings as the profile has them.
std::set<std::string> codes_that_moved(const GeneratedProgram& program) {
  const program::ProgramText text(program.profile, program.text);
  oracle::ProgramInput input(program.text);
  reference::Expander expander(program.profile, input.lines, reference::OpenPaths::shown);
  std::set<std::string> codes;
  while (const reference::Item* item = expander.next()) {
    EXPECT_FALSE(std::holds_alternative<reference::AlarmReport>(*item)) << program.text;
    EXPECT_FALSE(std::holds_alternative<reference::NotCovered>(*item)) << program.text;
    const auto* record = std::get_if<reference::Record>(item);
    if (record == nullptr || !is_motion(record->kind)) continue;
    codes.emplace(text.code_at(record->block));
  }
  return codes;
}

bool is_cycle(const reference::Code& code) {
  return code.kind == reference::Kind::cycle || code.kind == reference::Kind::thread;
}

class Valid : public ::testing::TestWithParam<Generator> {
 protected:
  static std::vector<GeneratedProgram> forty_or_more(const ValidOptions& options) {
    ValidPrograms programs(GetParam(), options);
    std::vector<GeneratedProgram> kept;
    for (std::uint64_t seed = kSeed; seed < kSeed + 50; ++seed) {
      if (auto program = programs.of_seed(seed)) kept.push_back(*std::move(program));
    }
    EXPECT_GE(kept.size(), 40U);
    return kept;
  }
};

TEST_P(Valid, NoProgramAlarmsAndEveryCycleIsAmongThem) {
  ValidPrograms programs(GetParam(), {});
  std::set<std::string> moved;
  std::uint64_t seed = kSeed;
  for (std::uint64_t kept = 0; kept < kPrograms; ++seed) {
    ASSERT_LT(seed, kSeed + 2 * kPrograms) << "half of them are thrown out";
    const std::optional<GeneratedProgram> program = programs.of_seed(seed);
    if (!program) continue;
    ++kept;
    moved.merge(codes_that_moved(*program));
  }
  for (const reference::Code& code : dialect_of(GetParam()).descriptor->codes) {
    EXPECT_TRUE(!is_cycle(code) || moved.contains(std::string(code.name))) << code.name;
  }
  const ValidCount& count = programs.count();
  EXPECT_LT(count.left_out * 7, count.blocks) << "the writer knows too little of what is refused";
}

TEST_P(Valid, EqualSeedsGiveEqualPrograms) {
  ValidPrograms one(GetParam(), {});
  ValidPrograms other(GetParam(), {});
  for (std::uint64_t seed = kSeed; seed < kSeed + 20; ++seed) {
    const auto first = one.of_seed(seed);
    const auto second = other.of_seed(seed);
    ASSERT_EQ(first.has_value(), second.has_value());
    EXPECT_TRUE(!first || (first->text == second->text && first->profile == second->profile));
  }
}

TEST_P(Valid, NoProgramNeedsAFeatureThatIsNotDeclared) {
  ValidOptions options;
  options.features = {"basic", "arc"};
  for (const GeneratedProgram& program : forty_or_more(options)) {
    for (const std::string& feature : program::features_needed({program.profile, program.text}))
      EXPECT_TRUE(options.features.contains(feature)) << feature << "\n" << program.text;
  }
}

TEST_P(Valid, EveryProgramIsForTheGivenMachine) {
  ValidOptions options;
  options.profile = std::get<reference::Profile>(reference::default_profile(GetParam().dialect));
  for (const GeneratedProgram& program : forty_or_more(options)) {
    EXPECT_TRUE(program.profile == *options.profile);
    EXPECT_FALSE(refusal_of(program, 10'000)) << program.text;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryDialect, Valid,
                         ::testing::ValuesIn(generators().begin(), generators().end()),
                         [](const auto& each) { return std::string(each.param.dialect); });

GeneratedProgram gsk(const char* text) {
  return {std::get<reference::Profile>(reference::default_profile("gsk988ta")), text};
}

// |R| of the taper is longer than the travel against it.
TEST(Refusal, NamesTheBlockAndTheRule) {
  const auto refusal = refusal_of(gsk("G00 X100 Z5\nG94 X50 Z-10 R16 F100\n"), 100);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->block, 2U);
  EXPECT_TRUE(refusal->why.starts_with("GSK-G94-09")) << refusal->why;
  EXPECT_FALSE(refusal_of(gsk("G00 X100 Z5\nG94 X50 Z-10 R15 F100\n"), 100));
}

TEST(Refusal, IsThatOfAnyAlternativeOfAnOpenReading) {
  GeneratedProgram program{std::get<reference::Profile>(reference::default_profile("hnc21t")),
                           "G00 X100 Z5\nG80 X50 Z-10 F100\nX40\n"};
  program.profile.readings.set("hnc.missing-axis=any"_reading);
  const auto refusal = refusal_of(program, 100);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->block, 3U);
}

}  // namespace
}  // namespace gonogo::generate
