// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs as chords that the certifier grants, and how many records they may be; centres that differ.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

Judging rs274(std::string chord = "0.01") {
  Judging judging;
  judging.dialect = "rs274";
  judging.chord = std::move(chord);
  return judging;
}

// Half a turn clockwise about (10010, 0), in so many chords. With 3,000 the sagitta is
// 10000 (1 - cos(pi/6000)) = 0.00137.
constexpr std::string_view kHalfTurnProgram = "G0 X10\nG2 X20010 I10000 F100\n";
TraceText chords(int count) {
  TraceText trace(1);
  trace.rapid({{'x', 10}}).block(2, 100);
  for (int i = 1; i <= count; ++i) {
    const double angle = std::numbers::pi * (1 - static_cast<double>(i) / count);
    trace.feed({{'x', 10010 + 10000 * std::cos(angle)}, {'y', 10000 * std::sin(angle)}});
  }
  return trace;
}

TEST(Chords, AsManyAsAnArcTakesAreNoOverrun) {
  const Verdict verdict = judge_trace(kHalfTurnProgram, chords(3000).text(), rs274());
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

// R3.
TEST(Chords, ThatAreNotGrantedAreNone) {
  const Verdict verdict = judge_trace(kHalfTurnProgram, chords(3000).text(), rs274(""));
  EXPECT_EQ(decision(verdict.kind), Decision::no_go);
}

// Two motions of the reference: 1,020 records, and the chords.
TEST(Chords, DoNotPayForOtherRecords) {
  TraceText trace = chords(2000);
  for (int i = 0; i < 1100; ++i) trace.feed({{'x', 20010}});
  const Verdict verdict = judge_trace(kHalfTurnProgram, trace.text(), rs274());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_overrun) << verdict.message;
}

// To and fro on the arc: a chord that goes back is none of it.
TEST(Chords, ThatGoBackAreADeparture) {
  TraceText trace = chords(3000);
  trace.feed({{'x', 20000}, {'y', 447.1}});
  EXPECT_EQ(decision(judge_trace(kHalfTurnProgram, trace.text(), rs274()).kind), Decision::no_go);
}

// R3. A quarter of a millimetre of a circle of radius 100 about (100, 0): the arc rises over
// its chord by 0.25^2 / 800 = 0.000078, and the tolerance is 0.0001.
constexpr std::string_view kFlatArc = "G0 X0 Y0\nG2 X0.0003125 Y0.25 I100 J0 F100\n";

// (0.0003125, 0.25) lies on it to 5e-8: 0.25^2 / 200 = 0.0003125.
TEST(FlatArcs, OneThatNothingTellsFromItsChordMayComeAsThat) {
  const auto told = [](std::string_view program, std::initializer_list<const char*> ends) {
    std::string trace;
    for (const char* end : ends) {
      trace += std::string(R"({"k":"feed","b":2,"to":{)") + end + R"(},"f":"100"})" + "\n";
    }
    return judge_trace(program, trace, rs274("")).kind;
  };
  const char* end = R"("x":"0.0003125","y":"0.25")";
  EXPECT_EQ(decision(told(kFlatArc, {end})), Decision::go);
  EXPECT_EQ(decision(told(kFlatArc, {R"("x":"0.00015625","y":"0.125")", end})), Decision::go);
  EXPECT_EQ(told(kFlatArc, {R"("x":"0.0003125","y":"0.24")"}), VerdictKind::fail_geometry);
  EXPECT_EQ(told(kFlatArc, {R"("x":"0.0006","y":"0.25")"}), VerdictKind::fail_geometry);
  EXPECT_EQ(told(kFlatArc, {R"("x":"0.0003125","y":"0.25")", R"("y":"0.2")"}),
            VerdictKind::fail_overrun);
  // Twice as long it rises by 0.00031.
  EXPECT_EQ(told("G0 X0 Y0\nG2 X0.00125 Y0.5 I100 J0 F100\n", {R"("x":"0.00125","y":"0.5")"}),
            VerdictKind::fail_geometry);
  // A chord of the long way round is none.
  EXPECT_EQ(told("G0 X0 Y0\nG3 X0.0003125 Y0.25 I100 J0 F100\n", {end}),
            VerdictKind::fail_geometry);
}

TEST(FlatArcs, ALineMayComeAsAnArcThatNothingTellsFromIt) {
  const auto told = [](const char* x, const char* y, int rot,
                       const char* end = R"("x":"0","y":"0.25")") {
    const std::string trace = fmt::format(
        R"({{"k":"arc","b":1,"plane":"G17","c":{{"x":"{}","y":"{}"}},"rot":{},"to":{{{}}},"f":"100"}})"
        "\n",
        x, y, rot, end);
    return judge_trace("G1 X0 Y0.25 F100\n", trace, rs274("")).kind;
  };
  EXPECT_EQ(decision(told("100", "0.125", -1)), Decision::go);
  EXPECT_EQ(decision(told("-100", "0.125", 1)), Decision::go);
  EXPECT_EQ(decision(told("10", "0.125", -1)), Decision::no_go);
  EXPECT_EQ(decision(told("100", "0.125", 1)), Decision::no_go);
  EXPECT_EQ(decision(told("100", "0.125", -2)), Decision::no_go);
  // Its ends are off by the tolerance, and its middle by more.
  EXPECT_EQ(decision(told("-100", "0.125", 1, R"("x":"0.0001","y":"0.25")")), Decision::no_go);
}

// A quarter about (0, 0); the tolerance is 0.0001.
TEST(Centres, TheDeviationIsHowFarTheyAreApart) {
  TraceText trace(1);
  trace.rapid({{'x', 10}})
      .block(2, 100)
      .arc("G17", {{'x', 0.0003}, {'y', -0.002}}, 1, {{'x', 0}, {'y', 10}});
  const Verdict verdict = judge_trace("G0 X10\nG3 X0 Y10 I-10 F100\n", trace.text(), rs274(""));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(verdict.deviation_exact, "0.002");
  EXPECT_EQ(verdict.witness, R"({"x":"0.0003","y":"-0.002","z":"0"})");
}

}  // namespace
}  // namespace gonogo::oracle
