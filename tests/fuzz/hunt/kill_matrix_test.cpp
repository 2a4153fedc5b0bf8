// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bench that measures the hunt has to notice when it measures nothing.
#include "fuzz/hunt/kill_matrix.hpp"

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
          builtin("gsk"),
          {},
          [fault] { return expanders::count("gsk", fault).value().reached; }};
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

TEST(KillMatrix, AFaultIsReachedBeforeItIsTriggeredAndTriggeredBeforeItIsKilled) {
  const Kill kill = matrix_row(faulty(), options()).kills.at(Method::hunt);
  EXPECT_GE(kill.reached, 1U);
  EXPECT_GE(kill.triggered, kill.reached);
  EXPECT_GE(kill.executions, kill.triggered);
}

TEST(KillMatrix, AKillWithoutATriggerIsNoticed) {
  const MatrixRow row{"gsk+a", "GSK-G94-02", {{Method::hunt, {true, 10, 1, 2, "why"}}}};
  EXPECT_TRUE(says(complaints({row}, kHunt), "no answer differed"));
}

TEST(KillMatrix, AJudgeThatAlwaysSaysGoIsNoticed) {
  const MatrixRow row = matrix_row(faulty(), options(true));
  EXPECT_TRUE(says(complaints({row}, kHunt), "hunt finds none of 1 planted faults"));
  // It is the judge that is to blame, and the row says so.
  EXPECT_GE(row.kills.at(Method::hunt).triggered, 1U);
  EXPECT_FALSE(row.kills.at(Method::hunt).killed);
  EXPECT_EQ(summary_of({row}, Method::hunt).triggered, 1U);
  EXPECT_EQ(summary_of({row}, Method::hunt).killed, 0U);
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
  return {true, executions, seconds, blocks, "", 1, executions};
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
  EXPECT_NE(text.find("| gsk+a | GSK-G94-02 | 1 | 10 | 10 | 1.00 | 2 |"), std::string::npos)
      << text;
  EXPECT_NE(text.find("- gsk: 300 programs GO"), std::string::npos) << text;
}

TEST(KillMatrix, FieldDefectsHaveATableOfTheirOwn) {
  MatrixRow reported{"ngc+a", "NGC-CYC-12", {{Method::hunt, kill(1, 10, 2)}}};
  reported.what = "goes there at once";
  reported.report = "https://github.com/acme/control/pull/7";
  const MatrixRow other{"ngc+b", "NGC-CYC-12", {{Method::hunt, kill(2, 20, 2)}}};
  const std::string text = field_defects_markdown({reported, other}, kHunt);
  EXPECT_NE(text.find("| ngc+a | goes there at once | "
                      "[acme/control#7](https://github.com/acme/control/pull/7) | 10 | 1.000 |"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("ngc+b"), std::string::npos);
  EXPECT_EQ(field_defects_markdown({other}, kHunt), "");
}

}  // namespace
}  // namespace gonogo::hunt::testing
