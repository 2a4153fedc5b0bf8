// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bench that measures the hunt has to notice when it measures nothing.
#include "hunt/kill_matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

const std::vector<Method> kHunt = {Method::hunt};

MatrixOptions options(bool blind = false) {
  MatrixOptions bench;
  bench.methods = kHunt;
  bench.most_seconds = 1;
  bench.clean_programs = 300;
  bench.blind = blind;
  return bench;
}

MatrixTarget faulty(const char* fault = "taper-sign") {
  return {std::string("gsk+") + fault,
          "GSK-G94-02",
          {"gsk988ta"},
          builtin("gsk", fault),
          builtin("gsk")};
}

bool says(const std::vector<std::string>& sentences, const std::string& text) {
  return std::ranges::any_of(sentences, [&](const std::string& sentence) {
    return sentence.find(text) != std::string::npos;
  });
}

TEST(KillMatrix, AFaultIsKilledAndReduced) {
  const MatrixRow row = matrix_row(faulty(), options());
  EXPECT_TRUE(row.kills.at(Method::hunt).killed);
  EXPECT_LE(row.kills.at(Method::hunt).blocks, 3U);
  EXPECT_TRUE(complaints({row}, kHunt).empty());
}

TEST(KillMatrix, AJudgeThatAlwaysSaysGoIsNoticed) {
  const MatrixRow row = matrix_row(faulty(), options(true));
  EXPECT_TRUE(says(complaints({row}, kHunt), "hunt finds none of 1 planted faults"));
}

// Reference against reference: the expander under test never runs its fault.
TEST(KillMatrix, ASubjectThatDoesNotRunItsFaultIsNoticed) {
  MatrixTarget swapped = faulty();
  swapped.make = builtin("gsk");
  const MatrixRow row = matrix_row(swapped, options());
  EXPECT_TRUE(says(complaints({row}, kHunt), "hunt does not find gsk+taper-sign"));
}

TEST(KillMatrix, AFaultFreeExpanderThatIsNoGoIsNoticed) {
  MatrixTarget clean = faulty();
  clean.name = "gsk";
  clean.clause.clear();
  const MatrixRow row = matrix_row(clean, options());
  EXPECT_TRUE(says(complaints({matrix_row(faulty(), options()), row}, kHunt),
                   "gsk is NO-GO by hunt, and has no fault"));
}

TEST(KillMatrix, AFaultFreeExpanderThatIsGoIsNoComplaint) {
  const MatrixTarget clean{"gsk", "", {"gsk988ta"}, builtin("gsk"), builtin("gsk")};
  const MatrixRow row = matrix_row(clean, options());
  EXPECT_FALSE(row.kills.at(Method::hunt).killed);
  EXPECT_EQ(row.kills.at(Method::hunt).executions, 300U);
}

Kill kill(double seconds, std::size_t executions, std::size_t blocks) {
  return {true, executions, seconds, blocks, ""};
}

TEST(KillMatrix, TheSummaryIsOfThoseThatAreKilled) {
  const std::vector<MatrixRow> rows = {{"a", "C", {{Method::hunt, kill(1, 10, 2)}}},
                                       {"b", "C", {{Method::hunt, kill(5, 90, 4)}}},
                                       {"c", "C", {{Method::hunt, kill(2, 20, 3)}}},
                                       {"d", "C", {{Method::hunt, {}}}},
                                       {"e", "", {{Method::hunt, kill(99, 99, 99)}}}};
  const MatrixSummary summary = summary_of(rows, Method::hunt);
  EXPECT_EQ(summary.faults, 4U);
  EXPECT_EQ(summary.killed, 3U);
  EXPECT_EQ(summary.median_seconds, 2);
  EXPECT_EQ(summary.most_executions, 90U);
  EXPECT_EQ(summary.median_blocks, 3U);
}

TEST(KillMatrix, TheDocumentHasARowForEachFault) {
  const std::vector<MatrixRow> rows = {{"gsk+a", "GSK-G94-02", {{Method::hunt, kill(1, 10, 2)}}},
                                       {"gsk", "", {{Method::hunt, {false, 300, 1, 0, ""}}}}};
  const std::string text = matrix_markdown(rows, kHunt);
  EXPECT_NE(text.find("| gsk+a | GSK-G94-02 | 10 | 1.00 | 2 |"), std::string::npos) << text;
  EXPECT_NE(text.find("- gsk: 300 programs GO"), std::string::npos) << text;
}

}  // namespace
}  // namespace gonogo::hunt::testing
