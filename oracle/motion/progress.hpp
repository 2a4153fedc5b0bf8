// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CYC-02: which records make progress, so that they do not count against the budget of records;
// and what a level of a pocket mills again and again.
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "oracle/motion/motion.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

// Whether a straight motion brings an axis nearer to where it is due by more than the tolerance,
// and none farther from it. As many do so as the way has tolerances.
bool comes_nearer(const Motion& motion, const Position& due, const Number& tolerance);

// Whether a motion ends within the pocket of a level, as far as that is wide along each axis.
bool ends_in_pocket(const Motion& motion, const reference::PocketLevel& level);

// The places, four tolerances wide, that a path has been to.
class VisitedPlaces {
 public:
  // Whether the path has not been here since it came to step number `step`. No more than
  // kMostPlaces of a step are new.
  bool is_new(std::size_t step, const Position& at, const Number& tolerance);

 private:
  std::size_t step_ = 0;
  std::unordered_set<std::uint64_t> places_;
};

// J-CYC-02: how far apart rings count as two where the step, or the tool's radius, is the given
// one.
Number ring_width(const Number& step, const Number& tolerance);

inline constexpr std::string_view kMilledTooOften =
    "The tool goes over the same place of a level more than ten times.";

// How often the cuts of a level make one motion, and how many turns they make on one ring.
class MilledAgain {
 public:
  // Motions and rings no farther apart than `width` are one, mm.
  explicit MilledAgain(const Number& width);

  // Counts the cut. False when it makes one motion, or a turn on one ring, once too often.
  bool allows(const Motion& cut);
  // A new level begins.
  void clear() { times_.clear(); }

 private:
  double width_;
  std::unordered_map<std::uint64_t, double> times_;  // by places, as they hash
};

// R8, measure: how far the tool goes in a level, along both axes of its plane together.
class MilledWay {
 public:
  // `most`: ten times the way that the clause needs, mm.
  explicit MilledWay(double most) : most_(most) {}

  // Adds the motion. False where the way is longer than the most.
  bool allows(const Motion& motion, const reference::PlaneAxes& axes);

 private:
  double most_;
  double way_ = 0;
};

}  // namespace gonogo::oracle
