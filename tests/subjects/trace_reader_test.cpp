// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/trace_reader.hpp"
#include "tests/has.hpp"

#include <gtest/gtest.h>

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::AxisSet;
using reference::FeedMode;
using reference::Plane;
using reference::Record;
using reference::RecordKind;

Record record_of(std::string_view line) {
  TraceReader reader;
  TraceLine read = reader.read(line);
  if (auto* fault = std::get_if<TraceFault>(&read)) ADD_FAILURE() << fault->message;
  return std::holds_alternative<Record>(read) ? std::get<Record>(read) : Record();
}

// The message of the fault; empty when there is none.
std::string fault_of(std::string_view line) {
  TraceReader reader;
  TraceLine read = reader.read(line);
  auto* fault = std::get_if<TraceFault>(&read);
  return fault ? fault->message : std::string();
}

#define EXPECT_FAULT(line, word) \
  EXPECT_TRUE(has(fault_of(line), word)) << (line) << " -> " << fault_of(line)

TEST(TraceReader, SaysFromWhichColumnOnALineIsNoJson) {
  EXPECT_FAULT(R"({"k":"rapid","to":{"x":5 6}})", "not JSON, from column 26 on: 6}}");
  EXPECT_FAULT(R"({"k":"rapid","to":{"x":5"}})", "has no end");  // nor has the text behind 5
  EXPECT_FAULT(R"({"k":"rapid","to":{"x":"5"})", "has no end");
  EXPECT_FAULT("G0 X5", "not JSON, from column 1 on: G0 X5");
  EXPECT_FAULT(std::string(100, '[') + std::string(100, ']'), "nests deeper than 64 levels");
}

TEST(TraceReader, ReadsAFeed) {
  const Record record =
      record_of(R"({"k":"feed","b":7,"to":{"x":"1.5","c":"-11/3"},"f":"2e2","fm":"rev"})");
  EXPECT_EQ(record.kind, RecordKind::feed);
  EXPECT_EQ(record.block, 7u);
  EXPECT_EQ(record.axes, (AxisSet{Axis::x, Axis::c}));
  EXPECT_EQ(record.to[Axis::x], Number(3) / Number(2));
  EXPECT_EQ(record.to[Axis::c], Number(-11) / Number(3));
  EXPECT_EQ(record.feed, Number(200));
  EXPECT_EQ(record.feed_mode, FeedMode::per_revolution);
}

TEST(TraceReader, ReadsAnArcWithTheCentreInTheOrderOfThePlane) {
  // G18: the pair is (Z, X).
  const Record record = record_of(
      R"({"k":"arc","plane":"G18","c":{"x":"1","z":"2"},"rot":-2,"to":{"z":"3","x":"4"},"f":"5"})");
  EXPECT_EQ(record.plane, Plane::g18);
  EXPECT_EQ(record.centre[0], Number(2));
  EXPECT_EQ(record.centre[1], Number(1));
  EXPECT_EQ(record.rot, -2);
  EXPECT_EQ(record.block, 0u);
}

TEST(TraceReader, ReadsTheOtherKinds) {
  EXPECT_EQ(record_of(R"({"k":"rapid","to":{"y":"1"}})").kind, RecordKind::rapid);
  EXPECT_EQ(record_of(R"({"k":"dwell","s":"0.25"})").seconds, Number(1) / Number(4));
  EXPECT_EQ(record_of(R"({"k":"m","m":30})").m, 30);
  const Record thread = record_of(R"({"k":"thread","to":{"z":"1"},"lead":"2","start":"90"})");
  EXPECT_EQ(thread.lead, Number(2));
  EXPECT_EQ(thread.start, Number(90));
  const Record arc3 = record_of(R"({"k":"arc3","via":{"x":"1","y":"2","z":"3"},)"
                                R"("to":{"x":"4","y":"5","z":"6"},"f":"7"})");
  EXPECT_EQ(arc3.via[Axis::z], Number(3));
  EXPECT_EQ(record_of(R"({"k":"end","to":{"x":"0","y":"0","z":"0","a":"0","c":"0"}})").axes,
            reference::kEveryAxis);
}

TEST(TraceReader, ReadsRootsAndEnclosuresAndHexFloats) {
  // 1 + 2*sqrt(2): (x - 1)^2 = 8.
  const Record record =
      record_of(R"({"k":"rapid","to":{"x":{"root":["1","2","2"]},)"
                R"("y":{"enclosure":["0.5","0.5000000000000001"]},"z":"0x1.8p1"}})");
  const Number x = record.to[Axis::x] - Number(1);
  EXPECT_EQ(x * x, Number(8));
  EXPECT_EQ(record.to[Axis::y].form(), Number::Form::enclosure);
  EXPECT_EQ(record.to[Axis::z], Number(3));
}

