// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs as chords that the certifier grants, and how many records they may be; centres that differ.
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

// Half a turn clockwise about (10010, 0), in so many chords. Of 3,000 the sagitta is
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

// J-PATH-10.
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

// A quarter about (0, 0); the tolerance is 0.0001.
TEST(Centres, TheDeviationIsHowFarTheyAreApart) {
  TraceText trace(1);
  trace.rapid({{'x', 10}})
      .block(2, 100)
      .arc("G17", {{'x', 0.0003}, {'y', -0.002}}, 1, {{'x', 0}, {'y', 10}});
  const Verdict verdict = judge_trace("G0 X10\nG3 X0 Y10 I-10 F100\n", trace.text(), rs274(""));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(verdict.deviation_exact, "0.002");
  EXPECT_EQ(verdict.witness, R"({"x":"0.0003","y":"-0.002"})");
}

}  // namespace
}  // namespace gonogo::oracle
