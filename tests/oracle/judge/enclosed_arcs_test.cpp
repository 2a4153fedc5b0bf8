// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs whose ends or centres are known by enclosures (angles AR=, AP=), judged against a subject
// that computes in doubles.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Judging sinumerik() {
  Judging judging;
  judging.dialect = "sinumerik840d";
  judging.binary64 = true;
  return judging;
}

// Polar arcs about the pole (1, 2), each by 7 degrees, to and fro between two radii by lines.
struct PolarArcs {
  std::string program = "G17 G90 G71 G94 F100\nG111 X1 Y2\nG0 AP=0 RP=10 Z0\n";
  TraceText trace{3, 100};
};

PolarArcs polar_arcs(int count, int pieces = 1) {
  PolarArcs result;
  result.trace.decimals(15).rapid({{'x', 11}, {'y', 2}, {'z', 0}});
  for (int i = 1; i <= count; ++i) {
    const int degrees = 7 * i % 360;
    result.program += fmt::format("G3 AP={} RP=10\n", degrees);
    result.trace.block(3 + i, 100);
    for (int k = 1; k <= pieces; ++k) {
      const double angle = (degrees - 7 + 7.0 * k / pieces) * kDegree;
      result.trace.arc("G17", {{'x', 1}, {'y', 2}}, 1,
                       {{'x', 1 + 10 * std::cos(angle)}, {'y', 2 + 10 * std::sin(angle)}});
    }
  }
  return result;
}

TEST(EnclosedArcs, PolarArcsAreFollowed) {
  for (int pieces : {1, 3}) {
    const PolarArcs arcs = polar_arcs(60, pieces);
    const Verdict verdict = judge_trace(arcs.program, arcs.trace.text(), sinumerik());
    EXPECT_EQ(decision(verdict.kind), Decision::go) << pieces << verdict.message << verdict.want;
  }
}

TEST(EnclosedArcs, WithoutLineNumbersArcsOfOneCircleAreJoined) {
  PolarArcs arcs = polar_arcs(60);
  Judging judging = sinumerik();
  judging.blocks = false;
  const Verdict verdict = judge_trace(arcs.program, arcs.trace.text(), judging);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message << verdict.want;
}

// Lines of one direction whose ends are known by enclosures only.
TEST(EnclosedArcs, WithoutLineNumbersPolarLinesAreJoined) {
  const double p = std::cos(25 * kDegree);
  const double q = std::sin(25 * kDegree);
  TraceText trace(1, 100);
  trace.decimals(15).rapid({{'x', 10 * p}, {'y', 10 * q}});
  trace.feed({{'x', 40 * p}, {'y', 40 * q}});
  Judging judging = sinumerik();
  judging.blocks = false;
  const Verdict verdict = judge_trace("G111 X0 Y0\nG0 AP=25 RP=10\nG1 RP=20 F100\nRP=30\nRP=40\n",
                                      trace.text(), judging);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message << verdict.want;
}

// By the angle of 33 degrees about (x + 5, 0): what the subject emits is computed in doubles.
TEST(EnclosedArcs, ArcsByTheirAngleAreFollowedFast) {
  constexpr int kArcs = 2'000;
  std::string program = "G17 G90 G71 G94 F100\n";
  TraceText trace(2, 100);
  trace.decimals(15);
  for (int i = 0; i < kArcs; ++i) {
    const double x = 0.5 * i;
    const int degrees = 20 + i % 300;
    program += fmt::format("G0 X{} Y0\nG2 I5 J0 AR={}\n", x, degrees);
    trace.block(2 + 2 * i, 0).rapid({{'x', x}, {'y', 0}}).block(3 + 2 * i, 100);
    const double angle = (180 - degrees) * kDegree;
    trace.arc("G17", {{'x', x + 5}, {'y', 0}}, -1,
              {{'x', x + 5 + 5 * std::cos(angle)}, {'y', 5 * std::sin(angle)}});
  }
  const std::clock_t begin = std::clock();
  const Verdict verdict = judge_trace(program, trace.text(), sinumerik());
  const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message << verdict.want;
  RecordProperty("microseconds_per_arc", static_cast<int>(took * 1e6 / kArcs));
  EXPECT_LT(took, 20);  // seconds of the processor, not of the clock
}

// From (30 cos 20, 30 sin 20, 0) through (30, 15, 4) to (12, 25, 9): of the tilted circle only
// enclosures are known.
TEST(EnclosedArcs, ACircleInSpaceFromAPolarPointIsFollowed) {
  const auto trace = [](double off) {
    TraceText text(2, 100);
    text.decimals(15).rapid(
        {{'x', 30 * std::cos(20 * kDegree)}, {'y', 30 * std::sin(20 * kDegree)}});
    return text.line(fmt::format(
        R"({{"k":"arc3","b":3,"via":{{"x":"30","y":"{:.15f}","z":"4"}},"to":{{"x":"12","y":"25","z":"9"}},"f":"100"}})",
        15 + off));
  };
  const std::string program = "G111 X0 Y0\nG0 AP=20 RP=30\nCIP I1=30 J1=15 K1=4 X12 Y25 Z9 F100\n";
  EXPECT_EQ(decision(judge_trace(program, trace(0).text(), sinumerik()).kind), Decision::go);
  EXPECT_EQ(decision(judge_trace(program, trace(0.01).text(), sinumerik()).kind), Decision::no_go);
}

