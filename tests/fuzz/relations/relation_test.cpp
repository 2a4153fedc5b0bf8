// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a relation asks of every control, the reference has to do, which knows nothing of relations.
#include <gtest/gtest.h>

#include "related.hpp"

namespace gonogo::relations::testing {
namespace {

constexpr std::uint64_t kSeed = 20261122;
constexpr std::uint64_t kPrograms = 150;
constexpr std::size_t kMostRecords = 1'000;

struct Tally {
  std::size_t held = 0;
  std::size_t not_related = 0;
};

// Few programs are written so that they lend themselves to these.
bool is_rarely_related(std::string_view relation) {
  return relation == "units" || relation == "increments" || relation == "halves" ||
         relation == "repeats";
}

// Each variant of the relation, on generated programs of the dialect.
Tally hold(const generate::Generator& generator, const Relation& relation) {
  const std::uint64_t programs = is_rarely_related(relation.name) ? 25 * kPrograms : kPrograms;
  const Number tolerance = Number::decimal(false, 1, 9);
  Tally tally;
  for (std::uint64_t seed = kSeed; seed < kSeed + programs; ++seed) {
    generate::Choices choices(seed);
    const generate::GeneratedProgram program = generator.generate(choices, nullptr);
    const oracle::ReferenceRun first =
        oracle::run_reference(program.profile, program.text, kMostRecords);
    if (!first.is_told()) continue;
    for (std::size_t variant = 0; variant < relation.variants(program); ++variant) {
      const std::optional<Related> related = relation.relate(program, variant);
      if (!related) {
        ++tally.not_related;
        continue;
      }
      const oracle::ReferenceRun other =
          oracle::run_reference(related->program.profile, related->program.text, kMostRecords);
      if (!other.is_told()) continue;
      const auto found = first_difference(trace_of(first), trace_of(other), *related, tolerance);
      EXPECT_FALSE(found) << relation.name << " " << variant << " seed " << seed << "\nwant "
                          << found->want << "\ngot " << found->got << "\n"
                          << program.text << "\n"
                          << related->program.text;
      ++tally.held;
    }
  }
  return tally;
}

// A lathe has one plane, and rs274 alone has a word that makes several holes.
bool has_domain(std::string_view dialect, std::string_view relation) {
  if (relation == "planes") return dialect != "hnc21t";
  return relation != "repeats" || dialect == "rs274";
}

TEST(Relations, HoldOfTheReference) {
  for (const generate::Generator& generator : generate::generators()) {
    for (const Relation& relation : relations()) {
      if (!has_domain(generator.dialect, relation.name)) continue;
      const Tally tally = hold(generator, relation);
      EXPECT_GE(tally.held, 10U) << generator.dialect << " " << relation.name << ": too few pairs";
    }
  }
}

TEST(Relations, AreFoundByName) {
  EXPECT_EQ(find_relation("translation")->name, "translation");
  EXPECT_EQ(find_relation("none"), nullptr);
}

TEST(Relations, EmptyLinesKeepTheirLines) {
  const generate::GeneratedProgram program = program_of("rs274", "%\nG0 X1\nX2");
  const Related related = *find_relation("empty-lines")->relate(program, 0);
  EXPECT_EQ(related.program.text, "%\nG0 X1\n\n;\nX2");
  EXPECT_EQ(related.lines, (std::vector<std::uint64_t>{1, 2, 5}));
}

TEST(Relations, ABeginningHasTheFirstLines) {
  const generate::GeneratedProgram program = program_of("rs274", "G0 X1\nX2\nX3");
  const Relation& beginning = *find_relation("beginning");
  EXPECT_EQ(beginning.variants(program), 2U);
  const Related related = *beginning.relate(program, 1);
  EXPECT_EQ(related.program.text, "G0 X1\nX2\n");
  EXPECT_EQ(related.lines, (std::vector<std::uint64_t>{1, 2, 0}));
}

TEST(Relations, ModesStandBehindTheHead) {
  const generate::GeneratedProgram program = program_of("hnc21t", "%0001\nG00 X1\n");
  EXPECT_EQ(find_relation("modes-again")->relate(program, 0)->program.text,
            "%0001\nG18 G21 G36 G40 G90 G94 G97\nG00 X1\n");
}

TEST(Relations, ZerosStandBehindTheSignAndNotInCodes) {
  const generate::GeneratedProgram program = program_of("rs274", "G1 X-1.5 F9 T3\n");
  EXPECT_EQ(find_relation("spelling")->relate(program, 2)->program.text, "G1 X-001.5 F009 T3\n");
}

}  // namespace
}  // namespace gonogo::relations::testing
