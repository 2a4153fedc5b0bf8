// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-ARC-01, G2 and G3: an arc in the plane in force, by its centre or by its radius; with the
// third axis, a helix.
#include <fmt/format.h>

#include <limits>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/exact/radians.hpp"
#include "reference/geometry/arc_centre.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/machine.hpp"
#include "reference/rs274/modes.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {
namespace {

using Centre = std::optional<Point_2>;

// ngc.arc-tolerance = linuxcnc: half the chord may be longer than R by this much, and a radius
// below it is zero. 0.00005 inch.
const Number kForgiven = Number::millionths(1270);

struct Arc {
  PlaneAxes axes;
  AxisSet named;
  ArcEnds ends;
  int sense;  // sign of rot
  bool names_plane() const { return named.has(axes.p) || named.has(axes.q); }
};

bool is_linuxcnc(const BlockContext& block) {
  return block.readings.is("ngc.arc-tolerance=linuxcnc"_reading);
}

// NGC-ARC-05: how many turns are begun. Nothing when the rules are broken.
std::optional<std::int32_t> turns_of(BlockContext& block) {
  if (!block.p_is_turns) return 1;
  const ClauseId clause = "NGC-ARC-05"_clause;
  const Number written = block.words.written('P');
  const NearWhole turns(written);
  const bool is_whole = turns.counts_as_whole(Whole::turns, block.readings);
  const bool is_positive = (is_whole ? turns.nearest() : written).sign() > 0;
  if (!is_positive) {
    block.alarm(AlarmClass::value_sign, clause, 'P',
                with_values("The number of turns, {}, is not above zero.", {written}));
  }
  if (!is_whole) {
    block.alarm(AlarmClass::not_an_integer, clause, 'P',
                with_values("The number of turns, {}, is not whole.", {written}));
    return std::nullopt;
  }
  if (turns.nearest() > Number(std::numeric_limits<std::int32_t>::max())) {
    block.alarm(AlarmClass::value_out_of_range, clause, 'P',
                with_values("The number of turns, {}, is above {}.",
                            {written, std::numeric_limits<std::int32_t>::max()}));
    return std::nullopt;
  }
  if (!is_positive) return std::nullopt;
  return static_cast<std::int32_t>(turns.nearest().to_int64().value());
}

// NGC-ARC-04. Nothing when the rules are broken.
Centre centre_by_radius(BlockContext& block, const Arc& arc) {
  const ClauseId clause = "NGC-ARC-04"_clause;
  if (!arc.names_plane()) {
    block.missing(clause, address_of(arc.axes.p));
    return std::nullopt;
  }
  if (arc.ends.closed()) {
    block.alarm(AlarmClass::arc_end_point, clause, 'R',
                "An arc given by R cannot end where it starts.");
    return std::nullopt;
  }
  const Number radius = block.words.length('R').value();
  Centre centre = centre_from_radius(arc.ends, radius, arc.sense);
  if (centre) return centre;
  if (arc.ends.chord_within((abs(radius) + kForgiven) * 2) && is_linuxcnc(block)) {
    return arc.ends.middle();
  }
  block.alarm(AlarmClass::arc_radius, clause, 'R', radius_too_small(arc.ends, radius));
  return std::nullopt;
}

// NGC-ARC-03: what is wrong with the radii at start and end.
struct RadiusFaults {
  bool zero = false;
  bool apart = false;
  friend bool operator==(const RadiusFaults&, const RadiusFaults&) = default;
};

Number limit_of_nist(bool inch) {
  return Number::millionths(inch ? 5080 : 2000);
}

// LinuxCNC's limits are those of its messages times the root of two; squared here. Between the two,
// 0.001 of the larger radius is allowed.
struct LinuxcncLimits {
  explicit LinuxcncLimits(bool inch)
      : least(inch ? inches(inches(Number::millionths(8))) : Number::millionths(800)),
        most(inch ? inches(inches(Number::millionths(80'000))) : Number(8)) {}
  Number least;  // 0.02 mm, 0.002 inch
  Number most;   // 2 mm, 0.2 inch
};

const Number kThousandth = Number::millionths(1000);

bool is_without_radius(const OffsetCentre& arc) {
  return arc.begins_at_centre() || arc.ends_at_centre();
}

RadiusFaults faults_by_nist(const OffsetCentre& arc, bool inch) {
  return {is_without_radius(arc), !arc.radii_agree(limit_of_nist(inch))};
}

// 0.0005 and 0.05 inch.
RadiusFaults faults_by_page(const OffsetCentre& arc, bool inch) {
  const bool agree = arc.radii_agree(Number::millionths(inch ? 12'700 : 5000)) ||
                     (arc.radii_agree(Number::millionths(inch ? 1'270'000 : 500'000)) &&
                      arc.radii_agree_in_part(kThousandth));
  return {is_without_radius(arc), !agree};
}

RadiusFaults faults_by_grbl(const OffsetCentre& arc) {
  const bool agree =
      arc.radii_agree(Number::millionths(5000)) || (arc.radii_agree(Number::millionths(500'000)) &&
                                                    arc.radii_agree_in_part_of_start(kThousandth));
  return {is_without_radius(arc), !agree};
}

RadiusFaults faults_by_linuxcnc(const OffsetCentre& arc, bool inch) {
  const LinuxcncLimits limits(inch);
  const bool agree = arc.radii_agree_squared(limits.least) ||
                     (arc.radii_agree_squared(limits.most) && arc.radii_agree_in_part(kThousandth));
  return {arc.radius_below(kForgiven), !agree};
}

std::string allowed_apart(bool inch) {
  const LinuxcncLimits limits(inch);
  return with_values(
      " NIST's interpreter allows {} mm, LinuxCNC {} mm and, up to {} mm, a thousandth of the "
      "larger radius.",
      {limit_of_nist(inch), exact::sqrt(limits.least), exact::sqrt(limits.most)});
}

// The reading is asked for only where it matters.
RadiusFaults faults_of(const BlockContext& block, const OffsetCentre& arc, bool inch) {
  const RadiusFaults nist = faults_by_nist(arc, inch);
  const RadiusFaults linuxcnc = faults_by_linuxcnc(arc, inch);
  const RadiusFaults page = faults_by_page(arc, inch);
  const RadiusFaults grbl = faults_by_grbl(arc);
  if (nist == linuxcnc && nist == page && nist == grbl) return nist;
  if (block.readings.is("ngc.arc-tolerance=page"_reading)) return page;
  if (block.readings.is("ngc.arc-tolerance=grbl"_reading)) return grbl;
  return is_linuxcnc(block) ? linuxcnc : nist;
}

void check_radii(BlockContext& block, const OffsetCentre& arc, char address) {
  const bool inch = block.words.modes().inch;
  // No alarm under any reading: a radius of zero is below what LinuxCNC allows.
  if (arc.radii_agree(limit_of_nist(inch)) && !arc.radius_below(kForgiven)) return;
  const RadiusFaults faults = faults_of(block, arc, inch);
  const ClauseId clause = "NGC-ARC-03"_clause;
  if (faults.zero) {
    block.alarm(AlarmClass::arc_radius, clause, address, "The radius of the arc is zero.");
  }
  if (faults.apart) {
    block.alarm(AlarmClass::arc_end_point, clause, address,
                radii_apart(arc, axes_of(block.machine.plane), block.machine.modes.diameter) +
                    allowed_apart(inch));
  }
}

// NGC-DIS-01: offsets from the start, or under G90.1 the centre itself, which needs both words.
std::optional<OffsetCentre> offset_centre(BlockContext& block, const Arc& arc) {
  const std::optional<Number> p = block.words.length(offset_address(arc.axes.p));
  const std::optional<Number> q = block.words.length(offset_address(arc.axes.q));
  if (!block.machine.modes.absolute_centre) {
    return OffsetCentre(arc.ends, Vector_2(p.value_or(0), q.value_or(0)));
  }
  if (!p) block.missing("NGC-ARC-02"_clause, offset_address(arc.axes.p));
  if (!q) block.missing("NGC-ARC-02"_clause, offset_address(arc.axes.q));
  if (!p || !q) return std::nullopt;
  return OffsetCentre(arc.ends, Point_2(*p, *q) - arc.ends.start);
}

// NGC-ARC-02. Nothing when the rules are broken.
Centre centre_by_offsets(BlockContext& block, const Arc& arc) {
  if (!arc.names_plane() && block.readings.is("ngc.full-circle-words=needed"_reading)) {
    block.missing("NGC-ARC-04"_clause, address_of(arc.axes.p));
  }
  const std::optional<OffsetCentre> found = offset_centre(block, arc);
  if (!found) return std::nullopt;
  const char p = offset_address(arc.axes.p);
  const char address = block.words.has(p) ? p : offset_address(arc.axes.q);
  check_radii(block, *found, address);
  return found->centre;
}

// NGC-ARC-02, NGC-COM-01: which words an arc has. Whether it can be computed.
bool check_words(BlockContext& block, const PlaneAxes& axes) {
  const BlockWords& words = block.words;
  const char third = offset_address(axes.d);
  const bool by_centre = words.has(offset_address(axes.p)) || words.has(offset_address(axes.q));
  if (words.has(third)) {
    block.alarm(AlarmClass::axis_not_in_plane, "NGC-ARC-02"_clause, third,
                fmt::format("{} is no offset along an axis of the plane.", third));
  }
  if (words.has('R') && words.has_offset()) {
    block.alarm(AlarmClass::conflicting_words, "NGC-COM-01"_clause, 'R',
                "R and I J K exclude each other in an arc.");
    return false;
  }
  if (!words.has('R') && !by_centre) {
    block.missing("NGC-ARC-02"_clause, 'R');
    return false;
  }
  return true;
}

// NGC-FED-01: the way along the arc that F of inverse time counts; NGC-FED-03: nothing where its
// radii differ. REQUIRES: both are above zero.
std::optional<Number> way_along(const Arc& arc, const Point_2& centre, std::int32_t turns,
                                const Number& rise) {
  const Vector_2 from = arc.ends.start - centre;
  const Vector_2 to = arc.ends.end - centre;
  // What enclosures leave open is equal.
  if ((from.squared_length() - to.squared_length()).try_sign().value_or(0) != 0) {
    return std::nullopt;
  }
  const Number across = CGAL::determinant(from, to) * Number(arc.sense);
  Number last = exact::angle_degrees(CGAL::scalar_product(from, to), across);
  if (last.sign() == 0) last = 360;
  const Number round =
      exact::sqrt(from.squared_length()) * exact::radians(last + Number(360) * Number(turns - 1));
  return exact::sqrt(round * round + rise * rise);
}

}  // namespace

void run_arc(BlockContext& block, int sense) {
  const PlaneAxes axes = axes_of(block.machine.plane);
  const bool is_inverse_time = block.machine.is_inverse_time;
  if (!is_inverse_time) block.need_feed("NGC-G0-01"_clause);
  const std::optional<std::int32_t> turns = turns_of(block);
  if (!check_words(block, axes)) return;
  Position to;
  const AxisSet named = commanded_end_point(block, to);
  const Arc arc{axes, named, ArcEnds(axes, block.machine.position, to), sense};
  const bool by_radius = block.words.has('R');
  const Centre centre = by_radius ? centre_by_radius(block, arc) : centre_by_offsets(block, arc);
  if (!centre || !turns) return;
  const bool winds = named.has(axes.d) || *turns > 1;
  const ClauseId clause = winds       ? "NGC-ARC-05"_clause
                          : by_radius ? "NGC-ARC-04"_clause
                                      : "NGC-ARC-02"_clause;
  const Number rise = to[axes.d] - block.machine.position[axes.d];
  Record record = block.arc_to(clause, named, to, geometry::pair(*centre), sense * *turns);
  // An arc that alarms may have no radius, and no way.
  if (is_inverse_time && block.words.has('F') && block.out.alarms.empty()) {
    const std::optional<Number> way = way_along(arc, *centre, *turns, rise);
    if (!way) return leave_out(block, 'F', "No text says how long an arc is whose radii differ.");
    record.feed = block.words.written('F') * *way;
  }
  block.put(std::move(record));
}

}  // namespace gonogo::reference::rs274
