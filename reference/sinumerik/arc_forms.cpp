// SPDX-License-Identifier: GPL-3.0-or-later
//
// The forms of an arc: its centre I J K, CR=, AR=.
#include "reference/predicate.hpp"
#include "reference/sinumerik/arc.hpp"

namespace gonogo::reference::sinumerik {
namespace {

PlanePoint plus(const PlanePoint& a, const PlanePoint& b) {
  return {a[0] + b[0], a[1] + b[1]};
}

FoundArc from_start(const BlockContext& block, const ArcCommand& arc, const PlanePoint& offset) {
  return {plus(block.position_in(arc.axes), offset), offset, std::nullopt, false};
}

// SIE-ARC-11: under that reading a chord may be longer than twice CR by CIRCLE_ERROR_CONST.
bool is_forgiven(const BlockContext& block, const ArcEnds& ends, const Number& radius) {
  const Number most =
      block.profile.parameter("CIRCLE_ERROR_CONST").value_or(Number::millionths(10'000));
  return ends.chord_within(exact::abs(radius) * 2 + most) &&
         block.readings.is(ReadingKey::sie_cr_tolerance, "const");
}

}  // namespace

// SIE-ARC-02: from the start, or absolute with AC(); one that is left out is 0.
ArcCentre programmed_centre(const BlockContext& block, const ArcCommand& arc) {
  const PlanePoint start = block.position_in(arc.axes);
  ArcCentre centre{start, {}, std::nullopt, std::nullopt};
  for (std::size_t i = 0; i < 2; ++i) {
    const Axis axis = i == 0 ? arc.axes.p : arc.axes.q;
    if (!block.words.has(centre_address(axis))) continue;
    const AxisWord word = block.words.centre_word(axis);
    centre.offset[i] = word.incremental ? word.value : word.value - start[i];
    centre.at[i] = word.incremental ? start[i] + word.value : word.value;
  }
  return centre;
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
  std::optional<PlanePoint> offset = centre_from_radius(ends, radius, arc.sense);
  if (!offset && is_forgiven(block, ends, radius)) offset = ends.middle();
  if (!offset) {
    block.alarm(AlarmClass::arc_radius, "SIE-ARC-11"_clause, word, radius_too_small(ends, radius));
    return std::nullopt;
  }
  return from_start(block, arc, *offset);
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
  const PlanePoint middle = ends.middle();
  return from_start(block, arc, {middle[0] - ends.dq * off, middle[1] + ends.dp * off});
}

// SIE-ARC-05. The end is the start, turned about the centre: seen from the start the offset of the
// centre less the same offset turned.
std::optional<FoundArc> arc_by_angle_and_centre(BlockContext& block, ArcCommand& arc) {
  const ArcCentre centre = programmed_centre(block, arc);
  const PlanePoint& offset = centre.offset;
  if (!any_nonzero({offset[0], offset[1]})) {
    block.alarm(AlarmClass::arc_radius, "SIE-ARC-08"_clause, WordName("AR"),
                "The centre is the start.");
    return std::nullopt;
  }
  const auto [cosine, sine] =
      exact::cos_sin_degrees(block.words.written(Address::ar) * Number(arc.sense));
  const PlanePoint turned = {offset[0] * cosine - offset[1] * sine,
                             offset[0] * sine + offset[1] * cosine};
  const PlanePoint start = block.position_in(arc.axes);
  for (std::size_t i = 0; i < 2; ++i) {
    const Axis axis = i == 0 ? arc.axes.p : arc.axes.q;
    arc.end.by[axis] = offset[i] - turned[i];
    arc.end.to[axis] = start[i] + arc.end.by[axis];
    arc.end.named.add(axis);
  }
  arc.end.closed = false;
  const Number radius_2 = known_start(block.machine, arc, centre)
                              .value_or(offset[0] * offset[0] + offset[1] * offset[1]);
  return FoundArc{centre.at, offset, PlaceMark{arc.plane, centre.at, radius_2, std::nullopt},
                  false};
}

}  // namespace gonogo::reference::sinumerik
