// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/generator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <variant>

#include "grammar/parser.hpp"
#include "reference/dialect.hpp"

namespace gonogo::generate {
namespace {

GeneratorSettings only(ProgramKind kind) {
  GeneratorSettings settings;
  settings.kinds = {0, 0, 0, 0, 0};
  std::uint32_t* const weights[] = {&settings.kinds.valid, &settings.kinds.near_invalid,
                                    &settings.kinds.boundary, &settings.kinds.raw,
                                    &settings.kinds.tiny};
  *weights[static_cast<std::size_t>(kind)] = 1;
  return settings;
}

// What so many programs of the settings hold.
Distribution held(const Generator& generator, const GeneratorSettings& settings,
                  std::uint64_t programs) {
  Distribution distribution;
  for (std::uint64_t seed = 1; seed <= programs; ++seed) {
    Choices choices(seed);
    generator.generate(choices, settings, &distribution);
  }
  return distribution;
}

std::size_t times(const Distribution& distribution, std::string_view beginning) {
  std::size_t sum = 0;
  for (const auto& [what, count] : distribution) {
    if (std::string_view(what).starts_with(beginning)) sum += count;
  }
  return sum;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

const Generator& any_generator() {
  return generators()[*rc::gen::inRange<std::size_t>(0, generators().size())];
}

TEST(Generator, DrawsEveryKindByItsWeightInEveryDialect) {
  GeneratorSettings settings;
  settings.kinds = {.valid = 1, .near_invalid = 2, .boundary = 1, .raw = 3, .tiny = 1};
  for (const Generator& generator : generators()) {
    const Distribution kinds = held(generator, settings, 800);
    // 100, 200, 100, 300 and 100 of 800 are expected; six standard deviations of the least are 57.
    EXPECT_NEAR(static_cast<double>(times(kinds, "kind valid")), 100, 57) << generator.dialect;
    EXPECT_NEAR(static_cast<double>(times(kinds, "kind near-invalid")), 200, 74)
        << generator.dialect;
    EXPECT_NEAR(static_cast<double>(times(kinds, "kind boundary")), 100, 57) << generator.dialect;
    EXPECT_NEAR(static_cast<double>(times(kinds, "kind raw")), 300, 83) << generator.dialect;
    EXPECT_NEAR(static_cast<double>(times(kinds, "kind tiny")), 100, 57) << generator.dialect;
  }
}

TEST(Generator, AValidProgramHasNothingPutWrong) {
  for (const Generator& generator : generators()) {
    const Distribution valid = held(generator, only(ProgramKind::valid), 300);
    EXPECT_EQ(times(valid, "fault"), 0U) << generator.dialect;
    EXPECT_EQ(times(valid, "boundary"), 0U) << generator.dialect;
    EXPECT_EQ(times(valid, "kind valid"), 300U) << generator.dialect;
  }
}

TEST(Generator, ANearInvalidOneHasEveryFaultSometimes) {
  for (const Generator& generator : generators()) {
    const Distribution near = held(generator, only(ProgramKind::near_invalid), 600);
    for (const char* fault : {"fault: word missing", "fault: word twice", "fault: sign",
                              "fault: zero", "fault: another axis", "fault: far out"}) {
      EXPECT_GT(times(near, fault), 0U) << generator.dialect << ", " << fault;
    }
  }
}

TEST(Generator, ABoundaryProgramHasValuesThatMeetOthers) {
  for (const Generator& generator : generators()) {
    const Distribution boundary = held(generator, only(ProgramKind::boundary), 300);
    EXPECT_GT(times(boundary, "boundary"), 50U) << generator.dialect;
    EXPECT_EQ(times(boundary, "fault"), 0U) << generator.dialect;
  }
}

TEST(Generator, ABoundaryProgramOfRs274HasNumbersThatAreNearlyWhole) {
  for (const Generator& generator : generators()) {
    if (generator.dialect != "rs274") continue;
    EXPECT_GT(times(held(generator, only(ProgramKind::boundary), 300), "beside a whole"), 50U);
  }
}

// Words of an axis that is led by no more than three increments.
std::size_t tiny_lengths(const Generator& generator, ProgramKind kind) {
  static const std::regex kTiny(R"([XYZUVW](=IC\( *)?-?0?\.000?[1-3](?![0-9]))");
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Choices choices(seed);
    const std::string text = generator.generate(choices, only(kind), nullptr).text;
    count += static_cast<std::size_t>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), kTiny), {}));
  }
  return count;
}

