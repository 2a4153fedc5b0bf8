// SPDX-License-Identifier: GPL-3.0-or-later
//
// G2 and G3: the plane of an arc, its form, and the turns of a helix.
#include "reference/sinumerik/arc.hpp"

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>

namespace gonogo::reference::sinumerik {
namespace {

constexpr std::int64_t kMostTurns = 999;

Plane plane_of(Axis d) {
  return d == Axis::z ? Plane::g17 : d == Axis::y ? Plane::g18 : Plane::g19;
}

// SIE-ARC-12: with the centre word of the common axis alone the other one may be a 0 that a helix
// of the plane in force has left out; CR= alone is a form of both.
bool may_wind(const BlockContext& block, Axis unnamed) {
  const BlockWords& words = block.words;
  const PlaneAxes axes = block.plane_axes();
  const Axis common = unnamed == axes.p ? axes.q : axes.p;
  const bool by_one_word = words.has(centre_address(common)) && !words.has(centre_address(axes.d));
  const bool by_radius = words.has(Address::cr) && !words.has_centre();
  return by_one_word || by_radius;
}

// SIE-ARC-12. Where two end-point axes choose the plane, the third of X Y Z stands upright on it.
Plane plane_of_arc(const BlockContext& block) {
  const BlockWords& words = block.words;
  const Plane in_force = block.machine.plane;
  std::optional<Axis> unnamed;
  for (const Axis axis : kLinearAxes) {
    if (words.has(address_of(axis))) continue;
    if (unnamed) return in_force;  // fewer than two
    unnamed = axis;
  }
  if (!unnamed || *unnamed == axes_of(in_force).d) return in_force;
  const bool is_helix = words.has(Address::turn) || words.has(Address::ar) ||
                        words.has(centre_address(*unnamed)) || words.is_polar();
  if (is_helix) return in_force;
  const bool winds = may_wind(block, *unnamed) && block.readings.is("sie.arc.plane=helix"_reading);
  return winds ? in_force : plane_of(*unnamed);
}

// SIE-ARC-13, SIE-ARC-09. Nothing when the rules are broken.
std::optional<int> more_turns(BlockContext& block) {
  if (!block.words.has(Address::turn)) return 0;
  const Number& turns = block.words.written(Address::turn);
  const ClauseId clause = "SIE-ARC-13"_clause;
  if (turns != turns.floor()) {
    block.alarm(AlarmClass::not_an_integer, clause, WordName("TURN"),
                with_values("The number of turns, {}, is not whole.", {turns}));
    return std::nullopt;
  }
  if (decided(clause, "TURN", turns) < 0 ||
      decided(clause, "TURN - 999", turns, Number(kMostTurns)) > 0) {
    block.alarm(
        AlarmClass::value_out_of_range, clause, WordName("TURN"),
        with_values("The number of turns is from 0 to {}, and not {}.", {kMostTurns, turns}));
    return std::nullopt;
  }
  return static_cast<int>(*turns.to_int64());
}

// SIE-ARC-14: no centre along an axis that is not of the plane. The first centre word of it.
Address check_centre_words(BlockContext& block, const PlaneAxes& axes) {
  const Address third = centre_address(axes.d);
  if (block.words.has(third)) {
    block.alarm(
        AlarmClass::axis_not_in_plane, "SIE-ARC-14"_clause, name_of(third),
        fmt::format("{} is no centre along an axis of the arc's plane.", name_of(third).text()));
  }
  return block.words.has(centre_address(axes.p)) ? centre_address(axes.p) : centre_address(axes.q);
}

// SIE-ARC-05: an arc of no angle that would lead nowhere, under a reading that has it do just that.
bool has_no_angle(const BlockWords& words) {
  return words.has(Address::ar) && words.written(Address::ar).sign() == 0 &&
         !words.has(Address::turn);
}
bool moves_nothing(const BlockContext& block, const std::optional<EndPoint>& end) {
  return end &&
         !any_nonzero({end->by[Axis::x], end->by[Axis::y], end->by[Axis::z], end->by[Axis::a],
                       end->by[Axis::c]}) &&
         block.readings.is("sie.ar.zero=none"_reading);
}

// SIE-ARC-05: the range of AR. Whether it is kept.
bool check_angle(BlockContext& block) {
  if (!block.words.has(Address::ar)) return true;
  const Number& angle = block.words.written(Address::ar);
  const ClauseId clause = "SIE-ARC-05"_clause;
  if (decided(clause, "AR", angle) > 0 && decided(clause, "AR - 360", angle, 360) < 0) return true;
  block.alarm(
      AlarmClass::value_out_of_range, clause, WordName("AR"),
      with_values("The angle of an arc is above 0 and below 360 degrees, and not {}.", {angle}));
  return false;
}

// SIE-ARC-16: whether CR= stands beside a centre, and whether that makes the arc.
bool has_radius_and_centre(const BlockWords& words) {
  return words.has(Address::cr) && words.has_centre();
}
bool leaves_radius_out(const BlockContext& block) {
  return has_radius_and_centre(block.words) && block.readings.is("sie.cr.centre=centre"_reading);
}

// SIE-ARC-11: an arc has one form. Whether it has.
bool check_form(BlockContext& block, const PlaneAxes& axes) {
  const ClauseId clause = "SIE-ARC-11"_clause;
  const BlockWords& words = block.words;
  const bool radius = words.has(Address::cr);
  const bool angle = words.has(Address::ar);
  const bool ends = words.has(address_of(axes.p)) || words.has(address_of(axes.q));
  const auto conflict_by = [&](ClauseId rule, std::string_view word, std::string_view others) {
    block.alarm(AlarmClass::conflicting_words, rule, WordName(word),
                fmt::format("{} does not stand beside {} in an arc.", word, others));
    return false;
  };
  const auto conflict = [&](std::string_view word, std::string_view others) {
    return conflict_by(clause, word, others);
  };
  if (words.is_polar() && (words.has_centre() || radius || angle)) {
    return conflict(words.has(Address::ap) ? "AP" : "RP", "a centre, CR or AR");
  }
  if (radius && angle) return conflict("CR", "AR");
  if (has_radius_and_centre(words) && block.readings.is("sie.cr.centre=alarm"_reading)) {
    return conflict_by("SIE-ARC-16"_clause, "CR", "a centre");
  }
  if (angle && words.has_centre() && ends) return conflict("AR", "a centre with an end point");
  if (angle ? words.has_centre() || ends : words.has_centre() || radius || words.is_polar()) {
    return true;
  }
  block.missing(clause, angle ? name_of(address_of(axes.p)) : WordName("CR"));
  return false;
}

// SIE-ARC-06: the pole is the centre. RP is the radius at the end; at the start it is known where
// the machine was sent there about the same pole.
ArcCentre polar_centre(const BlockContext& block, const ArcCommand& arc) {
  const Point_2& pole = block.machine.pole;
  return {pole, pole - block.position_in(arc.axes), std::nullopt, arc.end.mark->radius_2};
}

std::optional<FoundArc> find_arc(BlockContext& block, ArcCommand& arc, Address centre_word) {
  const BlockWords& words = block.words;
  if (words.has(Address::cr) && !leaves_radius_out(block)) return arc_by_radius(block, arc);
  if (words.has(Address::ar)) {
    return words.has_centre() ? arc_by_angle_and_centre(block, arc)
                              : arc_by_angle_and_end(block, arc);
  }
  if (words.is_polar()) {
    const WordName word = words.has(Address::rp) ? WordName("RP") : WordName("AP");
    return centre_in_force(block, arc, polar_centre(block, arc), word);
  }
  return centre_in_force(block, arc, programmed_centre(block, arc), name_of(centre_word));
}

// What the record says: the form of the arc, unless it winds or its centre is another one.
ClauseId clause_of(const BlockContext& block, const ArcCommand& arc, bool is_corrected) {
  const BlockWords& words = block.words;
  if (is_corrected) return "SIE-ARC-08"_clause;
  if (words.has(Address::turn) || arc.end.named.has(arc.axes.d)) return "SIE-ARC-09"_clause;
  if (words.has(Address::cr) && !leaves_radius_out(block)) return "SIE-ARC-04"_clause;
  if (words.has(Address::ar)) return "SIE-ARC-05"_clause;
  if (words.is_polar()) return "SIE-ARC-06"_clause;
  if (arc.closed()) return "SIE-ARC-03"_clause;
  return arc.plane == block.machine.plane ? "SIE-ARC-02"_clause : "SIE-ARC-01"_clause;
}

}  // namespace

bool ArcCommand::closed() const {
  if (end.closed) return *end.closed;
  return !names_plane() || !any_nonzero({end.by[axes.p], end.by[axes.q]});
}

// SIE-ARC-01: the sense is seen from the positive third axis of the arc's plane.
void run_arc(BlockContext& block, int sense) {
  refuse_words(block, {Address::i1, Address::j1, Address::k1});
  need_cutting(block);
  const std::optional<int> turns = more_turns(block);
  const Plane plane = plane_of_arc(block);
  const PlaneAxes axes = axes_of(plane);
  // The plane in force has been looked at where it was named.
  const bool admitted = plane == block.machine.plane || admits_plane(block, plane, 'G');
  const Address centre_word = check_centre_words(block, axes);
  std::optional<EndPoint> end;
  const bool needs_end = has_no_angle(block.words);
  if (needs_end) end = end_point(block);
  const bool stays = needs_end && moves_nothing(block, end);
  const bool angle_in_range = stays || check_angle(block);
  // Where the only centre is one along the third axis, there is none to work with.
  const bool has_no_centre = block.words.has_centre() && !block.words.has(centre_word);
  const bool has_form = check_form(block, axes);
  if (!needs_end) end = end_point(block);  // the rules of AP and RP hold anyway
  if (!has_form || has_no_centre || !end || !angle_in_range || !admitted || stays) return;
  ArcCommand arc{plane, axes, sense, *end};
  const std::optional<FoundArc> found = find_arc(block, arc, centre_word);
  if (!found) return;
  if (found->mark) arc.end.mark = found->mark;
  arc.end.closed = arc.closed();
  put_arc(block,
          {plane, found->centre, found->offset, sense * (1 + turns.value_or(0)),
           clause_of(block, arc, found->is_corrected)},
          arc.end);
}

}  // namespace gonogo::reference::sinumerik
