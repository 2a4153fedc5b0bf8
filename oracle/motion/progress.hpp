// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CYC-02: which records make progress, so that they do not count against the budget of records;
// and what a level of a pocket mills again and again.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "oracle/motion/motion.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

// Whether a straight motion brings an axis nearer to where it is due by more than the tolerance,
// and none farther from it. No more motions do so than the way has tolerances.
bool comes_nearer(const Motion& motion, const Position& due, const Number& tolerance);

// Whether a place is within the pocket of a level, as far as that is wide along each axis.
bool is_in_pocket(const Position& at, const reference::PocketLevel& level);

// How far the tool has come in a step of the reference. It comes on where it is farther than ever
// before by more than can be seen: so small motions add up, and those to and fro do not. In a step
// that happens a finite number of times. All is estimated: an error costs a record of the budget.
class StepProgress {
 public:
  explicit StepProgress(const Number& tolerance);

  // The tool is in this step from now on. Steps come in their order.
  void enter(std::size_t step);
  // On a straight way to `due`, joined with so many steps behind it: whether an axis is nearer to
  // that than it has been, and none farther.
  bool comes_nearer(const Position& at, const Position& due, std::size_t joined);
  // So many turns along an arc, at that radius: whether it has come farther round.
  bool goes_round(double turns, double radius);
  // Whether it has not been here, four tolerances wide. No more than kMostPlaces of a step are new.
  bool is_new_place(const Position& at);

 private:
  using Coordinates = std::array<double, reference::kAxes>;
  static Coordinates estimates(const Position& at);

  double width_;  // what can be seen, mm
  std::size_t step_ = 0;
  std::size_t joined_ = 0;
  Coordinates due_ = {};
  std::optional<Coordinates> nearest_;  // how near to `due_` each axis has been
  double turns_ = 0;
  std::unordered_set<std::uint64_t> places_;
};

// J-CYC-02: from which distance rings count as two, where the step or the tool's radius is the
// given one.
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
