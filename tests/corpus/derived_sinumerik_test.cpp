// SPDX-License-Identifier: GPL-3.0-or-later
//
// SINUMERIK 840D path commands derived by hand or taken from worked examples, against the
// vectors. Every number is rounded to nine decimals. r is the vector from the centre to the start
// of an arc, in the order of its plane: (X,Y), (Z,X), (Y,Z). A quarter turn counterclockwise takes
// (p, q) to (-q, p), one clockwise to (q, -p).
#include <gtest/gtest.h>

#include "corpus_testing.hpp"
#include "derived.hpp"

namespace gonogo::testing {
namespace {

using reference::Number;
using reference::Record;
using reference::RecordKind;

std::string rounded(const Number& number) {
  std::string text = number.decimal_text(9);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

// Most programs turn the spindle before they cut, which shapes no path.
bool turns_spindle(const Record& record) {
  return record.kind == RecordKind::m && record.m == 3;
}

// The records of an expectation but that one and, where it ends in one, its alarm.
Lines lines_of(const std::string& id, std::size_t expectation = 0) {
  const oracle::Expectation expected = checked_in_expectation(id, expectation);
  Lines lines;
  for (const Record& record : expected.records) {
    if (!turns_spindle(record)) lines.push_back(line_of(record, rounded));
  }
  for (const oracle::ExpectedAlarm& alarm : expected.alarms) {
    lines.push_back(std::to_string(alarm.block) + " " + std::string(name(alarm.alarm)));
  }
  return lines;
}

// What all expectations of the seed's second arc have before the arc, and behind it.
const Lines kBefore = {"1 rapid x133 y44.48", "2 feed z-5 f1000"};
const Lines kEnd = {"4 m 30", "end x115 y113.3 z-5 a0 c0"};

TEST(DerivedSinumerikLine, OfThreeAxes) {
  const Lines want = {"2 rapid x20 y20 z2", "3 feed z-2 f40", "4 feed x80 y80 z-15 f40",
                      "5 rapid z100",       "5 m 30",         "end x80 y80 z100 a0 c0"};
  EXPECT_EQ(lines_of("s840.seed.000001"), want);
}

TEST(DerivedSinumerikLine, ARotaryAxisGoesAlong) {
  const Lines want = {"1 feed x100 y20 z30 a40 f100", "end x100 y20 z30 a40 c0"};
  EXPECT_EQ(lines_of("s840.seed.000002"), want);
}

// The first arc: S (67.5, 80.211), E (17.203, 38.029), centre (50, 50); rS^2 = 1218.954521,
// rE^2 = 1218.94805.
TEST(DerivedSinumerikFirstArc, ByItsCentreUnderEachCorrection) {
  for (const char* id : {"s840.seed.000003", "s840.seed.000004"}) {
    const Lines start = {"1 rapid x67.5 y80.211"};
    const Lines end = {"end x17.203 y38.029 z0 a0 c0"};
    EXPECT_EQ(
        lines_of(id, 0),
        start + Lines{"2 arc G17 1 cx50.000125102 cy49.999927534 x17.203 y38.029 f500"} + end);
    EXPECT_EQ(
        lines_of(id, 1),
        start + Lines{"2 arc G17 1 cx50.000037766 cy50.000031672 x17.203 y38.029 f500"} + end);
    EXPECT_EQ(lines_of(id, 2), start + Lines{"2 arc G17 1 cx50 cy50 x17.203 y38.029 f500"} + end);
  }
}

TEST(DerivedSinumerikFirstArc, ByItsRadius) {
  // h^2 = 34.913^2 - 4309.109333 / 4 = 141.64023575.
  const Lines want = {"1 rapid x67.5 y80.211",
                      "2 arc G17 1 cx49.999127587 cy50.001116952 x17.203 y38.029 f500",
                      "end x17.203 y38.029 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.seed.000007"), want);
}

TEST(DerivedSinumerikFirstArc, ByItsAngleAndEnd) {
  const Lines want = {"1 rapid x67.5 y80.211",
                      "2 arc G17 1 cx50.000077645 cy49.999984121 x17.203 y38.029 f500",
                      "end x17.203 y38.029 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.seed.000008"), want);
}

TEST(DerivedSinumerikFirstArc, ByItsAngleAndCentre) {
  const Lines want = {"1 rapid x67.5 y80.211",
                      "2 arc G17 1 cx50 cy50 x17.202872937 y38.029077837 f500",
                      "end x17.202872937 y38.029077837 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.seed.000009"), want);
}

