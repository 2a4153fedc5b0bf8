// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CYC-02: records that make progress are no overrun, however many; those that make
// none are stopped. And GSK-CYC-02 through the whole judge. The pocket of judge_pocket_test.cpp:
// G18, centre Z 50, X 25 (radius), I - D = 12, L = 3.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kPocket =
    "G18 G0 X70 Z70 Y50\nG110 X50 Z50 Y40 R-5 I16 L3 Q5 P1 D4 F800\n";

TraceText approach() {
  TraceText trace(1, 800);
  trace.rapid({{'x', 35}, {'y', 50}, {'z', 70}}).block(2, 800).rapid({{'x', 25}, {'z', 50}});
  trace.rapid({{'y', 45}}).feed({{'y', 40}});
  return trace;
}

std::string leave(TraceText& trace) {
  trace.rapid({{'y', 45}}).rapid({{'x', 25}, {'z', 50}}).rapid({{'y', 50}});
  return trace.text();
}

// Clockwise from +z, in so many arcs.
void ring(TraceText& trace, double radius, int pieces) {
  trace.feed({{'x', 25}, {'z', 50 + radius}});
  for (int k = 1; k <= pieces; ++k) {
    const double angle = -2 * std::numbers::pi * k / pieces;
    trace.arc("G18", {{'x', 25}, {'z', 50}}, -1,
              {{'x', 25 + radius * std::sin(angle)}, {'z', 50 + radius * std::cos(angle)}});
  }
}

void ring_of_chords(TraceText& trace, double radius, int pieces, int sense = -1) {
  for (int k = 0; k <= pieces; ++k) {
    const double angle = sense * 2 * std::numbers::pi * k / pieces;
    trace.feed({{'x', 25 + radius * std::sin(angle)}, {'z', 50 + radius * std::cos(angle)}});
  }
}

TEST(RecordBudget, RingsInTwoThousandArcsAreGo) {
  TraceText trace = approach();
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) ring(trace, radius, 540);
  const Verdict verdict = judge_trace(kPocket, leave(trace));
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

TEST(RecordBudget, EndlessTurnsInOnePlaceAreStopped) {
  TraceText trace = approach();
  for (int k = 0; k < 3000; ++k) {
    trace.arc("G18", {{'x', 25}, {'z', 50.01}}, -1, {{'x', 25}, {'z', 50.02}});
    trace.arc("G18", {{'x', 25}, {'z', 50.01}}, -1, {{'x', 25}, {'z', 50}});
  }
  EXPECT_EQ(judge_trace(kPocket, leave(trace)).kind, VerdictKind::fail_overrun);
}

TEST(RecordBudget, RingsMilledOverAndOverAreStopped) {
  TraceText trace = approach();
  for (int k = 0; k < 40; ++k) ring(trace, 3, 60);
  EXPECT_EQ(judge_trace(kPocket, leave(trace)).kind, VerdictKind::fail_overrun);
}

// Rings of 3, 6, 9, 12, the last so many times more, in so many arcs each, or in one record.
std::string last_ring_again(int times, int pieces, int in_one_record = 0) {
  TraceText trace = approach();
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) ring(trace, radius, 2);
  for (int k = 0; k < times; ++k) ring(trace, 12, pieces);
  if (in_one_record != 0) {
    trace.arc("G18", {{'x', 25}, {'z', 50}}, in_one_record, {{'x', 25}, {'z', 62}});
  }
  return leave(trace);
}

// J-CYC-02: ten times is an allowance, an eleventh time is too many.
TEST(RecordBudget, ARingIsTurnedOnTenTimes) {
  for (const int pieces : {1, 2, 7, 60}) {
    EXPECT_EQ(decision(judge_trace(kPocket, last_ring_again(9, pieces)).kind), Decision::go);
    EXPECT_EQ(judge_trace(kPocket, last_ring_again(50, pieces)).kind, VerdictKind::fail_overrun)
        << pieces;
  }
}

