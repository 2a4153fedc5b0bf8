// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/progress.hpp"

#include <cmath>

namespace gonogo::oracle {

using reference::Axis;

bool comes_nearer(const Motion& motion, const Position& due, const Number& tolerance) {
  bool nearer = false;
  for (const Axis axis : reference::kAllAxes) {
    const Number before = exact::abs(due[axis] - motion.from[axis]);
    const Number after = exact::abs(due[axis] - motion.to()[axis]);
    if (after > before + tolerance) return false;
    nearer = nearer || after + tolerance < before;
  }
  return nearer;
}

bool ends_in_pocket(const Motion& motion, const reference::PocketLevel& level) {
  const reference::PlaneAxes axes = reference::axes_of(level.plane);
  return exact::abs(motion.to()[axes.p] - level.centre[0]) <= level.pocket_radius &&
         exact::abs(motion.to()[axes.q] - level.centre[1]) <= level.pocket_radius;
}

bool VisitedPlaces::is_new(std::size_t step, const Position& at, const Number& tolerance) {
  if (step != step_) {
    step_ = step;
    places_.clear();
  }
  if (places_.size() >= kMaximumPlaces) return false;
  // Estimates: a place that is taken for another costs a record of the budget, no more.
  const double width = 4 * estimate(tolerance);
  std::uint64_t key = 0;
  for (const Axis axis : reference::kAllAxes) {
    constexpr std::uint64_t kPrime = 0x100000001B3;  // of the hash FNV-1a
    const auto cell = static_cast<std::int64_t>(std::floor(estimate(at[axis]) / width));
    key = (key ^ static_cast<std::uint64_t>(cell)) * kPrime;
    key ^= key >> 29U;
  }
  return places_.insert(key).second;
}

}  // namespace gonogo::oracle
