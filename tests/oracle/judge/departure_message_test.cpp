// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CMP-12: a NO-GO names the motion that departs first and how far it is from where it
// may lead, not what follows from it. The numbers are by hand.
#include <gtest/gtest.h>

#include "judging.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/catalog/clause.hpp"

namespace gonogo::oracle {
namespace {

Judging of(std::string_view dialect, std::string_view resolution = {}) {
  Judging judging;
  judging.dialect = dialect;
  judging.resolution = resolution;
  return judging;
}

struct Expected {
  VerdictKind kind;
  std::size_t record;
  std::string_view clause;
  std::string_view deviation;  // exact
  std::string_view message = {};
};

void expect(const Verdict& verdict, const Expected& expected) {
  EXPECT_EQ(verdict.kind, expected.kind) << verdict.message;
  EXPECT_EQ(verdict.record, expected.record) << verdict.message << verdict.got;
  EXPECT_EQ(reference::clause_name(verdict.clause), expected.clause);
  EXPECT_EQ(verdict.deviation_exact, expected.deviation) << verdict.message;
  if (!expected.message.empty()) {
    EXPECT_EQ(verdict.message, expected.message);
  }
}

constexpr std::string_view kTraverseShort = "The traverse ends before it is where it has to end.";
constexpr std::string_view kCutShort = "The cut ends before it is where it has to end.";
constexpr std::string_view kTurning = "G00 X130 Z5\nG01 Z-28 F100\n";

TEST(DepartureMessage, ATraverseATenthShortIsNamedAndNotTheCutBehindIt) {
  TraceText trace(1);
  trace.rapid({{'x', 65}, {'z', 4.9}}).block(2, 100).feed({{'z', -28}});
  const Verdict verdict = judge_trace(kTurning, trace.text());
  expect(verdict, {VerdictKind::fail_geometry, 0, "GSK-COM-05", "0.1", kTraverseShort});
  EXPECT_EQ(verdict.block, 1U);
  EXPECT_EQ(verdict.witness, R"({"x":"65","y":"0","z":"4.9"})");
}

TEST(DepartureMessage, OfATraverseInPiecesTheLastIsNamed) {
  TraceText trace(1);
  trace.rapid({{'x', 65}}).rapid({{'z', 4}}).rapid({{'z', 4.7}}).block(2, 100).feed({{'z', -28}});
  expect(judge_trace(kTurning, trace.text()),
         {VerdictKind::fail_geometry, 2, "GSK-COM-05", "0.3", kTraverseShort});
}

// The cut behind it ends 0.1 from where the traverse has to end, as much as the traverse is short.
TEST(DepartureMessage, AShortTraverseBeforeAsShortACutIsNamed) {
  TraceText trace(1);
  trace.rapid({{'x', 65}, {'z', 4.9}}).block(2, 100).feed({{'z', 4.9}, {'x', 60}});
  expect(judge_trace("G00 X130 Z5\nG01 Z4.9 X120 F100\n", trace.text()),
         {VerdictKind::fail_geometry, 0, "GSK-COM-05", "0.1", kTraverseShort});
}

TEST(DepartureMessage, ACutThatStandsInForTheRestOfATraverseIsOfAnotherKind) {
  TraceText trace(1, 100);
  trace.rapid({{'x', 65}, {'z', 2}}).feed({{'z', 5}}).block(2, 100).feed({{'z', -28}});
  expect(judge_trace(kTurning, trace.text()),
         {VerdictKind::fail_geometry, 1, "GSK-COM-05", "", "The motion is of another kind."});
}

constexpr std::string_view kLine = "G17 G21 G90 G94\nG1 X50 F100\nG1 Y10\n";

TEST(DepartureMessage, AHundredthBesideALineIsToldAndNotTheWayStillToGo) {
  TraceText trace(2, 100);
  trace.feed({{'x', 25}, {'y', 0.01}}).feed({{'x', 50}, {'y', 0}}).block(3, 100).feed({{'y', 10}});
  const Verdict verdict = judge_trace(kLine, trace.text(), of("rs274"));
  expect(verdict,
         {VerdictKind::fail_geometry, 0, "NGC-G0-01", "0.01", "The cut does not end on the line."});
  EXPECT_EQ(verdict.witness, R"({"x":"25","y":"0.01","z":"0"})");
}

// From (0, 0) to (30, 10). At (15, 6), with t along the line, |15 - 30 t| = |6 - 10 t| is least at
// t = 21/40: 3/4.
TEST(DepartureMessage, BesideASlantingLineTheNearestPointOfItCounts) {
  TraceText trace(2, 100);
  trace.feed({{'x', 15}, {'y', 6}});
  expect(judge_trace("G17 G21 G90 G94\nG1 X30 Y10 F100\n", trace.text(), of("rs274")),
         {VerdictKind::fail_geometry, 0, "NGC-G0-01", "0.75"});
}

TEST(DepartureMessage, BeyondTheEndOfALineIsMeasuredFromItsEnd) {
  TraceText trace(2, 100);
  trace.feed({{'x', 50.25}}).block(3, 100).feed({{'y', 10}});
  expect(judge_trace(kLine, trace.text(), of("rs274")),
         {VerdictKind::fail_geometry, 0, "NGC-G0-01", "0.25"});
}

TEST(DepartureMessage, BackAlongALineIsMeasuredFromWhereTheCutHasBeen) {
  TraceText trace(2, 100);
  trace.feed({{'x', 25}}).feed({{'x', 22}}).feed({{'x', 50}});
  expect(judge_trace(kLine, trace.text(), of("rs274")),
         {VerdictKind::fail_geometry, 1, "NGC-G0-01", "3", "The cut goes back along the line."});
}

TEST(DepartureMessage, ACutShortOfACornerIsNamedByTheRecordThatEndsThere) {
  TraceText trace(2, 100);
  trace.feed({{'x', 25}}).feed({{'x', 49.9}}).block(3, 100).feed({{'y', 10}});
  expect(judge_trace(kLine, trace.text(), of("rs274")),
         {VerdictKind::fail_geometry, 1, "NGC-G0-01", "0.1", kCutShort});
}

TEST(DepartureMessage, ATraceThatStopsWithinAMotionNamesItsLastRecord) {
  TraceText trace(2, 100);
  trace.feed({{'x', 30}});
  const Verdict verdict = judge_trace("G17 G21 G90 G94\nG1 X50 F100\n", trace.text(), of("rs274"));
  expect(verdict, {VerdictKind::fail_geometry, 0, "NGC-G0-01", "20", kCutShort});
}

TEST(DepartureMessage, ADwellBehindAShortMotionIsNotWhatDeparts) {
  TraceText trace(2, 100);
  trace.feed({{'x', 49.5}}).line(R"({"k":"dwell","b":3,"s":"1"})");
  expect(judge_trace("G17 G21 G90 G94\nG1 X50 F100\nG4 P1\n", trace.text(), of("rs274")),
         {VerdictKind::fail_geometry, 0, "NGC-G0-01", "0.5", kCutShort});
}

TEST(DepartureMessage, ADwellThatIsNotDueIsWhatDeparts) {
  TraceText trace(2, 100);
  trace.feed({{'x', 25}}).line(R"({"k":"dwell","b":2,"s":"1"})").feed({{'x', 50}});
  const Verdict verdict = judge_trace(kLine, trace.text(), of("rs274"));
  expect(verdict, {VerdictKind::fail_geometry, 1, "NGC-G0-01", "",
                   "The subject dwells where no dwell is due."});
}

// A helix of one turn of radius 10 about (10, 0), 12 mm down; half way it is 6 mm down.
constexpr std::string_view kHelix = "G17 G21 G90 G94\nG2 X0 Y0 Z-12 I10 F100\n";

// R2.
TEST(DepartureMessage, AHelixOffByHalfAMicrometreIsToldByThatMuch) {
  TraceText trace(2, 100);
  trace.arc("G17", {{'x', 10}, {'y', 0}}, -1, {{'x', 20}, {'y', 0}, {'z', -6.0005}});
  expect(judge_trace(kHelix, trace.text(), of("rs274", "0.0001")),
         {VerdictKind::fail_geometry, 0, "NGC-ARC-05", "0.0005", "The arc ends off the curve."});
}

TEST(DepartureMessage, AnArcThatEndsOffItsCircleIsToldByItsRadius) {
  TraceText trace(2, 100);
  trace.arc("G17", {{'x', 10}, {'y', 0}}, -1, {{'x', 10}, {'y', 10.25}, {'z', -3}});
  expect(judge_trace(kHelix, trace.text(), of("rs274")),
         {VerdictKind::fail_geometry, 0, "NGC-ARC-05", "0.25", "The arc ends off the curve."});
}

// At the angle of its end, half a millimetre too deep.
TEST(DepartureMessage, AHelixThatIsOffInDepthAloneDoesNotGoBeyondItsEnd) {
  TraceText trace(2, 100);
  trace.arc("G17", {{'x', 10}, {'y', 0}}, -1, {{'x', 0}, {'y', 0}, {'z', -12.5}});
  expect(judge_trace(kHelix, trace.text(), of("rs274")),
         {VerdictKind::fail_geometry, 0, "NGC-ARC-05", "0.5", "The arc ends off the curve."});
}

TEST(DepartureMessage, AHelixThatStopsAQuarterTurnShortIsNamed) {
  TraceText trace(2, 100);
  trace.arc("G17", {{'x', 10}, {'y', 0}}, -1, {{'x', 10}, {'y', -10}, {'z', -9}});
  trace.block(3, 0).rapid({{'z', 5}});
  expect(judge_trace(std::string(kHelix) + "G0 Z5\n", trace.text(), of("rs274")),
         {VerdictKind::fail_geometry, 0, "NGC-ARC-05", "10", kCutShort});
}

// A quarter turn from (10, 0) to (0, 10) about the origin, gone the other way round: after 135 of
// its 270 degrees it stands at (-5 sqrt(2), -5 sqrt(2)), and both ends of the right one are 10 + 5
// sqrt(2) away along an axis.
TEST(DepartureMessage, AnArcTheWrongWayIsMarkedWhereItIsFarthestOff) {
  TraceText trace(2, 100);
  trace.arc("G17", {{'x', 0}, {'y', 0}}, -1, {{'x', 0}, {'y', 10}});
  Judging judging = of("rs274");
  const std::string start = R"({"k":"rapid","b":1,"to":{"x":"10"}})"
                            "\n";
  const Verdict verdict =
      judge_trace("G0 X10\nG3 X0 Y10 I-10 F100\nM2\n", start + trace.text(), judging);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.witness,
            R"({"x":{"root":["0","-5","2"]},"y":{"root":["0","-5","2"]},"z":"0"})");
  EXPECT_EQ(verdict.deviation_mm, "17.071067812");
}

// The same circle the other way: after a quarter of a turn they are on opposite sides of it.
TEST(DepartureMessage, ACircleTheWrongWayIsMarkedAcrossIt) {
  TraceText trace(2, 100);
  trace.arc("G17", {{'x', 0}, {'y', 0}}, -1, {{'x', 10}, {'y', 0}});
  const std::string start = R"({"k":"rapid","b":1,"to":{"x":"10"}})"
                            "\n";
  const Verdict verdict =
      judge_trace("G0 X10\nG3 I-10 F100\nM2\n", start + trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.witness, R"({"x":"0","y":"-10","z":"0"})");
  EXPECT_EQ(verdict.deviation_mm, "20");
}

// From (8, 6) to (6, 8) about the origin, gone the other way round by (10, 0), (0, -10), (-10, 0)
// and (0, 10). From (-10, 0) all of the right arc is at least 16 away along X, and none of the
// points that lie 45 degrees apart from the start is as far off.
TEST(DepartureMessage, AnArcTheWrongWayIsMarkedBesideItsCentre) {
  TraceText trace(2, 100);
  trace.arc("G17", {{'x', 0}, {'y', 0}}, -1, {{'x', 6}, {'y', 8}});
  const std::string start = R"({"k":"rapid","b":1,"to":{"x":"8","y":"6"}})"
                            "\n";
  const Verdict verdict =
      judge_trace("G0 X8 Y6\nG3 X6 Y8 I-8 J-6 F100\nM2\n", start + trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.witness, R"({"x":"-10","y":"0","z":"0"})");
  EXPECT_EQ(verdict.deviation_mm, "16");
}

TEST(DepartureMessage, ARotaryAxisDepartsInDegrees) {
  TraceText trace(1, 100);
  trace.line(R"({"k":"rapid","b":1,"to":{"x":"10","a":"45"}})");
  const Verdict verdict = judge_trace("G0 X10 A30\nM2\n", trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.deviation_mm, "");
  EXPECT_NE(verdict.message.find("The axis A is at 45 degrees in place of 30."), std::string::npos)
      << verdict.message;
}

// X is 1 mm off, A 80 degrees: no distance has both.
TEST(DepartureMessage, LinearAndRotaryAxesDepartEachInItsUnit) {
  TraceText trace(2, 100);
  trace.line(R"({"k":"feed","b":2,"to":{"x":"11","a":"110"},"f":"100"})");
  const Verdict verdict = judge_trace("G0 X0\nG1 X10 A30 F100\nM2\n", trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.deviation_mm, "1");
  EXPECT_NE(verdict.message.find("The axis A is at 110 degrees in place of 30."), std::string::npos)
      << verdict.message;
}

TEST(DepartureMessage, TheEndHasARotaryAxisInDegrees) {
  TraceText trace(1, 100);
  trace.line(R"({"k":"rapid","b":1,"to":{"x":"10","a":"30"}})");
  trace.line(R"({"k":"end","to":{"x":"10","y":"0","z":"0","a":"45"}})");
  const Verdict verdict = judge_trace("G0 X10 A30\nM2\n", trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.deviation_mm, "");
  EXPECT_EQ(verdict.message,
            "The end position differs. The axis A is at 45 degrees in place of 30.");
}

TEST(DepartureMessage, ALeadThatDiffersHasBothValues) {
  TraceText trace(1);
  trace.rapid({{'x', 65}, {'z', 5}}).block(3, 0);
  trace.line(R"({"k":"thread","b":3,"to":{"z":"-28"},"lead":"1.75","start":"0"})");
  const Verdict verdict =
      judge_trace("G00 X130 Z5\nM03 S100\nG32 Z-28 F1.5\nM30\n", trace.text(), of("hnc21t"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_feed) << verdict.message;
  EXPECT_EQ(verdict.message, "The lead differs. It is 1.75 mm in place of 1.5.");
}

// The cut along Z is left out. What comes instead ends 5 mm beside it.
TEST(DepartureMessage, WhatComesInsteadOfAMotionThatIsLeftOutIsNamed) {
  TraceText trace(1);
  trace.rapid({{'x', 65}, {'z', 5}}).block(2, 100).feed({{'x', 70}});
  expect(judge_trace("G00 X130 Z5\nG01 Z-28 F100\nX140\n", trace.text()),
         {VerdictKind::fail_geometry, 1, "GSK-COM-05", "5", "The cut does not end on the line."});
}

// The traverse away and back is left out: the cut is the one that the reference makes behind it.
TEST(DepartureMessage, AMotionThatFitsLaterIsOutOfOrder) {
  TraceText trace(1);
  trace.rapid({{'x', 65}, {'z', 5}}).block(4, 100).feed({{'z', -28}});
  Judging judging;
  judging.blocks = false;
  const Verdict verdict =
      judge_trace("G00 X130 Z5\nG00 X200\nG00 X130\nG01 Z-28 F100\n", trace.text(), judging);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_order);
  EXPECT_EQ(verdict.record, 1U);
  EXPECT_EQ(verdict.message,
            "A later motion comes here: one before it is missing, or comes after it.");
}

constexpr const char* kCutAndTraverse = "G00 X130 Z5\nG01 Z-28 F100\nG00 X140\n";

// Lines 1 and 2 as they are due, a traverse back that no block asks for, and the one of line 3.
TraceText one_too_many() {
  TraceText trace(1);
  trace.rapid({{'x', 65}, {'z', 5}}).block(2, 100).feed({{'z', -28}});
  return trace.rapid({{'z', 5}});
}

TEST(DepartureMessage, AMotionTooManyIsOfTheBlockThatMadeIt) {
  const TraceText trace = one_too_many().block(3, 0).rapid({{'x', 70}});
  EXPECT_EQ(judge_trace(kCutAndTraverse, trace.text()).block, 2U);
}

TEST(DepartureMessage, WithoutLinesTheNextRecordShowsAMotionTooMany) {
  Judging judging;
  judging.blocks = false;
  const TraceText shown = one_too_many().rapid({{'x', 70}});
  EXPECT_EQ(judge_trace(kCutAndTraverse, shown.text(), judging).block, 2U);
  const TraceText elsewhere = one_too_many().rapid({{'x', 71}});
  EXPECT_EQ(judge_trace(kCutAndTraverse, elsewhere.text(), judging).block, 3U);
  TraceText wrong_way(1);
  wrong_way.rapid({{'x', 65}, {'z', 5}}).block(2, 100).feed({{'z', -28}});
  wrong_way.block(3, 100).feed({{'x', 69}}).rapid({{'x', 70}});
  EXPECT_EQ(judge_trace(kCutAndTraverse, wrong_way.text(), judging).block, 3U);
}

TEST(DepartureMessage, AMotionBehindAllIsOfTheLastBlockThatMoves) {
  const char* const program = "G00 X130 Z5\nG01 Z-28 F100\nM30\n";
  Judging judging;
  EXPECT_EQ(judge_trace(program, one_too_many().text(), judging).block, 2U);
  judging.blocks = false;
  const Verdict verdict = judge_trace(program, one_too_many().text(), judging);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_overrun) << verdict.message;
  EXPECT_EQ(verdict.block, 2U);
}

