// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/hnc/plan.hpp"

namespace gonogo::expanders::hnc {

/// Place that the words of the block command, in the base frame; `axes` are those commanded.
Point commanded_point(Machine& machine, const Block& block, Axes& axes);

/// The ordinary feed.
Feed feed_in_force(const Machine& machine);

}  // namespace gonogo::expanders::hnc
