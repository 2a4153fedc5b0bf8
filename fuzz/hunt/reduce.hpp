// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest reproducer that still shows the same: fewer programs before it, fewer blocks, fewer
// words, shorter numbers, fewer settings of the machine.
#pragma once

#include <chrono>
#include <functional>

#include "fuzz/hunt/specimen.hpp"

namespace gonogo::hunt {

// Whether a reproducer still shows what is to be kept.
using StillShows = std::function<bool(const Reproducer&)>;

struct ReduceLimits {
  std::size_t runs = 2'000;
  std::chrono::milliseconds time{30'000};
  // A program for which no path is right shows nothing about a judged subject.
  bool needs_right_path = true;
};

struct Reduced {
  Reproducer reproducer;
  std::size_t runs = 0;   // calls of `shows`; never more than allowed
  bool finished = false;  // nothing smaller was found, rather than a limit reached
};

// REQUIRES: shows(reproducer). The same reproducer and answers give the same result, unless the
// time ends.
Reduced reduce(Reproducer reproducer, const StillShows& shows, const ReduceLimits& limits);

}  // namespace gonogo::hunt