// Ten turns are ten turns, however the doubles come out that they are summed up from: of places
// rounded to 0.001, 240 arcs of 15 degrees and some more.
TEST(RecordBudget, TenTurnsInPiecesAreNoMoreThanTen) {
  for (const int pieces : {5, 13, 21, 23, 24, 27, 32, 35, 37}) {
    TraceText trace = approach();
    trace.decimals(3);
    for (const double radius : {3.0, 6.0, 9.0}) ring(trace, radius, 2);
    for (int k = 0; k < 10; ++k) ring(trace, 12, pieces);
    const Verdict verdict = judge_trace(kPocket, leave(trace));
    EXPECT_EQ(decision(verdict.kind), Decision::go) << pieces << " " << verdict.message;
  }
}

// No time depends on how many turns a record makes.
TEST(RecordBudget, TurnsCountWhereOneRecordMakesThem) {
  EXPECT_EQ(decision(judge_trace(kPocket, last_ring_again(0, 1, -9)).kind), Decision::go);
  for (const int rot : {-11, -1'000'000'000, -2'147'483'647}) {
    EXPECT_EQ(judge_trace(kPocket, last_ring_again(0, 1, rot)).kind, VerdictKind::fail_overrun)
        << rot;
  }
}

// Farther away than a double can say: the judge ends, with anything but GO.
TEST(RecordBudget, AnArcBeyondAllDoublesIsNotGo) {
  const std::string far = "1" + std::string(400, '0');
  TraceText trace = approach();
  trace.line(R"({"k":"arc","b":2,"plane":"G18","c":{"x":"25","z":")" + far +
             R"("},"rot":-1,"to":{"x":"25","z":"51"},"f":"800"})");
  EXPECT_NE(decision(judge_trace(kPocket, leave(trace)).kind), Decision::go);
}

// Off the middle, and on a link to and fro.
TEST(RecordBudget, TurnsAsideAndLinksToAndFroAreCountedToo) {
  TraceText aside = approach();
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) ring(aside, radius, 2);
  aside.arc("G18", {{'x', 25}, {'z', 61.5}}, -1'000'000, {{'x', 25}, {'z', 62}});
  EXPECT_EQ(judge_trace(kPocket, leave(aside)).kind, VerdictKind::fail_overrun);
  TraceText links = approach();
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) ring(links, radius, 2);
  for (int k = 0; k < 40; ++k) links.feed({{'z', k % 2 == 0 ? 50.0 : 62.0}});
  EXPECT_EQ(judge_trace(kPocket, leave(links)).kind, VerdictKind::fail_overrun);
}

// R8, measure: five circles of 12 go 480 along both axes, and ten times that is allowed. 60 rings
// 0.2 apart, L / 15, go 2,928; 300 rings 0.04 apart 14,448.
TEST(RecordBudget, RingsASmallStepApartAreGoAsFarAsTheMeasureGoes) {
  TraceText many = approach();
  for (int k = 1; k <= 60; ++k) ring(many, 0.2 * k, 2);
  const Verdict verdict = judge_trace(kPocket, leave(many));
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
  TraceText more = approach();
  for (int k = 1; k <= 300; ++k) ring(more, 0.04 * k, 2);
  EXPECT_EQ(judge_trace(kPocket, leave(more)).kind, VerdictKind::fail_overrun);
}

