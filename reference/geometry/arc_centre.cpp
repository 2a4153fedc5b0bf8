// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/geometry/arc_centre.hpp"

#include "reference/compared.hpp"
#include "reference/predicate.hpp"

namespace gonogo::reference {
namespace {

// um of mm.
Number fine(const Number& length) {
  return length * 1000;
}

Number square(const Number& value) {
  return value * value;
}

// mm of a square of micrometres.
Number root_of_fine(const Number& square_2) {
  return exact::sqrt(square_2) / 1000;
}

// Compares two radii whose squares these are.
bool is_at_least(const Number& radius_2, const Number& limit_2) {
  const int sign = sign_of(limit_2 <=> radius_2);
  return decided_by_roots("limit - radius", sign, {{1, limit_2}, {-1, radius_2}}) <= 0;
}

}  // namespace

ArcEnds::ArcEnds(const PlaneAxes& axes, const Position& from, const Position& to)
    : start(geometry::point_in(axes, from)),
      end(geometry::point_in(axes, to)),
      chord(end - start),
      chord_2((chord * 1000).squared_length()) {}

ArcEnds::ArcEnds(const Vector_2& by)
    : start(CGAL::ORIGIN),
      end(CGAL::ORIGIN + by),
      chord(by),
      chord_2((chord * 1000).squared_length()) {}

bool ArcEnds::chord_within(const Number& length) const {
  const Number most_2 = square(fine(length));
  const int sign = sign_of(chord_2 <=> most_2);
  return decided_by_roots("chord - limit", sign, {{1, chord_2}, {-1, most_2}}) <= 0;
}

// The centre stands off the middle of the chord by sqrt(R^2 - (chord/2)^2): in chords,
// sqrt((4 R^2 - chord^2) / (4 chord^2)). Its two coordinates share that root, which CGAL's kernel
// knows nothing of.
std::optional<Point_2> centre_off_middle(const ArcEnds& ends, const Number& radius_2, int side) {
  const Number rest = radius_2 * 4 - ends.chord_2;
  if (decided_by_roots("chord - 2 R", -rest.sign(), {{1, ends.chord_2}, {-2, radius_2}}) > 0) {
    return std::nullopt;
  }
  const Point_2 middle = ends.middle();
  const Vector_2 right = ends.chord.perpendicular(CGAL::CLOCKWISE) * side;
  const auto centre =
      Number::roots({middle.x(), middle.y()}, {right.x(), right.y()}, rest, ends.chord_2 * 4);
  return Point_2(centre[0], centre[1]);
}

std::optional<Point_2> centre_from_radius(const ArcEnds& ends, const Number& radius, int sense) {
  return centre_off_middle(ends, square(fine(radius)), -sense * radius.sign());
}

OffsetCentre::OffsetCentre(const ArcEnds& ends, const Vector_2& offset)
    : centre(ends.start + offset),
      to_start(offset * -1000),
      to_end((ends.chord - offset) * 1000),
      start_2(to_start.squared_length()),
      end_2(to_end.squared_length()) {}

bool OffsetCentre::radii_agree(const Number& limit) const {
  // Nearly always enough: the radii differ by the difference of their squares over their sum, which
  // is at least `reach`. Not for enclosures: whether equal ones are equal is not decided.
  if (end_2.is_rational() && !decisions_are_watched()) {
    const Number reach =
        max(abs(to_start.x()), abs(to_start.y())) + max(abs(to_end.x()), abs(to_end.y()));
    if (abs(start_2 - end_2) <= fine(limit) * reach) return true;
  }
  return radii_agree_squared(square(limit));
}

// abs(sqrt(a) - sqrt(b))^2 <= limit^2 without roots: a + b - limit^2 <= 2 sqrt(a b).
bool OffsetCentre::radii_agree_squared(const Number& limit_2) const {
  const Number most_2 = fine(fine(limit_2));
  const Number left = start_2 + end_2 - most_2;
  const int sign = left.sign() < 0 ? -1 : sign_of(square(left) <=> start_2 * end_2 * 4);
  return decided_by_roots("difference of radii - limit", sign,
                          {{1, start_2}, {-1, end_2}, {-1, most_2}}) <= 0;
}

// sqrt(b) >= (1 - part) sqrt(a), where b is the smaller one.
bool OffsetCentre::radii_agree_in_part(const Number& part) const {
  return is_at_least(min(start_2, end_2), square(Number(1) - part) * max(start_2, end_2));
}

// (1 - part) sqrt(a) <= sqrt(b) <= (1 + part) sqrt(a), where a is at the start.
bool OffsetCentre::radii_agree_in_part_of_start(const Number& part) const {
  const bool not_short =
      part >= Number(1) || is_at_least(end_2, square(Number(1) - part) * start_2);
  return not_short && is_at_least(square(Number(1) + part) * start_2, end_2);
}

bool OffsetCentre::radius_below(const Number& length) const {
  return !is_at_least(min(start_2, end_2), square(fine(length)));
}

std::string radius_too_small(const ArcEnds& ends, const Number& radius) {
  return with_values("Twice the radius is {} mm, less than the chord of {} mm.",
                     {abs(radius) * 2, root_of_fine(ends.chord_2)});
}

std::string radii_apart(const OffsetCentre& arc, const PlaneAxes& axes, bool on_lathe) {
  const auto name = [&](Axis axis) {
    return std::string(1, "XYZ"[index(axis)]) + (on_lathe && axis == Axis::x ? " as a radius" : "");
  };
  const Number start = root_of_fine(arc.start_2);
  const Number end = root_of_fine(arc.end_2);
  const Number apart = arc.start_2 < arc.end_2 ? end - start : start - end;
  const std::string centre = name(axes.p) + " {}, " + name(axes.q) + " {}.";
  return with_values(
      "The radius is {} mm at the start and {} mm at the end, {} mm apart, about the centre " +
          centre,
      {start, end, apart, arc.centre.x(), arc.centre.y()});
}

}  // namespace gonogo::reference
