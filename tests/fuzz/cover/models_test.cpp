// SPDX-License-Identifier: GPL-3.0-or-later
//
// The models as they are: what they claim is what the reference says.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fuzz/cover/cases.hpp"
#include "oracle/features.hpp"
#include "reference/clause.hpp"
#include "reference/outcome.hpp"

namespace gonogo::fuzz::cover {
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

TEST_P(EveryModel, NamesClausesFeaturesAndAlarmsThatThereAre) {
  std::set<std::string_view> clauses;
  for (const reference::Clause& clause : reference::clauses()) clauses.insert(clause.id);
  for (const std::string& clause : clause_list(model().clauses)) {
    EXPECT_TRUE(clauses.contains(clause)) << clause;
  }
  for (const Parameter& parameter : parse_parameters(model().parameters).list) {
    for (const Class& one : parameter.classes) {
      for (const std::string& alarm : one.alarms) {
        EXPECT_TRUE(reference::alarm_class(alarm).has_value()) << alarm;
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
}  // namespace gonogo::fuzz::cover