TEST(Generator, ATinyProgramHasLengthsOfAFewIncrements) {
  for (const Generator& generator : generators()) {
    const std::size_t tiny = tiny_lengths(generator, ProgramKind::tiny);
    EXPECT_GT(tiny, 100U) << generator.dialect;
    EXPECT_GT(tiny, 5 * tiny_lengths(generator, ProgramKind::valid)) << generator.dialect;
    EXPECT_EQ(times(held(generator, only(ProgramKind::tiny), 100), "fault"), 0U);
  }
}

TEST(Generator, ARawProgramHasLinesThatCanBeReadAndSuchThatCannot) {
  for (const Generator& generator : generators()) {
    const grammar::Dialect dialect = reference::find_dialect(generator.dialect)->grammar;
    std::size_t read = 0;
    std::size_t refused = 0;
    grammar::Block block;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      Choices choices(seed);
      const auto program = generator.generate(choices, only(ProgramKind::raw), nullptr);
      for (std::size_t begin = 0; begin < program.text.size();) {
        const std::size_t end = std::min(program.text.find('\n', begin), program.text.size());
        const auto line = std::string_view(program.text).substr(begin, end - begin);
        ++(grammar::parse_block(dialect, line, block) ? refused : read);
        begin = end + 1;
      }
    }
    EXPECT_GT(read, 100U) << generator.dialect;
    EXPECT_GT(refused, 100U) << generator.dialect;
  }
}

RC_GTEST_PROP(Generator, TheSameDecisionsGiveTheSameProgram, ()) {
  const Generator& generator = any_generator();
  GeneratorSettings settings;
  settings.kinds = {.valid = 1, .near_invalid = 1, .boundary = 1, .raw = 1, .tiny = 1};
  const auto bytes = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
  Choices one{std::span<const std::uint8_t>(bytes)};
  Choices other{std::span<const std::uint8_t>(bytes)};
  const GeneratedProgram first = generator.generate(one, settings, nullptr);
  Distribution distribution;
  const GeneratedProgram second = generator.generate(other, settings, &distribution);
  RC_ASSERT(first.text == second.text);
  RC_ASSERT(first.profile == second.profile);
  RC_ASSERT(first.profile.dialect == generator.dialect);
}

// A GSK program is a head, blocks and perhaps an M30, each perhaps with an empty line behind it; a
// raw one is blocks alone.
RC_GTEST_PROP(Generator, HasNoMoreBlocksThanTheSettingsSay, ()) {
  const int most = *rc::gen::inRange(1, 6);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  GeneratorSettings settings = only(*rc::gen::element(ProgramKind::valid, ProgramKind::boundary));
  settings.most_blocks = most;
  Choices choices(seed);
  const auto program = find_generator("gsk")->generate(choices, settings, nullptr);
  RC_ASSERT(lines(program.text) <= static_cast<std::size_t>(2 * (most + 1) + 1));
  settings = only(ProgramKind::raw);
  settings.most_blocks = most;
  Choices others(seed);
  RC_ASSERT(lines(any_generator().generate(others, settings, nullptr).text) <=
            static_cast<std::size_t>(most));
}

TEST(Generator, FewerBlocksMakeShorterProgramsInEveryDialect) {
  const auto all_lines = [](const Generator& generator, const GeneratorSettings& settings) {
    std::size_t sum = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      Choices choices(seed);
      sum += lines(generator.generate(choices, settings, nullptr).text);
    }
    return sum;
  };
  GeneratorSettings few;
  few.most_blocks = 1;
  for (const Generator& generator : generators()) {
    EXPECT_LT(4 * all_lines(generator, few), 3 * all_lines(generator, {})) << generator.dialect;
  }
}

RC_GTEST_PROP(Generator, LeavesTheMachineAloneWhereTheSettingsSaySo, ()) {
  const Generator& generator = any_generator();
  GeneratorSettings settings;
  settings.kinds = {.valid = 1, .near_invalid = 1, .boundary = 1, .raw = 1, .tiny = 1};
  settings.machine = {
      .state = false, .readings = false, .parameters = false, .offsets = false, .tools = false};
  Choices choices(*rc::gen::arbitrary<std::uint64_t>());
  const auto program = generator.generate(choices, settings, nullptr);
  auto standard = std::get<reference::Profile>(reference::default_profile(generator.dialect));
  // A pocket needs a tool.
  if (generator.dialect == "sinumerik802s") standard.tools = program.profile.tools;
  RC_ASSERT(program.profile == standard);
}