TEST(RecordBudget, ALineInFiveThousandPiecesIsGo) {
  TraceText trace(1, 200);
  trace.rapid({{'x', 65}, {'z', 5}}).block(2, 200);
  for (int k = 1; k <= 5000; ++k) trace.feed({{'z', 5 - 0.01 * k}});
  const Verdict verdict = judge_trace("G18 G98 G00 X130 Z5\nG01 Z-45 F200\n", trace.text());
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

TEST(RecordBudget, ATraverseInThreeThousandPiecesIsGo) {
  TraceText trace(1);
  for (int k = 1; k <= 3000; ++k) trace.rapid({{'x', 0.02 * k}, {'z', 0.01 * k}});
  const Verdict verdict = judge_trace("G18 G00 X120 Z30\n", trace.text());
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

// A control that interpolates gives pieces of a tolerance or less, one a millisecond. They add up:
// 2 mm in 2,000 pieces and more, and a circle of radius 1, 6.283 mm long, in arcs of 2.09 and 1 um.
TEST(RecordBudget, PiecesOfAToleranceAndLessAddUpOnALine) {
  for (const int pieces : {2000, 4000, 20'000}) {
    TraceText feeds(1, 200);
    TraceText traverses(1);
    for (int k = 1; k <= pieces; ++k) {
      feeds.feed({{'z', -2.0 * k / pieces}});
      traverses.rapid({{'x', 2.0 * k / pieces}, {'z', -2.0 * k / pieces}});
    }
    const Verdict fed = judge_trace("G18 G98 G01 Z-2 F200\n", feeds.text());
    EXPECT_EQ(decision(fed.kind), Decision::go) << pieces << fed.message;
    const Verdict traversed = judge_trace("G18 G00 X4 Z-2\n", traverses.text());
    EXPECT_EQ(decision(traversed.kind), Decision::go) << pieces << traversed.message;
  }
}

// From (1, 0) about the origin; `depth` along z in each turn.
TraceText circle_of_one(int turns, int pieces, double depth) {
  TraceText trace(1);
  trace.rapid({{'x', 1}}).block(2, 100);
  for (int k = 1; k <= turns * pieces; ++k) {
    const double angle = 2 * std::numbers::pi * (k % pieces) / pieces;
    trace.arc("G17", {{'x', 0}, {'y', 0}}, 1,
              {{'x', std::cos(angle)}, {'y', std::sin(angle)}, {'z', depth * k / pieces}});
  }
  return trace;
}

TEST(RecordBudget, PiecesOfAToleranceAndLessAddUpOnAnArc) {
  const auto expect_go = [](const char* program, const TraceText& trace) {
    const Verdict verdict =
        judge_trace(program, trace.text(), {.dialect = "rs274", .tolerance = "0.001"});
    EXPECT_EQ(decision(verdict.kind), Decision::go) << program << verdict.message;
  };
  const char* const once = "G17 G21 G0 X1\nG3 X1 Y0 I-1 J0 F100\n";
  expect_go(once, circle_of_one(1, 3000, 0));
  expect_go(once, circle_of_one(1, 6283, 0));
  // The second turn and the third lead to no place that is new.
  expect_go("G17 G21 G0 X1\nG3 X1 Y0 I-1 J0 P3 F100\n", circle_of_one(3, 3000, 0));
  expect_go("G17 G21 G0 X1\nG3 X1 Y0 Z-3 I-1 J0 P3 F100\n", circle_of_one(3, 3000, -1));
}

// One that stands still on its way, or goes to and fro within the tolerance, comes to no end.
TEST(RecordBudget, DitheringOnALineIsStopped) {
  for (const double by : {0.0, 0.0005, 0.001}) {
    TraceText trace(1, 200);
    trace.feed({{'z', -1}});
    for (int k = 0; k < 3000; ++k) trace.feed({{'z', k % 2 == 0 ? -1 - by : -1.0}});
    EXPECT_EQ(judge_trace("G18 G98 G01 Z-2 F200\n", trace.text()).kind, VerdictKind::fail_overrun)
        << by;
  }
}

TEST(RecordBudget, AnEndlessLineAwayIsStopped) {
  TraceText trace(1, 200);
  trace.rapid({{'x', 65}, {'z', 5}}).block(2, 200);
  for (int k = 1; k <= 3000; ++k) trace.feed({{'z', 5 - 0.1 * k}});
  EXPECT_EQ(judge_trace("G18 G98 G00 X130 Z5\nG01 Z-45 F200\n", trace.text()).kind,
            VerdictKind::fail_overrun);
}

TEST(RecordBudget, OscillationOnALineIsNoGo) {
  TraceText trace(1, 200);
  trace.rapid({{'x', 65}, {'z', 5}}).block(2, 200);
  for (int k = 1; k <= 3000; ++k) trace.feed({{'z', k % 2 == 0 ? 5.0 : 4.0}});
  EXPECT_EQ(decision(judge_trace("G18 G98 G00 X130 Z5\nG01 Z-45 F200\n", trace.text()).kind),
            Decision::no_go);
}

// GSK-CYC-02: 12 straight through solid, then inwards.
TEST(PocketOrder, StraightToTheWallAndInwardsIsNoGoWithAWitness) {
  TraceText trace = approach();
  for (const double radius : {12.0, 9.0, 6.0, 3.0}) ring(trace, radius, 2);
  const Verdict verdict = judge_trace(kPocket, leave(trace));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region);
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-CYC-02");
  EXPECT_FALSE(verdict.witness.empty());
}

// J-PKT-07: 200 chords of a circle of 12 run 12 (1 - cos(pi / 200)) = 0.0015 inside of it.
TEST(PocketChords, RingsOfChordsAreGoWhereTheyAreGranted) {
  TraceText trace = approach();
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) ring_of_chords(trace, radius, 200);
  const std::string text = leave(trace);
  Judging granted;
  granted.chord = "0.002";
  const Verdict verdict = judge_trace(kPocket, text, granted);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message << verdict.witness;
  EXPECT_EQ(decision(judge_trace(kPocket, text).kind), Decision::no_go);
}

// As a controller with three decimals writes them.
TEST(PocketChords, RoundedChordsAreGo) {
  TraceText trace = approach();
  trace.decimals(3);
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) {
    ring_of_chords(trace, radius, static_cast<int>(radius * 100));
  }
  Judging granted;
  granted.chord = "0.002";
  const Verdict verdict = judge_trace(kPocket, leave(trace), granted);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message << verdict.witness;
}

