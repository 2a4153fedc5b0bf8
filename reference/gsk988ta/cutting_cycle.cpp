// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/cutting_cycle.hpp"

#include "reference/compared.hpp"
#include "reference/gsk988ta/descriptor.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonogo::reference::gsk988ta {
namespace {

// GSK-G94-08: whether the word of the axis leads to where it stands. REQUIRES: the block has one.
bool stands_still(const BlockContext& block, Axis axis) {
  const AxisWord word = block.words.axis_word(axis).value();
  const Number way = word.incremental ? word.value : word.value - block.machine.position[axis];
  return way.try_sign() == 0;
}

// GSK-G94-06: what the block does not give although it has the code in force again.
void take_code_again(BlockContext& block) {
  RetainedCut& retained = block.machine.cut;
  const bool lacks_taper = retained.taper.sign() != 0 && !block.words.has('R');
  const bool lacks_axis = std::ranges::any_of(kLinearAxes, [&](Axis axis) {
    return retained.end_point[index(axis)].has_value() && !block.words.has_axis_word(axis);
  });
  if (!lacks_taper && !lacks_axis) return;
  if (block.readings.is("gsk.g94.rewrite=clear-all"_reading)) return retained.clear();
  if (lacks_taper && block.readings.is("gsk.g94.rewrite=clear"_reading)) retained.taper = 0;
}

// Whether the block has the code of the cycle, or a word of it: a spindle or a tool has none.
bool speaks_of_cut(const BlockContext& block) {
  if (block.codes.motion >= 0) return true;
  const Code& code = *block.code_in_force();
  return std::ranges::any_of(block.words.block().words, [&](const grammar::Word& word) {
    const bool is_axis = (table::kAxisLetters & letter_bit(word.address)) != 0;
    return word.address == 'F' || (code.takes(word.address) && !is_axis);
  });
}

}  // namespace

void carry_cut(Machine& machine, const ReadingsInUse& readings, bool units_change) {
  RetainedCut& cut = machine.cut;
  if (cut.empty()) return;
  if (readings.is("gsk.retained=clear"_reading)) return cut.clear();
  if (readings.is("gsk.retained=in-plane"_reading)) {
    cut.end_point[index(axes_of(machine.plane).d)].reset();
  }
  if (!units_change || !readings.is("gsk.retained=number"_reading)) return;
  const Number factor = machine.units == Units::inch ? inches(1) : Number(1) / inches(1);
  for (std::optional<AxisWord>& word : cut.end_point) {
    if (word) word->value = word->value * factor;
  }
  cut.taper = cut.taper * factor;
}

void refuse_other_axes(BlockContext& block, const CuttingAxes& axes, ClauseId clause) {
  for (const AxisAddresses& addresses : kAxisAddresses) {
    if (addresses.axis == axes.positioning || addresses.axis == axes.cutting) continue;
    if (!block.words.has_axis_word(addresses.axis)) continue;
    if (stands_still(block, addresses.axis) &&
        block.readings.is("gsk.g94.still-axis=ignored"_reading)) {
      continue;
    }
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
  if (is_cutting_cycle(block.codes.motion) && !block.entered_cut) take_code_again(block);
  RetainedCut& retained = block.machine.cut;
  for (Axis axis : {axes.positioning, axes.cutting}) {
    if (auto word = block.words.axis_word(axis)) retained.end_point[index(axis)] = word;
  }
  if (auto taper = block.words.length('R')) retained.taper = *taper;
}

// GSK-G94-12, GSK-G90-12, GSK-G92-12
bool runs_cut(const BlockContext& block, const CuttingAxes& axes) {
  return block.words.has_axis_word(axes.positioning) || block.words.has_axis_word(axes.cutting) ||
         block.words.has('R') ||
         (!block.entered_cut && !block.machine.cut.empty() && speaks_of_cut(block) &&
          block.readings.is("gsk.g94.empty-block=repeat"_reading));
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
