// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/shapes.hpp"

#include <cmath>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

bool is_rational(const PlanePoint& point) {
  return point.p.is_rational() && point.q.is_rational();
}

// The rational unit vector n = ((1 - t^2), 2 t) / (1 + t^2) next to a direction; t is a multiple of
// 2^-bits.
PlanePoint rational_direction(double x, double y, int bits) {
  const double tangent = y / (std::hypot(x, y) + std::fabs(x));  // of half the angle to the axis
  const Number t = to_number(std::ldexp(std::round(std::ldexp(tangent, bits)), -bits));
  const Number below = Number(1) + t * t;
  const Number p = (Number(1) - t * t) / below;
  return {x < 0 ? -p : p, Number(2) * t / below};
}

// A rational direction a hair inside a sweep that begins at u (side 1) or ends there (side -1).
PlanePoint direction_inside(const IntervalVector& u, double side) {
  const double hair = std::ldexp(side, -kHairBits);
  const double x = median(u.x());
  const double y = median(u.y());
  return rational_direction(x - hair * y, y + hair * x, kHairBits + 8);
}

// Sectors of at most 90 degrees and a little; a and b are the rational directions of the ends.
void append_sectors(const CircleShape& ring, const PlanePoint& a, const PlanePoint& b, bool wide,
                    std::vector<Shape>& out) {
  if (!wide && dot(a, b) >= Number(0)) {
    if (cross(a, b).sign() <= 0) return;  // too narrow for rational directions inside it
    CircleShape shape = ring;
    shape.sweep = {a, b};
    out.push_back(shape);
    return;
  }
  const IntervalVector m = middle_direction(enclose(a), enclose(b), wide);
  const PlanePoint middle = rational_direction(median(m.x()), median(m.y()), kCoarseBits);
  append_sectors(ring, a, middle, false, out);
  append_sectors(ring, middle, b, false, out);
}

void append_round(const Band& band, const CircleShape& ring, const Number& radius,
                  std::vector<Shape>& out) {
  if (!band.sweep) {
    out.push_back(ring);
    return;
  }
  const Sweep& sweep = *band.sweep;
  const PlanePoint a{sweep.a.p / radius, sweep.a.q / radius};
  const PlanePoint b{sweep.b.p / radius, sweep.b.q / radius};
  append_sectors(ring, a, b, sweep.wide, out);
}

// Within the band, by what the enclosures leave open.
void append_within(const Band& band, const PlanePoint& centre, double unsure,
                   std::vector<Shape>& out) {
  const Interval shift{unsure, unsure};
  const double outer = (band.outer - shift).inf();
  const double inner = band.has_hole() ? (band.inner + shift).sup() : 0;
  if (!(inner < outer)) return;
  const CircleShape ring{centre, to_number(inner), to_number(outer), std::nullopt};
  if (band.shape != Band::Shape::sector) {
    out.push_back(ring);
    return;
  }
  const PlanePoint a = direction_inside(band.ua, 1);
  const PlanePoint b = direction_inside(band.ub, -1);
  const bool inside =
      determinant(band.ua, enclose(a)).inf() > 0 && determinant(enclose(b), band.ub).inf() > 0;
  if (inside && unsure == 0) append_sectors(ring, a, b, band.wide, out);
}

// A band whose centre is known as an enclosure only.
void append_enclosed(const Band& band, std::vector<Shape>& out) {
  const double x = median(band.c.x());
  const double y = median(band.c.y());
  const bool exact = band.c.x().is_point() && band.c.y().is_point();
  if (!std::isfinite(x) || !std::isfinite(y)) return;  // so far away that nothing is known
  const double unsure = exact ? 0 : norm(band.c - IntervalVector(x, y)).sup();
  append_within(band, middle_of(band.c), unsure, out);
}

// With the exact normal where the line's length is rational, else with one 2^-40 beside it.
bool append_capsule(const Line& line, const Number& reach, std::vector<Shape>& out) {
  if (!is_rational(line.from) || !is_rational(line.to) || !reach.is_rational()) return false;
  const PlanePoint d = line.to - line.from;
  const Number length = exact::sqrt(norm_squared(d));
  const PlanePoint normal =
      length.is_rational() ? PlanePoint{-d.q / length, d.p / length}
                           : rational_direction(-median(line.u.y()), median(line.u.x()), kHairBits);
  out.push_back(CapsuleShape{line.from, line.to, normal, reach});
  return true;
}

}  // namespace

bool append_shapes(const Band& band, const Number& reach, std::vector<Shape>& out) {
  if (band.shape == Band::Shape::capsule) return append_capsule(*band.line, reach, out);
  if (band.shape == Band::Shape::rectangle) {
    out.push_back(band.cleared->exact);
    return true;
  }
  if (!band.centre) {
    append_enclosed(band, out);
    return true;
  }
  if (!is_rational(*band.centre) || !reach.is_rational()) return false;
  const Number radius = band.radius2 ? exact::sqrt(*band.radius2) : Number();
  if (!band.radius2 || !radius.is_rational()) {
    append_within(band, *band.centre, 0, out);
    return true;
  }
  CircleShape ring{*band.centre, Number(), radius + reach, std::nullopt};
  if (radius > reach) ring.inner = radius - reach;
  append_round(band, ring, radius, out);
  return true;
}

}  // namespace gonogo::oracle::region
