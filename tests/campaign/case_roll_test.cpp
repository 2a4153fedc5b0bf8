// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/case_roll.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "reference/dialect.hpp"

namespace gonogo::oracle {
namespace {

using Json = ResultsReader::Json;

// J-RUN-13: what a line must hold, so that its verdict can be derived again.
TEST(LineFault, IsOfALineThatIsNeitherGoNorSkippedWithoutProgramOrTrace) {
  Case test;
  test.id = "hnc.basic.000001";
  test.dialect = "hnc21t";
  test.cycle = "basic";
  test.program = "M30\n";
  test.profile = std::get<reference::Profile>(reference::default_profile("hnc21t"));
  Json line =
      Json::parse(R"({"id":"hnc.basic.000001","dialect":"hnc21t","cycle":"basic","clauses":[],)"
                  R"("program":"M30\n","trace":[]})");
  Json without_program = line;
  without_program.erase("program");
  Json without_trace = line;
  without_trace.erase("trace");
  for (const char* verdict : {"xfail", "xpass", "advice", "oracle-gap", "fail.geometry", "crash"}) {
    line["verdict"] = without_program["verdict"] = without_trace["verdict"] = verdict;
    EXPECT_EQ(line_fault(test, line), "") << verdict;
    EXPECT_NE(line_fault(test, without_program), "") << verdict;
    EXPECT_NE(line_fault(test, without_trace), "") << verdict;
  }
  for (const char* verdict : {"pass-exact", "skip"}) {
    without_program["verdict"] = verdict;
    without_program.erase("trace");
    EXPECT_EQ(line_fault(test, without_program), "") << verdict;
  }
}

}  // namespace
}  // namespace gonogo::oracle
