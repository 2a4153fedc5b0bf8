// SPDX-License-Identifier: GPL-3.0-or-later
//
// One motion of what must come, made up of several of the subject's.
#include "checker/match.hpp"

#include <gtest/gtest.h>

#include "checker/motion_match.hpp"

namespace gonogo::checker {
namespace {

std::vector<Record> records_of(const std::vector<std::string>& texts) {
  std::vector<Record> records;
  for (const std::string& text : texts) records.push_back(read_record(parse_json(text)));
  return records;
}

Judgement found(const std::vector<std::string>& want, const std::vector<std::string>& got,
                const char* dialect = "rs274", const char* program = "\n\n",
                bool is_exact = false) {
  const Vector vector{"x.y.000001", dialect, {}, parse_json("{}"), program, {}};
  Expectation expectation;
  expectation.records = records_of(want);
  Tolerances tolerances;
  tolerances.tolerance = Rational(1, 1000);
  tolerances.is_exact = is_exact;
  return match(vector, expectation, {records_of(got), std::nullopt, TraceEnd::end, {}}, tolerances);
}

std::string to(const char* kind, const std::string& axes) {
  return std::string(R"({"k":")") + kind + R"(","b":1,"to":{)" + axes + R"(},"f":"100"})";
}

std::string arc(const std::string& axes, const char* rotation = "-1") {
  return R"({"k":"arc","b":1,"plane":"G17","c":{"x":"0","y":"0"},"rot":)" + std::string(rotation) +
         R"(,"to":{)" + axes + R"(},"f":"100"})";
}

const std::string kLine = to("feed", R"("x":"6","y":"9")");
const std::string kStart = to("rapid", R"("x":"10")");
const std::string kHalf = arc(R"("x":"-10","y":"0")");

TEST(CheckerMatch, PiecesOfALineMayLieBesideItByTheTolerance) {
  // At x 2 the line is at y 3.
  EXPECT_EQ(found({kLine}, {to("feed", R"("x":"2","y":"3.001")"), kLine}).answer, Answer::fits);
  EXPECT_EQ(found({kLine}, {to("feed", R"("x":"2","y":"3.003")"), kLine}).answer, Answer::departs);
}

TEST(CheckerMatch, ALineMayNotGoBack) {
  const std::string far = to("feed", R"("x":"4","y":"6")");
  const std::string back = to("feed", R"("x":"2","y":"3")");
  EXPECT_EQ(found({kLine}, {far, back, kLine}).answer, Answer::departs);
}

TEST(CheckerMatch, ALineThatStopsShortIsADeparture) {
  EXPECT_EQ(found({kLine}, {to("feed", R"("x":"4","y":"6")")}).answer, Answer::departs);
}

TEST(CheckerMatch, ALineThatGoesTooFarIsADeparture) {
  EXPECT_EQ(found({kLine}, {to("feed", R"("x":"8","y":"12")")}).answer, Answer::departs);
}

TEST(CheckerMatch, ATraverseMayTakeItsAxesOneByOne) {
  const std::string both = to("rapid", R"("x":"5","y":"-5")");
  EXPECT_EQ(found({both}, {to("rapid", R"("y":"-5")"), to("rapid", R"("x":"5")")}).answer,
            Answer::fits);
}

TEST(CheckerMatch, ATraverseMayNotTurnBackNorMoveAnotherAxis) {
  const std::string both = to("rapid", R"("x":"5","y":"-5")");
  EXPECT_EQ(found({both}, {to("rapid", R"("x":"6")"), both}).answer, Answer::departs);
  EXPECT_EQ(
      found({both}, {to("rapid", R"("z":"1")"), to("rapid", R"("x":"5","y":"-5","z":"0")")}).answer,
      Answer::departs);
}

// R4: two that turn back within the tolerance may do so by twice it, and no number of them by more.
TEST(CheckerMatch, ATraverseMayNotCreepBack) {
  const std::string want = to("rapid", R"("x":"100","z":"10")");
  std::vector<std::string> got = {to("rapid", R"("x":"20","z":"10")"),
                                  to("rapid", R"("x":"30","z":"9.999")"),
                                  to("rapid", R"("x":"40","z":"9.998")"), want};
  EXPECT_EQ(found({want}, got).answer, Answer::fits);
  got.insert(got.end() - 1, to("rapid", R"("x":"50","z":"9.997")"));
  EXPECT_EQ(found({want}, got).answer, Answer::departs);
}

// Down by nine thousandths and up again, each motion no longer than the tolerance.
TEST(CheckerMatch, ShortMotionsThatLeadAwayAreADeparture) {
  std::vector<std::string> got;
  for (const int depth : {1, 2, 3, 4, 5, 6, 7, 8, 9, 8, 7, 6, 5, 4, 3, 2, 1}) {
    got.push_back(to("feed", R"("z":"-0.00)" + std::to_string(depth) + "\""));
  }
  got.push_back(to("feed", R"("z":"0")"));
  got.push_back(kLine);
  EXPECT_EQ(found({kLine}, got).answer, Answer::departs);
  EXPECT_EQ(found({kLine}, {got.front(), kLine}).answer, Answer::fits);
}

TEST(CheckerMatch, ACircleInSpaceThatIsNotDueIsADeparture) {
  const std::string circle = R"({"k":"arc3","b":1,"to":{"x":"0","y":"0","z":"0"},)"
                             R"("via":{"x":"0","y":"100","z":"-50"},"f":"100"})";
  EXPECT_EQ(found({kLine}, {circle, kLine}).answer, Answer::departs);
}

TEST(CheckerMatch, AnArcMayComeInPieces) {
  // (0, -10) is a quarter on; 0.0005 off is no exact continuation, but within the tolerance.
  const std::string quarter = arc(R"("x":"0.0005","y":"-10")");
  EXPECT_EQ(found({kStart, kHalf}, {kStart, quarter, kHalf}).answer, Answer::fits);
}

TEST(CheckerMatch, APieceBesideTheArcIsADeparture) {
  const std::string quarter = arc(R"("x":"0","y":"-10.5")");
  EXPECT_EQ(found({kStart, kHalf}, {kStart, quarter, kHalf}).answer, Answer::departs);
}

TEST(CheckerMatch, PiecesThatMakeATurnTooManyAreADeparture) {
  // From (10, 0) clockwise over a quarter to a whole turn and the half: more than the half.
  const std::string quarter = arc(R"("x":"0.0005","y":"-10")");
  EXPECT_EQ(found({kStart, kHalf}, {kStart, quarter, arc(R"("x":"10","y":"0")"), kHalf}).answer,
            Answer::departs);
}

// J-PATH-06.
TEST(CheckerMatch, AnArcTurnsAsItsRecordSaysUnlessRoundingMayDecide) {
  const std::string whole = arc(R"("x":"10","y":"0")");
  const std::string a_bit = arc(R"("x":"10","y":"-0.001")");
  const std::string a_bit_less = arc(R"("x":"10","y":"0.001")");
  const auto told = [&](const std::vector<std::string>& got, bool is_exact) {
    return found({kStart, whole}, got, "rs274", "\n\n", is_exact).answer;
  };
  for (const bool is_exact : {false, true}) {
    EXPECT_EQ(told({kStart, whole}, is_exact), Answer::fits);
    EXPECT_EQ(told({kStart, a_bit_less}, is_exact), Answer::fits);
  }
  EXPECT_EQ(told({kStart, a_bit}, false), Answer::undecided);
  EXPECT_EQ(told({kStart, a_bit}, true), Answer::departs);
  EXPECT_EQ(told({kStart, a_bit, whole}, true), Answer::fits);
  EXPECT_EQ(found({kStart, whole}, {kStart, arc(R"("x":"10","y":"0")", "-3")}).answer,
            Answer::departs);
}

TEST(CheckerMatch, ADwellIsNoLength) {
  const auto dwell = [](const char* seconds) {
    return std::string(R"({"k":"dwell","b":1,"s":")") + seconds + "\"}";
  };
  EXPECT_EQ(found({dwell("0.0001")}, {dwell("0.0001")}).answer, Answer::fits);
  EXPECT_EQ(found({dwell("0.0001")}, {dwell("0.0000001")}).answer, Answer::undecided);
  EXPECT_EQ(found({dwell("0.1")}, {dwell("0.0001")}).answer, Answer::departs);
}

// R2, R3.
TEST(CheckerMatch, APieceOfAThreadHasTheAngleOfTheFirst) {
  const auto thread = [](const char* z, const char* start, const char* lead = "2") {
    return std::string(R"({"k":"thread","b":1,"to":{"z":")") + z + R"("},"lead":")" + lead +
           R"(","start":")" + start + "\"}";
  };
  const std::vector<std::string> want = {kStart, thread("-20", "0")};
  EXPECT_EQ(found(want, {kStart, thread("-7", "0"), thread("-20", "360")}).answer, Answer::fits);
  EXPECT_EQ(found(want, {kStart, thread("-7", "0"), thread("-20", "77")}).answer, Answer::departs);
  EXPECT_EQ(found(want, {kStart, thread("-20", "0", "2.0001")}).answer, Answer::departs);
}

// What ends exactly where it starts makes whole turns, and what nearly makes one after others makes
// it.
TEST(CheckerMatch, OneTurnTooManyOfWholeCirclesIsADeparture) {
  const std::string twice = arc(R"("x":"10","y":"0")", "-2");
  EXPECT_EQ(found({kStart, twice}, {kStart, twice}).answer, Answer::fits);
  EXPECT_EQ(found({kStart, twice}, {kStart, arc(R"("x":"10","y":"0")", "-3")}).answer,
            Answer::departs);
  EXPECT_EQ(found({kStart, twice}, {kStart, arc(R"("x":"10","y":"0.001")", "-3")}).answer,
            Answer::departs);
  EXPECT_EQ(found({kStart, twice}, {kStart, arc(R"("x":"10","y":"-0.001")", "-3")}).answer,
            Answer::fits);
  // By 0.003 over: fewer turns may be a piece.
  const std::string over = arc(R"("x":"10","y":"-0.003")", "-2");
  EXPECT_EQ(found({kStart, over}, {kStart, arc(R"("x":"10","y":"-0.003")", "-1")}).answer,
            Answer::undecided);
}

TEST(CheckerMatch, AShortArcWhereNoneIsWantedIsNil) {
  const std::string short_arc = arc(R"("x":"10","y":"-0.0005")");
  EXPECT_EQ(found({kStart}, {kStart, short_arc}).answer, Answer::fits);
  // The long way round, or in so many words a whole turn; after rounding it may be none.
  EXPECT_EQ(found({kStart}, {kStart, arc(R"("x":"10","y":"0.0005")")}).answer, Answer::undecided);
  EXPECT_EQ(found({kStart}, {kStart, arc(R"("x":"10","y":"0")")}).answer, Answer::undecided);
  EXPECT_EQ(found({kStart}, {kStart, arc(R"("x":"10","y":"-0.5")")}).answer, Answer::departs);
}

TEST(CheckerMatch, AHelixWithAnotherDepthIsADeparture) {
  const std::string down = arc(R"("x":"10","y":"0","z":"-4")", "-2");
  EXPECT_EQ(found({kStart, down}, {kStart, down}).answer, Answer::fits);
  EXPECT_EQ(found({kStart, down}, {kStart, arc(R"("x":"10","y":"0","z":"-4.1")", "-2")}).answer,
            Answer::departs);
}

TEST(CheckerMatch, ACircleInSpaceThroughAnotherPointIsNotDecided) {
  const auto circle = [](const char* via) {
    return std::string(R"({"k":"arc3","b":1,"to":{"x":"2","y":"0","z":"0"},"via":{"x":"1",)") +
           via + R"(},"f":"100"})";
  };
  const std::string one = circle(R"("y":"1","z":"0")");
  EXPECT_EQ(found({one}, {one}).answer, Answer::fits);
  EXPECT_EQ(found({one}, {circle(R"("y":"0","z":"1")")}).answer, Answer::undecided);
}

TEST(CheckerMatch, AMotionAsShortAsTheToleranceIsNoReasonForANoGo) {
  const std::string little = to("feed", R"("x":"0.0011")");
  const std::string rest = to("feed", R"("y":"5")");
  // Rounded to 0.001 the first motion is one that is dropped.
  const std::string rounded = to("feed", R"("x":"0.001")");
  EXPECT_EQ(found({little, rest}, {rounded, rest}).answer, Answer::undecided);
  EXPECT_EQ(found({little, rest}, {to("feed", R"("y":"6")")}).answer, Answer::departs);
}

TEST(CheckerMatch, AnOpenPathIsNoReasonForANoGo) {
  const auto circle = [](const char* clause, const char* radius) {
    return std::string(R"({"k":"arc","b":1,"plane":"G17","c":{"x":")") + radius +
           R"(","y":"0"},"rot":1,"to":{"x":"0","y":"0"},"f":"100","clause":")" + clause + "\"}";
  };
  const std::string open = circle("GSK-G110-09", "5");
  const std::string said = circle("GSK-COM-05", "5");
  const std::string other = circle("GSK-COM-05", "6");
  EXPECT_EQ(found({open}, {open}, "gsk988ta").answer, Answer::fits);
  EXPECT_EQ(found({open}, {other}, "gsk988ta").answer, Answer::undecided);
  EXPECT_EQ(found({said}, {other}, "gsk988ta").answer, Answer::departs);
}

TEST(CheckerMatch, AfterARenamingADepartureIsNotDecided) {
  const std::string one = R"({"k":"feed","b":2,"to":{"x":"1"},"f":"100"})";
  const std::string two = R"({"k":"feed","b":2,"to":{"x":"2"},"f":"100"})";
  EXPECT_EQ(found({one}, {two}, "gsk988ta", "G50 X0\nG01 X2\n").answer, Answer::undecided);
  EXPECT_EQ(found({one}, {one}, "gsk988ta", "G50 X0\nG01 X2\n").answer, Answer::fits);
  EXPECT_EQ(found({one}, {two}, "gsk988ta", "G00 X0\nG01 X2\n").answer, Answer::departs);
}

TEST(CheckerMatch, FeedsOfABinarySubjectMayBeOffByTwoUnitsOfTheLastPlace) {
  Tolerances tolerances;
  tolerances.is_binary64 = true;
  // Between 64 and 128 the last place is worth 2^-46.
  const Rational unit = parse_rational("0x1p-46");
  EXPECT_EQ(feed_agrees(100, Rational(100 + 2 * unit), tolerances), Truth::yes);
  EXPECT_EQ(feed_agrees(100, Rational(100 + 3 * unit), tolerances), Truth::no);
}

TEST(CheckerMatch, RootsAreComparedByTheirSquares) {
  // sqrt(2) <= sqrt(1) + t for t = 0.4142136 and not for 0.4142135.
  EXPECT_EQ(root_at_most(2, 1, Rational(4142136, 10000000)), Truth::yes);
  EXPECT_EQ(root_at_most(2, 1, Rational(4142135, 10000000)), Truth::no);
}

}  // namespace
}  // namespace gonogo::checker