// From Z-28 back to Z5.
TEST(DepartureMessage, AMotionTooManyHasItsDistance) {
  const Verdict verdict = judge_trace("G00 X130 Z5\nG01 Z-28 F100\nM30\n", one_too_many().text());
  expect(verdict, {VerdictKind::fail_overrun, 2, "", "33",
                   "All motions of the program have come, and the subject makes another one."});
  EXPECT_EQ(verdict.witness, R"({"x":"65","y":"0","z":"5"})");
}

// A circle of radius 5 from (10, 0) about (5, 0), which ends where it began: (0, 0) is 10 away.
TEST(DepartureMessage, ACircleTooManyIsMarkedWhereItIsFarthestOff) {
  TraceText trace(1);
  trace.rapid({{'x', 10}}).block(1, 100);
  trace.arc("G17", {{'x', 5}, {'y', 0}}, 1, {{'x', 10}, {'y', 0}});
  const Verdict verdict = judge_trace("G0 X10\nM2\n", trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_overrun) << verdict.message;
  EXPECT_EQ(verdict.witness, R"({"x":"0","y":"0","z":"0"})");
  EXPECT_EQ(verdict.deviation_mm, "10");
}

// J-CMP-12. By hand: 7/3 = 2.3333..., the root of 2 = 1.41421356237...
TEST(DepartureMessage, AWitnessIsPrintedWithNineDecimalsBesideItsExactText) {
  EXPECT_EQ(point_for_people(R"({"x":"65","z":"4.9"})"), R"({"x":"65","z":"4.9"})");
  EXPECT_EQ(point_for_people(R"({"x":"7/3","z":"1"})"),
            R"({"x":"7/3","z":"1"} = x 2.333333333, z 1)");
  EXPECT_EQ(point_for_people(R"({"y":{"root":["0","1","2"]}})"),
            R"({"y":{"root":["0","1","2"]}} = y 1.414213562)");
  EXPECT_EQ(point_for_people(R"({"a":{"enclosure":["0.1234567890123","0.1234567890124"]}})"),
            R"({"a":{"enclosure":["0.1234567890123","0.1234567890124"]}} = a 0.123456789)");
  EXPECT_EQ(point_for_people(""), "");
}

