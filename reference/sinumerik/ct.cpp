// SPDX-License-Identifier: GPL-3.0-or-later
//
// CT: an arc in the plane in force, tangent to the motion before it.
#include <cstdlib>

#include "reference/clause_literal.hpp"
#include "reference/exact/radians.hpp"
#include "reference/exact/size.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr ClauseId kBefore = "SIE-CT-02"_clause;

// Each tangent arc has more digits than the one before, and one that is only enclosed more
// operations: what a chain of them costs would grow with the square or the cube of its length.
constexpr std::size_t kLongestTangent = 16'384;  // bits of a component
constexpr std::size_t kDeepestTangent = 1'000;   // operations

void refuse(BlockContext& block, ClauseId clause, std::string message) {
  for (const Axis axis : {block.plane_axes().p, block.plane_axes().q}) {
    if (!block.words.has(address_of(axis))) continue;
    block.alarm(AlarmClass::arc_tangent, clause, name_of(address_of(axis)), std::move(message));
    return;
  }
  block.alarm(AlarmClass::arc_tangent, clause, WordName("CT"), std::move(message));
}

// Whether an arc from one point to another about a centre is no part of a turn, as far as can be
// told. An arc that ends nearer or farther on the ray of its start (SIE-ARC-08) has a length
// nevertheless.
bool may_have_no_sweep(const Vector_2& from, const Vector_2& to) {
  // First what is decided at once of half a turn, whose ends are as hard to tell from one ray.
  const std::optional<int> along = CGAL::scalar_product(from, to).try_sign();
  if (along.value_or(1) <= 0) return false;
  return CGAL::determinant(from, to).try_sign().value_or(0) == 0;
}

// Where the programmed centre is kept and the end stands in it (SIE-ARC-08), as far as is known.
bool may_end_in_centre(const Vector_2& to) {
  return to.x().try_sign().value_or(0) == 0 && to.y().try_sign().value_or(0) == 0;
}

// Whether no text says which way an arc goes at its end, as far as is known.
bool may_go_no_way(const LastArc& arc) {
  if (may_end_in_centre(arc.to_end)) return true;
  return !arc.closed && std::abs(arc.rot) == 1 && may_have_no_sweep(arc.from_centre, arc.to_end);
}

// The whole angle that a helix turned through, in radians.
Number angle_of(const LastArc& helix) {
  const Vector_2& a = helix.from_centre;
  const Vector_2& b = helix.to_end;
  const int sense = helix.rot > 0 ? 1 : -1;
  const Number across = CGAL::determinant(a, b) * Number(sense);
  const Number last =
      helix.closed ? Number(360) : exact::angle_degrees(CGAL::scalar_product(a, b), across);
  return exact::radians(last + Number(360) * Number(sense * helix.rot - 1));
}

// SIE-CT-02: what the plane sees of the direction before.
Vector_2 direction_in_plane(const LastMotion& last, const PlaneAxes& axes) {
  const bool climbs = last.arc && last.arc->climb && last.arc->climb->axis != axes.d;
  return geometry::vector_in(axes, climbs ? whole_direction(last) : last.direction);
}

bool is_kept(const Number& component) {
  const exact::Size size = exact::size_of(component);
  return size.bits <= kLongestTangent && size.depth <= kDeepestTangent;
}

// SIE-CT-01: from the start to the centre, on the left where that is positive: square to the
// tangent there, and as far from the end, so that o.o = (chord - o).(chord - o). CGAL's
// intersection of that normal with the chord's bisector would ask whether an enclosure is 1.
Vector_2 centre_of_tangent_arc(const Vector_2& tangent, const Vector_2& chord) {
  const Number off = chord.squared_length() / (CGAL::determinant(tangent, chord) * Number(2));
  return tangent.perpendicular(CGAL::COUNTERCLOCKWISE) * off;
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
                       Address::cr, Address::ar});
  refuse_turns(block);
  need_cutting(block);
  std::optional<EndPoint> end = end_point(block);
  if (!end) return;
  const PlaneAxes axes = block.plane_axes();
  const std::optional<LastMotion>& last = block.machine.last;
  if (!last) return refuse(block, "SIE-CT-01"_clause, "No motion stands before the arc.");
  if (last->undecided || (last->arc && may_go_no_way(*last->arc))) {
    throw exact::Undecided("exact: which way the motion before goes");
  }
  const Vector_2 tangent = direction_in_plane(*last, axes);
  if (!is_kept(tangent.x()) || !is_kept(tangent.y())) {
    throw exact::Undecided("exact: a direction of more digits than the gauge keeps");
  }
  if (!any_nonzero({tangent.x(), tangent.y()})) {
    return refuse(block, kBefore, "The motion before stands upright on the plane.");
  }
  const Vector_2 chord = geometry::vector_in(axes, end->by);
  if (end->closed.value_or(false) || !any_nonzero({chord.x(), chord.y()})) {
    return refuse(block, kBefore, "A tangent arc cannot end where it starts.");
  }
  end->named = end->named | AxisSet{axes.p, axes.q};
  const int sense = CGAL::orientation(tangent, chord);
  // SIE-CT-01: straight ahead, or straight behind.
  if (sense == CGAL::COLLINEAR) {
    if (CGAL::angle(tangent, chord) == CGAL::ACUTE) {
      return put_line(block, RecordKind::feed, "SIE-CT-01"_clause, *end);
    }
    return refuse(block, "SIE-CT-01"_clause, "The end stands straight behind the start.");
  }
  const Vector_2 offset = centre_of_tangent_arc(tangent, chord);
  const bool is_helix = end->named.has(axes.d);
  put_arc(block,
          {block.machine.plane, block.position_in(axes) + offset, offset, sense,
           is_helix ? kBefore : "SIE-CT-01"_clause},
          *end);
}

}  // namespace gonogo::reference::sinumerik
