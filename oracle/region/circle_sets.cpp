// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/circle_sets.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>

#include <list>
#include <string>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;
using Set = CGAL::General_polygon_set_2<Traits>;
using Polygon = Traits::General_polygon_2;
using HoledPolygon = Traits::General_polygon_with_holes_2;
using Curve = Traits::Curve_2;
using MonotoneCurve = Traits::X_monotone_curve_2;
using Real = Kernel::FT;
using Point = Kernel::Point_2;
using Circle = Kernel::Circle_2;
using ArcPoint = Traits::Point_2;

Real to_real(const Number& value) {
  const auto [numerator, denominator] = value.fraction();
  return Real(Kernel::Exact_kernel::FT(numerator + "/" + denominator));
}

Point to_point(const PlanePoint& point) {
  return {to_real(point.p), to_real(point.q)};
}

// The direction at the radius, seen from the centre.
Point on_circle(const Point& centre, const PlanePoint& direction, const Real& radius) {
  return {centre.x() + radius * to_real(direction.p), centre.y() + radius * to_real(direction.q)};
}

void append(Polygon& polygon, const Curve& curve) {
  std::list<CGAL::Object> parts;
  Traits().make_x_monotone_2_object()(curve, std::back_inserter(parts));
  for (const CGAL::Object& part : parts) {
    MonotoneCurve monotone;
    if (CGAL::assign(monotone, part)) polygon.push_back(monotone);
  }
}

void append_arc(Polygon& polygon, const Point& centre, const Real& radius, bool counterclockwise,
                const Point& from, const Point& to) {
  const Circle circle(centre, radius * radius,
                      counterclockwise ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
  append(polygon, Curve(circle, ArcPoint(from.x(), from.y()), ArcPoint(to.x(), to.y())));
}

Polygon disc(const Point& centre, const Real& radius, bool counterclockwise = true) {
  Polygon polygon;
  append(polygon, Curve(Circle(centre, radius * radius,
                               counterclockwise ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE)));
  return polygon;
}

Polygon sector(const CircleShape& shape, const Point& centre) {
  const Real inner = to_real(shape.inner);
  const Real outer = to_real(shape.outer);
  const auto& [a, b] = *shape.sweep;
  const bool pointed = shape.inner.sign() == 0;
  const Point near_a = on_circle(centre, a, inner);
  const Point near_b = on_circle(centre, b, inner);
  const Point far_a = on_circle(centre, a, outer);
  const Point far_b = on_circle(centre, b, outer);
  Polygon polygon;
  append(polygon, Curve(near_a, far_a));
  append_arc(polygon, centre, outer, true, far_a, far_b);
  append(polygon, Curve(far_b, near_b));
  if (!pointed) append_arc(polygon, centre, inner, false, near_b, near_a);
  return polygon;
}

Polygon capsule(const CapsuleShape& shape) {
  const Point a = to_point(shape.from);
  const Point b = to_point(shape.to);
  const Real radius = to_real(shape.radius);
  const PlanePoint& n = shape.normal;
  const PlanePoint opposite{-n.p, -n.q};
  const Point a_left = on_circle(a, n, radius);
  const Point b_left = on_circle(b, n, radius);
  const Point a_right = on_circle(a, opposite, radius);
  const Point b_right = on_circle(b, opposite, radius);
  Polygon polygon;
  append(polygon, Curve(a_right, b_right));
  append_arc(polygon, b, radius, true, b_right, b_left);
  append(polygon, Curve(b_left, a_left));
  append_arc(polygon, a, radius, true, a_left, a_right);
  return polygon;
}

Polygon rectangle(const RoundedRectangle& shape) {
  const Real p = to_real(shape.core_p);
  const Real q = to_real(shape.core_q);
  const Real r = to_real(shape.radius);
  if (shape.core_p.sign() == 0 && shape.core_q.sign() == 0) return disc(Point(0, 0), r);
  const Point corners[] = {{p, q}, {-p, q}, {-p, -q}, {p, -q}};
  const CGAL::Vector_2<Kernel> axes[] = {{r, 0}, {0, r}, {-r, 0}, {0, -r}};
  Polygon polygon;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point begin = corners[k] + axes[k];
    const Point end = corners[k] + axes[(k + 1) % 4];
    const Point next = corners[(k + 1) % 4] + axes[(k + 1) % 4];
    append_arc(polygon, corners[k], r, true, begin, end);
    if (end != next) append(polygon, Curve(end, next));
  }
  return polygon;
}

