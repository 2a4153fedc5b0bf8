// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/thread_geometry.hpp"

#include "oracle/judge/open_start.hpp"
#include "reference/gsk988ta/thread_path.hpp"

namespace gonogo::oracle {
namespace {

Number near_rational(const Number& value) {
  constexpr int kBits = 80;
  return value.is_rational() ? value : value.bounds(kBits)[0];
}

}  // namespace

PlaneVector near_rational(const PlaneVector& v) {
  return {near_rational(v.p), near_rational(v.q)};
}

ThreadGeometry::ThreadGeometry(const reference::ThreadMilling& item, const JudgeTerms& terms)
    : item_(item),
      terms_(terms),
      loose_(terms),
      axes_(reference::axes_of(item.plane)),
      up_(item.r_plane < item.bottom ? -1 : 1) {
  loose_.tolerance = terms.tolerance * 3;
}

PlaneVector ThreadGeometry::from_axis(const Position& at) const {
  return {at[axes_.p] - item_.centre[0], at[axes_.q] - item_.centre[1]};
}

bool ThreadGeometry::on_circle(const Position& at, const Number& radius) const {
  return OpenStart(radius, terms_.tolerance).admits({}, from_axis(at));
}

bool ThreadGeometry::is_free(const Position& at, const Number& radius) const {
  const PlaneVector v = near_rational(from_axis(at));
  const Keep keep{item_.external, radius, slack()};
  return clearance_of_line({v.p, v.q}, {v.p, v.q}, keep).kind == Clearance::Kind::clear;
}

bool ThreadGeometry::is_safe(const Position& at, bool named) const {
  const Number safe = reference::gsk988ta::safe_radius(item_);
  const Number& tau = terms_.tolerance;
  const PlaneVector v = from_axis(at);
  if (named) return agree(v.p, safe, tau);
  if (item_.external) return is_free(at, safe);
  return abs(v.p) <= abs(safe) + tau;
}

bool ThreadGeometry::moves_depth_alone(const Motion& motion) const {
  return moved_axes(motion, terms_.tolerance) == AxisSet{axes_.d};
}

bool ThreadGeometry::moves_first_axis_alone(const Motion& motion) const {
  return moved_axes(motion, terms_.tolerance) == AxisSet{axes_.p} && !nearly_full_turn(motion) &&
         motion.record.kind != RecordKind::arc;
}

bool ThreadGeometry::moves_in_plane(const Motion& motion) const {
  const AxisSet moved = moved_axes(motion, terms_.tolerance);
  return moved.has(axes_.p) || moved.has(axes_.q) || nearly_full_turn(motion);
}

Clearance ThreadGeometry::clearance(const Motion& motion, const Number& radius) const {
  return clearance_from(motion, {item_.external, radius, slack()});
}

Clearance ThreadGeometry::clearance_of_chord(const Motion& chord, const Number& radius) const {
  return clearance_from(chord, {item_.external, radius, slack() + terms_.chord});
}

Clearance ThreadGeometry::within(const Motion& motion, const Number& radius) const {
  return clearance_from(motion, {false, radius, slack()});
}

Clearance ThreadGeometry::clearance_from(const Motion& motion, const Keep& keep) const {
  const PlaneVector from = near_rational(from_axis(motion.from));
  const PlaneVector to = near_rational(from_axis(motion.to()));
  const Record& record = motion.record;
  if (record.kind == RecordKind::rapid) {
    return clearance_of_box({from.p, from.q}, {to.p, to.q}, keep);
  }
  if (record.kind == RecordKind::feed) {
    return clearance_of_line({from.p, from.q}, {to.p, to.q}, keep);
  }
  if (record.plane != item_.plane) return {Clearance::Kind::undecided, {}, {}};
  const PlaneVector centre = near_rational(
      PlaneVector{record.centre[0] - item_.centre[0], record.centre[1] - item_.centre[1]});
  region::LevelMotion arc;
  arc.is_arc = true;
  arc.from = {from.p, from.q};
  arc.to = {to.p, to.q};
  arc.centre = {centre.p, centre.q};
  arc.rot = record.rot;
  return clearance_of_arc(arc, keep);
}

}  // namespace gonogo::oracle
