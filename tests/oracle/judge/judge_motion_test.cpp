// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge's rules for single motions: helices, splits, joins, chords, dwells, M functions, order.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "judging.hpp"
#include "oracle/motion/open_start.hpp"

namespace gonogo::oracle {
namespace {

Decision decided(std::string_view program, const TraceText& trace, const Judging& judging = {}) {
  return decision(judge_trace(program, trace.text(), judging).kind);
}

// G17 circle of radius 10 about the origin from X10 Y0, counterclockwise; X is a diameter.
constexpr std::string_view kCircle = "G17 G00 X20 Y0 Z0\nG03 X20 Y0 I-10 J0 F100\n";

TraceText start_of_circle() {
  TraceText trace(1);
  trace.rapid({{'x', 10}}).block(2, 100);
  return trace;
}

double x_at(double degrees, double radius = 10) {
  return radius * std::cos(degrees * std::numbers::pi / 180);
}
double y_at(double degrees, double radius = 10) {
  return radius * std::sin(degrees * std::numbers::pi / 180);
}

// R2.
TEST(MotionJudge, ACircleInArcsIsTheSameCircle) {
  for (int parts : {1, 2, 5, 36}) {
    TraceText trace = start_of_circle();
    for (int i = 1; i <= parts; ++i) {
      const double degrees = 360.0 * i / parts;
      trace.arc("G17", {{'x', 0}, {'y', 0}}, 1, {{'x', x_at(degrees)}, {'y', y_at(degrees)}});
    }
    EXPECT_EQ(decided(kCircle, trace), Decision::go) << parts;
  }
}

TEST(MotionJudge, ACircleShortOfAPartIsNoGo) {
  TraceText trace = start_of_circle();
  trace.arc("G17", {{'x', 0}, {'y', 0}}, 1, {{'x', x_at(350)}, {'y', y_at(350)}});
  EXPECT_EQ(decided(kCircle, trace), Decision::no_go);
}

TEST(MotionJudge, TwoTurnsForOneAreNoGo) {
  TraceText trace = start_of_circle();
  trace.arc("G17", {{'x', 0}, {'y', 0}}, 2, {{'x', 10}, {'y', 0}});
  EXPECT_EQ(decided(kCircle, trace), Decision::no_go);
}

TEST(MotionJudge, AnArcOffTheCircleByTwoTolerancesIsNoGo) {
  for (const auto& [off, want] : {std::pair(0.0009, Decision::go), {0.0021, Decision::no_go}}) {
    TraceText trace = start_of_circle();
    trace.arc("G17", {{'x', 0}, {'y', 0}}, 1, {{'x', 0}, {'y', 10 + off}});
    trace.arc("G17", {{'x', 0}, {'y', 0}}, 1, {{'x', 10}, {'y', 0}});
    EXPECT_EQ(decided(kCircle, trace), want) << off;
  }
}

// R3.
TEST(MotionJudge, ChordsNeedTheCertifiersGrantAndKeepWithinIt) {
  // 100 chords: sagitta 10 (1 - cos 1.8 degrees) = 0.0049.
  TraceText trace = start_of_circle();
  for (int i = 1; i <= 100; ++i) {
    trace.feed({{'x', x_at(3.6 * i)}, {'y', y_at(3.6 * i)}});
  }
  EXPECT_EQ(decided(kCircle, trace), Decision::no_go);
  EXPECT_EQ(decided(kCircle, trace, {.chord = "0.001"}), Decision::no_go);
  EXPECT_EQ(decided(kCircle, trace, {.chord = "0.005"}), Decision::go);
}

TEST(MotionJudge, ChordsTheWrongWayRoundAreNoGo) {
  TraceText trace = start_of_circle();
  for (int i = 1; i <= 100; ++i) {
    trace.feed({{'x', x_at(-3.6 * i)}, {'y', y_at(-3.6 * i)}});
  }
  EXPECT_EQ(decided(kCircle, trace, {.chord = "0.005"}), Decision::no_go);
}

// Three turns of a helix whose end is off its start by the rounding of a double, either way.
// R2, J-PATH-06.
TEST(MotionJudge, TheTurnsOfAHelixAreCountedWhereItsEndIsNearItsStart) {
  constexpr std::string_view kPocket = "G17 G00 X0 Y0 Z10\nG113 X0 Y0 Z4 I14 L3 D4 F100\n";
  for (double off : {-1e-15, 0.0, 1e-15}) {
    TraceText trace(1);
    trace.decimals(15).rapid({{'z', 10}}).block(2, 100);
    trace.arc("G17", {{'x', 5}, {'y', 0}}, 1, {{'x', 10}, {'y', 0}});
    trace.arc("G17", {{'x', 0}, {'y', 0}}, 3, {{'x', 10}, {'y', off}, {'z', 4}});
    trace.arc("G17", {{'x', 5}, {'y', 0}}, 1, {{'x', 0}, {'y', 0}});
    trace.rapid({{'z', 10}});
    for (const char* side : {"gsk.helix.entry-side=any", "gsk.helix.entry-side=+p"}) {
      const Judging doubles{.reading = side, .binary64 = true};
      EXPECT_EQ(decided(kPocket, trace, doubles), Decision::go) << off << side;
    }
  }
}

// R1.
TEST(MotionJudge, ALineInPiecesMayNotGoBack) {
  constexpr std::string_view kLine = "G00 Z10\nG01 Z0 F100\n";
  auto trace = [](double first, double second) {
    TraceText text(1);
    text.rapid({{'z', 10}}).block(2, 100);
    text.feed({{'z', first}}).feed({{'z', second}}).feed({{'z', 0}});
    return text;
  };
  EXPECT_EQ(decided(kLine, trace(7, 3)), Decision::go);
  EXPECT_EQ(decided(kLine, trace(3, 3.0005)), Decision::go);
  EXPECT_EQ(decided(kLine, trace(3, 3.0011)), Decision::no_go);
}

// R1, R3.
TEST(MotionJudge, TwoCutsOfOneLineMayBeOneOnlyInOneBlock) {
  constexpr std::string_view kTwo = "G00 Z10\nG01 Z5 F100\nZ0\n";
  TraceText trace(1);
  trace.rapid({{'z', 10}}).block(2, 100).feed({{'z', 0}});
  EXPECT_EQ(decided(kTwo, trace), Decision::no_go);
}

// R4.
TEST(MotionJudge, ATraverseInPartsIsMonotoneOnEachAxis) {
  constexpr std::string_view kBoth = "G00 X20 Z10\n";
  EXPECT_EQ(decided(kBoth, TraceText(1).rapid({{'z', 10}}).rapid({{'x', 10}})), Decision::go);
  EXPECT_EQ(decided(kBoth, TraceText(1).rapid({{'z', 11}}).rapid({{'x', 10}, {'z', 10}})),
            Decision::no_go);
  EXPECT_EQ(decided(kBoth, TraceText(1).rapid({{'y', 1}}).rapid({{'x', 10}, {'y', 0}, {'z', 10}})),
            Decision::no_go);
}

TEST(MotionJudge, AnExchangedPairIsAnOrderFailure) {
  constexpr std::string_view kTwo = "G00 Z10\nG01 X20 F100\nG00 Z20\n";
  TraceText trace(1);
  trace.rapid({{'z', 10}}).rapid({{'z', 20}});
  TraceText blocks(1);
  blocks.rapid({{'z', 10}}).block(3, 0).rapid({{'z', 20}});
  EXPECT_EQ(decided(kTwo, trace, {.blocks = false}), Decision::no_go);
  // The traverse of block 3 starts elsewhere than it should, so it is no later motion.
  EXPECT_EQ(judge_trace(kTwo, blocks.text()).kind, VerdictKind::fail_geometry);
}

// J-CMP-12.
TEST(MotionJudge, ALaterMotionFromTheSamePointIsAnOrderFailure) {
  // There and back twice; the second way starts where the first does.
  constexpr std::string_view kTwo = "G00 Z10\nG00 Z0\nG00 Z20\n";
  TraceText trace(3);
  trace.rapid({{'z', 20}});
  EXPECT_EQ(judge_trace(kTwo, trace.text()).kind, VerdictKind::fail_order);
}

// R5, J-CMP-12.
TEST(MotionJudge, ADwellIsDueWhereItStands) {
  constexpr std::string_view kDwell = "G00 Z10\nG04 X1.5\nG00 Z20\n";
  auto trace = [](const char* seconds, bool late) {
    TraceText text(1);
    text.rapid({{'z', 10}});
    const std::string dwell = fmt::format(R"({{"k":"dwell","b":2,"s":"{}"}})", seconds);
    if (!late) text.line(dwell);
    text.block(3, 0).rapid({{'z', 20}});
    if (late) text.line(dwell);
    return text.text();
  };
  EXPECT_EQ(judge_trace(kDwell, trace("1.5", false)).kind, VerdictKind::pass_exact);
  EXPECT_EQ(judge_trace(kDwell, trace("1.6", false)).kind, VerdictKind::fail_feed);
  EXPECT_EQ(judge_trace(kDwell, trace("1.5", true)).kind, VerdictKind::fail_order);
}

// R5.
TEST(MotionJudge, MFunctionsAreComparedInTheirOrderOnlyWhenDeclared) {
  constexpr std::string_view kM = "M3 G00 Z10\nM8 G00 Z20\n";
  auto trace = [](int first, int second) {
    TraceText text(1);
    text.line(fmt::format(R"({{"k":"m","b":1,"m":{}}})", first)).rapid({{'z', 10}});
    text.block(2, 0).rapid({{'z', 20}});
    text.line(fmt::format(R"({{"k":"m","b":2,"m":{}}})", second));
    return text;
  };
  EXPECT_EQ(decided(kM, trace(3, 8), {.m = true}), Decision::go);
  const Verdict verdict = judge_trace(kM, trace(8, 3).text(), Judging{.m = true});
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(verdict.word, 'M');
  EXPECT_EQ(decided(kM, trace(8, 3)), Decision::go);
}

// J-CMP-09. What lies within the tolerance of the line, or is a chord, is not exact.
TEST(MotionJudge, APieceThatEndsBesideItsMotionPassesWithinTheTolerance) {
  const Judging coarse{.dialect = "rs274", .tolerance = "0.01"};
  const auto in_two = [&](double x, double y) {
    TraceText trace(1, 100);
    trace.feed({{'x', x}, {'y', y}}).feed({{'x', 10}, {'y', 5}});
    return judge_trace("G21 G1 X10 Y5 F100\n", trace.text(), coarse).kind;
  };
  EXPECT_EQ(in_two(4, 2), VerdictKind::pass_exact);
  EXPECT_EQ(in_two(4, 2.01), VerdictKind::pass_tolerance);
  EXPECT_EQ(in_two(4, 2.000000001), VerdictKind::pass_tolerance);
  // The ways of a traverse are free.
  TraceText rapids(1);
  rapids.rapid({{'x', 4}, {'y', 3}}).rapid({{'x', 10}, {'y', 5}});
  EXPECT_EQ(judge_trace("G21 G0 X10 Y5\n", rapids.text(), coarse).kind, VerdictKind::pass_exact);
}

// The half circle from (10, 0) over (0, 10) to (-10, 0); (8, 6) and (6, 8) lie on it.
TEST(MotionJudge, APieceOfAnArcIsExactOnItsCircle) {
  constexpr std::string_view kHalf = "G21 G17 G0 X10\nG3 X-10 Y0 I-10 J0 F100\n";
  const auto begin = [] {
    TraceText trace(1);
    return trace.rapid({{'x', 10}}).block(2, 100);
  };
  const auto in_two = [&](double x, double y) {
    TraceText trace = begin();
    trace.arc("G17", {{'x', 0}, {'y', 0}}, 1, {{'x', x}, {'y', y}});
    trace.arc("G17", {{'x', 0}, {'y', 0}}, 1, {{'x', -10}, {'y', 0}});
    return judge_trace(kHalf, trace.text(), {.dialect = "rs274"}).kind;
  };
  EXPECT_EQ(in_two(6, 8), VerdictKind::pass_exact);
  EXPECT_EQ(in_two(6.00005, 8), VerdictKind::pass_tolerance);
  // 10 (1 - cos 26.6 degrees) = 1.06 at most between a chord and the arc.
  TraceText chords = begin();
  chords.feed({{'x', 8}, {'y', 6}}).feed({{'x', 0}, {'y', 10}}).feed({{'x', -8}, {'y', 6}});
  chords.feed({{'x', -10}, {'y', 0}});
  EXPECT_EQ(judge_trace(kHalf, chords.text(), {.chord = "1.2", .dialect = "rs274"}).kind,
            VerdictKind::pass_tolerance);
}

TEST(MotionJudge, ACorrectlyRoundedEndPassesAsRounded) {
  constexpr std::string_view kThird = "G00 Z0.0004\n";
  const Judging rounding{.resolution = "0.001"};
  EXPECT_EQ(judge_trace(kThird, TraceText(1).rapid({{'z', 0.0004}}).text(), rounding).kind,
            VerdictKind::pass_exact);
  // The motion is smaller than the tolerance: neither side need show it.
  EXPECT_EQ(decided(kThird, TraceText(1), rounding), Decision::go);
  constexpr std::string_view kMore = "G00 Z5.0004\n";
  EXPECT_EQ(judge_trace(kMore, TraceText(1).rapid({{'z', 5}}).text(), rounding).kind,
            VerdictKind::pass_rounded);
  EXPECT_EQ(judge_trace(kMore, TraceText(1).rapid({{'z', 5.001}}).text(), rounding).kind,
            VerdictKind::pass_tolerance);
}

PlaneVector vector_of(const char* p, const char* q) {
  return {*Number::parse(p), *Number::parse(q)};
}

TEST(OpenStart, AdmitsThePointsOfOneAndTheSameCurveOnly) {
  // Radius 10, tolerance 0.001. Both points are off their own curve by less than the tolerance,
  // but no start serves both: the first wants q in [0.9e-3, 2.9e-3], the second q in [-2.9e-3,
  // -0.9e-3], turned by 90 degrees.
  const Number tau = Number::millionths(1000);
  OpenStart starts(10, tau);
  ASSERT_TRUE(starts.narrow({}, vector_of("10", "0.0019")));
  EXPECT_TRUE(starts.admits(turn_by(90), vector_of("-0.0019", "10")));
  EXPECT_TRUE(starts.admits(turn_by(90), vector_of("-0.0001", "10")));
  EXPECT_FALSE(starts.admits(turn_by(90), vector_of("0.0019", "10")));
}

TEST(OpenStart, APointOffTheCircleAdmitsNone) {
  const Number tau = Number::millionths(1000);
  EXPECT_TRUE(OpenStart(10, tau).admits({}, vector_of("10.001", "0")));
  EXPECT_FALSE(OpenStart(10, tau).admits({}, vector_of("10.0011", "0")));
  EXPECT_TRUE(OpenStart(10, tau).admits({}, vector_of("9.999", "0")));
  EXPECT_FALSE(OpenStart(10, tau).admits({}, vector_of("9.9989", "0")));
}

TEST(OpenStart, ThePartOfATurnMayBeAnyAngle) {
  // 6 cos 30 = 5.196152..., 6 sin 30 = 3; scaled by 1.5: radius 9.
  const Number tau = Number::millionths(1000);
  OpenStart starts(6, tau);
  ASSERT_TRUE(starts.narrow({}, vector_of("6", "0")));
  EXPECT_TRUE(starts.narrow(turn_by(30), vector_of("5.196", "3")));
  EXPECT_FALSE(starts.narrow(turn_by(31), vector_of("5.196", "3")));
  const Similarity turn = turn_by(30);
  const Number scale = Number(3) / 2;
  EXPECT_TRUE(starts.admits({scale * turn.a, scale * turn.b}, vector_of("7.794", "4.5")));
}

}  // namespace
}  // namespace gonogo::oracle
