// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/border_sense.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/region/constants.hpp"
#include "oracle/region/gouge.hpp"

namespace gonogo::oracle::region {
namespace {

// The angle is estimated, its turns are known.
Interval length_of(const Arc& arc) {
  using std::numbers::pi;
  const double sine = median(determinant(arc.ua, arc.ub));
  double angle = std::atan2(sine, median(scalar_product(arc.ua, arc.ub)));
  if (angle < (arc.sweep.wide ? pi / 2 : -pi / 2)) angle += 2 * pi;
  angle = std::max(angle, 0.0) + 2 * pi * arc.turns;
  return hull(arc.ra, arc.rb) * Interval(std::max(angle - kEstimate, 0.0), angle + kEstimate);
}

Course course_of(int way, Against runs_along, const Interval& length) {
  if (runs_along == Against::no) return {};
  return {way, runs_along == Against::yes, length.inf(), length.sup()};
}

}  // namespace

// What decides the direction, in doubles: the sine between a motion of four times the width
// and the border that it runs along is at most 1/2, so the sign of its progress is never close.
struct BorderSense::Track {
  double x, y;    // the motion's middle
  double dx, dy;  // from its begin to its end
};

// A border no more than the width across has no direction: a path in it runs along all of
// it. Motions no longer than four times the width have none either: both their ends may be off by
// the tolerance on each axis, so that a way along the border or across it may come out backward.
BorderSense::BorderSense(const RoundedRectangle& border, int sense, const Number& width)
    : sense_(sense),
      border_(enclose(border)),
      outer_(with_radius(border, border.radius + width)),
      shortest_(kNoDirection * enclose(width).sup()) {
  if (inner_radius(border) > width) inner_ = eroded(border, width);
  if (inner_) enclosed_inner_ = enclose(*inner_);
}

bool BorderSense::is_nearly_inside(const IntervalVector& point) const {
  if (inner_->radius.sign() > 0) {
    return squared_distance_to_core(enclosed_inner_, point).sup() < enclosed_inner_.radius2.inf();
  }
  return abs(point.x()).sup() < enclosed_inner_.core_p.inf() &&
         abs(point.y()).sup() < enclosed_inner_.core_q.inf();
}

int BorderSense::way_of(const Track& track) const {
  // Straight out of the area: from the core's nearest point or, within it, through the nearest
  // side.
  const double depth_p = std::fabs(track.x) - median(border_.core_p);
  const double depth_q = std::fabs(track.y) - median(border_.core_q);
  double nx = std::copysign(std::max(0.0, depth_p), track.x);
  double ny = std::copysign(std::max(0.0, depth_q), track.y);
  if (depth_p <= 0 && depth_q <= 0) {
    nx = depth_p >= depth_q ? std::copysign(1.0, track.x) : 0.0;
    ny = depth_p >= depth_q ? 0.0 : std::copysign(1.0, track.y);
  }
  const double progress = (nx * track.dy - ny * track.dx) * sense_;
  const double half = 0.5 * std::hypot(nx, ny) * std::hypot(track.dx, track.dy);
  return progress < -half ? -1 : progress > half ? 1 : 0;
}

// Whether the line lies on the far side of one straight side of the inner area. Exactly.
bool BorderSense::is_beside(const Line& line) const {
  const Number p = inner_->core_p + inner_->radius;
  const Number q = inner_->core_q + inner_->radius;
  return (line.from.p >= p && line.to.p >= p) || (line.from.p <= -p && line.to.p <= -p) ||
         (line.from.q >= q && line.to.q >= q) || (line.from.q <= -q && line.to.q <= -q);
}

Against BorderSense::along(const LinePiece& whole_line) const {
  std::vector<LinePiece> open{whole_line};
  Against result = Against::yes;
  for (int budget = kMostStretches; !open.empty(); --budget) {
    const LinePiece piece = open.back();
    open.pop_back();
    if (lies_outside(piece, enclosed_inner_)) continue;
    const IntervalVector middle = Interval(0.5) * (piece.a + piece.b);
    if (is_nearly_inside(middle)) return Against::no;
    if (budget <= 0 || !(norm(piece.b - piece.a).sup() > kBeside)) {
      result = Against::undecided;
      continue;
    }
    open.push_back({piece.a, middle});
    open.push_back({middle, piece.b});
  }
  return result;
}

Course BorderSense::of_line(const Line& line) const {
  if (!inner_ || !(line.length.inf() > shortest_)) return {};
  if (is_nearly_inside(line.a) || is_nearly_inside(line.b)) return {};
  const IntervalVector d = line.b - line.a;
  const IntervalVector m = Interval(0.5) * (line.a + line.b);
  const int way = way_of({median(m.x()), median(m.y()), median(d.x()), median(d.y())});
  if (way == 0 || !contains(outer_, line.from) || !contains(outer_, line.to)) return {};
  const Against along_it = is_beside(line) ? Against::yes : along(LinePiece{line.a, line.b});
  return course_of(way, along_it, line.length);
}

bool BorderSense::runs_along(const Line& line) const {
  if (!inner_ || is_nearly_inside(line.a) || is_nearly_inside(line.b)) return false;
  if (!contains(outer_, line.from) || !contains(outer_, line.to)) return false;
  return is_beside(line) || along(LinePiece{line.a, line.b}) == Against::yes;
}

bool BorderSense::touches(const PlanePoint& at) const {
  return inner_ && contains(outer_, at) && !is_nearly_inside(enclose(at));
}

bool BorderSense::is_long_enough(const PlanePoint& from, const PlanePoint& to) const {
  return norm(enclose(to) - enclose(from)).inf() > shortest_;
}

Course BorderSense::between(const PlanePoint& from, const PlanePoint& to) const {
  const IntervalVector a = enclose(from);
  const IntervalVector b = enclose(to);
  const IntervalVector d = b - a;
  const IntervalVector m = Interval(0.5) * (a + b);
  const int way = way_of({median(m.x()), median(m.y()), median(d.x()), median(d.y())});
  return course_of(way, Against::yes, norm(d));
}

Against BorderSense::along(std::vector<Stretch> open, const Arc& arc) const {
  Against result = Against::yes;
  for (int budget = kMostStretches; !open.empty(); --budget) {
    const Stretch stretch = open.back();
    open.pop_back();
    const bool is_quarter = stretch.is_at_most_quarter();
    if (is_quarter && lies_outside(stretch.circles(arc.c), enclosed_inner_)) continue;
    const auto parts = halves(stretch);
    if (is_nearly_inside(arc.c + parts[0].b())) return Against::no;
    if (budget <= 0 || stretch.is_tiny()) {
      result = Against::undecided;
      continue;
    }
    open.insert(open.end(), parts.begin(), parts.end());
  }
  return result;
}

Course BorderSense::of_arc(const Arc& arc, bool counterclockwise) const {
  if (!inner_) return {};
  const Stretch stretch = whole(arc);
  const IntervalVector a = arc.c + stretch.a();
  const IntervalVector b = arc.c + stretch.b();
  if (is_nearly_inside(a) || is_nearly_inside(b)) return {};
  int way = counterclockwise == (sense_ > 0) ? 1 : -1;
  if (arc.turns > 0 || arc.full || stretch.wide) {
    // More than half round the border: it goes as it turns.
    if (!(2 * std::min(arc.ra.inf(), arc.rb.inf()) > shortest_)) return {};
  } else {
    const IntervalVector d = counterclockwise ? b - a : a - b;
    if (!(norm(d).inf() > shortest_)) return {};
    const IntervalVector m = arc.c + middle_of(stretch);
    way = way_of({median(m.x()), median(m.y()), median(d.x()), median(d.y())});
    if (way == 0) return {};
  }
  const Reach reach = reach_of(arc, outer_);
  if (reach.kind == Reach::Kind::outside) return {};
  Against along_it = along({stretch}, arc);
  const bool is_open = reach.kind == Reach::Kind::undecided && along_it == Against::yes;
  if (is_open) along_it = Against::undecided;
  return course_of(way, along_it, length_of(arc));
}

Against WayBack::add(const Course& narrow, const Course& wide) {
  const bool is_sure = narrow.is_sure && wide.is_sure && narrow.way == wide.way;
  const Course& course = wide.way != 0 ? wide : narrow;
  if (course.way == 0) return Against::no;
  const Interval length(is_sure ? course.least : 0.0, course.most);
  back_ = course.way < 0 ? back_ + length : back_ - length;
  back_ = Interval(std::max(back_.inf(), 0.0), std::max(back_.sup(), 0.0));
  if (back_.inf() > limit_.sup()) return Against::yes;
  return back_.sup() > limit_.inf() ? Against::undecided : Against::no;
}

}  // namespace gonogo::oracle::region