TEST(DerivedSinumerikFirstArc, AboutAPole) {
  const std::string id = "s840.seed.000011";
  const Lines start = {"1 rapid x67.5 y80.211"};
  const Lines end = {"end x17.203362302 y38.029280526 z0 a0 c0"};
  EXPECT_EQ(
      lines_of(id, 0),
      start + Lines{"3 arc G17 1 cx50.000714375 cy49.999586203 x17.203362302 y38.029280526 f500"} +
          end);
  EXPECT_EQ(lines_of(id, 2),
            start + Lines{"3 arc G17 1 cx50 cy50 x17.203362302 y38.029280526 f500"} + end);
}

TEST(DerivedSinumerikFirstArc, AsPrinted) {
  const Lines dash = {"1 rapid x67.5 y80.211", "2 syntax"};
  EXPECT_EQ(lines_of("s840.seed.000005"), dash);
  // J-ALM-04: the feed is a word that is missing.
  const Lines feed = {"1 rapid x67.5 y80.211", "2 feed-missing", "2 missing-word"};
  EXPECT_EQ(lines_of("s840.seed.000006"), feed);
}

// The second arc: S (133, 44.48), E (115, 113.3), centre (90, 70); rS^2 = 2500.2704,
// rE^2 = 2499.89.
TEST(DerivedSinumerikSecondArc, ByItsCentreUnderEachCorrection) {
  for (const char* id : {"s840.seed.000012", "s840.seed.000013"}) {
    EXPECT_EQ(
        lines_of(id, 0),
        kBefore + Lines{"3 arc G17 -1 cx89.99805856 cy69.996728481 x115 y113.3 f1000"} + kEnd);
    EXPECT_EQ(
        lines_of(id, 1),
        kBefore + Lines{"3 arc G17 -1 cx90.000676575 cy69.997413228 x115 y113.3 f1000"} + kEnd);
    EXPECT_EQ(lines_of(id, 2), kBefore + Lines{"3 arc G17 -1 cx90 cy70 x115 y113.3 f1000"} + kEnd);
  }
}

TEST(DerivedSinumerikSecondArc, ByItsRadiusOfEitherSign) {
  // h^2 = 2500 - 5060.1924 / 4 = 1234.9519.
  EXPECT_EQ(lines_of("s840.seed.000014"),
            kBefore + Lines{"3 arc G17 -1 cx90.001780412 cy69.997701939 x115 y113.3 f1000"} + kEnd);
  EXPECT_EQ(
      lines_of("s840.seed.000015"),
      kBefore + Lines{"3 arc G17 -1 cx157.998219588 cy87.782298061 x115 y113.3 f1000"} + kEnd);
}

TEST(DerivedSinumerikSecondArc, ByItsAngle) {
  const Lines centre = {"3 arc G17 -1 cx90 cy70 x115.000322788 y113.304206037 f1000", "4 m 30",
                        "end x115.000322788 y113.304206037 z-5 a0 c0"};
  EXPECT_EQ(lines_of("s840.seed.000016"), kBefore + centre);
  EXPECT_EQ(lines_of("s840.seed.000017"),
            kBefore + Lines{"3 arc G17 -1 cx90.001916449 cy69.997737519 x115 y113.3 f1000"} + kEnd);
}

TEST(DerivedSinumerikSecondArc, AsPrintedWithG91) {
  // The end is (248, 157.78), 130.7 off; its chord is 161.44 long. J-ALM-04: either name is right.
  const Lines off = kBefore + Lines{"3 arc-end-point", "3 arc-radius"};
  EXPECT_EQ(lines_of("s840.seed.000018"), off);
  EXPECT_EQ(lines_of("s840.seed.000019"), off);
  const Lines beyond = kBefore + Lines{"3 arc-radius", "3 arc-end-point"};
  EXPECT_EQ(lines_of("s840.seed.000020"), beyond);
  EXPECT_EQ(lines_of("s840.seed.000021"), lines_of("s840.seed.000016"));
}

