// SPDX-License-Identifier: GPL-3.0-or-later
//
// CT: an arc in the plane in force, tangent to the motion before it.
#include "reference/exact/radians.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr ClauseId kBefore = "SIE-CT-02"_clause;

void refuse(BlockContext& block, ClauseId clause, std::string message) {
  for (const Axis axis : {block.plane_axes().p, block.plane_axes().q}) {
    if (!block.words.has(address_of(axis))) continue;
    block.alarm(AlarmClass::arc_tangent, clause, name_of(address_of(axis)), std::move(message));
    return;
  }
  block.alarm(AlarmClass::arc_tangent, clause, WordName("CT"), std::move(message));
}

// The whole angle that a helix turned through, in radians.
Number angle_of(const Climb& climb) {
  const PlanePoint& a = climb.from_centre;
  const PlanePoint& b = climb.to_end;
  const int sense = climb.rot > 0 ? 1 : -1;
  const Number across = (a[0] * b[1] - a[1] * b[0]) * Number(sense);
  const Number last =
      climb.closed ? Number(360) : exact::angle_degrees(a[0] * b[0] + a[1] * b[1], across);
  return exact::radians(last + Number(360) * Number(sense * climb.rot - 1));
}

// SIE-CT-02: what the plane sees of the direction before.
PlanePoint direction_in_plane(const LastMotion& last, const PlaneAxes& axes) {
  const bool climbs = last.climb && last.climb->axis != axes.d;
  const Position direction = climbs ? whole_direction(last) : last.direction;
  return {direction[axes.p], direction[axes.q]};
}

}  // namespace

// A helix climbs by its height over its angle while it goes on by its radius.
Position whole_direction(const LastMotion& last) {
  Position direction = last.direction;
  if (last.climb && any_nonzero({last.climb->height})) {
    direction[last.climb->axis] = last.climb->height / angle_of(*last.climb);
  }
  return direction;
}

void run_tangent(BlockContext& block) {
  refuse_words(block, {Address::i, Address::j, Address::k, Address::i1, Address::j1, Address::k1,
                       Address::cr, Address::ar, Address::turn});
  need_cutting(block);
  std::optional<EndPoint> end = end_point(block);
  if (!end) return;
  const PlaneAxes axes = block.plane_axes();
  const std::optional<LastMotion>& last = block.machine.last;
  if (!last) return refuse(block, "SIE-CT-01"_clause, "No motion stands before the arc.");
  if (last->undecided) throw exact::Undecided("exact: which way the motion before goes");
  const PlanePoint t = direction_in_plane(*last, axes);
  if (!any_nonzero({t[0], t[1]})) {
    return refuse(block, kBefore, "The motion before stands upright on the plane.");
  }
  const PlanePoint d = {end->by[axes.p], end->by[axes.q]};
  if (end->closed.value_or(false) || !any_nonzero({d[0], d[1]})) {
    return refuse(block, kBefore, "A tangent arc cannot end where it starts.");
  }
  end->named = end->named | AxisSet{axes.p, axes.q};
  const Number across = t[0] * d[1] - t[1] * d[0];
  const int sense = across.sign();
  // SIE-CT-01: straight ahead, or straight behind.
  if (sense == 0) {
    if ((t[0] * d[0] + t[1] * d[1]).sign() > 0) {
      return put_line(block, RecordKind::feed, "SIE-CT-01"_clause, *end);
    }
    return refuse(block, "SIE-CT-01"_clause, "The end stands straight behind the start.");
  }
  // The curvature is 2 t x d / (|t| |d|^2), and the centre stands off on the left by its inverse.
  const Number off = (d[0] * d[0] + d[1] * d[1]) / (across * Number(2));
  const PlanePoint offset = {-(t[1] * off), t[0] * off};
  const PlanePoint start = block.position_in(axes);
  const bool is_helix = end->named.has(axes.d);
  put_arc(block,
          {block.machine.plane,
           {start[0] + offset[0], start[1] + offset[1]},
           offset,
           sense,
           is_helix ? kBefore : "SIE-CT-01"_clause},
          *end);
}

}  // namespace gonogo::reference::sinumerik
