// SPDX-License-Identifier: GPL-3.0-or-later
// G83 and G73: pecks, counted in whole counts.
#include <algorithm>

#include "expanders/ngc/cycle.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr Fixed kHundredth = kOne / 100;
constexpr Fixed kEndless = 1'000'000'000;
constexpr Fixed kMostSummed = 1'000'000;  // a sum of more takes too long
constexpr Fixed kQuarter = kOne / 4;

/// Peck k of all but the last ends at top - k * infeed.
struct Pecks {
  Fixed count;
  Fixed infeed;
  Fixed top;
  Fixed bottom;
};

// The least n with n * infeed >= depth, at least 1 (NGC-G83-01).
Fixed count_of(Fixed depth, Fixed infeed) {
  const Fixed whole = depth / infeed;
  return std::max<Fixed>(1, whole + (depth % infeed != 0 ? 1 : 0));
}

// The same by a sum of binary64 numbers, which may end just short of the depth.
Fixed count_by_sum(Fixed top, Fixed bottom, Fixed infeed) {
  constexpr auto kScale = static_cast<double>(kOne);
  const double step = static_cast<double>(infeed) / kScale;
  const double end = static_cast<double>(bottom) / kScale;
  Fixed count = 1;
  for (double level = static_cast<double>(top) / kScale - step; level > end; level -= step) {
    ++count;
  }
  return count;
}

// What the planted faults make of them.
void spoil(const Machine& machine, const Cycle& cycle, Pecks& pecks) {
  const Fixed depth = pecks.top - pecks.bottom;
  const Fixed rest = depth % pecks.infeed;
  Fixed& count = pecks.count;
  count = machine.alters("g83-without-pecks"_fault, count, 1);
  count = machine.alters("empty-last-peck"_fault, count, count + (rest == 0 && depth > 0 ? 1 : 0));
  if (count < kMostSummed && machine.has("peck-binary-sum"_fault)) {
    count = machine.alters("peck-binary-sum"_fault, count,
                           count_by_sum(pecks.top, pecks.bottom, pecks.infeed));
  }
  const bool endless = pecks.infeed < kHundredth && depth > 0;
  count = machine.alters("endless-pecks"_fault, count, endless ? kEndless : count);
  if (rest != 0 && count > 1 && machine.adds("remainder-dropped"_fault)) {
    pecks.bottom += rest;
    --count;
  }
  const Fixed whole = pecks.top - count * pecks.infeed;
  pecks.bottom =
      machine.alters("last-peck-whole"_fault, pecks.bottom, std::min(whole, cycle.bottom));
  pecks.infeed = machine.alters("equal-pecks"_fault, pecks.infeed,
                                static_cast<Fixed>(scaled(depth, 1, count)));
}

Pecks pecks_of(const Machine& machine, const Cycle& cycle) {
  const Fixed top = machine.alters("pecks-from-clear-level"_fault, cycle.r, cycle.clear);
  Pecks pecks{count_of(top - cycle.bottom, cycle.infeed), cycle.infeed, top, cycle.bottom};
  spoil(machine, cycle, pecks);
  return pecks;
}

// Between two pecks: out, and back to the clearance above `bottom`, the end of the last one.
bool withdraw(const Hole& hole, Fixed bottom) {
  Machine& machine = hole.machine;
  const Cycle& cycle = hole.cycle;
  const Fixed clearance = machine.alters("return-without-clearance"_fault, cycle.clearance, 0);
  Fixed back = bottom + clearance;  // NGC-G83-05, NGC-G73-04: also above R
  back = machine.alters("return-not-above-r"_fault, back, std::min(back, cycle.r));
  const bool chip_breaking = cycle.code == Motion::kG73;
  if (machine.alters("g73-full-retract"_fault, !chip_breaking, true)) {
    const bool to_clear = !chip_breaking && machine.follows("ngc.g83.retract=clear"_reading);
    if (!hole.rapid(to_clear ? cycle.clear : cycle.r)) return false;  // NGC-G83-02
    if (!chip_breaking && machine.follows("ngc.g83.return=feed"_reading)) return true;
  }
  return hole.rapid(back);  // NGC-G83-03, NGC-G73-01
}

}  // namespace

bool peck(const Hole& hole) {
  Machine& machine = hole.machine;
  const Cycle& cycle = hole.cycle;
  const Fixed pause = machine.follows("ngc.peck.dwell=quarter"_reading) ? kQuarter : 0;
  const Pecks pecks = pecks_of(machine, cycle);
  for (Fixed n = 1; n < pecks.count; ++n) {
    const Fixed bottom = std::max(pecks.top - n * pecks.infeed, pecks.bottom);
    if (!hole.feed(bottom) || !machine.tracer.dwell(pause) || !withdraw(hole, bottom)) return false;
  }
  if (!hole.feed(pecks.bottom) || !machine.tracer.dwell(pause)) return false;
  if (cycle.code == Motion::kG83) return hole.rapid(cycle.clear);  // NGC-G83-06
  // NGC-G73-02
  const bool on_clear = machine.follows("ngc.g73.end=clear"_reading);
  const bool on_r = machine.follows("ngc.g73.end=r-plane"_reading);
  return (on_clear || hole.rapid(cycle.r)) && (on_r || hole.rapid(cycle.clear));
}

}  // namespace gonogo::expanders::ngc