TEST(DerivedSinumerikManuals, OneArcInFourForms) {
  // From (30, 40) to (50, 40), clockwise. Both radii about (40, 33) are the root of 149; that of
  // 12.207 has its centre 49.010849^(1/2) = 7.000774888 below the chord.
  const Lines start = {"1 rapid x30 y40"};
  const Lines end = {"end x50 y40 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.seed.000023"),
            start + Lines{"2 arc G17 -1 cx40 cy33 x50 y40 f100"} + end);
  EXPECT_EQ(lines_of("s840.seed.000024"),
            start + Lines{"2 arc G17 -1 cx40 cy32.999225114 x50 y40 f100"} + end);
  EXPECT_EQ(lines_of("s840.seed.000025"),
            start + Lines{"2 arc3 via x40 y45 z0 to x50 y40 z0 f100"} + end);
  const Lines polar = {"3 arc G17 -1 cx40 cy33 x51.396216266 y37.37459756 f100",
                       "end x51.396216266 y37.37459756 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.seed.000026", 2), start + polar);
}

TEST(DerivedSinumerikManuals, AHelixOfTwoTurnsAndSome) {
  // About (20, 20); 210 degrees and 720.
  const Lines want = {"1 rapid x27.5 y32.99 z-5", "2 arc G17 3 cx20 cy20 x20 y5 z-20 f100",
                      "end x20 y5 z-20 a0 c0"};
  EXPECT_EQ(lines_of("s840.helix.000031", 2), want);
}

TEST(DerivedSinumerikManuals, AHelixOfThreeTurnsAndAHalf) {
  const Lines want = {"1 rapid x0 y50 z50", "2 arc G17 4 cx0 cy25 x0 y0 z33 f100",
                      "end x0 y0 z33 a0 c0"};
  EXPECT_EQ(lines_of("s840.helix.000032"), want);
}

TEST(DerivedSinumerikManuals, AChainOfPoles) {
  // (20, 10) + 50 (cos 30, sin 30) = (63.301, 35); the pole (53.301, 55), and 30 at 45 degrees; the
  // pole (93.301, 75), and 30 at 135.
  const Lines want = {"2 feed x63.301270189 y35 f100", "4 feed x74.514473625 y76.213203436 f100",
                      "6 feed x72.088066754 y96.213203436 f100",
                      "end x72.088066754 y96.213203436 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.poles.000024"), want);
}

TEST(DerivedSinumerikArc, AQuarterClockwiseOfZAndX) {
  // From (Z-12, X-5) about the zero: r (-12, -5) becomes (-5, 12).
  const Lines want = {"1 rapid x-5 z-12", "2 arc G18 -1 cx0 cz0 x12 z-5 f100",
                      "end x12 y0 z-5 a0 c0"};
  EXPECT_EQ(lines_of("s840.arcs.000017"), want);
}

TEST(DerivedSinumerikArc, ThreeQuartersClockwiseOfZAndX) {
  // From (Z2, X8) about (Z-2, X5): r (4, 3); three quarters clockwise are one counterclockwise,
  // (-3, 4), which is (Z-5, X9).
  const Lines want = {"1 rapid x8 z2", "2 arc G18 -1 cx5 cz-2 x9 z-5 f100", "end x9 y0 z-5 a0 c0"};
  EXPECT_EQ(lines_of("s840.arcs.000019"), want);
}

TEST(DerivedSinumerikArc, AQuarterCounterclockwiseOfYAndZ) {
  // r (-12, -5) becomes (5, -12).
  const Lines want = {"1 rapid y-12 z-5", "2 arc G19 1 cy0 cz0 y5 z-12 f100",
                      "end x0 y5 z-12 a0 c0"};
  EXPECT_EQ(lines_of("s840.arcs.000029"), want);
}

TEST(DerivedSinumerikArc, AFullCircleWithoutAnEndPoint) {
  // From (Z6, X17) by K4 I3: (Z10, X20).
  const Lines want = {"1 rapid x17 z6", "2 arc G18 -1 cx20 cz10 x17 z6 f100",
                      "end x17 y0 z6 a0 c0"};
  EXPECT_EQ(lines_of("s840.arcs.000045"), want);
}

TEST(DerivedSinumerikArc, AbsoluteOfAChordWordIsZeroAndNotLeftOut) {
  // J=AC(0) is Y0, 10 below the start: r (0, 10) becomes (10, 0).
  const Lines want = {"1 rapid x10 y10", "2 arc G17 -1 cx10 cy0 x20 y0 f100",
                      "end x20 y0 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.arcs.000087"), want);
}

