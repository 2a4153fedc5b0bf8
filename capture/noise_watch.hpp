// SPDX-License-Identifier: GPL-3.0-or-later
//
// The noise of samples: how far they scatter where the machine stands still or moves at a
// constant speed, and how far it stays away from the path there. Estimates for people and for the
// question whether a tolerance can be judged at all; no verdict of GO depends on them.
//
// A straight uniform motion is laid through each axis of sixteen samples at a time. What is left
// over is noise where it changes sign as noise does (the squares of its differences sum to more
// than its own squares); what is left over of an acceleration or an arc does not. Of those sets, at
// rest and moving apart, the ones count whose scatter is at most twice that of the lower quartile.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "capture/sample_point.hpp"

namespace gonogo::oracle {

struct NoiseFigures {
  double noise = 0;      // mm, the most of sixteen on an axis, as a rule; 0: none was seen
  double following = 0;  // mm, from the path, for sixteen samples on end of a constant speed
};

class NoiseWatch {
 public:
  // `off`: how far from the path, mm.
  void add(const SamplePoint& sample, double time, double off);
  NoiseFigures figures() const;

 private:
  static constexpr std::size_t kSet = 16;
  struct Set {
    float scatter;
    float least_off;
    bool moving;
  };
  void close();
  std::array<std::array<double, reference::kAxes>, kSet> at_{};
  std::array<double, kSet> times_{};
  double least_off_ = 0;
  std::size_t filled_ = 0;
  std::vector<Set> sets_;
};

}  // namespace gonogo::oracle
