// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motion in step with the spindle: what G33 and G33.1 share.
#pragma once

#include "reference/rs274/machine.hpp"

namespace gonogo::reference::rs274 {

// The motion of a block, which has to be made yet.
struct SynchronousMotion {
  AxisSet named;
  Position to;
  Number path_lead;

  bool moves_from(const Position& at) const { return to != at; }
};

// NGC-G33-01 to NGC-G33-06. Nothing where the rules are broken, or the program is not read from
// here on. `code`: as it is quoted.
std::optional<SynchronousMotion> synchronous_motion(BlockContext& block, std::string_view code);

// The record from where the machine stands; it moves it.
Record thread_to(BlockContext& block, ClauseId clause, const SynchronousMotion& motion);

}  // namespace gonogo::reference::rs274
