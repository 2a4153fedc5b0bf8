// SPDX-License-Identifier: GPL-3.0-or-later
//
// The forms of an arc: its centre I J K, CR=, AR=.
#include "reference/clause_literal.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"
#include "reference/sinumerik/arc.hpp"

namespace gonogo::reference::sinumerik {
namespace {

using geometry::Aff_transformation_2;

FoundArc from_start(const BlockContext& block, const ArcCommand& arc, const Vector_2& offset) {
  return {block.position_in(arc.axes) + offset, offset, std::nullopt, false};
}

// SIE-ARC-11: under that reading a chord may be longer than twice CR by CIRCLE_ERROR_CONST.
bool is_forgiven(const BlockContext& block, const ArcEnds& ends, const Number& radius) {
  const Number most =
      block.profile.parameter("CIRCLE_ERROR_CONST").value_or(Number::millionths(10'000));
  return ends.chord_within(exact::abs(radius) * 2 + most) &&
         block.readings.is("sie.cr.tolerance=const"_reading);
}

}  // namespace

// SIE-ARC-02: from the start, or absolute with AC(); one that is left out is 0.
ArcCentre programmed_centre(const BlockContext& block, const ArcCommand& arc) {
  const auto along = [&](Axis axis) {
    const Number& start = block.machine.position[axis];
    if (!block.words.has(centre_address(axis))) return std::array<Number, 2>{start, 0};
    const AxisWord word = block.words.centre_word(axis);
    return word.incremental ? std::array<Number, 2>{start + word.value, word.value}
                            : std::array<Number, 2>{word.value, word.value - start};
  };
  const auto [at_p, offset_p] = along(arc.axes.p);
  const auto [at_q, offset_q] = along(arc.axes.q);
  return {{at_p, at_q}, {offset_p, offset_q}, std::nullopt, std::nullopt};
}

// SIE-ARC-04
std::optional<FoundArc> arc_by_radius(BlockContext& block, const ArcCommand& arc) {
  const Number radius = block.words.length(Address::cr);
  const WordName word("CR");
  if (decided("SIE-ARC-04"_clause, "CR", radius) == 0) {
    block.alarm(AlarmClass::arc_radius, "SIE-ARC-04"_clause, word, "The radius is zero.");
    return std::nullopt;
  }
  if (arc.closed()) {
    block.alarm(AlarmClass::arc_end_point, "SIE-ARC-04"_clause, word,
                "An arc given by its radius cannot end where it starts.");
    return std::nullopt;
  }
  const ArcEnds ends = arc.ends();
  std::optional<Point_2> centre = centre_from_radius(ends, radius, arc.sense);
  if (!centre && is_forgiven(block, ends, radius)) centre = ends.middle();
  if (!centre) {
    block.alarm(AlarmClass::arc_radius, "SIE-ARC-11"_clause, word, radius_too_small(ends, radius));
    return std::nullopt;
  }
  return from_start(block, arc, *centre - ends.start);
}

// SIE-ARC-05. The centre stands off the middle of the chord by half its length times the cotangent
// of half the angle: on the left for a short arc counterclockwise.
std::optional<FoundArc> arc_by_angle_and_end(BlockContext& block, const ArcCommand& arc) {
  if (arc.closed()) {
    block.alarm(AlarmClass::arc_end_point, "SIE-ARC-11"_clause, WordName("AR"),
                "An arc given by its angle cannot end where it starts.");
    return std::nullopt;
  }
  const ArcEnds ends = arc.ends();
  const auto [cosine, sine] = exact::cos_sin_degrees(block.words.written(Address::ar) * kHalf);
  const Number off = Number(arc.sense) * kHalf * cosine / sine;
  const Vector_2& chord = ends.chord;
  return from_start(block, arc, chord * kHalf + chord.perpendicular(CGAL::COUNTERCLOCKWISE) * off);
}

// SIE-ARC-05. The end is the start, turned about the centre: seen from the start the offset of the
// centre less the same offset turned.
std::optional<FoundArc> arc_by_angle_and_centre(BlockContext& block, ArcCommand& arc) {
  const ArcCentre centre = programmed_centre(block, arc);
  const Vector_2& offset = centre.offset;
  if (!any_nonzero({offset.x(), offset.y()})) {
    block.alarm(AlarmClass::arc_radius, "SIE-ARC-08"_clause, WordName("AR"),
                "The centre is the start.");
    return std::nullopt;
  }
  const auto [cosine, sine] =
      exact::cos_sin_degrees(block.words.written(Address::ar) * Number(arc.sense));
  const Aff_transformation_2 turn(CGAL::ROTATION, sine, cosine);
  const Vector_2 chord = offset - turn(offset);
  for (const auto& [axis, by] : {std::pair(arc.axes.p, chord.x()), {arc.axes.q, chord.y()}}) {
    arc.end.by[axis] = by;
    arc.end.to[axis] = block.machine.position[axis] + by;
    arc.end.named.add(axis);
  }
  arc.end.closed = false;
  const Number radius_2 = known_start(block.machine, arc, centre).value_or(offset.squared_length());
  return FoundArc{centre.at, centre.offset, PlaceMark{arc.plane, centre.at, radius_2, std::nullopt},
                  false};
}

}  // namespace gonogo::reference::sinumerik
