// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/chords.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "oracle/motion/swept_turns.hpp"
#include "reference/geometry/kernel.hpp"

namespace gonogo::oracle {
namespace {

using geometry::Point_2;
using geometry::Vector_2;

struct Circle {
  Point_2 centre;
  Number radius;
};

Point_2 place(const PlaneVector& point) {
  return {point.p, point.q};
}

// Three of the points, those that lie least in line: first, middle and last, or a third apart
// where the first and last are near each other.
std::optional<Circle> circle_of(std::span<const PlaneVector> points) {
  const std::size_t last = points.size() - 1;
  const Point_2 a = place(points[0]);
  std::array<Point_2, 2> widest;
  Number area = 0;
  for (const auto& [i, k] : {std::pair(last / 2, last), std::pair(last / 3, last - last / 3)}) {
    const Point_2 b = place(points[i]);
    const Point_2 c = place(points[k]);
    const Number product = abs(CGAL::determinant(b - a, c - a));
    if (product <= area) continue;
    area = product;
    widest = {b, c};
  }
  if (area.sign() == 0) return std::nullopt;
  const Point_2 centre = CGAL::circumcenter(a, widest[0], widest[1]);
  return Circle{centre, exact::sqrt((a - centre).squared_length())};
}

bool agrees_with(const Circle& circle, const PlaneVector& point, const Number& tolerance) {
  const Number distance_2 = (place(point) - circle.centre).squared_length();
  const Number outer = circle.radius + tolerance;
  const Number inner = circle.radius - tolerance;
  return distance_2 <= outer * outer && (inner.sign() <= 0 || distance_2 >= inner * inner);
}

}  // namespace

bool lie_along_a_line(std::span<const PlaneVector> points, const Number& tolerance) {
  const PlaneVector along = points.back() - points.front();
  const Number length_2 = dot(along, along);
  const Number limit = tolerance * tolerance * length_2;
  Number reached = 0;  // along the line, times its length
  for (const PlaneVector& point : points) {
    const PlaneVector v = point - points.front();
    const Number aside = cross(along, v);
    if (aside * aside > limit) return false;
    const Number here = dot(along, v);
    const Number back = reached - here;
    if (back.sign() > 0 && back * back > limit) return false;
    reached = max(reached, here);
  }
  return true;
}

bool are_chords_of_an_arc(std::span<const PlaneVector> points, const Number& tolerance,
                          const Number& granted) {
  if (points.size() < 3) return false;
  const std::optional<Circle> circle = circle_of(points);
  if (!circle || !agrees_with(*circle, points.front(), tolerance)) return false;
  int sense = 0;
  SweptTurns swept;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!agrees_with(*circle, points[i], tolerance)) return false;
    const Vector_2 from = place(points[i - 1]) - circle->centre;
    const Vector_2 to = place(points[i]) - circle->centre;
    const Number turn = CGAL::determinant(from, to);
    if (turn.sign() == 0 || (sense != 0 && turn.sign() != sense)) return false;
    sense = turn.sign();
    swept.add(std::abs(std::atan2(estimate(turn), estimate(CGAL::scalar_product(from, to)))) /
              (2 * std::numbers::pi));
    // A sagitta of g has a half chord of sqrt(2 r g - g^2).
    const PlaneVector chord = points[i] - points[i - 1];
    const bool is_flat = circle->radius * granted * 2 >= granted * granted + dot(chord, chord) / 4;
    if (circle->radius > granted && !is_flat) return false;
  }
  return !swept.exceed_a_turn(estimate(tolerance), estimate(circle->radius));
}

}  // namespace gonogo::oracle
