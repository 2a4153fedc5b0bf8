// SPDX-License-Identifier: GPL-3.0-or-later
//
// The models as they are: what they claim is what the reference says.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "fuzz/generate/cover/cases.hpp"
#include "fuzz/program/modes.hpp"
#include "reference/clause.hpp"
#include "reference/dialect.hpp"
#include "reference/outcome.hpp"

namespace gonogo::cover {
namespace {

class EveryModel : public ::testing::TestWithParam<const Model*> {
 protected:
  const Model& model() const { return *GetParam(); }
  // Pairs keep the test short; the corpus has the triples.
  CoverCases cases() const { return cover_cases({&model(), {2, 1}, 7, 0, {}}); }
};

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(models()),
                         [](const auto& instance) {
                           std::string name(instance.param->name);
                           std::ranges::replace(name, '.', '_');
                           return name;
                         });

TEST_P(EveryModel, AgreesWithTheReference) {
  const CoverCases made = cases();
  EXPECT_EQ(made.disagreements, std::vector<std::string>{});
}

TEST_P(EveryModel, IsCoveredByItsCases) {
  const CoverCases made = cases();
  EXPECT_GT(made.count.allowed, 0U);
  EXPECT_EQ(made.count.missing, std::vector<std::string>{});
  EXPECT_EQ(made.count.invalid, std::vector<std::string>{});
}

// Cases of rules that no text states are written by hand; another alternative may come to one.
TEST_P(EveryModel, RestsOnTexts) {
  for (const oracle::Case& test : cases().cases) {
    EXPECT_NE(test.expect.front().basis, reference::Basis::silent) << test.id << "\n" << test.program;
  }
}

TEST_P(EveryModel, NamesClausesFeaturesAndAlarmsThatThereAre) {
  std::set<std::string_view> clauses;
  for (const reference::Clause& clause : reference::clauses()) clauses.insert(clause.id);
  for (const std::string& clause : clause_list(model().clauses)) {
    EXPECT_TRUE(clauses.contains(clause)) << clause;
  }
  const auto features = reference::find_dialect(model().dialect)->descriptor->features;
  std::istringstream named{std::string(model().features)};
  for (std::string feature; named >> feature;) {
    EXPECT_NE(std::ranges::find(features, feature, &reference::DialectFeature::name),
              features.end())
        << feature;
  }
  for (const Parameter& parameter : parse_parameters(model().parameters).list) {
    for (const Class& one : parameter.classes) {
      for (const std::string& alarm : one.alarms) {
        EXPECT_TRUE(reference::alarm_class(alarm).has_value()) << alarm;
      }
    }
  }
}

using CodesAndWords = std::set<std::pair<std::string, std::string>>;

// Which words stand beside which codes in the cases of all models of the maker: the path commands
// of the 802S are the 840D's.
CodesAndWords written_by_models(const reference::Dialect& dialect) {
  CodesAndWords written;
  for (const Model* model : models()) {
    if (reference::find_dialect(model->dialect)->grammar != dialect.grammar) continue;
    for (const oracle::Case& test : cover_cases({model, {2, 1}, 7, 0, {}}).cases) {
      const program::ProgramText text(test.profile, test.program);
      for (const program::TextBlock& block : text.blocks) {
        for (const program::TextWord& word : block.words) {
          written.emplace(block.modes.code_name(), program::name_of(word));
        }
      }
    }
  }
  return written;
}

// Words that no model draws, and why.
bool is_left_to_other_vectors(const reference::Code& code, const reference::CodeWord& word) {
  using reference::Kind;
  using reference::Role;
  // Ends are those of paths, polar ones of lines and arcs.
  if (word.role == Role::place || word.role == Role::way) return true;
  // Those of rs274 stand for X and Y, in vectors of their own.
  const bool is_polar = word.role == Role::polar_angle || word.role == Role::polar_radius;
  if (is_polar && (code.kind == Kind::circle || word.feature == "polar-words")) return true;
  // The values that are read change nothing: a run-out or an angle of 0, one start.
  const bool is_trivial = std::ranges::any_of(code.passed, [&](const reference::IgnoredWords& rule) {
    return rule.when.starts_with("of ") && rule.words.find(word.address) != std::string_view::npos;
  });
  // GSK-G92-07, GSK-G92-13: a run-out of 0 alone, and no thread to the inch.
  const bool is_unread = code.name == "G92" && (word.role == Role::size || word.address == "I");
  // P of G75 is another letter for the same count; a pole is put by polar words in the recipes.
  const bool has_twin = (code.name == "G75" && word.address == "P") || code.kind == Kind::pole;
  return is_trivial || is_unread || has_twin;
}

// A cycle, a motion or a word that is new in the table of a dialect needs a model that draws it.
TEST(Models, DrawEveryWordBesideEveryCodeThatTakesIt) {
  using reference::Kind;
  for (const reference::Dialect& dialect : reference::dialects()) {
    const CodesAndWords written = written_by_models(dialect);
    const auto is_written = [&](std::string_view code, std::string_view word) {
      return std::ranges::any_of(written, [&](const auto& pair) {
        return (code.empty() || pair.first == code) && pair.second == word;
      });
    };
    for (const reference::Code& code : dialect.descriptor->codes) {
      const bool is_varied = code.kind >= Kind::thread && code.kind <= Kind::cycle;
      const bool is_other = code.kind == Kind::pole || code.kind == Kind::frame;
      if (code.treatment != reference::Treatment::read || (!is_varied && !is_other)) continue;
      // The words of a call stand before it.
      const bool is_call = code.tenths < 0 && code.kind == Kind::cycle;
      EXPECT_TRUE(is_written(code.name, is_call ? code.name : "G") || code.tenths < 0)
          << dialect.name << " " << code.name;
      for (const auto& list : code.words) {
        for (const reference::CodeWord& word : list) {
          if (is_left_to_other_vectors(code, word)) continue;
          EXPECT_TRUE(is_written(is_call ? "" : code.name, word.address))
              << dialect.name << " " << code.name << " " << word.address;
        }
      }
    }
  }
}

TEST(Models, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Model* model : models()) EXPECT_TRUE(names.insert(model->name).second) << model->name;
  EXPECT_EQ(find_model("gsk.g94")->dialect, "gsk988ta");
  EXPECT_EQ(find_model("gsk.g95"), nullptr);
}

TEST(CoverCases, AnIdSaysWhatDeterminesTheCase) {
  const CoverCases made = cover_cases({find_model("gsk.g94"), {1, 1}, 3, 0, {}});
  EXPECT_EQ(made.cases.front().id.substr(0, 20), "gsk.g94.v1-t1f1-s3.0");
}

TEST(CoverCases, TheCasesOfASeedAreTheSame) {
  const Making making{find_model("ngc.line"), {2, 2}, 5, 4, {}};
  EXPECT_EQ(oracle::vector_file_text("2026.1.0", cover_cases(making).cases),
            oracle::vector_file_text("2026.1.0", cover_cases(making).cases));
}

TEST(ClauseList, SpellsOutARange) {
  EXPECT_EQ(clause_list("GSK-G94-09..11 GSK-COM-01"),
            (std::vector<std::string>{"GSK-G94-09", "GSK-G94-10", "GSK-G94-11", "GSK-COM-01"}));
}

}  // namespace
}  // namespace gonogo::cover
