// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PATH-06: what a record says of its turns is what it does, also where its ends agree within the
// tolerance of 0.001 mm; what rounding leaves open of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

// A circle of radius 5 about (35, 0) from (30, 0) along the axes p and q, in any plane.
struct Circle {
  const char* plane;
  char p, q, d;
  bool clockwise = true;
};
constexpr Circle kCircles[] = {
    {"G17", 'x', 'y', 'z'},        {"G18", 'z', 'x', 'y'},        {"G19", 'y', 'z', 'x'},
    {"G17", 'x', 'y', 'z', false}, {"G18", 'z', 'x', 'y', false}, {"G19", 'y', 'z', 'x', false},
};

std::string program_of(const Circle& circle, const char* q_end = "0") {
  const auto upper = [](char c) { return static_cast<char>(c - 'a' + 'A'); };
  const auto centre = [](char c) { return static_cast<char>(c - 'x' + 'I'); };
  return fmt::format(
      "G0 X0 Y0 Z0 M3 S100\n{} G1 {}30 F100\n{} {}30 {}{} {}5 {}0\nG0 {}5\nM30\n", circle.plane,
      upper(circle.p), circle.clockwise ? "G2" : "G3", upper(circle.p), upper(circle.q), q_end,
      centre(circle.p), centre(circle.q), upper(circle.d));
}

// `ahead`: of the start, along the circle. Clockwise about a centre at greater p that is towards
// greater q.
std::string trace_of(const Circle& circle, int turns, const char* ahead, const char* d_end = "5") {
  const std::string_view size = ahead[0] == '-' ? ahead + 1 : ahead;
  const bool is_negative = (ahead[0] == '-') == circle.clockwise;
  return fmt::format(
      R"({{"k":"feed","b":2,"to":{{"{0}":"30"}},"f":"100"}}
{{"k":"arc","b":3,"plane":"{4}","c":{{"{0}":"35","{1}":"0"}},"rot":{5},"to":{{"{0}":"30","{1}":"{6}{7}"}},"f":"100"}}
{{"k":"rapid","b":4,"to":{{"{2}":"{3}"}}}}
)",
      circle.p, circle.q, circle.d, d_end, circle.plane, circle.clockwise ? -turns : turns,
      is_negative ? "-" : "", size);
}

enum class Says { nothing, exact, doubles, rounded };

Judging judging(Says says) {
  Judging result = {.dialect = "sinumerik840d"};
  result.exact = says == Says::exact;
  result.binary64 = says == Says::doubles;
  if (says == Says::rounded) result.resolution = "0.001";
  return result;
}

// A gap has its reason (R9).
Decision decided(const Circle& circle, int turns, const char* ahead, Says says) {
  const Verdict verdict =
      judge_trace(program_of(circle), trace_of(circle, turns, ahead), judging(says));
  const bool is_open = decision(verdict.kind) == Decision::undecided;
  EXPECT_EQ(verdict.gap, is_open ? GapReason::two_readings : GapReason::none);
  return decision(verdict.kind);
}

// A subject that drops a circle whose end is not its start to the last bit prints this.
TEST(StatedTurns, ACircleThatEndsJustAheadOfItsStartIsMissing) {
  for (const Circle& circle : kCircles) {
    for (const char* ahead : {"0.0005", "0.001", "0.0000000000001"}) {
      EXPECT_EQ(decided(circle, 1, ahead, Says::exact), Decision::no_go) << circle.plane << ahead;
      EXPECT_EQ(decided(circle, 1, ahead, Says::doubles), Decision::no_go) << circle.plane;
      // Rounding may have moved the end of a circle there.
      EXPECT_EQ(decided(circle, 1, ahead, Says::nothing), Decision::undecided) << circle.plane;
      EXPECT_EQ(decided(circle, 1, ahead, Says::rounded), Decision::undecided) << circle.plane;
    }
  }
}

TEST(StatedTurns, ACircleThatClosesOrFallsShortByLessThanTheToleranceIsOne) {
  for (const Circle& circle : kCircles) {
    for (const Says says : {Says::nothing, Says::exact, Says::doubles, Says::rounded}) {
      for (const char* ahead : {"0", "-0.0005", "-0.001"}) {
        EXPECT_EQ(decided(circle, 1, ahead, says), Decision::go) << circle.plane << ahead;
      }
      EXPECT_EQ(decided(circle, 1, "-0.0011", says), Decision::no_go) << circle.plane;
    }
  }
}

// One turn and less than the tolerance.
TEST(StatedTurns, AWholeTurnAndALittleIsOneTurn) {
  for (const Circle& circle : kCircles) {
    for (const Says says : {Says::nothing, Says::exact, Says::doubles, Says::rounded}) {
      EXPECT_EQ(decided(circle, 2, "0.0005", says), Decision::go) << circle.plane;
    }
  }
}

TEST(StatedTurns, ATurnTooManyIsOneAlsoWhereItFallsShort) {
  for (const Circle& circle : kCircles) {
    for (const Says says : {Says::nothing, Says::exact, Says::doubles, Says::rounded}) {
      for (const char* ahead : {"0", "-0.0005"}) {
        EXPECT_EQ(decided(circle, 2, ahead, says), Decision::no_go) << circle.plane << ahead;
      }
      EXPECT_EQ(decided(circle, 3, "0.0005", says), Decision::no_go) << circle.plane;
    }
  }
}

