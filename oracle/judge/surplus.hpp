// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which block made the motion that departs: a motion too many belongs to the block before the one
// whose motions are due.
#pragma once

#include <cstdint>
#include <optional>

#include "oracle/judge/alignment.hpp"

namespace gonogo::oracle {

// J-CMP-12. A motion of a subject without lines, where the first of a block is due.
struct Surplus {
  Motion got;
  Motion due;
  std::uint64_t block = 0;  // before that of `due`, which made `got` if the next record shows it

  // Whether it ends where the motion that is due does, along the axes that this one names.
  bool is_shown_by(const Record& next, const Tolerances& tolerances) const;
};

// Nothing where the motion may be a wrong one of the block that is due: it leads towards the end of
// the due motion, or goes on from a piece of it.
std::optional<Surplus> surplus_of(const Refutation& refutation, const ReferenceSteps& steps,
                                  const Tolerances& tolerances);

}  // namespace gonogo::oracle
