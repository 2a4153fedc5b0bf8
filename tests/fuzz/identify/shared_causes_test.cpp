// SPDX-License-Identifier: GPL-3.0-or-later
//
// One planted fault shows in many departures: they are of one cause, and those of two faults of
// two. The names are those of what a fault does.
#include "fuzz/identify/shared_causes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "corpus/io/corpus.hpp"
#include "fuzz/program/text.hpp"
#include "pools.hpp"
#include "secret_subject.hpp"

namespace gonogo::identify {
namespace {

using testing::builtin;
using testing::checked_in_corpus;
using testing::TwoFaults;

constexpr const char* kAbsolute = "I J K are taken as absolute";
constexpr const char* kUnsigned = "R of G2 G3 is taken without its sign";

// Puts the last motion of a program with a dwell somewhere else, by what no mistake comes to.
class Displaced : public WrappedSubject {
 public:
  Displaced() : WrappedSubject(builtin("ngc", "offsets-absolute")) {}
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    std::size_t moved = 0;
    const bool is_displaced = program.find("G4") != std::string_view::npos;
    return WrappedSubject::run(id, program, [&](const Record& record) {
      Record other = record;
      if (is_displaced && record.axes.has(reference::Axis::x)) {
        other.to[reference::Axis::x] =
            other.to[reference::Axis::x] +
            *reference::Number::parse(++moved % 2 == 0 ? "0.717" : "3.1");
      }
      return sink(other);
    });
  }
};

struct Sorted {
  std::vector<ProgramAsked> symptoms;
  std::vector<ProgramAsked> others;
};

// The programs of some cases, those on which the subject departs first.
Sorted sorted(oracle::Subject& subject, std::initializer_list<const char*> cycles) {
  constexpr std::size_t kMostSymptoms = 60;
  Sorted programs;
  ExplanationOptions options;
  Explainer explainer(subject, options);
  oracle::CaseReader reader(checked_in_corpus(), oracle::Detail::to_run);
  while (const auto test = reader.next()) {
    const bool is_of = std::ranges::any_of(cycles, [&](const char* cycle) {
      return test->dialect == "rs274" && test->cycle == cycle;
    });
    if (!is_of) continue;
    const ProgramAsked asked{test->id, test->program, test->profile};
    const auto seen = explainer.observe(asked);
    if (!seen) continue;
    if (!seen->departs()) {
      programs.others.push_back(asked);
    } else if (programs.symptoms.size() < kMostSymptoms) {
      programs.symptoms.push_back(asked);
    }
  }
  return programs;
}

std::vector<std::string> names(const SharedCauses& found) {
  std::vector<std::string> names;
  for (const SharedCause& cause : found.causes) names.push_back(cause.name);
  return names;
}

TEST(SharedCauses, ManyFacesOfOneFaultAreOfOneCause) {
  const auto subject = builtin("ngc", "offsets-absolute");
  const Sorted programs = sorted(*subject, {"arc", "helix"});
  ASSERT_GT(programs.symptoms.size(), 20U);
  ASSERT_GT(programs.others.size(), 5U);
  const SharedCauses found = find_shared_causes(*subject, programs.symptoms, programs.others, {});
  ASSERT_EQ(names(found), std::vector<std::string>{kAbsolute});
  EXPECT_EQ(found.causes.front().symptoms.size(), programs.symptoms.size());
  EXPECT_EQ(found.causes.front().passes, programs.others.size());
}

TEST(SharedCauses, TwoFaultsAreTwoCausesAndNoFaceIsOfBoth) {
  TwoFaults subject;
  const Sorted programs = sorted(subject, {"arc-distance", "helix", "basic"});
  const SharedCauses found = find_shared_causes(subject, programs.symptoms, programs.others, {});
  std::vector<std::string> told = names(found);
  std::ranges::sort(told);
  ASSERT_EQ(told, (std::vector<std::string>{kAbsolute, testing::kDwellCause}));
  std::set<std::size_t> symptoms;
  for (const SharedCause& cause : found.causes) {
    ASSERT_GT(cause.symptoms.size(), 1U) << cause.name;
    for (const std::size_t symptom : cause.symptoms) {
      EXPECT_TRUE(symptoms.insert(symptom).second);
      const bool has_arc =
          programs.symptoms[symptom].program.find_first_of("IJK") != std::string::npos;
      EXPECT_EQ(has_arc, cause.name == kAbsolute);
    }
  }
}

// Dwells of G4 are there, and those of cycles are not.
class WithoutDwellsOfCycles : public WrappedSubject {
 public:
  WithoutDwellsOfCycles() : WrappedSubject(builtin("ngc")) {}
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    static const std::regex kDwell("[gG]0*4($|[^0-9])");
    const std::vector<program::TextLine> lines = program::lines_of(program);
    return WrappedSubject::run(id, program, [&](const Record& record) {
      const bool is_dwell = record.kind == reference::RecordKind::dwell;
      const bool is_written =
          is_dwell && std::regex_search(line_text(lines.at(record.block - 1)), kDwell);
      return (is_dwell && !is_written) || sink(record);
    });
  }
};

