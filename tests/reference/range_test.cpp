// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/range.hpp"
#include "reference/reading_literal.hpp"

#include <gtest/gtest.h>

#include "grammar/line_source.hpp"
#include "reference/expander.hpp"

namespace gonogo::reference {
namespace {

// How a program ends: "end", "value-out-of-range@2", "not covered@2 range".
std::string end_of(std::string_view dialect, std::string_view program) {
  auto profile = std::get<Profile>(default_profile(dialect));
  profile.readings.set("ngc.program-end=free"_reading);
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  Expander expander(profile, lines, OpenPaths::shown);
  std::string end;
  while (const Item* item = expander.next()) {
    if (const auto* report = std::get_if<AlarmReport>(item)) {
      end = std::string(name(report->alarms.front().alarm)) + "@" + std::to_string(report->block);
    } else if (const auto* stop = std::get_if<NotCovered>(item)) {
      end = "not covered@" + std::to_string(stop->block) + " " + stop->code;
    } else if (const auto* record = std::get_if<Record>(item)) {
      if (record->kind == RecordKind::end) end = "end";
    }
  }
  return end;
}

constexpr std::string_view kDialects[] = {"gsk988ta", "hnc21t", "rs274", "sinumerik840d",
                                          "sinumerik802s"};

TEST(Range, SevenDigitsBeforeThePointAreCoveredAndEightAreNot) {
  for (const std::string_view dialect : kDialects) {
    EXPECT_EQ(end_of(dialect, "G00 X10\nX9999999.999"), "end") << dialect;
    EXPECT_EQ(end_of(dialect, "G00 X10\nX-10000000"), "not covered@2 range") << dialect;
    EXPECT_EQ(end_of(dialect, "G00 X10\nX10000000.5"), "not covered@2 range") << dialect;
  }
}

TEST(Range, ZerosBeforeANumberDoNotMatter) {
  for (const std::string_view dialect : kDialects) {
    EXPECT_EQ(end_of(dialect, "G01 X1 F000000000000000000001"), "end") << dialect;
    EXPECT_EQ(end_of(dialect, "G01 X1 F900000000000000000000"), "not covered@1 range") << dialect;
    EXPECT_EQ(end_of(dialect, "G01 X0.00000000000000000000001 F1"), "end") << dialect;
  }
}

// Ten steps of 9.9 km each: the eleventh leaves the 100 km that a place may be away.
TEST(Range, ASumOfWordsHasARangeToo) {
  std::string program = "G91 G0 X9900000\n";
  for (int i = 0; i < 9; ++i) program += "X9900000\n";
  EXPECT_EQ(end_of("rs274", program), "end");
  EXPECT_EQ(end_of("rs274", program + "X9900000\n"), "not covered@11 range");
}

// GSK-COM-06: the table of the milling cycles ends at 999,999.999 mm.
TEST(Range, WhereTheManualNamesARangeItIsAnAlarm) {
  EXPECT_EQ(end_of("gsk988ta", "G17 G110 X0 Y0 Z-10000000 I16 L3 Q5 D4 F100"),
            "value-out-of-range@1");
}

TEST(Range, ValuesOfExpressionsHaveTheRangeAndRParametersHaveNot) {
  EXPECT_EQ(end_of("sinumerik840d", "R1=9999*9999\nG0 X=R1/9999"), "end");
  EXPECT_EQ(end_of("sinumerik840d", "R1=9999*9999\nG0 X=R1"), "not covered@2 range");
  EXPECT_EQ(end_of("sinumerik802s", "R104=-9999*9999 R101=5\nF9 LCYC82"), "conflicting-words@2");
  EXPECT_EQ(end_of("sinumerik802s", "R104=-9999*9999 R101=5 F9\nLCYC82"), "not covered@2 range");
}

// No text says where the M functions of these end; those of the 840D have 31 bits.
TEST(Range, LargeMFunctionsAreNotCoveredWhereNoTextEndsThem) {
  EXPECT_EQ(end_of("gsk988ta", "M9999"), "end");
  EXPECT_EQ(end_of("gsk988ta", "M10000"), "not covered@1 M10000");
  EXPECT_EQ(end_of("hnc21t", "M2147483647"), "not covered@1 M2147483647");
  EXPECT_EQ(end_of("hnc21t", "M2147483648"), "value-out-of-range@1");
  EXPECT_EQ(end_of("sinumerik802s", "M99"), "end");
  EXPECT_EQ(end_of("sinumerik802s", "M100"), "not covered@1 M100");
  EXPECT_EQ(end_of("sinumerik840d", "M2147483647"), "end");
}

TEST(Range, CodesAndToolsAreNoLengths) {
  EXPECT_EQ(end_of("rs274", "G99999999"), "undefined-code@1");
  EXPECT_EQ(end_of("rs274", "T99999999 G0 X1"), "end");
  EXPECT_EQ(end_of("rs274", "M600000000000000000000"),
            "undefined-code@1");  // whole, not a fraction
}

}  // namespace
}  // namespace gonogo::reference
