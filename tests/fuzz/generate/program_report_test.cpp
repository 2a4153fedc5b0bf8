// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/program_report.hpp"

#include <gtest/gtest.h>

namespace gonogo::generate {
namespace {

GeneratedProgram for_defaults(std::string_view dialect, std::string text) {
  return {std::get<reference::Profile>(reference::default_profile(dialect)), std::move(text)};
}

TEST(ProgramReport, CountsRecordsPlanesAndClauses) {
  Distribution counts;
  // A traverse, a feed, and an arc in each of two planes.
  count_program(for_defaults("rs274", "G0 X1\nG1 X2 F100\nG17 G2 X4 I1\nG18 G2 X6 I1\nM2\n"),
                counts);
  EXPECT_EQ(counts["programs"], 1U);
  EXPECT_EQ(counts["blocks"], 5U);
  EXPECT_EQ(counts["record rapid"], 1U);
  EXPECT_EQ(counts["record feed"], 1U);
  EXPECT_EQ(counts["record arc"], 2U);
  EXPECT_EQ(counts["arc plane G17"], 1U);
  EXPECT_EQ(counts["arc plane G18"], 1U);
  EXPECT_EQ(counts.count("arc plane G19"), 0U);
  EXPECT_EQ(counts["program ends"], 1U);
  EXPECT_EQ(counts["machine: of defaults"], 1U);
  EXPECT_EQ(counts.count("programs without motion or alarm"), 0U);
}

TEST(ProgramReport, CountsAlarmsByClassAndProgramsThatShowNothing) {
  Distribution counts;
  count_program(for_defaults("rs274", "G1 X2\n"), counts);
  EXPECT_EQ(counts["alarm feed-missing"], 1U);
  EXPECT_EQ(counts["refused by NGC-G0-01 feed-missing"], 1U);
  EXPECT_EQ(counts["program alarms"], 1U);
  EXPECT_EQ(counts.count("programs without motion or alarm"), 0U);
  count_program(for_defaults("rs274", "G90 M2\n"), counts);
  EXPECT_EQ(counts["programs without motion or alarm"], 1U);
}

TEST(ProgramReport, CountsWhatAMachineHas) {
  GeneratedProgram program = for_defaults("hnc21t", "G00 X1\n");
  program.profile.offsets["G55"][reference::Axis::x] = 5;
  program.profile.parameters["3410"] = 1;
  program.profile.x_diameter = false;
  Distribution counts;
  count_program(program, counts);
  EXPECT_EQ(counts["machine: offset G55"], 1U);
  EXPECT_EQ(counts["machine: parameter 3410"], 1U);
  EXPECT_EQ(counts["machine: X a radius"], 1U);
  EXPECT_EQ(counts.count("machine: of defaults"), 0U);
}

TEST(ProgramReport, GeneratedProgramsReachEveryPlaneAndManyAlarmsInEveryDialect) {
  for (const Generator& generator : generators()) {
    Distribution counts;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
      Choices choices(seed);
      count_program(generator.generate(choices, &counts), counts);
    }
    std::size_t alarm_classes = 0;
    std::size_t readings = 0;
    for (const auto& [what, times] : counts) {
      alarm_classes += what.starts_with("alarm ") ? 1U : 0U;
      readings += what.starts_with("reading ") ? 1U : 0U;
    }
    EXPECT_GE(alarm_classes, 6U) << generator.dialect;
    EXPECT_GE(readings, 4U) << generator.dialect;
    // A lathe without Y has one plane.
    for (const char* plane : {"arc plane G17", "arc plane G19"}) {
      EXPECT_EQ(counts.contains(plane), generator.dialect != "hnc21t") << generator.dialect;
    }
    EXPECT_TRUE(counts.contains("arc plane G18")) << generator.dialect;
    EXPECT_EQ(counts.contains("machine: offset G54"), generator.dialect == "hnc21t");
    EXPECT_EQ(counts.contains("machine: tool 1"), generator.dialect == "sinumerik802s");
    EXPECT_LT(counts["programs without motion or alarm"], 20U) << generator.dialect;
  }
}

TEST(ProgramReport, IsALineANameWithItsPartOfThePrograms) {
  const std::string text = distribution_text({{"programs", 4}, {"record feed", 6}});
  EXPECT_NE(text.find("record feed"), std::string::npos);
  EXPECT_NE(text.find("1.5000"), std::string::npos);
}

}  // namespace
}  // namespace gonogo::generate