TEST(DerivedSinumerikArc, IncrementsOfTheEndAndAnAbsoluteCentre) {
  const Lines want = {"1 rapid x10 y5", "2 arc G17 -1 cx20 cy5 x30 y5 f100", "end x30 y5 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.arcs.000080"), want);
}

TEST(DerivedSinumerikRadius, TheCentreIsOnTheRightOfAShortClockwiseArc) {
  // The middle (4, 8); 12 along (0.6, -0.8).
  const Lines want = {"1 rapid x0 y5", "2 arc G17 -1 cx11.2 cy-1.6 x8 y11 f100",
                      "end x8 y11 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.cr.000001"), want);
}

TEST(DerivedSinumerikRadius, AndOnTheLeftOfALongOne) {
  const Lines want = {"1 rapid x0 y5", "2 arc G17 -1 cx-3.2 cy17.6 x8 y11 f100",
                      "end x8 y11 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.cr.000002"), want);
}

TEST(DerivedSinumerikRadius, InTheOrderOfZAndX) {
  // The middle (Z7, X-19), the chord (14, -48) / 50; right of it is (-48, -14) / 50: 60 along it
  // are
  // (-57.6, -16.8).
  const Lines want = {"1 rapid x5 z0", "2 arc G18 -1 cx-35.8 cz-50.6 x-43 z14 f100",
                      "end x-43 y0 z14 a0 c0"};
  EXPECT_EQ(lines_of("s840.cr.000017"), want);
}

TEST(DerivedSinumerikRadius, HalfATurnHasItsCentreInTheMiddleWhateverTheSign) {
  const Lines want = {"1 rapid x5 y0", "2 arc G17 -1 cx15 cy0 x25 y0 f100", "end x25 y0 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.cr.000025"), want);
  EXPECT_EQ(lines_of("s840.cr.000026"), want);
}

TEST(DerivedSinumerikRadius, AChordThatIsForgivenHasItsCentreInTheMiddle) {
  const Lines want = {"1 rapid x0 y0", "2 arc G17 -1 cx5.005 cy0 x10.01 y0 f100",
                      "end x10.01 y0 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.cr.000059"), want);
  EXPECT_EQ(lines_of("s840.cr.000060"),
            (Lines{"1 rapid x0 y0", "2 arc-radius", "2 arc-end-point"}));
}

TEST(DerivedSinumerikAngle, WithTheEndPoint) {
  // A quarter over (10, 10): the centre 5 root 2 to the left of the middle. Half a turn: the middle
  // (5, 15). A quarter over (0, -20): 10 to the left, along +X, of (0, 10).
  const Lines want = {"1 rapid x0 y0", "2 arc G17 1 cx0 cy10 x10 y10 f100",
                      "3 arc G17 1 cx5 cy15 x0 y20 f100", "4 arc G17 1 cx10 cy10 x0 y0 f100",
                      "end x0 y0 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.ar.000057"), want);
}

TEST(DerivedSinumerikAngle, WithTheCentre) {
  // 10 (cos 60, sin 60).
  const Lines want = {"1 rapid x10", "2 arc G17 1 cx0 cy0 x5 y8.660254038 f100",
                      "3 feed x0 y0 f100", "end x0 y0 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.ar.000030"), want);
}

TEST(DerivedSinumerikPolar, AFullCircleAtAnAngleWithoutARoot) {
  // 10 (cos 37, sin 37).
  const Lines want = {"1 rapid x7.9863551 y6.018150232",
                      "2 arc G17 1 cx0 cy0 x7.9863551 y6.018150232 f100",
                      "end x7.9863551 y6.018150232 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.polar.000089"), want);
}

TEST(DerivedSinumerikPolar, AngleAndRadiusStay) {
  // 10, 20, 30 at 30 degrees.
  const Lines want = {"1 feed x8.660254038 y5 f100", "2 feed x17.320508076 y10 f100",
                      "3 feed x25.980762114 y15 f100", "end x25.980762114 y15 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.polar.000018"), want);
}

TEST(DerivedSinumerikPolar, PolesAddUp) {
  // Three times (1, 2), and 5 along X.
  const Lines want = {"4 feed x8 y6 f100", "end x8 y6 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.poles.000012"), want);
}

