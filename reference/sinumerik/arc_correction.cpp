// SPDX-License-Identifier: GPL-3.0-or-later
//
// The centre of an arc whose end misses its circle: how far it may, and what is done about it.
#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/exact/radians.hpp"
#include "reference/reading_literal.hpp"
#include "reference/sinumerik/arc.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr ClauseId kCorrected = "SIE-ARC-08"_clause;
const Number kPerMille = Number::millionths(1000);

// um^2 of mm^2, as OffsetCentre has them.
Number fine_2(const Number& mm_2) {
  return mm_2 * 1'000'000;
}

// SIE-ARC-07: the larger of the two limits decides, so either will do.
bool check_radii(BlockContext& block, const OffsetCentre& radii, const PlaneAxes& axes,
                 WordName word) {
  const Number most =
      block.profile.parameter("CIRCLE_ERROR_CONST").value_or(Number::millionths(10'000));
  const Number part = block.profile.parameter("CIRCLE_ERROR_FACTOR").value_or(kPerMille);
  if (radii.radii_agree_squared(most * most) || radii.radii_agree_in_part_of_start(part)) {
    return true;
  }
  block.alarm(
      AlarmClass::arc_end_point, "SIE-ARC-07"_clause, word,
      radii_apart(radii, axes, block.machine.modes.diameter) +
          with_values(" The larger of {} mm and {} times the radius at the start is allowed.",
                      {most, part}));
  return false;
}

// SIE-ARC-10: the polar coordinates of a place about the point; nothing where it was not sent there
// by them.
const PlaceMark::Polar* polar_about(const std::optional<PlaceMark>& mark, Plane plane,
                                    const Point_2& centre) {
  const bool is_about =
      mark && mark->polar && mark->plane == plane && surely_equal(mark->centre, centre);
  return is_about ? &*mark->polar : nullptr;
}

// On which side of the chord the programmed centre is, seen along it: +1 left, 0 on the chord
// itself. Angles of both ends about that centre decide it where coordinates are enclosures.
int side_of_programmed(const Machine& machine, const ArcCommand& arc, const ArcEnds& ends,
                       const ArcCentre& programmed) {
  const PlaceMark::Polar* from = polar_about(machine.mark, arc.plane, programmed.at);
  const PlaceMark::Polar* to = polar_about(arc.end.mark, arc.plane, programmed.at);
  if (from == nullptr || to == nullptr) {
    return CGAL::orientation(ends.chord, programmed.offset);
  }
  if (to->radius.sign() == 0) return 0;
  const Number turns = (to->angle - from->angle) / Number(360);
  const Number part = turns - turns.floor();
  if (part.sign() == 0 || part == kHalf) return 0;
  return part < kHalf ? 1 : -1;
}

// On the perpendicular bisector at the radius of the start, on the side of the programmed centre;
// for one on the chord itself on the side of the shorter arc. A chord above twice that radius has
// its centre in its middle.
Vector_2 at_start_radius(const Machine& machine, const ArcCommand& arc, const ArcEnds& ends,
                         const OffsetCentre& radii, const ArcCentre& programmed) {
  const int left = side_of_programmed(machine, arc, ends, programmed);
  const int side = left != 0 ? -left : -arc.sense;  // +1: right of the chord
  return centre_off_middle(ends, radii.start_2, side).value_or(ends.middle()) - ends.start;
}

// The foot of the programmed centre on the perpendicular bisector. By its distance off the chord:
// CGAL's projection on the line would ask whether an enclosure is 0.
Vector_2 projected(const ArcEnds& ends, const Vector_2& programmed) {
  const Number off = CGAL::determinant(ends.chord, programmed) / ends.chord.squared_length();
  return ends.chord * kHalf + ends.chord.perpendicular(CGAL::COUNTERCLOCKWISE) * off;
}

// Radians, where the centres are apart.
Number angle_between(const Vector_2& programmed, const Vector_2& found) {
  return exact::radians(exact::angle_degrees(CGAL::scalar_product(programmed, found),
                                             exact::abs(CGAL::determinant(programmed, found))));
}

// An enclosure might contain no angle at all, and a message decides nothing.
std::string too_far_text(const Vector_2& programmed, const Vector_2& found) {
  const bool is_enclosed = CGAL::determinant(programmed, found).form() == Number::Form::enclosure;
  const Number limit = exact::sqrt(kPerMille);
  return is_enclosed
             ? with_values(
                   "The corrected centre is seen from the start more than {} radians beside the "
                   "programmed one.",
                   {limit})
             : with_values(
                   "The corrected centre is seen from the start {} radians beside the programmed "
                   "one, and {} are allowed.",
                   {angle_between(programmed, found), limit});
}

// Whether the angle at the start between the two centres is at most the root of 0.001 radians. Its
// tangent is algebraic and that of the root is not: they are never equal, and enough digits decide.
bool is_near(const Vector_2& programmed, const Vector_2& found) {
  const Number along = CGAL::scalar_product(programmed, found);
  if (along.sign() <= 0) return false;
  const Number across = CGAL::determinant(programmed, found);
  // The tangent is above the angle.
  if (across * across <= along * along * kPerMille) return true;
  return angle_between(programmed, found) <= exact::sqrt(kPerMille);
}

}  // namespace

std::optional<Number> known_start(const Machine& machine, const ArcCommand& arc,
                                  const ArcCentre& centre) {
  const bool is_known = machine.mark && machine.mark->plane == arc.plane &&
                        surely_equal(machine.mark->centre, centre.at);
  return is_known ? std::optional<Number>(machine.mark->radius_2) : std::nullopt;
}

std::optional<FoundArc> centre_in_force(BlockContext& block, const ArcCommand& arc,
                                        const ArcCentre& centre, WordName word) {
  const ArcEnds ends = arc.ends();
  OffsetCentre radii(ends, centre.offset);
  radii.centre = centre.at;  // for people: the offset is from the start
  if (const auto known = known_start(block.machine, arc, centre)) radii.start_2 = fine_2(*known);
  const Vector_2 to_end = from_centre_to_end(arc.axes, centre.at, centre.offset, arc.end);
  radii.end_2 = fine_2(centre.end_2.value_or(to_end.squared_length()));
  if (radii.begins_at_centre()) {
    block.alarm(AlarmClass::arc_radius, kCorrected, word, "The centre is the start.");
    // No text says which of the two is looked at first.
    if (!arc.closed()) check_radii(block, radii, arc.axes, word);
    return std::nullopt;
  }
  FoundArc found{centre.at, centre.offset, std::nullopt, false};
  // SIE-ARC-03: a full circle ends on itself.
  if (arc.closed()) return found;
  if (radii.start_2 == radii.end_2) {
    found.mark = PlaceMark{arc.plane, centre.at, radii.end_2 / Number(1'000'000), std::nullopt};
    if (arc.end.mark) found.mark = arc.end.mark;
    return found;
  }
  if (!check_radii(block, radii, arc.axes, word)) return std::nullopt;
  found.is_corrected = true;
  const ReadingsInUse& readings = block.readings;
  if (readings.is("sie.arc.correct=programmed"_reading)) return found;
  const bool projects = readings.is("sie.arc.correct=project"_reading);
  found.offset = projects ? projected(ends, centre.offset)
                          : at_start_radius(block.machine, arc, ends, radii, centre);
  found.centre = block.position_in(arc.axes) + found.offset;
  if (!is_near(centre.offset, found.offset)) {
    block.alarm(AlarmClass::arc_end_point, kCorrected, word,
                too_far_text(centre.offset, found.offset));
    return std::nullopt;
  }
  return found;
}

}  // namespace gonogo::reference::sinumerik