// The words of a gap are the reference's: code and word.
TEST(DepartureMessage, WhatIsNotCoveredHasItsBlock) {
  TraceText trace(2, 100);
  trace.feed({{'x', 50}});
  const Verdict verdict =
      judge_trace("G17 G21 G90 G94\nG1 X50 F100\nG41 D1 G1 X60\n", trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::oracle_gap) << verdict.message;
  EXPECT_EQ(verdict.block, 3U);
  EXPECT_NE(verdict.message.find("G41"), std::string::npos) << verdict.message;
}

// What moves behind the code is not known, but what was due before it is.
TEST(DepartureMessage, AnMFunctionBeforeWhatIsNotCoveredIsMissing) {
  TraceText trace(1, 100);
  trace.rapid({{'x', 5}});
  trace.block(4, 100).feed({{'x', 1}});
  const Verdict verdict = judge_trace("G0 X5\nM8\nG41\nG1 X1 F100\nM2\n", trace.text(),
                                      {.m = true, .dialect = "rs274"});
  EXPECT_EQ(decision(verdict.kind), Decision::no_go);
  EXPECT_NE(verdict.want.find(R"("m":8)"), std::string::npos) << verdict.want;
  EXPECT_EQ(verdict.message.find("All motions"), std::string::npos) << verdict.message;
}