TEST(DerivedSinumerikPlane, TheEndPointChoosesIt) {
  // From (Z5, X10) by I-10: half a turn about (Z5, X0).
  const Lines want = {"1 rapid x10 z5", "2 arc G18 -1 cx0 cz5 x-10 z5 f100",
                      "end x-10 y0 z5 a0 c0"};
  EXPECT_EQ(lines_of("s840.planes.000025"), want);
}

TEST(DerivedSinumerikPlane, ACentreWordOfTheOtherAxisMakesAHelix) {
  const Lines want = {"1 rapid x0 y0 z0", "2 arc G17 -1 cx10 cy0 x20 y0 z-5 f100",
                      "end x20 y0 z-5 a0 c0"};
  EXPECT_EQ(lines_of("s840.planes.000035"), want);
}

TEST(DerivedSinumerikPlane, OneInEach) {
  const Lines want = {"1 rapid x0 y0 z0", "2 arc G17 -1 cx10 cy0 x10 y10 f100",
                      "3 arc G19 -1 cy20 cz0 y20 z10 f100", "4 arc G18 -1 cx10 cz20 x20 z20 f100",
                      "end x20 y20 z20 a0 c0"};
  EXPECT_EQ(lines_of("s840.planes.000034"), want);
}

TEST(DerivedSinumerikCorrection, HalfATurnOutsideHasItsCentreInTheMiddle) {
  // (5 - 5.008) / 2; programmed it stays.
  const Lines start = {"1 rapid x5"};
  const Lines end = {"end x-5.008 y0 z0 a0 c0"};
  const std::string id = "s840.correction.000004";
  EXPECT_EQ(lines_of(id, 0), start + Lines{"2 arc G17 1 cx-0.004 cy0 x-5.008 y0 f100"} + end);
  EXPECT_EQ(lines_of(id, 1), start + Lines{"2 arc G17 1 cx-0.004 cy0 x-5.008 y0 f100"} + end);
  EXPECT_EQ(lines_of(id, 2), start + Lines{"2 arc G17 1 cx0 cy0 x-5.008 y0 f100"} + end);
}

TEST(DerivedSinumerikCorrection, HalfATurnInsideGoesTheShorterWay) {
  // The middle (0.002, 0); (25 - 4.998^2)^(1/2) = 0.141407213, to the left of a chord along -X for
  // G3, to the right for G2.
  EXPECT_EQ(lines_of("s840.correction.000005")[1],
            "2 arc G17 1 cx0.002 cy-0.141407213 x-4.996 y0 f100");
  EXPECT_EQ(lines_of("s840.correction.000006")[1],
            "2 arc G17 -1 cx0.002 cy0.141407213 x-4.996 y0 f100");
}

TEST(DerivedSinumerikCorrection, AProjectedCentreIsOnTheBisector) {
  // Chord (-5, 5.005); the middle (2.5, 2.5025); from there the zero is -(2.5, 2.5025), of which
  // (2.5 * 5.005 + 2.5025 * 5) / (5^2 + 5.005^2) = 0.4999997502 lies along (5.005, 5) backwards.
  EXPECT_EQ(lines_of("s840.correction.000001", 1)[1],
            "2 arc G17 1 cx-0.00249875 cy0.002501249 x0 y5.005 f100");
}

TEST(DerivedSinumerikCip, InSpace) {
  const Lines want = {"1 rapid x10", "2 arc3 via x0 y10 z0 to x0 y0 z10 f100",
                      "end x0 y0 z10 a0 c0"};
  EXPECT_EQ(lines_of("s840.cip.000013"), want);
}

TEST(DerivedSinumerikCip, IncrementsOfBothPointsCountFromTheStart) {
  // From (10, 5): through (20, 15) to (30, 5).
  const Lines want = {"1 rapid x10 y5", "2 arc3 via x20 y15 z0 to x30 y5 z0 f100",
                      "end x30 y5 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.cip.000026"), want);
}

TEST(DerivedSinumerikCip, APointOfTheWayMakesALine) {
  // (2, 3, 4) is a third of (6, 9, 12).
  const Lines want = {"1 rapid x1 y2 z3", "2 feed x7 y11 z15 f100", "end x7 y11 z15 a0 c0"};
  EXPECT_EQ(lines_of("s840.cip.000035"), want);
}

