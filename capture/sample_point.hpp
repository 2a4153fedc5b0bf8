// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "capture/sample_reader.hpp"
#include "oracle/motion/approximate.hpp"
#include "oracle/motion/motion.hpp"

namespace gonogo::oracle {

// A number as a double, for estimates: at once for six decimals, which samples have.
inline double quick(const Number& value) {
  constexpr double kMillion = 1e6;
  using exact::NumberAccess;
  if (NumberAccess::node(value) != nullptr) return estimate(value);
  return static_cast<double>(NumberAccess::millionths(value)) / kMillion;
}

// A sample with its coordinates as doubles, for estimates.
struct SamplePoint {
  explicit SamplePoint(const Sample& sample) : exact(sample.at) {
    for (reference::Axis axis : reference::kAllAxes) {
      near[reference::index(axis)] = quick(exact[axis]);
    }
  }
  const Position& exact;
  std::array<double, reference::kAxes> near{};
};

// How close a sample must come to the reference's path. What no arithmetic of this gauge decides
// counts against the machine (`strict`) or for it; only what holds both ways becomes a verdict.
struct Tube {
  Number tolerance;  // mm an axis
  double half = 0;   // the same
  bool strict = true;
  static constexpr double kUnsure = 1e-6;  // mm
  double sure_half() const { return strict ? half - kUnsure : half + kUnsure; }
};

}  // namespace gonogo::oracle