// The end of a double is off by 2e-15 at 35 mm: nothing tells which side was meant.
TEST(StatedTurns, DoublesMayCloseACircleOnEitherSide) {
  for (const Circle& circle : kCircles) {
    EXPECT_EQ(decided(circle, 1, "0.000000000000002", Says::doubles), Decision::go) << circle.plane;
    EXPECT_EQ(decided(circle, 1, "0.000000000000002", Says::exact), Decision::no_go);
  }
}

// What rounding leaves open excuses nothing else.
TEST(StatedTurns, BehindACircleThatRoundingLeavesOpenAnythingElseIsNoGo) {
  const Circle& circle = kCircles[0];
  const Verdict verdict = judge_trace(program_of(circle), trace_of(circle, 1, "0.0005", "6"),
                                      judging(Says::nothing));
  EXPECT_EQ(decision(verdict.kind), Decision::no_go) << verdict.message;
}

// The program goes on by 0.0005 along the circle; the record's end is its start: a whole turn. Of
// decimals of 0.001 the end is the right one, rounded.
TEST(StatedTurns, AWholeTurnForHardlyAMotionIsOneTooMany) {
  for (const Circle& circle : {kCircles[0], kCircles[1], kCircles[2]}) {
    const std::string program = program_of(circle, "0.0005");
    const auto told = [&](int turns, const char* ahead, Says says) {
      return decision(judge_trace(program, trace_of(circle, turns, ahead), judging(says)).kind);
    };
    EXPECT_EQ(told(1, "0.0005", Says::exact), Decision::go) << circle.plane;
    EXPECT_EQ(told(1, "0", Says::exact), Decision::no_go) << circle.plane;
    EXPECT_EQ(told(1, "-0.0004", Says::exact), Decision::no_go) << circle.plane;
    EXPECT_EQ(told(2, "0.0005", Says::exact), Decision::no_go) << circle.plane;
    EXPECT_EQ(told(1, "0", Says::doubles), Decision::no_go) << circle.plane;
    EXPECT_EQ(told(1, "0", Says::nothing), Decision::undecided) << circle.plane;
    EXPECT_EQ(told(1, "0", Says::rounded), Decision::go) << circle.plane;
    EXPECT_EQ(told(2, "0", Says::rounded), Decision::no_go) << circle.plane;
  }
}

// Three turns of a helix down by 6, which close.
TEST(StatedTurns, OfAHelixTheLastTurnCountsAsItIsStated) {
  const auto told = [](int rot, const char* y, const Judging& says) {
    const std::string trace = fmt::format(
        R"({{"k":"rapid","b":1,"to":{{"x":"30","y":"0","z":"0"}}}}
{{"k":"arc","b":2,"plane":"G17","c":{{"x":"35","y":"0"}},"rot":{},"to":{{"x":"30","y":"{}","z":"-6"}},"f":"100"}}
)",
        rot, y);
    return decision(
        judge_trace("G0 X30 Y0 Z0\nG2 X30 Y0 Z-6 I5 J0 P3 F100\n", trace, says).kind);
  };
  const Judging exact = {.dialect = "rs274", .exact = true};
  EXPECT_EQ(told(-3, "0", exact), Decision::go);
  EXPECT_EQ(told(-3, "-0.00005", exact), Decision::go);
  EXPECT_EQ(told(-4, "0.00005", exact), Decision::go);
  EXPECT_EQ(told(-3, "0.00005", exact), Decision::no_go);
  EXPECT_EQ(told(-4, "-0.00005", exact), Decision::no_go);
  EXPECT_EQ(told(-4, "0", exact), Decision::no_go);
  EXPECT_EQ(told(-2, "0", exact), Decision::no_go);
  const Judging rounded = {.resolution = "0.0001", .dialect = "rs274"};
  EXPECT_EQ(told(-3, "0", rounded), Decision::go);
  EXPECT_EQ(told(-3, "0.00005", rounded), Decision::undecided);
  EXPECT_EQ(told(-4, "0", rounded), Decision::no_go);
}

// In pieces it is known whether it is a turn: to (35, 5), and on to the end.
TEST(StatedTurns, InPiecesACircleMayEndOnEitherSideOfItsStart) {
  const Circle& circle = kCircles[0];
  const auto told = [&](const char* end, int first_rot) {
    const std::string trace = fmt::format(
        R"({{"k":"feed","b":2,"to":{{"x":"30"}},"f":"100"}}
{{"k":"arc","b":3,"plane":"G17","c":{{"x":"35","y":"0"}},"rot":{},"to":{{"x":"35","y":"5"}},"f":"100"}}
{{"k":"arc","b":3,"plane":"G17","c":{{"x":"35","y":"0"}},"rot":-1,"to":{{"x":"30","y":"{}"}},"f":"100"}}
{{"k":"rapid","b":4,"to":{{"z":"5"}}}}
)",
        first_rot, end);
    return decision(judge_trace(program_of(circle), trace, judging(Says::exact)).kind);
  };
  for (const char* end : {"0", "0.0005", "-0.0005"}) {
    EXPECT_EQ(told(end, -1), Decision::go) << end;
    EXPECT_EQ(told(end, -2), Decision::no_go) << end;
  }
}

}  // namespace
}  // namespace gonogo::oracle
