// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/cutting_cycle.hpp"

#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>

namespace gonogo::reference::gsk988ta {

void refuse_other_axes(BlockContext& block, const CuttingAxes& axes, ClauseId clause) {
  for (const AxisAddresses& addresses : kAxisAddresses) {
    if (addresses.axis == axes.positioning || addresses.axis == axes.cutting) continue;
    for (char address : {addresses.absolute, addresses.increment}) {
      if (!block.words.has(address)) continue;
      block.alarm(
          AlarmClass::axis_not_in_plane, clause, address,
          fmt::format("{} is no axis of plane G{}.", address, plane_code(block.machine.plane)));
    }
  }
}

// GSK-G94-06, GSK-G90-06, GSK-G92-06
void retain_cut_words(BlockContext& block, const CuttingAxes& axes) {
  RetainedCut& retained = block.machine.cut;
  for (Axis axis : {axes.positioning, axes.cutting}) {
    if (auto word = block.words.axis_word(axis)) retained.end_point[index(axis)] = word;
  }
  if (auto taper = block.words.length('R')) {
    retained.taper = *taper;
  } else if (is_cutting_cycle(block.codes.motion) && !block.entered_cut &&
             block.readings.is("gsk.g94.rewrite=clear"_reading)) {
    retained.taper = 0;
  }
}

bool runs_cut(const BlockContext& block, const CuttingAxes& axes) {
  if (block.words.has_axis_word(axes.positioning) || block.words.has_axis_word(axes.cutting) ||
      block.words.has('R')) {
    return true;
  }
  return !block.entered_cut && !block.machine.cut.empty() &&
         block.readings.is("gsk.g94.empty-block=repeat"_reading);
}

// GSK-MOD-07: a retained increment is taken from A again; a retained word of an axis that is not in
// the plane waits.
Number cut_end_point(const BlockContext& block, Axis axis) {
  const Number& start = block.machine.position[axis];
  const std::optional<AxisWord>& word = block.machine.cut.end_point[index(axis)];
  if (!word) return start;
  return word->incremental ? start + word->value : word->value;
}

void name_corners(const BlockContext& block, const CuttingAxes& axes,
                  const std::array<Number, 2>& c) {
  if (!block.out.notes_places) return;
  const PlaneAxes plane = axes_of(block.machine.plane);
  Position end = block.machine.position;
  end[plane.p] = c[0];
  end[plane.q] = c[1];
  block.name_corners(axes.positioning, axes.cutting, block.machine.cut.taper, end);
  block.out.name_axis(axes.positioning == plane.p ? 'p' : 'q', axes.positioning);
}

void check_taper(BlockContext& block, const Number& travel, ClauseId clause,
                 std::optional<ReadingAlternative> refused_by) {
  const Number& taper = block.machine.cut.taper;
  if (decided(clause, "R * travel", taper.sign() * travel.sign()) >= 0) return;
  if (decided(clause, "abs(R) - abs(travel)", abs(taper), abs(travel)) <= 0) return;
  if (refused_by && !block.readings.is(*refused_by)) return;
  block.alarm(AlarmClass::taper_limit, clause, 'R',
              with_values("The taper R of {} mm is larger than the opposite travel of {} mm.",
                          {taper, travel}));
}

}  // namespace gonogo::reference::gsk988ta