TEST(TraceReader, ReadsAnAlarm) {
  TraceReader reader;
  const TraceLine line =
      reader.read(R"({"k":"alarm","class":"syntax","b":3,"word":"Q","native":"P/S 61"})");
  const auto& alarm = std::get<SubjectAlarm>(line);
  EXPECT_EQ(alarm.alarm_class, "syntax");
  EXPECT_EQ(alarm.block, 3u);
  EXPECT_EQ(alarm.word, 'Q');
  EXPECT_EQ(alarm.native, "P/S 61");
}

TEST(TraceReader, IgnoresClauseAndKeysOfOnesOwnOnly) {
  record_of(R"({"k":"dwell","clause":"GSK-G94-01","x-note":{"a":[1.5,null]},"s":"1"})");
  EXPECT_FAULT(R"({"k":"dwell","s":"1","note":"a"})", "note");
  EXPECT_FAULT(R"({"k":"dwell","s":"1","f":"2"})", "\"f\"");
}

TEST(TraceReader, RefusesBareNumbers) {
  EXPECT_FAULT(R"({"k":"dwell","s":1})", "\"s\"");
  EXPECT_FAULT(R"({"k":"rapid","to":{"x":1.5}})", "\"x\"");
  EXPECT_FAULT(R"({"k":"rapid","to":{"x":null}})", "\"x\"");
  EXPECT_FAULT(R"({"k":"rapid","to":{"x":{"root":["1",2,"3"]}}})", "\"x\"");
}

TEST(TraceReader, RefusesWhatIsNoNumber) {
  for (const char* text : {"nan", "inf", "-Infinity", "", "1.2.3", "1/0", " 1", "1 mm", "1,5"}) {
    EXPECT_FAULT(std::string(R"({"k":"dwell","s":")") + text + "\"}", "\"s\"");
  }
}

TEST(TraceReader, RefusesNumbersOfMoreThanAThousandCharacters) {
  const std::string digits(1000, '7');
  record_of(R"({"k":"dwell","s":")" + digits + "\"}");
  EXPECT_FAULT(R"({"k":"dwell","s":")" + digits + "7\"}", "1000");
}

TEST(TraceReader, RefusesEnclosuresThatAreWideOrReversed) {
  EXPECT_FAULT(R"({"k":"dwell","s":{"enclosure":["0","0.0000000000000011"]}})", "wider");
  EXPECT_FAULT(R"({"k":"dwell","s":{"enclosure":["1","0"]}})", "\"s\"");
  EXPECT_EQ(fault_of(R"({"k":"dwell","s":{"enclosure":["0","1e-15"]}})"), "");
}

TEST(TraceReader, RefusesFormsThatAreNone) {
  EXPECT_FAULT(R"({"k":"dwell","s":{"root":["1","2"]}})", "\"s\"");
  EXPECT_FAULT(R"({"k":"dwell","s":{"root":["1","2","-3"]}})", "negative");
  EXPECT_FAULT(R"({"k":"dwell","s":{"power":["1","2"]}})", "power");
  EXPECT_FAULT(R"({"k":"dwell","s":{}})", "\"s\"");
}

TEST(TraceReader, RefusesDuplicateKeysAtEveryDepth) {
  EXPECT_FAULT(R"({"k":"dwell","s":"1","s":"1"})", "\"s\"");
  EXPECT_FAULT(R"({"k":"rapid","to":{"x":"1","x":"1"}})", "\"x\"");
  EXPECT_FAULT(R"({"k":"dwell","s":"1","\u0073":"1"})", "\"s\"");
  EXPECT_FAULT(R"({"k":"dwell","s":"1","x-a":[{"q":1,"q":1}]})", "\"q\"");
}

TEST(TraceReader, FindsADuplicateAmongManyKeys) {
  std::string line = R"({"k":"dwell","s":"1")";
  for (int i = 0; i < 100; ++i) line += ",\"x-" + std::to_string(i) + "\":0";
  EXPECT_EQ(fault_of(line + "}"), "");
  EXPECT_FAULT(line + ",\"x-3\":0}", "\"x-3\"");
}

TEST(TraceReader, RefusesUnknownKindsAndAxes) {
  EXPECT_FAULT(R"({"k":"probe"})", "probe");
  EXPECT_FAULT(R"({"to":{}})", "\"k\"");
  EXPECT_FAULT(R"({"k":"rapid","to":{"b":"1"}})", "\"b\"");
  EXPECT_FAULT(R"({"k":"rapid","to":{"X":"1"}})", "\"X\"");
}