TEST(Generator, ASwitchLeavesOutWhatItNamesAndNothingElse) {
  struct Part {
    std::string_view dialect;
    bool MachineSettings::*its_switch;
    bool (*differs)(const reference::Profile& profile, const reference::Profile& standard);
  };
  const Part parts[] = {
      {"hnc21t", &MachineSettings::offsets,
       [](const auto& one, const auto& standard) { return one.offsets != standard.offsets; }},
      {"hnc21t", &MachineSettings::parameters,
       [](const auto& one, const auto& standard) { return one.parameters != standard.parameters; }},
      {"rs274", &MachineSettings::readings,
       [](const auto& one, const auto& standard) { return one.readings != standard.readings; }},
      {"gsk988ta", &MachineSettings::state,
       [](const auto& one, const auto& standard) { return one.increment != standard.increment; }},
      {"sinumerik802s", &MachineSettings::tools,
       [](const auto& one, const auto&) {
         return one.tools.at("1").radius != reference::Number(1);
       }},
  };
  for (const Part& part : parts) {
    const auto generator = std::ranges::find(generators(), part.dialect, &Generator::dialect);
    const auto standard = std::get<reference::Profile>(reference::default_profile(part.dialect));
    for (const bool on : {true, false}) {
      GeneratorSettings settings;
      settings.machine.*part.its_switch = on;
      std::size_t different = 0;
      std::size_t other_machines = 0;
      for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Choices choices(seed);
        const auto program = generator->generate(choices, settings, nullptr);
        different += part.differs(program.profile, standard) ? 1U : 0U;
        other_machines += program.profile != standard ? 1U : 0U;
      }
      EXPECT_EQ(different > 0, on) << part.dialect;
      EXPECT_GT(other_machines, 20U) << part.dialect;
    }
  }
}

TEST(Generator, WithoutPocketsNoneComes) {
  for (const std::string_view dialect : {"gsk988ta", "sinumerik802s"}) {
    const auto generator = std::ranges::find(generators(), dialect, &Generator::dialect);
    GeneratorSettings settings;
    const auto pockets = [&] {
      const Distribution distribution = held(*generator, settings, 200);
      return times(distribution, "pocket") + times(distribution, "LCYC75");
    };
    EXPECT_GT(pockets(), 20U) << dialect;
    settings.pockets = false;
    EXPECT_EQ(pockets(), 0U) << dialect;
  }
}

// sie.arc.correct is open by default: of 1,600 programs 200 leave a part of the readings so, it
// among them in 50. One in two of the rest takes another alternative of one of ten readings, each
// of the three as often: 26 take the second, 26 the third. 28 and 20 are four standard deviations.
TEST(Generator, ReadingsAreLeftOpenAsOftenAsItSaysAndTheTextIsTheSame) {
  GeneratorSettings settings = in_process_settings();
  ASSERT_EQ(settings.open_one_in, 8U);
  GeneratorSettings all_open = settings;
  all_open.open_one_in = 1;
  settings.machine.readings = all_open.machine.readings = false;
  const reference::ReadingKey key = reference::find_reading("sie.arc.correct")->key;
  const Generator& generator = generator_of("sinumerik840d");
  std::map<std::string, int, std::less<>> values;
  for (std::uint64_t seed = 1; seed <= 1'600; ++seed) {
    Choices choices(seed);
    Choices again(seed);
    const GeneratedProgram program = generator.generate(choices, settings, nullptr);
    const GeneratedProgram open = generator.generate(again, all_open, nullptr);
    ASSERT_EQ(program.text, open.text);
    ASSERT_EQ(open.profile.readings.get(key), "any");
    ++values[std::string(program.profile.readings.get(key))];
  }
  EXPECT_NEAR(values["any"], 50, 28);
  for (const char* alternative : {"project", "programmed"}) {
    EXPECT_NEAR(values[alternative], 26, 20) << alternative;
  }
}

// A subject without offsets, expressions and O words need not know the alternatives of theirs.
TEST(Generator, ReadingsThatNoProgramAsksForStayOpen) {
  static const std::regex kAsking(R"(G *92(?!\.9)|[-+] *[#[]|EQ|NE|call)");
  GeneratorSettings settings = in_process_settings();
  settings.machine.readings = false;
  const Generator& generator = generator_of("rs274");
  ASSERT_EQ(generator.unasked.size(), 9U);
  for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
    Choices choices(seed);
    const GeneratedProgram program = generator.generate(choices, settings, nullptr);
    for (const reference::ReadingKey key : generator.unasked) {
      ASSERT_EQ(program.profile.readings.get(key), "any") << seed;
    }
    ASSERT_FALSE(std::regex_search(program.text, kAsking)) << program.text;
  }
}

}  // namespace
}  // namespace gonogo::generate
