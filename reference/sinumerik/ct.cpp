// SPDX-License-Identifier: GPL-3.0-or-later
//
// CT: an arc in the plane in force, tangent to the motion before it.
#include <cstdlib>

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

// Nothing where that cannot be told.
std::optional<int> sign_of(const Number& value) {
  try {
    return value.sign();
  } catch (const exact::Undecided&) {
    return std::nullopt;
  }
}

// Whether an arc from one point to another about a centre is no part of a turn, as far as can be
// told. An arc that ends nearer or farther on the ray of its start (SIE-ARC-08) has a length
// nevertheless.
bool may_have_no_sweep(const PlanePoint& from, const PlanePoint& to) {
  // First what is decided at once of half a turn, whose ends are as hard to tell from one ray.
  const std::optional<int> along = sign_of(from[0] * to[0] + from[1] * to[1]);
  if (along.value_or(1) <= 0) return false;
  return sign_of(from[0] * to[1] - from[1] * to[0]).value_or(0) == 0;
}

// Where the programmed centre is kept and the end stands in it (SIE-ARC-08), as far as can be told.
bool may_end_in_centre(const PlanePoint& to) {
  return sign_of(to[0]).value_or(0) == 0 && sign_of(to[1]).value_or(0) == 0;
}

// Whether no text says which way an arc goes at its end, as far as can be told.
bool may_go_no_way(const LastArc& arc) {
  if (may_end_in_centre(arc.to_end)) return true;
  return !arc.closed && std::abs(arc.rot) == 1 && may_have_no_sweep(arc.from_centre, arc.to_end);
}

// The whole angle that a helix turned through, in radians.
Number angle_of(const LastArc& helix) {
  const PlanePoint& a = helix.from_centre;
  const PlanePoint& b = helix.to_end;
  const int sense = helix.rot > 0 ? 1 : -1;
  const Number across = (a[0] * b[1] - a[1] * b[0]) * Number(sense);
  const Number last =
      helix.closed ? Number(360) : exact::angle_degrees(a[0] * b[0] + a[1] * b[1], across);
  return exact::radians(last + Number(360) * Number(sense * helix.rot - 1));
}

// SIE-CT-02: what the plane sees of the direction before.
PlanePoint direction_in_plane(const LastMotion& last, const PlaneAxes& axes) {
  const bool climbs = last.arc && last.arc->climb && last.arc->climb->axis != axes.d;
  const Position direction = climbs ? whole_direction(last) : last.direction;
  return {direction[axes.p], direction[axes.q]};
}

}  // namespace

// A helix climbs by its height over its angle while it goes on by its radius.
Position whole_direction(const LastMotion& last) {
  Position direction = last.direction;
  if (!last.arc || !last.arc->climb) return direction;
  const auto& [axis, height] = *last.arc->climb;
  if (any_nonzero({height})) direction[axis] = height / angle_of(*last.arc);
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
  if (last->undecided || (last->arc && may_go_no_way(*last->arc))) {
    throw exact::Undecided("exact: which way the motion before goes");
  }
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
