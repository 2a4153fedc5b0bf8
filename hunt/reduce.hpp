// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest exhibit that still shows the same: fewer programs before it, fewer blocks, fewer
// words, shorter numbers, fewer settings of the machine.
#pragma once

#include <chrono>
#include <functional>

#include "hunt/specimen.hpp"

namespace gonogo::hunt {

// Whether an exhibit still shows what is to be kept.
using StillShows = std::function<bool(const Exhibit&)>;

struct ReduceLimits {
  std::size_t runs = 2'000;
  std::chrono::milliseconds time{30'000};
  // What no path is right for shows nothing of a subject that is held against the reference.
  bool needs_right_path = true;
};

struct Reduced {
  Exhibit exhibit;
  std::size_t runs = 0;   // calls of `shows`; never more than allowed
  bool finished = false;  // nothing smaller was found, rather than a limit reached
};

// REQUIRES: shows(exhibit). The same exhibit and answers give the same result, unless the time
// ends.
Reduced reduce(Exhibit exhibit, const StillShows& shows, const ReduceLimits& limits);

}  // namespace gonogo::hunt
