// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/operation_hunt.hpp"

#include <gtest/gtest.h>

#include "fuzz/hunt/kill_matrix.hpp"
#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

OperationHunt hunt_of(std::vector<OperationHunt::Named> subjects, std::string dialect = {}) {
  OperationOptions options;
  if (!dialect.empty()) options.dialects.push_back(std::move(dialect));
  return {std::move(subjects), std::move(options)};
}

std::vector<OperationFinding> findings(OperationHunt& hunt, std::size_t lists) {
  std::vector<OperationFinding> all;
  for (std::size_t i = 0; i < lists; ++i) {
    for (OperationFinding& finding : hunt.step()) all.push_back(std::move(finding));
  }
  return all;
}

TEST(OperationHunt, FindsNothingBetweenExpandersOfAllDialects) {
  OperationHunt hunt = hunt_of({{"gsk", builtin("gsk")},
                                {"hnc", builtin("hnc")},
                                {"sinumerik", builtin("sinumerik")},
                                {"ngc", builtin("ngc")}});
  EXPECT_EQ(hunt.ways().size(), 10U);
  for (const OperationFinding& finding : findings(hunt, 300)) {
    ADD_FAILURE() << finding.signature() << "\n" << finding.second.text << finding.breakdown;
  }
  EXPECT_GT(hunt.count().pairs, 1'000U);
  EXPECT_EQ(hunt.count().skipped, 0U);
}

bool any_of_rule(const std::vector<OperationFinding>& found, relations::Rule rule) {
  return std::ranges::any_of(found, [&](const OperationFinding& finding) {
    return finding.breach && finding.breach->rule == rule;
  });
}

// A taper with the other sign is a sound path: only another dialect, or the same without the cycle,
// shows it.
TEST(OperationHunt, FindsWhatOneDialectDoesOtherwise) {
  OperationHunt hunt = hunt_of({{"hnc", builtin("hnc")}, {"gsk", builtin("gsk", "taper-sign")}});
  const auto found = findings(hunt, 60);
  ASSERT_FALSE(found.empty());
  for (const OperationFinding& finding : found) {
    EXPECT_EQ(finding.second.subject, "gsk") << finding.signature();
    EXPECT_TRUE(finding.second.notation.has_cycles);
    EXPECT_EQ(finding.list.operations.size(), 1U) << "made small";
  }
}

TEST(OperationHunt, FindsWhatIsUnsafeInOneDialectAlone) {
  struct Case {
    const char* fault;
    relations::Rule rule;
  };
  for (const Case& each : {Case{"g98-retracts-to-r", relations::Rule::retract_level},
                           Case{"g83-without-pecks", relations::Rule::peck_too_deep}}) {
    OperationHunt hunt = hunt_of({{"ngc", builtin("ngc", each.fault)}});
    EXPECT_TRUE(any_of_rule(findings(hunt, 200), each.rule)) << each.fault;
  }
  OperationHunt gsk = hunt_of({{"gsk", builtin("gsk", "rapid-retract")}});
  EXPECT_TRUE(any_of_rule(findings(gsk, 100), relations::Rule::traverse_in_stock));
}

TEST(OperationHunt, IsAMethodOfTheKillMatrix) {
  MatrixOptions options;
  options.methods = {Method::operations};
  options.most_seconds = 2;
  options.clean_programs = 50;
  MatrixTarget faulty{
      "gsk+taper-sign", "GSK-G94-02", {"gsk988ta"}, builtin("gsk", "taper-sign"), builtin("gsk")};
  faulty.peers = {builtin("hnc")};
  const MatrixTarget sound{"gsk", "", {"gsk988ta"}, builtin("gsk"), builtin("gsk")};
  EXPECT_TRUE(matrix_row(faulty, options).kills.at(Method::operations).killed);
  EXPECT_FALSE(matrix_row(sound, options).kills.at(Method::operations).killed);
  options.blind = true;
  EXPECT_FALSE(matrix_row(faulty, options).kills.at(Method::operations).killed);
}

TEST(OperationHunt, IsRepeatedByItsSeed) {
  const auto signatures = [] {
    OperationHunt hunt = hunt_of({{"gsk", builtin("gsk", "taper-sign")}});
    std::vector<std::string> all;
    for (const OperationFinding& finding : findings(hunt, 50)) all.push_back(finding.signature());
    return all;
  };
  EXPECT_EQ(signatures(), signatures());
  EXPECT_FALSE(signatures().empty());
}

TEST(OperationHunt, ASubjectWithoutTheDialectHasNoWayToWrite) {
  EXPECT_TRUE(hunt_of({{"gsk", builtin("gsk")}}, "rs274").ways().empty());
}

}  // namespace
}  // namespace gonogo::hunt::testing
