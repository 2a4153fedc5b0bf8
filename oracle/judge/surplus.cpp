// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/surplus.hpp"

#include <algorithm>

#include "oracle/motion/places.hpp"
#include "oracle/motion/progress.hpp"

namespace gonogo::oracle {

bool Surplus::is_shown_by(const Record& next, const Tolerances& tolerances) const try {
  const Motion motion = motion_from(got.to(), next, got.number + 1);
  return next.kind == due.record.kind && std::ranges::all_of(reference::kAllAxes, [&](Axis axis) {
           return !due.record.axes.has(axis) ||
                  agree(motion.to()[axis], due.to()[axis], tolerances.tolerance);
         });
} catch (const exact::Undecided&) {
  return false;
}

std::optional<Surplus> surplus_of(const Refutation& refutation, const ReferenceSteps& steps,
                                  const Tolerances& tolerances) {
  const Hypothesis& from = refutation.from;
  const ReferenceSteps::Step* const step = steps.known(from.step);
  if (tolerances.compare_blocks || refutation.verdict || from.piece || step == nullptr) return {};
  const auto* const due = std::get_if<Motion>(&step->what);
  const Motion& got = *refutation.motion;
  const bool is_first = step->left_block != 0 && step->left_block < step->block;
  if (due == nullptr || !is_first || comes_nearer(got, due->to(), tolerances.tolerance)) return {};
  return Surplus{got, *due, step->left_block};
}

}  // namespace gonogo::oracle