Polygon square(const Window& window) {
  const Point centre = to_point(window.centre);
  const Real half = to_real(window.half);
  const Point corners[] = {{centre.x() - half, centre.y() - half},
                           {centre.x() + half, centre.y() - half},
                           {centre.x() + half, centre.y() + half},
                           {centre.x() - half, centre.y() + half}};
  Polygon polygon;
  for (std::size_t k = 0; k < 4; ++k) append(polygon, Curve(corners[k], corners[(k + 1) % 4]));
  return polygon;
}

// What a union is made of.
struct Parts {
  std::vector<Polygon> polygons;
  std::vector<HoledPolygon> holed;

  void add(const RoundedRectangle& shape) { polygons.push_back(rectangle(shape)); }
  void add(const CapsuleShape& shape) { polygons.push_back(capsule(shape)); }
  void add(const CircleShape& shape) {
    const Point centre = to_point(shape.centre);
    if (shape.sweep) {
      polygons.push_back(sector(shape, centre));
    } else if (shape.inner.sign() == 0) {
      polygons.push_back(disc(centre, to_real(shape.outer)));
    } else {
      HoledPolygon ring(disc(centre, to_real(shape.outer)));
      ring.add_hole(disc(centre, to_real(shape.inner), false));
      holed.push_back(ring);
    }
  }
};

Set united(const std::vector<Shape>& shapes) {
  Parts parts;
  for (const Shape& shape : shapes) {
    std::visit([&parts](const auto& one) { parts.add(one); }, shape);
  }
  Set set;
  // The range overload unites by halves: much faster than one after the other.
  set.join(parts.polygons.begin(), parts.polygons.end(), parts.holed.begin(), parts.holed.end());
  return set;
}

using Sample = std::array<double, 2>;

// Corners, middles of every two of them, and their mean.
void append_samples(const Polygon& border, std::vector<Sample>& out) {
  std::vector<Sample> corners;
  for (auto curve = border.curves_begin(); curve != border.curves_end(); ++curve) {
    if (corners.size() == kMostTries) break;
    corners.push_back({CGAL::to_double(curve->source().x()), CGAL::to_double(curve->source().y())});
  }
  Sample mean{0, 0};
  for (const Sample& corner : corners) {
    mean[0] += corner[0] / static_cast<double>(corners.size());
    mean[1] += corner[1] / static_cast<double>(corners.size());
  }
  out.push_back(mean);
  for (const Sample& a : corners) {
    for (const Sample& b : corners) {
      if (out.size() < kMostSpots) {
        out.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2});
      }
    }
  }
}

Remainder remainder_of(const RoundedRectangle& area, const std::optional<Window>& window,
                       const std::vector<Shape>& shapes) {
  Set rest;
  rest.insert(rectangle(area));
  if (window) rest.intersection(square(*window));
  rest.difference(united(shapes));
  Remainder result;
  result.empty = rest.is_empty();
  if (result.empty) return result;
  std::vector<HoledPolygon> pieces;
  rest.polygons_with_holes(std::back_inserter(pieces));
  for (const HoledPolygon& piece : pieces) {
    append_samples(piece.outer_boundary(), result.samples);
    for (auto hole = piece.holes_begin(); hole != piece.holes_end(); ++hole) {
      append_samples(*hole, result.samples);
    }
  }
  return result;
}

}  // namespace

Remainder uncovered_remainder(const RoundedRectangle& area, const std::optional<Window>& window,
                              const std::vector<Shape>& shapes) {
  // The kernel's filters count on it; the region rules ask while they round outward.
  const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  try {
    return remainder_of(area, window, shapes);
  } catch (const CGAL::Failure_exception& error) {
    throw CircleSetsError(std::string("The exact decision failed: ") + error.what());
  }
}

}  // namespace gonogo::oracle::region