TEST(TraceReader, EveryRequiredKeyIsRequired) {
  EXPECT_FAULT(R"({"k":"rapid"})", "\"to\"");
  EXPECT_FAULT(R"({"k":"feed","to":{"x":"1"}})", "\"f\"");
  EXPECT_FAULT(R"({"k":"dwell"})", "\"s\"");
  EXPECT_FAULT(R"({"k":"m"})", "\"m\"");
  EXPECT_FAULT(R"({"k":"thread","to":{},"lead":"1"})", "\"start\"");
  EXPECT_FAULT(R"({"k":"thread","to":{},"start":"1"})", "\"lead\"");
  EXPECT_FAULT(R"({"k":"arc3","to":{"x":"1","y":"1","z":"1"},"f":"1"})", "\"via\"");
  EXPECT_FAULT(R"({"k":"end"})", "\"to\"");
  EXPECT_FAULT(R"({"k":"alarm","b":3})", "class");
}

// Whoever names every class would be right with any alarm.
TEST(TraceReader, AnAlarmStandsForThreeClassesAtMost) {
  TraceReader reader;
  const auto line = reader.read(R"({"k":"alarm","class":"syntax value-sign no-tool"})");
  EXPECT_EQ(std::get<SubjectAlarm>(line).alarm_class, "syntax value-sign no-tool");
  EXPECT_FAULT(R"({"k":"alarm","class":"syntax value-sign no-tool unused-word"})", "3 classes");
}

TEST(TraceReader, AnArcNeedsBothAxesOfItsPlane) {
  EXPECT_FAULT(R"({"k":"arc","plane":"G17","c":{"x":"1"},"rot":1,"to":{"x":"1","y":"1"},"f":"1"})",
               "\"c\"");
  EXPECT_FAULT(
      R"({"k":"arc","plane":"G17","c":{"x":"1","z":"1"},"rot":1,"to":{"x":"1","y":"1"},"f":"1"})",
      "\"c\"");
  EXPECT_FAULT(R"({"k":"arc","plane":"G17","c":{"x":"1","y":"1"},"rot":1,"to":{"x":"1"},"f":"1"})",
               "axis y");
  EXPECT_FAULT(
      R"({"k":"arc","plane":"G20","c":{"x":"1","y":"1"},"rot":1,"to":{"x":"1","y":"1"},"f":"1"})",
      "plane");
}

std::string arc_with_rot(const std::string& rot) {
  return R"({"k":"arc","plane":"G17","c":{"x":"1","y":"1"},"rot":)" + rot +
         R"(,"to":{"x":"1","y":"1"},"f":"1"})";
}

TEST(TraceReader, RotIsANonzeroIntegerBelowTwoToTheThirtyOne) {
  EXPECT_EQ(record_of(arc_with_rot("2147483647")).rot, 2147483647);
  EXPECT_EQ(record_of(arc_with_rot("-2147483647")).rot, -2147483647);
  for (const char* rot : {"0", "2147483648", "-2147483648", "1.0", "\"1\"", "true", "1e0"}) {
    EXPECT_FAULT(arc_with_rot(rot), "\"rot\"");
  }
}

TEST(TraceReader, BlocksAreIntegersFromOne) {
  for (const char* b : {"0", "-1", "1.0", "\"1\"", "18446744073709551615"}) {
    EXPECT_FAULT(std::string(R"({"k":"dwell","s":"1","b":)") + b + "}", "\"b\"");
  }
}

TEST(TraceReader, FeedModeIsMinOrRev) {
  EXPECT_EQ(record_of(R"({"k":"feed","to":{"x":"1"},"f":"1","fm":"min"})").feed_mode,
            FeedMode::per_minute);
  EXPECT_FAULT(R"({"k":"feed","to":{"x":"1"},"f":"1","fm":"inv"})", "fm");
}

TEST(TraceReader, RefusesWhatIsNotOneJsonObject) {
  for (const char* line :
       {"", " ", "[]", "1", "{", "{}}", "{} {}", "{'k':1}", R"({"k":"dwell","s":"1",})",
        "{\"k\":\"\xFF\"}", "nul", R"({"k":"dwell","s":"1","x-a":NaN})"}) {
    EXPECT_NE(fault_of(line), "") << line;
  }
}

TEST(TraceReader, NestingIsBounded) {
  auto nested = [](std::size_t depth) {
    return R"({"k":"dwell","s":"1","x-a":)" + std::string(depth, '[') + std::string(depth, ']') +
           "}";
  };
  EXPECT_EQ(fault_of(nested(50)), "");
  EXPECT_NE(fault_of(nested(70)), "");
  EXPECT_NE(fault_of(nested(1'000'000)), "");
}

TEST(TraceReader, GoesOnAfterAFaultAndAfterALongLine) {
  TraceReader reader;
  EXPECT_TRUE(std::holds_alternative<TraceFault>(reader.read("{")));
  const std::string longest =
      R"({"k":"dwell","s":"1","x-a":")" + std::string(5'000'000, 'a') + "\"}";
  EXPECT_TRUE(std::holds_alternative<Record>(reader.read(longest)));
  EXPECT_TRUE(std::holds_alternative<Record>(reader.read(R"({"k":"dwell","s":"1"})")));
}

}  // namespace
}  // namespace gonogo::oracle
