// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/thread_geometry.hpp"

#include "oracle/motion/open_start.hpp"
#include "oracle/region/constants.hpp"
#include "reference/gsk988ta/thread_path.hpp"

namespace gonogo::oracle {
namespace {

Number near_rational(const Number& value) {
  return value.is_rational() ? value : value.bounds(kRationalBits)[0];
}

}  // namespace

Number run_out_degrees(const reference::ThreadMilling& item) {
  return item.runout_angle - (item.runout_angle / 360).floor() * 360;
}

PlaneVector near_rational(const PlaneVector& v) {
  return {near_rational(v.p), near_rational(v.q)};
}

ThreadGeometry::ThreadGeometry(const reference::ThreadMilling& item, const Tolerances& tolerances)
    : item_(item),
      tolerances_(tolerances),
      loose_(tolerances),
      axes_(reference::axes_of(item.plane)),
      up_(item.r_plane < item.bottom ? -1 : 1) {
  loose_.tolerance = tolerances.tolerance * kTwoPlaces;
}

PlaneVector ThreadGeometry::from_axis(const Position& at) const {
  return {at[axes_.p] - item_.centre[0], at[axes_.q] - item_.centre[1]};
}

Position ThreadGeometry::place(const PlaneVector& from_axis, Position as_high) const {
  as_high[axes_.p] = item_.centre[0] + from_axis.p;
  as_high[axes_.q] = item_.centre[1] + from_axis.q;
  return as_high;
}

bool ThreadGeometry::on_circle(const Position& at, const Number& radius) const {
  return OpenStart(radius, tolerances_.tolerance).admits({}, from_axis(at));
}

bool ThreadGeometry::is_free(const Position& at, const Number& radius) const {
  const PlaneVector v = near_rational(from_axis(at));
  const Keep keep{item_.external, radius, slack()};
  return clearance_of_line(v, v, keep).kind == Clearance::Kind::clear;
}

bool ThreadGeometry::is_safe(const Position& at, int side) const {
  const Number safe = reference::gsk988ta::safe_radius(item_);
  const Number& tau = tolerances_.tolerance;
  const PlaneVector v = from_axis(at);
  if (side != 0) return agree(v.p, safe * side, tau);
  if (item_.external) return is_free(at, safe);
  return abs(v.p) <= abs(safe) + tau;
}

bool ThreadGeometry::is_beyond_reach(const Position& at) const {
  return item_.external && abs(from_axis(at).p) > reach() + tolerances_.tolerance;
}

bool ThreadGeometry::moves_depth_alone(const Motion& motion) const {
  return moved_axes(motion, tolerances_.tolerance) == AxisSet{axes_.d};
}

bool ThreadGeometry::moves_first_axis_alone(const Motion& motion) const {
  return moved_axes(motion, tolerances_.tolerance) == AxisSet{axes_.p} &&
         !nearly_full_turn(motion) && motion.record.kind != RecordKind::arc;
}

bool ThreadGeometry::moves_in_plane(const Motion& motion) const {
  const AxisSet moved = moved_axes(motion, tolerances_.tolerance);
  return moved.has(axes_.p) || moved.has(axes_.q) || nearly_full_turn(motion);
}

Clearance ThreadGeometry::clearance(const Motion& motion, const Number& radius,
                                    const Number& part) const {
  return clearance_in({{item_.external, radius, slack()}, {}}, motion, part);
}

Clearance ThreadGeometry::clearance_of_chord(const Motion& chord, const Number& radius,
                                             const Number& part) const {
  return clearance_in({{item_.external, radius, slack() + tolerances_.chord}, {}}, chord, part);
}

Clearance ThreadGeometry::within(const Motion& motion, const Number& radius) const {
  return clearance_in({{false, radius, slack()}, {}}, motion, 0);
}

Clearance ThreadGeometry::within_chord(const Motion& motion, const PlaneVector& a,
                                       const PlaneVector& b) const {
  const PlaneVector half{(b.p - a.p) / 2, (b.q - a.q) / 2};
  const Number radius = exact::sqrt(norm_squared(half));
  return clearance_in({{false, radius, slack() + tolerances_.chord}, a + half}, motion, 0);
}

Clearance ThreadGeometry::clearance_in(const Limit& limit, const Motion& motion,
                                       const Number& part) const {
  const auto seen = [&](const PlaneVector& v) { return near_rational(v) - limit.middle; };
  const PlaneVector from = seen(from_axis(motion.from));
  const PlaneVector to = seen(from_axis(motion.to()));
  const Record& record = motion.record;
  if (record.kind == RecordKind::rapid) return clearance_of_box(from, to, limit.keep);
  if (record.kind == RecordKind::feed) {
    return clearance_of_line({from.p + part * (to.p - from.p), from.q + part * (to.q - from.q)}, to,
                             limit.keep);
  }
  if (record.plane != item_.plane) return {Clearance::Kind::undecided, {}, {}};
  region::LevelMotion arc;
  arc.is_arc = true;
  arc.from = from;
  arc.to = to;
  arc.centre = seen({record.centre[0] - item_.centre[0], record.centre[1] - item_.centre[1]});
  arc.rot = record.rot;
  return clearance_of_arc(arc, limit.keep, part);
}

}  // namespace gonogo::oracle
