// SPDX-License-Identifier: GPL-3.0-or-later
//
// CIP: a circle in space through an intermediate point. Seen from the start, u is that point and v
// the end.
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr ClauseId kPoints = "SIE-CIP-02"_clause;
using Vector = std::array<Number, 3>;  // along X, Y, Z

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Number dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector way(const Position& by) {
  return {by[Axis::x], by[Axis::y], by[Axis::z]};
}

// SIE-CIP-02: coordinates that are left out are those of the start.
EndPoint intermediate_point(const BlockContext& block) {
  EndPoint via;
  via.to = block.machine.position;
  for (const Axis axis : kLinearAxes) {
    if (!block.words.has(intermediate_address(axis))) continue;
    const AxisWord word = block.words.intermediate_word(axis);
    const Number& start = block.machine.position[axis];
    via.by[axis] = word.incremental ? word.value : word.value - start;
    via.to[axis] = word.incremental ? start + word.value : word.value;
  }
  return via;
}

// The direction at the end. n = u x v is the axis of the circle about which it goes positively, and
// ((u.u) v x n + (v.v) n x u) / (2 n.n) its centre c; the direction is that of n x (v - c), here
// times 2 n.n.
Vector direction_at_end(const Vector& u, const Vector& v, const Vector& n) {
  const Vector first = cross(v, n);
  const Vector second = cross(n, u);
  const Number u_2 = dot(u, u);
  const Number v_2 = dot(v, v);
  const Number n_2 = dot(n, n) * 2;
  Vector from_centre;
  for (std::size_t i = 0; i < 3; ++i) {
    from_centre[i] = v[i] * n_2 - (u_2 * first[i] + v_2 * second[i]);
  }
  return cross(n, from_centre);
}

void put_circle(BlockContext& block, const EndPoint& end, const EndPoint& via, const Vector& n) {
  const Vector direction = direction_at_end(way(via.by), way(end.by), n);
  Record record = block.motion_to(RecordKind::arc3, "SIE-CIP-01"_clause, end.named, end.to);
  record.via_axes = AxisSet{Axis::x, Axis::y, Axis::z};
  for (const Axis axis : kLinearAxes) record.via[axis] = via.to[axis];
  LastMotion last;
  for (const Axis axis : kLinearAxes) last.direction[axis] = direction[index(axis)];
  block.machine.last = std::move(last);
  put_motion(block, end, std::move(record));
}

}  // namespace

void run_intermediate(BlockContext& block) {
  refuse_words(block, {Address::i, Address::j, Address::k, Address::cr, Address::ar, Address::ap,
                       Address::rp, Address::turn});
  need_cutting(block);
  if (!block.words.has_intermediate()) {
    block.missing(kPoints, WordName("I1"));
    return;
  }
  if (block.words.is_polar()) return;
  std::optional<EndPoint> end = end_point(block);
  if (!end) return;
  end->named = end->named | AxisSet{Axis::x, Axis::y, Axis::z};
  const EndPoint via = intermediate_point(block);
  const Vector u = way(via.by);
  const Vector v = way(end->by);
  const Vector n = cross(u, v);
  if (any_nonzero({n[0], n[1], n[2]})) {
    put_circle(block, *end, via, n);
    return;
  }
  // SIE-CIP-01: on one line the intermediate point is between the others, or it is none.
  const Number along = dot(u, v);
  if (along.sign() > 0 && along < dot(v, v)) {
    put_line(block, RecordKind::feed, "SIE-CIP-01"_clause, *end);
    return;
  }
  const char* word = "I1";
  if (!block.words.has(Address::i1)) word = block.words.has(Address::j1) ? "J1" : "K1";
  block.alarm(AlarmClass::arc_intermediate_point, kPoints, WordName(word),
              "Start, intermediate point and end are no three points of a circle.");
}

}  // namespace gonogo::reference::sinumerik
