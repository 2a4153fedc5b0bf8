// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circles in space (arc3): as the reference's curve, as the subject's motion, joined and dropped.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "oracle/motion/curve_follower.hpp"

namespace gonogo::oracle {
namespace {

using reference::Plane;

// Points of a tilted circle of radius 15 about the origin, 15 (c e1 + s e2) with the unit vectors
// e1 = (1, 2, 2)/3 and e2 = (2, 1, -2)/3, which are at right angles: 1*2 + 2*1 - 2*2 = 0.
Position at(const Number& c, const Number& s) {
  Position point;
  point[Axis::x] = c * 5 + s * 10;
  point[Axis::y] = c * 10 + s * 5;
  point[Axis::z] = c * 10 - s * 10;
  return point;
}
// The angle whose cosine and sine are tenths: (8, 6) is 36.87 degrees, (6, 8) is 53.13.
Position tenths(int c, int s) {
  return at(Number(c) / 10, Number(s) / 10);
}

Position xyz(const char* x, const char* y, const char* z) {
  Position point;
  point[Axis::x] = *Number::parse(x);
  point[Axis::y] = *Number::parse(y);
  point[Axis::z] = *Number::parse(z);
  return point;
}

Number decimal(double value) {
  return Number::millionths(std::llround(value * 1e6));
}

Motion motion(RecordKind kind, const Position& from, const Position& to) {
  Motion result;
  result.record.kind = kind;
  result.record.feed = 100;
  result.record.to = to;
  result.record.axes = {Axis::x, Axis::y, Axis::z};
  result.from = from;
  return result;
}
Motion arc3(const Position& from, const Position& via, const Position& to) {
  Motion result = motion(RecordKind::arc3, from, to);
  result.record.via = via;
  result.record.via_axes = {Axis::x, Axis::y, Axis::z};
  return result;
}
Motion arc(Plane plane, const Position& from, std::array<Number, 2> centre, int rot,
           const Position& to) {
  Motion result = motion(RecordKind::arc, from, to);
  result.record.plane = plane;
  result.record.centre = std::move(centre);
  result.record.rot = rot;
  return result;
}

// The answer to the first piece that departs, else to the last.
MatchResult match(const Motion& reference, const std::vector<Motion>& pieces,
                  const char* chord = "0") {
  Tolerances tolerances;
  tolerances.chord = *Number::parse(chord);
  CurveFollower curve(reference, tolerances);
  MatchResult result;
  for (const Motion& piece : pieces) {
    result = curve.match(piece);
    if (result.departure != Departure::none) break;
  }
  return result;
}
bool fits(const Motion& reference, const std::vector<Motion>& pieces, const char* chord = "0") {
  const MatchResult result = match(reference, pieces, chord);
  return result.departure == Departure::none && result.done;
}

const Motion kHalfCircle = arc3(tenths(10, 0), tenths(0, 10), tenths(-10, 0));

TEST(Arc3, AnyPointOfTheArcServesAsIntermediatePoint) {
  for (const Position& via : {tenths(0, 10), tenths(8, 6), tenths(6, 8), tenths(-8, 6)}) {
    EXPECT_TRUE(fits(kHalfCircle, {arc3(tenths(10, 0), via, tenths(-10, 0))}));
  }
}

TEST(Arc3, TheOtherWayRoundIsTheWrongSense) {
  EXPECT_EQ(match(kHalfCircle, {arc3(tenths(10, 0), tenths(0, -10), tenths(-10, 0))}).departure,
            Departure::sense);
}

TEST(Arc3, PiecesOfTheCircleAreTheSameCircle) {
  const Motion first = arc3(tenths(10, 0), tenths(8, 6), tenths(6, 8));
  const Motion second = arc3(tenths(6, 8), tenths(0, 10), tenths(-6, 8));
  const Motion third = arc3(tenths(-6, 8), tenths(-8, 6), tenths(-10, 0));
  EXPECT_TRUE(fits(kHalfCircle, {first, second, third}));
  EXPECT_FALSE(match(kHalfCircle, {first, second}).done);
}

TEST(Arc3, APieceMayNotGoBeyondTheEnd) {
  EXPECT_EQ(match(kHalfCircle, {arc3(tenths(10, 0), tenths(0, 10), tenths(-8, -6))}).departure,
            Departure::geometry);
}

TEST(Arc3, APieceMayNotGoBack) {
  const Motion there = arc3(tenths(10, 0), tenths(6, 8), tenths(0, 10));
  const Motion back = arc3(tenths(0, 10), tenths(6, 8), tenths(8, 6));
  EXPECT_EQ(match(kHalfCircle, {there, back}).departure, Departure::sense);
}

TEST(Arc3, EndsAndIntermediatePointMayBeOffByTheToleranceAnAxis) {
  // The circle leaves the origin's sphere nowhere: a point moved outward by d along e1 = (1, 2,
  // 2)/3 is off by d/3, 2d/3, 2d/3; the tolerance of 0.001 an axis allows d up to 0.0015.
  const auto out = [](const char* d) {
    const Number third = *Number::parse(d) / 3;
    Position point = tenths(10, 0);
    point[Axis::x] += third;
    point[Axis::y] += third * 2;
    point[Axis::z] += third * 2;
    return point;
  };
  const Motion from_behind = arc3(tenths(0, -10), tenths(10, 0), tenths(0, 10));
  EXPECT_TRUE(fits(from_behind, {arc3(tenths(0, -10), out("0.0014"), tenths(0, 10))}));
  EXPECT_FALSE(fits(from_behind, {arc3(tenths(0, -10), out("0.0016"), tenths(0, 10))}));
  const Motion to_there = arc3(tenths(-10, 0), tenths(0, -10), tenths(10, 0));
  EXPECT_TRUE(fits(to_there, {arc3(tenths(-10, 0), tenths(0, -10), out("0.0014"))}));
  EXPECT_FALSE(fits(to_there, {arc3(tenths(-10, 0), tenths(0, -10), out("0.0016"))}));
}

// 0.03 mm after the start and 0.0009 mm further in than the circle: between points 30 mm apart that
// bends the arc inward by 0.0009 * 15 * 15 / (0.03 * 30) = 0.2 mm.
// J-PATH-09.
TEST(Arc3, AnIntermediatePointNearTheStartMayNotMakeAnotherCircle) {
  const Position good = xyz("5.02", "10.01", "9.98");
  const Position bad = xyz("5.0197", "10.0094", "9.9794");
  const Motion short_way = arc3(tenths(10, 0), good, tenths(-10, 0));
  EXPECT_EQ(match(kHalfCircle, {arc3(tenths(10, 0), bad, tenths(-10, 0))}).departure,
            Departure::geometry);
  // Its own circle is the one that it stands for.
  EXPECT_TRUE(fits(short_way, {short_way}));
}

// The program's own points 11 mm and 9 m apart, rounded to 1e-6: the circle through them is one of
// kilometres, and its middles move by 1e-6 * 9000 / 11 = 0.0008.
TEST(Arc3, TheProgramsOwnPointsMayBeRoundedWhateverCircleTheyMake) {
  const Position from = xyz("0.0000004", "0", "0");
  const Position via = xyz("9000", "0.0000004", "0");
  const Position to = xyz("0", "11.0000004", "3");
  const Motion want = arc3(from, via, to);
  const auto fits_within = [&](const Motion& subject, const char* tolerance) {
    Tolerances tolerances;
    tolerances.tolerance = *Number::parse(tolerance);
    return CurveFollower(want, tolerances).match(subject).departure == Departure::none;
  };
  const Motion rounded = arc3(xyz("0", "0", "0"), xyz("9000", "0", "0"), xyz("0", "11", "3"));
  EXPECT_TRUE(fits_within(rounded, "0.000001"));
  EXPECT_FALSE(fits_within(rounded, "0.0000003"));
}

TEST(Arc3, ThreePointsInLineAreNoArc) {
  EXPECT_EQ(
      match(kHalfCircle, {arc3(tenths(10, 0), xyz("10", "20", "20"), tenths(-10, 0))}).departure,
      Departure::geometry);
}

TEST(Arc3, ADoubleSubjectMayPutItInManyPieces) {
  const Motion most = arc3(tenths(10, 0), tenths(-10, 0), tenths(6, -8));
  const double whole = 2 * std::numbers::pi - std::atan2(0.8, 0.6);
  const auto point = [&](double part) {
    return at(decimal(std::cos(whole * part)), decimal(std::sin(whole * part)));
  };
  for (int pieces : {1, 2, 7, 300}) {
    std::vector<Motion> path;
    for (int i = 0; i < pieces; ++i) {
      path.push_back(
          arc3(point(1.0 * i / pieces), point((i + 0.5) / pieces), point((i + 1.0) / pieces)));
    }
    EXPECT_TRUE(fits(most, path)) << pieces;
  }
}

// 100 chords of a half circle of radius 15: height 15 (1 - cos 0.9 degrees) = 0.00185.
TEST(Arc3, ChordsNeedTheCertifiersGrant) {
  std::vector<Motion> path;
  Position here = tenths(10, 0);
  for (int i = 1; i <= 100; ++i) {
    const double angle = std::numbers::pi * i / 100;
    const Position next = at(decimal(std::cos(angle)), decimal(std::sin(angle)));
    path.push_back(motion(RecordKind::feed, here, next));
    here = next;
  }
  EXPECT_EQ(match(kHalfCircle, path).departure, Departure::kind);
  EXPECT_FALSE(fits(kHalfCircle, path, "0.0001"));
  EXPECT_TRUE(fits(kHalfCircle, path, "0.002"));
}

// Radius 10 about the origin, 3 above it, from +X over +Y to -X: counterclockwise in G17.
const Motion kFlat = arc3(xyz("10", "0", "3"), xyz("0", "10", "3"), xyz("-10", "0", "3"));

// J-PATH-09.
TEST(Arc3, InACoordinatePlaneAnArcIsTheSame) {
  const Position from = xyz("10", "0", "3");
  const Position to = xyz("-10", "0", "3");
  EXPECT_TRUE(fits(kFlat, {arc(Plane::g17, from, {0, 0}, 1, to)}));
  EXPECT_EQ(match(kFlat, {arc(Plane::g17, from, {0, 0}, -1, to)}).departure, Departure::sense);
  EXPECT_EQ(match(kFlat, {arc(Plane::g17, from, {*Number::parse("0.0011"), 0}, 1, to)}).departure,
            Departure::geometry);
  EXPECT_EQ(match(kFlat, {arc(Plane::g18, from, {3, 0}, 1, to)}).departure, Departure::geometry);
  EXPECT_FALSE(fits(kFlat, {arc(Plane::g17, from, {0, 0}, 2, to)}));
}

// The pair of G18 is (Z, X): from +Z to +X is counterclockwise.
TEST(Arc3, TheSenseOfAnArcIsThatOfItsPlane) {
  const Position from = xyz("0", "7", "10");
  const Position to = xyz("10", "7", "0");
  const Motion quarter = arc3(from, xyz("6", "7", "8"), to);
  EXPECT_TRUE(fits(quarter, {arc(Plane::g18, from, {0, 0}, 1, to)}));
  EXPECT_FALSE(fits(quarter, {arc(Plane::g18, from, {0, 0}, -1, to)}));
}

TEST(Arc3, AnArcIsNoCircleAcrossThePlanes) {
  EXPECT_EQ(
      match(kHalfCircle, {arc(Plane::g17, tenths(10, 0), {0, 0}, 1, tenths(-10, 0))}).departure,
      Departure::geometry);
}

TEST(Arc3, ServesForAnArcOfTheReference) {
  const Position from = xyz("10", "0", "3");
  const Position to = xyz("-10", "0", "3");
  const Motion want = arc(Plane::g17, from, {0, 0}, 1, to);
  EXPECT_TRUE(fits(want, {arc3(from, xyz("6", "8", "3"), to)}));
  EXPECT_TRUE(fits(want, {arc3(from, xyz("8", "6", "3"), xyz("6", "8", "3")),
                          arc3(xyz("6", "8", "3"), xyz("0", "10", "3"), to)}));
  EXPECT_EQ(match(want, {arc3(from, xyz("6", "-8", "3"), to)}).departure, Departure::sense);
  EXPECT_TRUE(fits(want, {arc3(from, xyz("6", "8", "3.001"), to)}));
  EXPECT_FALSE(fits(want, {arc3(from, xyz("6", "8", "3.0011"), to)}));
}

TEST(Arc3, HalvesMakeWholeTurnsOfAnArc) {
  const Position east = xyz("10", "0", "3");
  const Position west = xyz("-10", "0", "3");
  const Motion upper = arc3(east, xyz("6", "8", "3"), west);
  const Motion lower = arc3(west, xyz("6", "-8", "3"), east);
  const Motion once = arc(Plane::g17, east, {0, 0}, 1, east);
  EXPECT_TRUE(fits(once, {upper, lower}));
  EXPECT_FALSE(match(once, {upper}).done);
  EXPECT_EQ(match(once, {upper, lower, upper}).departure, Departure::geometry);
  const Motion twice = arc(Plane::g17, east, {0, 0}, 2, east);
  EXPECT_FALSE(match(twice, {upper, lower}).done);
  EXPECT_TRUE(fits(twice, {upper, lower, upper, lower}));
}

// 64 pieces of a turn of radius 10 that rises by 3.2; each leaves the helix by far less than 0.001.
// R2.
TEST(Arc3, SmallPiecesFollowAHelix) {
  const auto point = [](double turn, double off) {
    Position position;
    position[Axis::x] = decimal(10 * std::cos(2 * std::numbers::pi * turn));
    position[Axis::y] = decimal(10 * std::sin(2 * std::numbers::pi * turn));
    position[Axis::z] = decimal(3.2 * turn + off);
    return position;
  };
  const Motion helix = arc(Plane::g17, point(0, 0), {0, 0}, 1, point(1, 0));
  const auto path = [&](double off) {
    std::vector<Motion> pieces;
    for (int i = 0; i < 64; ++i) {
      const double from = i / 64.0;
      pieces.push_back(
          arc3(point(from, 0), point(from + 1 / 128.0, off), point(from + 1 / 64.0, 0)));
    }
    return pieces;
  };
  EXPECT_TRUE(fits(helix, path(0)));
  EXPECT_FALSE(fits(helix, path(0.002)));
}

TEST(Arc3, ALineMayComeAsAnArcThatNothingTellsFromIt) {
  const Motion line = motion(RecordKind::feed, xyz("0", "0", "0"), xyz("10", "0", "0"));
  const auto bulging = [&](const char* z) { return arc3(line.from, xyz("5", "0", z), line.to()); };
  EXPECT_TRUE(fits(line, {bulging("0.001")}));
  EXPECT_EQ(match(line, {bulging("0.0011")}).departure, Departure::kind);
  EXPECT_EQ(match(line, {bulging("5")}).departure, Departure::kind);
}

// A bulge of 0.0004 is none where places are written in thousandths.
// R3.
TEST(Arc3, MayComeAsALineThatNothingTellsFromIt) {
  const Position from = xyz("0", "0", "0");
  const Position to = xyz("10", "0", "0");
  const auto bulging = [&](const char* z) { return arc3(from, xyz("5", "0", z), to); };
  const auto middle = xyz("5", "0", "0");
  EXPECT_TRUE(fits(bulging("0.0004"), {motion(RecordKind::feed, from, to)}));
  EXPECT_TRUE(fits(bulging("0.0004"),
                   {motion(RecordKind::feed, from, middle), motion(RecordKind::feed, middle, to)}));
  EXPECT_EQ(
      match(bulging("0.0004"), {motion(RecordKind::feed, from, xyz("10", "0.002", "0"))}).departure,
      Departure::geometry);
  EXPECT_EQ(match(bulging("0.0011"), {motion(RecordKind::feed, from, to)}).departure,
            Departure::kind);
  const Motion most = arc3(tenths(10, 0), tenths(-10, 0), tenths(8, -6));
  EXPECT_EQ(match(most, {motion(RecordKind::feed, most.from, most.to())}).departure,
            Departure::kind);
}

TEST(Arc3, InLineItIsItsChord) {
  const Position from = xyz("0", "0", "0");
  const Position to = xyz("3", "6", "9");
  EXPECT_EQ(straightened(arc3(from, xyz("1", "2", "3"), to)).record.kind, RecordKind::feed);
  EXPECT_EQ(straightened(arc3(from, xyz("1", "2", "3.1"), to)).record.kind, RecordKind::arc3);
  EXPECT_EQ(straightened(arc3(from, xyz("4", "8", "12"), to)).record.kind, RecordKind::arc3);
}

TEST(Arc3, PiecesOfOneCircleAreJoined) {
  Motion path = arc3(tenths(10, 0), tenths(8, 6), tenths(6, 8));
  EXPECT_TRUE(join(path, arc3(tenths(6, 8), tenths(0, 10), tenths(-6, 8))));
  EXPECT_EQ(path.to(), tenths(-6, 8));
  EXPECT_TRUE(fits(arc3(tenths(10, 0), tenths(0, 10), tenths(-6, 8)), {path}));
}

TEST(Arc3, OtherCirclesAndOtherSensesAreNotJoined) {
  const Motion start = arc3(tenths(10, 0), tenths(8, 6), tenths(6, 8));
  Motion path = start;
  // The way back, another radius, another plane through the same tangent's point.
  EXPECT_FALSE(join(path, arc3(tenths(6, 8), tenths(8, 6), tenths(10, 0))));
  EXPECT_FALSE(join(path, arc3(tenths(6, 8), tenths(0, 10), xyz("0", "0", "0"))));
  EXPECT_FALSE(join(path, arc3(tenths(6, 8), xyz("0", "0", "15"), tenths(-6, -8))));
  EXPECT_EQ(path.to(), start.to());
}

TEST(Arc3, IsNotJoinedToAFullTurn) {
  Motion path = kHalfCircle;
  EXPECT_FALSE(join(path, arc3(tenths(-10, 0), tenths(0, -10), tenths(10, 0))));
  EXPECT_FALSE(join(path, arc3(tenths(-10, 0), tenths(0, -10), tenths(8, 6))));
  EXPECT_TRUE(join(path, arc3(tenths(-10, 0), tenths(-6, -8), tenths(0, -10))));
}

TEST(Arc3, GoesRoundWhereItsIntermediatePointIsElsewhere) {
  const Number tau = Number::millionths(1000);
  const Position here = xyz("0", "0", "0");
  const Position near = xyz("0.0004", "0", "0");
  EXPECT_FALSE(goes_round(arc3(here, xyz("0.0002", "0.0001", "0"), near), tau));
  EXPECT_TRUE(goes_round(arc3(here, xyz("0", "20", "0"), near), tau));
  // Nearly in line, and the intermediate point not between the ends: round a circle of radius
  // 0.0002 * 0.0006 / 0.0000002, over 0.5 mm.
  EXPECT_TRUE(goes_round(arc3(here, xyz("-0.0002", "0.0000001", "0"), near), tau));
}

// Beside the line by 0.0001 mm, the intermediate point beyond the end: what comes of it depends on
// the tolerance of 0.001 mm where a coordinate is no short decimal, and has to be rounded.
// R9.
TEST(Arc3, PointsInLineHangOnRoundingWhereThereIsAny) {
  const Number tau = Number::millionths(1000);
  const auto hangs = [&](const char* via_x, const char* via_y, const Number& start_y) {
    Position start = xyz("0", "0", "0");
    start[Axis::y] = start_y;
    return hangs_on_rounding(arc3(start, xyz(via_x, via_y, "0"), xyz("10", "0", "0")), tau);
  };
  const Number tiny = *Number::parse("0.00000000001");
  EXPECT_TRUE(hangs("20", "0.0001", tiny));
  EXPECT_TRUE(hangs("0", "0.0001", tiny));
  EXPECT_FALSE(hangs("20", "0.0001", 0));
  EXPECT_FALSE(hangs("5", "0.0001", tiny)) << "a flat arc";
  EXPECT_FALSE(hangs("20", "1", tiny)) << "a circle";
}

TEST(Arc3, ACircleNearlyClosedIsNoNilOne) {
  const Motion round = arc3(xyz("10", "0", "0"), xyz("-10", "0", "0"), xyz("10", "0.0005", "0"));
  EXPECT_TRUE(fits(round, {round}));
  // Clockwise all round, and the small way counterclockwise.
  const Motion small =
      arc3(xyz("10", "0", "0"), xyz("10.0001", "0.0002", "0"), xyz("10", "0.0005", "0"));
  EXPECT_FALSE(fits(round, {small}));
}

// The circle of radius 10 about Z, seen against Z.
TEST(SpaceCircle, AgreesWithPointsByTheToleranceOnEachAxis) {
  const auto circle = circle_through({10, 0, 0}, {0, 10, 0}, {-10, 0, 0});
  ASSERT_TRUE(circle);
  EXPECT_EQ(circle->radius_2, Number(100));
  const Number tau = Number::millionths(1000);
  const auto passes = [&](const char* x, const char* y, const char* z) {
    return passes_box(*circle, space_point(xyz(x, y, z)), tau);
  };
  EXPECT_TRUE(passes("10.001", "0", "0.001"));
  EXPECT_FALSE(passes("10.001000001", "0", "0"));
  EXPECT_FALSE(passes("10", "0", "0.001000001"));
  EXPECT_TRUE(passes("9.999", "0", "0"));
  EXPECT_FALSE(passes("9.998999", "0", "0"));
  // (6, 8) moved by (0.001, 0.001) has a corner of its box on the circle.
  EXPECT_TRUE(passes("6.001", "8.001", "0"));
  EXPECT_FALSE(passes("6.001", "8.0010001", "0"));
}

TEST(SpaceCircle, ItsMiddlesLieOnIt) {
  const SpacePoint a = space_point(tenths(10, 0));
  const SpacePoint b = space_point(tenths(8, 6));
  const SpacePoint c = space_point(tenths(-10, 0));
  const SpacePoint middle = middle_seen_from(a, b, c);
  EXPECT_EQ(dot(middle, middle), Number(225));
  // In the plane of e1 and e2, whose normal is e1 x e2, along (-2, 2, -1).
  EXPECT_EQ(dot(middle, {-2, 2, -1}), Number(0));
  const auto circle = circle_through(a, b, c);
  EXPECT_NEAR(part_of_turn(*circle, a, middle) * 360, (36.8699 + 180) / 2, 0.001);
}

}  // namespace
}  // namespace gonogo::oracle
