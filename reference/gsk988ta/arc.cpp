// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSK-COM-05, G02 and G03: an arc by its radius or by its centre; with the depth axis, a helix.
#include <fmt/format.h>

#include <string_view>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/geometry/arc_centre.hpp"
#include "reference/gsk988ta/machine.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

using Centre = std::optional<Point_2>;

// Parameter 3410, mm: how far two radii may be apart.
Number most_apart(const BlockContext& block) {
  return block.profile.parameter("3410").value_or(Number::millionths(10'000));
}

// Whether the machine runs on instead of an alarm: 0 in its parameter, or as a reading says.
bool runs_on(const BlockContext& block, std::string_view parameter, ReadingAlternative reading) {
  if (auto value = block.profile.parameter(parameter)) return value->sign() == 0;
  return block.readings.is(reading);
}

// GSK-COM-05, parameter 3403#4: R is less than half the chord, by no more than radii may be apart.
bool is_semicircle(const BlockContext& block, const ArcEnds& ends) {
  const Number limit = most_apart(block);
  return limit.sign() > 0 &&
         ends.chord_within((abs(block.words.length('R').value()) + limit) * 2) &&
         runs_on(block, "3403.4", "gsk.arc.small-radius=semicircle"_reading);
}

// Nothing when the rules are broken.
Centre centre_by_radius(BlockContext& block, const ArcEnds& ends, int sense) {
  if (ends.closed()) {
    if (block.readings.is("gsk.arc.closed=alarm"_reading)) {
      block.alarm(AlarmClass::arc_end_point, "GSK-COM-05"_clause, 'R',
                  "An arc given by R cannot end where it starts.");
    }
    return std::nullopt;
  }
  const Centre centre = centre_from_radius(ends, block.words.length('R').value(), sense);
  if (!centre && is_semicircle(block, ends)) return ends.middle();
  if (!centre) {
    block.alarm(AlarmClass::arc_radius, "GSK-COM-05"_clause, 'R',
                radius_too_small(ends, block.words.length('R').value()));
  }
  return centre;
}

// The centre from I J K: kept as given; the radii at start and end may differ by parameter 3410.
Centre centre_by_offsets(BlockContext& block, const PlaneAxes& axes, const ArcEnds& ends) {
  const char address = offset_address(axes.p);
  const OffsetCentre arc(ends, Vector_2(block.words.length(address).value_or(0),
                                        block.words.length(offset_address(axes.q)).value_or(0)));
  if (arc.is_point()) {
    if (block.readings.is("gsk.arc.zero-radius=alarm"_reading)) {
      block.alarm(AlarmClass::arc_radius, "GSK-COM-05"_clause, address,
                  "The radius of the arc is zero.");
    }
    return std::nullopt;
  }
  const Number limit = most_apart(block);
  const bool checked =
      limit.sign() > 0 ||
      (limit.sign() == 0 && block.readings.is("gsk.arc.tolerance-zero=exact"_reading));
  // However near its end is: no angle leads there from the centre.
  const bool has_no_radius =
      arc.begins_at_centre() && block.readings.is("gsk.arc.zero-radius=alarm"_reading);
  if (has_no_radius) {
    block.alarm(AlarmClass::arc_radius, "GSK-COM-05"_clause, address,
                "The arc begins at its centre.");
  }
  if (checked && !arc.radii_agree(limit)) {
    block.alarm(AlarmClass::arc_end_point, "GSK-COM-05"_clause, address,
                radii_apart(arc, axes, true) + with_values(" {} mm is allowed.", {limit}));
    return std::nullopt;
  }
  if (has_no_radius) return std::nullopt;
  return arc.centre;
}

}  // namespace

void run_arc(BlockContext& block, int sense) {
  const BlockWords& words = block.words;
  Machine& machine = block.machine;
  const PlaneAxes axes = axes_of(machine.plane);
  const bool by_radius = words.has('R');
  const bool by_centre = words.has(offset_address(axes.p)) || words.has(offset_address(axes.q));
  Position to;
  const AxisSet named = commanded_end_point(block, to);
  if (named.empty() && !by_radius && !by_centre) return;
  const bool has_centre = by_radius || by_centre;
  // GSK-COM-01, parameter 3403#5.
  if (!has_centre && runs_on(block, "3403.5", "gsk.arc.no-centre=line"_reading)) {
    return run_straight_feed(block);
  }
  block.need_feed();
  if (!has_centre) return block.missing("GSK-COM-01"_clause, 'R');
  const ArcEnds ends(axes, machine.position, to);
  const Centre centre =
      by_radius ? centre_by_radius(block, ends, sense) : centre_by_offsets(block, axes, ends);
  if (!centre) {
    // Under gsk.arc.zero-radius = none, or gsk.arc.closed = none, only the axes outside the plane
    // have a way to go.
    if (block.out.alarms.empty() && to != machine.position) run_straight_feed(block);
    return;
  }
  block.put(block.arc_to("GSK-COM-05"_clause, named, to, geometry::pair(*centre), sense));
}

}  // namespace gonogo::reference::gsk988ta