TEST(DerivedSinumerikTangent, OneQuarterAndThree) {
  // t (1, 0). d (10, 10): k = 2 * 10 / 200 = 1/10; d (-10, 10): the same.
  EXPECT_EQ(
      lines_of("s840.ct.000001"),
      (Lines{"1 feed x10 f100", "2 arc G17 1 cx10 cy10 x20 y10 f100", "end x20 y10 z0 a0 c0"}));
  EXPECT_EQ(lines_of("s840.ct.000005"),
            (Lines{"1 feed x10 f100", "2 arc G17 1 cx10 cy10 x0 y10 f100", "end x0 y10 z0 a0 c0"}));
}

TEST(DerivedSinumerikTangent, BehindACircleInSpace) {
  // The circle through (10, 0, 0), (0, 10, 0), (0, 0, 10) turns about (1, 1, 1) and its centre is
  // 10/3 (1, 1, 1). At its end (1, 1, 1) x 10/3 (-1, -1, 2) is along (1, -1, 0). With d (-10, -5):
  // t x d = -15, d . d = 125; the centre is 125 / (2 * -15) times (1, 1).
  EXPECT_EQ(lines_of("s840.ct.000051").at(2),
            "3 arc G17 -1 cx-4.166666667 cy-4.166666667 x-10 y-5 f100");
}

TEST(DerivedSinumerikTangent, BehindAnArc) {
  // At (10, 0) a clockwise arc about the zero goes along (0, -1); d (10, -10): the centre (20, 0).
  EXPECT_EQ(lines_of("s840.ct.000032").at(2), "3 arc G17 1 cx20 cy0 x20 y-10 f100");
}

TEST(DerivedSinumerikTangent, OfZAndX) {
  // t along Z, d (10, 10).
  EXPECT_EQ(
      lines_of("s840.ct.000057"),
      (Lines{"1 feed z10 f100", "2 arc G18 1 cx10 cz10 x10 z20 f100", "end x10 y0 z20 a0 c0"}));
}

TEST(DerivedSinumerikModes, AssignmentsActFromLeftToRight) {
  const Lines want = {"1 rapid x5", "2 rapid y6", "end x5 y6 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.expressions.000035"), want);
}

TEST(DerivedSinumerikModes, RevolutionsOfADwell) {
  // 60 / 7.
  const Lines want = {"2 dwell 8.571428571", "end x0 y0 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.modes.000057"), want);
}

TEST(DerivedSinumerikModes, FUnderG70) {
  const Lines end = {"end x25.4 y0 z0 a0 c0"};
  const std::string id = "s840.units.000018";
  EXPECT_EQ(lines_of(id, 0), Lines{"1 feed x25.4 f10"} + end);
  EXPECT_EQ(lines_of(id, 1), Lines{"1 feed x25.4 f254"} + end);
}

TEST(DerivedSinumerikModes, AnArcInInches) {
  // From 25.4 to 50.8 about 38.1.
  const Lines want = {"1 rapid x25.4", "2 arc G17 -1 cx38.1 cy0 x50.8 y0 f100",
                      "end x50.8 y0 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.units.000021"), want);
}

TEST(DerivedSinumerikModes, EachWordInItsOwnWay) {
  // From (10, 20, 30): X 5 more, Y to 5, Z 2 less; then X to 5, Y 5 more, Z to -2.
  const Lines want = {"1 rapid x10 y20 z30", "2 feed x15 y5 z28 f100", "3 feed x5 y10 z-2 f100",
                      "end x5 y10 z-2 a0 c0"};
  EXPECT_EQ(lines_of("s840.address.000038"), want);
}

TEST(DerivedSinumerikModes, NoCodeOfMotionYet) {
  const std::string id = "s840.modes.000005";
  EXPECT_EQ(lines_of(id, 0), (Lines{"1 feed-missing", "1 missing-word"}));
  EXPECT_EQ(lines_of(id, 1), (Lines{"1 rapid x10", "end x10 y0 z0 a0 c0"}));
}

TEST(DerivedSinumerikModes, FunctionsBeforeAndBehindTheMotion) {
  const Lines want = {"1 m 8", "1 rapid x10", "1 m 0", "2 rapid x20", "end x20 y0 z0 a0 c0"};
  EXPECT_EQ(lines_of("s840.modes.000076"), want);
}

}  // namespace
}  // namespace gonogo::testing