TEST(PocketChords, ChordsTheOtherWayRoundAreNoGo) {
  TraceText trace = approach();
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) ring_of_chords(trace, radius, 200, 1);
  Judging granted;
  granted.chord = "0.002";
  const Verdict verdict = judge_trace(kPocket, leave(trace), granted);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region);
  EXPECT_NE(verdict.message.find("turns"), std::string::npos) << verdict.message;
}

// 12 sides: the sides run 12 (1 - cos 15 degrees) = 0.41 inside.
TEST(PocketChords, APolygonIsNoRing) {
  TraceText trace = approach();
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) ring_of_chords(trace, radius, 12);
  Judging granted;
  granted.chord = "0.002";
  EXPECT_EQ(decision(judge_trace(kPocket, leave(trace), granted).kind), Decision::no_go);
}

TEST(PocketChords, ChordsBeyondTheBorderByMoreThanTheChordGouge) {
  TraceText trace = approach();
  for (const double radius : {3.0, 6.0, 9.0, 12.004}) ring_of_chords(trace, radius, 200);
  Judging granted;
  granted.chord = "0.002";
  const Verdict verdict = judge_trace(kPocket, leave(trace), granted);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region);
  EXPECT_NE(verdict.message.find("wall"), std::string::npos) << verdict.message;
  EXPECT_EQ(verdict.deviation_mm.substr(0, 5), "0.004");
}

TEST(PocketChords, InwardsIsNoGoInChordsToo) {
  TraceText trace = approach();
  for (const double radius : {12.0, 9.0, 6.0, 3.0}) ring_of_chords(trace, radius, 200);
  Judging granted;
  granted.chord = "0.002";
  EXPECT_EQ(reference::clause_name(judge_trace(kPocket, leave(trace), granted).clause),
            "GSK-CYC-02");
}

}  // namespace
}  // namespace gonogo::oracle
