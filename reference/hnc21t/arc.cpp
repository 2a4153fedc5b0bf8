// SPDX-License-Identifier: GPL-3.0-or-later
//
// HNC-COM-01, G02 and G03: an arc in the plane of Z and X, by its radius or by its centre.

#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/geometry/arc_centre.hpp"
#include "reference/hnc21t/machine.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::hnc21t {
namespace {

using Centre = std::optional<Point_2>;

// Parameter 3410, mm: how far two radii may be apart; a negative one allows any difference.
Number most_apart(const BlockContext& block) {
  return block.profile.parameter("3410").value_or(Number::millionths(10'000));
}

// R is less than half the chord, by no more than radii may be apart.
bool is_semicircle(const BlockContext& block, const ArcEnds& ends) {
  const Number limit = most_apart(block);
  return limit.sign() > 0 &&
         ends.chord_within((abs(block.words.length('R').value()) + limit) * 2) &&
         block.readings.is("hnc.arc.small-radius=semicircle"_reading);
}

// Nothing when the rules are broken.
Centre centre_by_radius(BlockContext& block, const ArcEnds& ends, int sense) {
  if (ends.closed()) {
    if (block.readings.is("hnc.arc.closed=alarm"_reading)) {
      block.alarm(AlarmClass::arc_end_point, "HNC-COM-01"_clause, 'R',
                  "An arc given by R cannot end where it starts.");
    }
    return std::nullopt;
  }
  const Centre centre = centre_from_radius(ends, block.words.length('R').value(), sense);
  if (!centre && is_semicircle(block, ends)) return ends.middle();
  if (!centre) {
    block.alarm(AlarmClass::arc_radius, "HNC-COM-01"_clause, 'R',
                radius_too_small(ends, block.words.length('R').value()));
  }
  return centre;
}

void refuse_zero_radius(BlockContext& block, std::string message) {
  if (!block.readings.is("hnc.arc.zero-radius=alarm"_reading)) return;
  block.alarm(AlarmClass::arc_radius, "HNC-COM-01"_clause, block.words.has('K') ? 'K' : 'I',
              std::move(message));
}

// The centre from I and K, increments from the start and true lengths. The radii at start and end
// may differ by parameter 3410.
Centre centre_by_offsets(BlockContext& block, const ArcEnds& ends) {
  const OffsetCentre arc(
      ends, Vector_2(block.words.length('K').value_or(0), block.words.length('I').value_or(0)));
  if (arc.is_point()) {
    refuse_zero_radius(block, "The radius of the arc is zero.");
    return std::nullopt;
  }
  const Number limit = most_apart(block);
  // However near its end is: no angle leads there from the centre.
  if (arc.begins_at_centre()) refuse_zero_radius(block, "The arc begins at its centre.");
  if (limit.sign() >= 0 && !arc.radii_agree(limit)) {
    block.alarm(AlarmClass::arc_end_point, "HNC-COM-05"_clause, block.words.has('K') ? 'K' : 'I',
                radii_apart(arc, axes_of(block.machine.plane), true) +
                    with_values(" {} mm is allowed.", {limit}));
    return std::nullopt;
  }
  return arc.centre;
}

}  // namespace

void run_arc(BlockContext& block, int sense) {
  const BlockWords& words = block.words;
  const bool by_radius = words.has('R');
  const bool by_centre = words.has('I') || words.has('K');
  Position to;
  const AxisSet named = commanded_end_point(block, to);
  if (named.empty() && !by_radius && !by_centre) return;
  block.need_feed();
  if (!by_radius && !by_centre) {
    block.missing("HNC-COM-01"_clause, 'R');
    return;
  }
  const ArcEnds ends(axes_of(block.machine.plane), block.machine.position, to);
  const Centre centre =
      by_radius ? centre_by_radius(block, ends, sense) : centre_by_offsets(block, ends);
  // Under hnc.arc.zero-radius = none, or hnc.arc.closed = none, there is no way to go.
  if (centre)
    block.put(block.arc_to("HNC-COM-01"_clause, named, to, geometry::pair(*centre), sense));
}

}  // namespace gonogo::reference::hnc21t