// The end on the ray of the start, 0.003 further in: the angle of both is the same, and a subject's
// rounding puts its end on either side of the ray. The reference turns fully.
TEST(EnclosedArcs, AnArcToTheRayOfItsStartFitsOnEitherSideOfIt) {
  const std::string program =
      "G17 G90 G71 G94 F100\nG111 X0 Y0\nG0 AP=58.585 RP=6.978 Z0\nG2 AP=IC(0) RP=6.975\nG0 X0\n";
  Judging judging = sinumerik();
  judging.binary64 = false;
  judging.resolution = "0.000001";
  judging.reading = "sie.arc.correct=programmed";
  const double p = std::cos(58.585 * kDegree);
  const double q = std::sin(58.585 * kDegree);
  const auto trace = [&](double across, double radius) {
    TraceText text(3, 0);
    text.rapid({{'x', 6.978 * p}, {'y', 6.978 * q}, {'z', 0}}).block(4, 100);
    text.arc("G17", {{'x', 0}, {'y', 0}}, -1,
             {{'x', radius * p - across * q}, {'y', radius * q + across * p}});
    text.block(5, 0).rapid({{'x', 0}});
    return text.text();
  };
  for (const double across : {-2e-7, 2e-7}) {
    const Verdict verdict = judge_trace(program, trace(across, 6.975), judging);
    EXPECT_EQ(decision(verdict.kind), Decision::go) << across << verdict.message << verdict.want;
    EXPECT_EQ(decision(judge_trace(program, trace(across, 6.9749), judging).kind), Decision::no_go);
  }
  EXPECT_EQ(decision(judge_trace(program, trace(1e-4, 6.975), judging).kind), Decision::no_go);
}

// How far two equal enclosures lie apart cannot be told; that a traverse is no cut can.
TEST(EnclosedEnds, ADepartureIsToldThoughItsSizeIsNot) {
  const std::string end =
      R"("to":{"x":{"enclosure":["9.39692620785908384054","9.39692620785908384055"]},)"
      R"("y":{"enclosure":["3.42020143325668733044","3.42020143325668733045"]}})";
  const std::string start = R"({"k":"rapid","b":1,"to":{"x":"10","y":"0"}})"
                            "\n";
  constexpr std::string_view kCosine = "G0 X10 Y0\nG1 X=10*COS(20) Y=10*SIN(20) F100\n";
  const Judging judging = {.dialect = "sinumerik840d"};
  EXPECT_EQ(judge_trace(kCosine, start + R"({"k":"rapid","b":2,)" + end + "}\n", judging).kind,
            VerdictKind::fail_geometry);
  EXPECT_EQ(decision(judge_trace(kCosine, start + R"({"k":"feed","b":2,"f":"100",)" + end + "}\n",
                                 judging)
                         .kind),
            Decision::go);
}

// Where the ends of a whole turn are one point, an end known by an enclosure lies on either side of
// it, and what angle it is seen under has no sign.
TEST(EnclosedEnds, OfAWholeTurnDecideNothing) {
  constexpr std::string_view kHelix = "G0 AP=37 RP=10 Z0 S400 M3\nG3 AP=37 Z-5 TURN=1 F100\n";
  const auto decided = [&](std::string_view depth) {
    constexpr std::string_view kAt37Degrees =
        R"("to":{{"x":{{"enclosure":["7.98635510047292846284","7.98635510047292846285"]}},)"
        R"("y":{{"enclosure":["6.01815023152048279917","6.01815023152048279918"]}},"z":"{}"}}}})";
    const std::string start = R"({"k":"m","b":1,"m":3})"
                              "\n"
                              R"({"k":"rapid","b":1,)" +
                              fmt::format(kAt37Degrees, 0);
    const std::string turns =
        R"({"k":"arc","b":2,"plane":"G17","c":{"x":"0","y":"0"},"rot":2,"f":"100",)" +
        fmt::format(kAt37Degrees, depth);
    const Judging judging = {.dialect = "sinumerik840d"};
    return decision(judge_trace(kHelix, start + "\n" + turns + "\n", judging).kind);
  };
  EXPECT_EQ(decided("-5"), Decision::go);
  EXPECT_EQ(decided("-4"), Decision::no_go);
}

// A number about 0 is neither rounded rightly nor wrongly, and no sign of a point at the centre.
TEST(EnclosedEnds, AboutZeroAreJudgedByTheTolerance) {
  const std::string quarter =
      R"({"k":"arc","b":2,"plane":"G17","c":{"x":"5","y":"0"},"rot":-1,"f":"100",)"
      R"("to":{"x":{"enclosure":["4.9999999999999999","5.0000000000000001"]},"y":"5"}})"
      "\n";
  Judging judging = {.dialect = "rs274"};
  judging.exact = true;
  EXPECT_EQ(decision(judge_trace("G21 G90\nG2 X5 Y5 I5 F100\nM2\n", quarter, judging).kind),
            Decision::go);
  const std::string line =
      R"({"k":"rapid","b":2,"to":{"x":"10"}})"
      "\n"
      R"({"k":"feed","b":3,"to":{"x":{"enclosure":["-1e-16","1e-16"]}},"f":"100"})"
      "\n";
  judging = {.dialect = "rs274"};
  judging.binary64 = true;
  EXPECT_EQ(decision(judge_trace("G21 G90\nG0 X10\nG1 X0 F100\nM2\n", line, judging).kind),
            Decision::go);
}

}  // namespace
}  // namespace gonogo::oracle