constexpr std::string_view kDwelling = "G1 X10 F100\nG4 P2\nX20\nM2\n";

TEST(DepartureMessage, ADwellBeforeAMotionThatIsMissingIsALaterOne) {
  TraceText trace(1, 100);
  trace.line(R"({"k":"dwell","b":2,"s":"2"})").block(3, 100).feed({{'x', 20}});
  const Verdict verdict = judge_trace(kDwelling, trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_order) << verdict.message;
  EXPECT_EQ(verdict.message,
            "A later dwell comes here: what is due before it is missing, or comes later.");
}

TEST(DepartureMessage, AMissingDwellIsToldInItsOwnLine) {
  TraceText trace(1, 100);
  trace.feed({{'x', 10}}).block(3, 100).feed({{'x', 20}});
  const Verdict verdict = judge_trace(kDwelling, trace.text(), of("rs274"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.block, 2U);
}

// The arc of line 3 ends a thousandth from its start, no farther than the tolerance: the control
// may have left it out, but what it makes in its line is a wrong arc.
TEST(DepartureMessage, AWrongArcIsOfItsOwnLineThoughTheRightOneIsNegligible) {
  TraceText trace(2, 100);
  trace.feed({{'x', 10}}).block(3, 100);
  trace.arc("G17", {{'x', 10}, {'y', 5}}, 1, {{'x', 15}, {'y', 5}});
  const Verdict verdict = judge_trace("G90 F100\nG1 X10\nG3 X10.001 Y0 R5\nG1 X30\nM2\n",
                                      trace.text(), of("rs274", "0.001"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_NE(verdict.message, "The motion belongs to another block.");
  EXPECT_EQ(verdict.block, 3U);
}

// R5, R6. What is missing, and what comes in its place.
TEST(DepartureMessage, WhatIsMissingBeforeTheEndIsNamed) {
  const Judging judging{.m = true, .dialect = "rs274"};
  const std::string cut = R"({"k":"feed","b":1,"to":{"x":"10"},"f":"100"})"
                          "\n";
  const std::string alarm = R"({"k":"alarm","b":3,"class":"duplicate-word"})";
  const auto said = [&](const std::string& block, const std::string& behind) {
    const std::string program = "G21 G1 X10 F100\n" + block + "\nG0 X1 X2\n";
    return judge_trace(program, cut + behind, judging).message;
  };
  EXPECT_EQ(said("G1 X20", ""), "The end of the trace comes before this motion.");
  EXPECT_EQ(said("G4 P0.5", ""), "The end of the trace comes before this dwell.");
  EXPECT_EQ(said("G1 X20", alarm), "The alarm comes before this motion.");
  EXPECT_EQ(said("G4 P0.5", alarm), "The alarm comes before this dwell.");
  EXPECT_EQ(said("M3 S100", alarm), "The alarm comes before this M function.");
}

// R3. Four events of four lines; `dwell` and `m` stand for the `b` of theirs.
Verdict judged_lines(std::string_view dwell, std::string_view m) {
  const Judging judging{.m = true, .dialect = "rs274"};
  const std::string trace = R"({"k":"feed","b":1,"to":{"x":"10"},"f":"100"}
{"k":"dwell",)" + std::string(dwell) +
                            R"("s":"0.5"}
{"k":"m",)" + std::string(m) +
                            R"("m":3}
{"k":"feed","b":4,"to":{"x":"20"},"f":"100"}
)";
  return judge_trace("G21 G1 X10 F100\nG4 P0.5\nM3 S100\nG1 X20\n", trace, judging);
}

TEST(DepartureMessage, AnEventWithoutALineBreaksTheProtocol) {
  EXPECT_EQ(judged_lines(R"("b":2,)", R"("b":3,)").kind, VerdictKind::pass_exact);
  const Verdict dwell = judged_lines("", R"("b":3,)");
  EXPECT_EQ(dwell.kind, VerdictKind::protocol) << dwell.message;
  EXPECT_EQ(dwell.record, 1U);
  const Verdict m = judged_lines(R"("b":2,)", "");
  EXPECT_EQ(m.kind, VerdictKind::protocol) << m.message;
  EXPECT_EQ(m.record, 2U);
}

TEST(DepartureMessage, AnEventOfAnotherLineBelongsToAnotherBlock) {
  const Verdict dwell = judged_lines(R"("b":3,)", R"("b":3,)");
  expect(dwell,
         {VerdictKind::fail_geometry, 1, "NGC-G4-01", "", "The dwell belongs to another block."});
  const Verdict m = judged_lines(R"("b":2,)", R"("b":2,)");
  EXPECT_EQ(m.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(m.message, "The M function belongs to another block.");
}

TEST(DepartureMessage, AnAlarmWithoutALineBreaksTheProtocol) {
  const auto judged = [](const std::string& program, std::string_view line) {
    const std::string trace = R"({"k":"feed","b":1,"to":{"x":"10"},"f":"100"}
{"k":"alarm",)" + std::string(line) +
                              R"("class":"duplicate-word"})";
    return judge_trace("G21 G1 X10 F100\n" + program, trace, of("rs274"));
  };
  EXPECT_EQ(judged("G0 X1 X2\n", R"("b":2,)").kind, VerdictKind::pass_exact);
  EXPECT_EQ(judged("G0 X1 X2\n", "").kind, VerdictKind::protocol);
  EXPECT_EQ(judged("G0 X1\n", "").kind, VerdictKind::protocol);
}

// HNC-MOD-05, in the form of another maker. Line 4 alarms, too.
TEST(DepartureMessage, AnAlarmOfACycleWithoutTravelIsAnAdviceThoughALaterBlockAlarms) {
  TraceText trace(1);
  trace.line(R"({"k":"m","b":1,"m":3})").block(2, 0).rapid({{'x', 31}, {'z', -20}});
  trace.line(R"({"k":"alarm","b":3,"class":"missing-word"})");
  const std::string program =
      "M03 S300\nG00 X62 Z-20\nG75 R0.5\nG75 X40 Z-30 P2000 Q2500 F0.1\nM30\n";
  EXPECT_EQ(judge_trace(program, trace.text(), of("hnc21t")).kind, VerdictKind::advice);
}

}  // namespace
}  // namespace gonogo::oracle