TEST(SharedCauses, OneMistakeInAllCyclesIsOneCause) {
  WithoutDwellsOfCycles subject;
  Sorted programs = sorted(subject, {"cycles"});
  // G4 in the block of a cycle: whose dwell it is, the subject does not tell.
  std::erase_if(programs.others, [](const ProgramAsked& other) {
    return other.program.find(" G4 ") != std::string::npos;
  });
  ASSERT_GT(programs.symptoms.size(), 20U);
  const SharedCauses found = find_shared_causes(subject, programs.symptoms, programs.others, {});
  EXPECT_EQ(names(found), std::vector<std::string>{"the dwells of all cycles are left out"});
}

TEST(SharedCauses, AFaceThatNoMistakeExplainsIsOfNone) {
  Displaced subject;
  const Profile machine = testing::default_machine("rs274");
  const std::vector<ProgramAsked> symptoms = {
      {"centre", "F100\nG2 X10 Y0 I5 J3\nG2 X0 Y0 I-5 J-3\nM2\n", machine},
      {"displaced", "F100\nG4 P1\nG1 X10\nX20 Y5\nX40\nM2\n", machine},
      {"helix", "F100\nG1 X1\nG3 X1 Z5 I2\nM2\n", machine}};
  const SharedCauses found = find_shared_causes(subject, symptoms, {}, {});
  ASSERT_EQ(names(found), std::vector<std::string>{kAbsolute});
  EXPECT_EQ(found.causes.front().symptoms, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(found.causes.front().evidence().substr(0, 65),
            "It explains 2 of 3 departures that were tried (not: displaced).");
}

// Where arcs of other planes pass, it is not every arc that turns the other way.
TEST(SharedCauses, WhatPassesMustPassWithTheMistakeToo) {
  const auto subject = builtin("ngc", "g18-sense-flipped");
  const Profile machine = testing::default_machine("rs274");
  const std::vector<ProgramAsked> symptoms = {
      {"g18", "F100\nG18\nG2 X10 Z0 I5 K0\nG2 X20 Z0 I5 K0\nM2\n", machine}};
  const std::vector<ProgramAsked> others = {
      {"g17", "F100\nG2 X10 Y0 I5 J0\nG3 X20 Y0 I5 J0\nM2\n", machine},
      {"g19", "F100\nG19\nG2 Y10 Z0 J5 K0\nM2\n", machine}};
  const SharedCauses found = find_shared_causes(*subject, symptoms, others, {});
  ASSERT_EQ(names(found), std::vector<std::string>{"every arc in G18 turns the other way"});
  EXPECT_EQ(found.passes, 2U);
}

// "G0 2" is G02 to the grammar, and G0 and a loose number to all that looks at words.
TEST(SharedCauses, AProgramIsHeldAgainstMistakesAsTheGrammarPrintsIt) {
  const auto subject = builtin("ngc", "radius-sign-ignored");
  const Profile machine = testing::default_machine("rs274");
  const std::vector<ProgramAsked> symptoms = {{"plain", "F100\nG2 X10 R-8\nM2\n", machine},
                                              {"odd", "F100\ng0 2 x1 0 r-8\nM2\n", machine},
                                              {"other", "F100\nG3 X10 R-8\nM2\n", machine}};
  const std::vector<ProgramAsked> others = {
      {"line", "F100\nG1 X10 Y5\nG3 X0 Y7 R20\nG2 X10 Y5 R20\nM2\n", machine},
      {"hole", "F100\nG81 X1 Y2 Z-5 R-1\nM2\n", machine}};
  const SharedCauses found = find_shared_causes(*subject, symptoms, others, {});
  ASSERT_EQ(names(found), std::vector<std::string>{kUnsigned});
  EXPECT_EQ(found.causes.front().symptoms.size(), 3U);
}

// A reduced program has H1, of which "one too few" and "ignored" make the same; another tells them
// apart.
TEST(SharedCauses, OtherDeparturesTellMistakesApartThatASmallestProgramDoesNot) {
  const auto subject = builtin("ngc", "g76-h-total");
  const Profile machine = testing::default_machine("rs274");
  const auto threaded = [](const char* passes) {
    return fmt::format("G18 G0 X0 Z30\nM3 S100\nG76 P2 Z20 I-1 J0.5 K1.2 R2 {}\nM2\n", passes);
  };
  const std::vector<ProgramAsked> symptoms = {{"smallest", threaded("H1"), machine}};
  const std::vector<ProgramAsked> others = {{"without", threaded("H0"), machine},
                                            {"other", threaded("H3"), machine}};
  const std::string ignored = "H is ignored";
  EXPECT_EQ(names(find_shared_causes(*subject, symptoms, {}, {})), std::vector{ignored});
  const std::vector<std::string> told = names(find_shared_causes(*subject, symptoms, others, {}));
  EXPECT_EQ(told, std::vector<std::string>{"H counts one too few"});
}

// What explains one program and no other that departs may be a coincidence.
TEST(SharedCauses, OneProgramAloneHasNoneWhereOthersDepartToo) {
  Displaced subject;
  const Profile machine = testing::default_machine("rs274");
  const std::vector<ProgramAsked> symptoms = {
      {"centre", "F100\nG2 X10 Y0 I5 J3\nG2 X0 Y0 I-5 J-3\nM2\n", machine}};
  const std::vector<ProgramAsked> others = {
      {"displaced", "F100\nG4 P1\nG1 X10\nX20 Y5\nX40\nM2\n", machine}};
  EXPECT_EQ(find_shared_causes(subject, symptoms, {}, {}).causes.size(), 1U);
  EXPECT_EQ(names(find_shared_causes(subject, symptoms, others, {})), std::vector<std::string>{});
}

TEST(SharedCauses, AreNotNamedWithMoreRecordsThanTheyMayTake) {
  const auto subject = builtin("ngc", "offsets-absolute");
  const Sorted programs = sorted(*subject, {"arc"});
  ExplanationOptions options;
  options.most_records = 100;
  const SharedCauses found =
      find_shared_causes(*subject, programs.symptoms, programs.others, options);
  EXPECT_TRUE(found.given_up);
  EXPECT_TRUE(found.causes.empty());
}

TEST(SharedCauses, ANewFaceIsOfTheKnownMistakeThatExplainsAllOfIt) {
  Displaced subject;
  const Profile machine = testing::default_machine("rs274");
  const std::set<std::string> known = {kAbsolute, kUnsigned};
  const auto cause = [&](const char* program) {
    return known_cause(subject, {"symptom", program, machine}, known, {});
  };
  EXPECT_EQ(cause("F100\nG1 X1\nG3 X1 Z5 I2\nM2\n"), kAbsolute);
  // Departs by something else, or by something else as well, or not at all.
  EXPECT_EQ(cause("F100\nG4 P1\nG1 X10\nX20 Y5\nX40\nM2\n"), "");
  EXPECT_EQ(cause("F100\nG4 P1\nG1 X3\nG2 X10 Y0 I5 J3\nM2\n"), "");
  EXPECT_EQ(cause("F100\nG1 X10\nM2\n"), "");
  const std::set<std::string> none = {kUnsigned};
  EXPECT_EQ(known_cause(subject, {"symptom", "F100\nG1 X1\nG3 X1 Z5 I2\nM2\n", machine}, none, {}),
            "");
}

}  // namespace
}  // namespace gonogo::identify
