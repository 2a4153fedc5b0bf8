// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/line.hpp"

namespace gonogo::oracle::region {

Line make_line(const PlanePoint& from, const PlanePoint& to) {
  const Rounding outward;
  Line line{from, to, enclose(from), enclose(to), {}, {}};
  const IntervalVector d = enclose(to - from);
  line.length = norm(d);
  line.u = unit(d);
  return line;
}

std::optional<Line> joined(const Line& first, const Line& second) {
  if (!(first.to == second.from)) return std::nullopt;
  const Interval side = determinant(first.u, second.u);
  if (side.inf() > 0 || side.sup() < 0) return std::nullopt;
  const PlanePoint early = first.to - first.from;
  const PlanePoint late = second.to - second.from;
  if (cross(early, late).sign() != 0 || dot(early, late).sign() < 0) return std::nullopt;
  return make_line(first.from, second.to);
}

Number squared_distance(const Line& line, const PlanePoint& point) {
  const PlanePoint along = line.to - line.from;
  const PlanePoint offset = point - line.from;
  const Number at = dot(offset, along);
  if (at.sign() <= 0) return norm_squared(offset);
  const Number length2 = norm_squared(along);
  if (at >= length2) return norm_squared(point - line.to);
  const Number aside = cross(along, offset);
  return aside * aside / length2;
}

Interval squared_distance(const Line& line, const IntervalVector& point) {
  return squared_distance(line.a, line.b, line.u, line.length, point);
}

Interval squared_distance(const IntervalVector& a, const IntervalVector& b, const IntervalVector& u,
                          Interval length, const IntervalVector& point) {
  const IntervalVector offset = point - a;
  const Interval at = scalar_product(offset, u);
  const Interval to_a = offset.squared_length();
  if (at.sup() <= 0) return to_a;
  const Interval to_b = (point - b).squared_length();
  if (at.inf() >= length.sup()) return to_b;
  const Interval aside = square(determinant(u, offset));
  if (at.inf() >= 0 && at.sup() <= length.inf()) return aside;
  return {aside.inf(), std::min(to_a.sup(), to_b.sup())};
}

}  // namespace gonogo::oracle::region
