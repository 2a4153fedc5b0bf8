// SPDX-License-Identifier: GPL-3.0-or-later
//
// G94, the radial cutting cycle: face and taper. From A, where the tool stands, to B, C, D and
// back.
#include <fmt/format.h>

#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// GSK-G94-08: neither the third axis of the plane nor any other may be commanded.
void refuse_axes_outside_plane(BlockContext& block, const PlaneAxes& axes) {
  for (const AxisAddresses& addresses : kAxisAddresses) {
    if (addresses.axis == axes.p || addresses.axis == axes.q) continue;
    for (char address : {addresses.absolute, addresses.increment}) {
      if (!block.words.has(address)) continue;
      block.alarm(
          AlarmClass::axis_not_in_plane, "GSK-G94-08"_clause, address,
          fmt::format("{} is no axis of plane G{}.", address, plane_code(block.machine.plane)));
    }
  }
}

// GSK-G94-06: words of this block replace the retained ones.
void retain_words(BlockContext& block, const PlaneAxes& axes) {
  RetainedG94& retained = block.machine.g94;
  for (Axis axis : {axes.p, axes.q}) {
    if (auto word = block.words.axis_word(axis)) retained.end_point[index(axis)] = word;
  }
  if (auto taper = block.words.length('R')) {
    retained.taper = *taper;
  } else if (block.codes.motion == 94 && !block.entered_g94 &&
             block.readings.is(ReadingKey::g94_rewrite, "clear")) {
    retained.taper = 0;
  }
}

// C along one axis: absolute, an increment from A (GSK-MOD-07), or no travel (GSK-G94-12).
Number end_point(const BlockContext& block, Axis axis) {
  const Number& start = block.machine.position[axis];
  const std::optional<AxisWord>& word = block.machine.g94.end_point[index(axis)];
  if (!word) return start;
  return word->incremental ? start + word->value : word->value;
}

}  // namespace

void run_g94(BlockContext& block) {
  const PlaneAxes axes = axes_of(block.machine.plane);  // GSK-G94-01
  refuse_axes_outside_plane(block, axes);
  retain_words(block, axes);
  // GSK-G94-12: a cycle runs where the block has an axis word or R.
  const bool named = block.words.has_axis_word(axes.p) || block.words.has_axis_word(axes.q) ||
                     block.words.has('R');
  const bool repeats = !block.entered_g94 && !block.machine.g94.empty() && !named &&
                       block.readings.is(ReadingKey::g94_empty_block, "repeat");
  if (!named && !repeats) return;

  const Position a = block.machine.position;
  const Number c_p = end_point(block, axes.p);
  const Number c_q = end_point(block, axes.q);
  const Number& taper = block.machine.g94.taper;  // GSK-G94-11: a true length, like the travel
  const Number travel = c_p - a[axes.p];
  if (taper.sign() * travel.sign() < 0 && abs(taper) > abs(travel)) {
    block.alarm(
        AlarmClass::taper_limit, "GSK-G94-09"_clause, 'R',
        fmt::format("R {} is larger than the opposite travel {}.", taper.text(), travel.text()));
  }
  block.need_feed();

  // GSK-G94-10: all motions are those of this block.
  block.rapid("GSK-G94-02"_clause, {{axes.p, c_p + taper}});
  block.feed("GSK-G94-03"_clause, {{axes.p, c_p}, {axes.q, c_q}});
  block.feed("GSK-G94-04"_clause, {{axes.p, a[axes.p]}});
  block.rapid("GSK-G94-05"_clause, {{axes.q, a[axes.q]}});
}

}  // namespace gonogo::reference::gsk988ta
