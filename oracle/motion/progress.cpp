// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

using reference::Axis;

namespace {

// A hash of places as estimates: one that is taken for another costs a record of the budget, or a
// time that a motion is made, no more.
class PlaceHash {
 public:
  explicit PlaceHash(double width) : width_(width) {}

  PlaceHash& add(double coordinate) {
    const std::uint64_t prime = 0x100000001B3;  // of the hash FNV-1a
    // Beyond what a number of a cell can be, all is one.
    const double place = std::floor(coordinate / width_);
    const bool is_near =
        std::abs(place) < static_cast<double>(std::numeric_limits<std::int64_t>::max());
    const auto cell = is_near ? static_cast<std::int64_t>(place) : std::int64_t{0};
    key_ = (key_ ^ static_cast<std::uint64_t>(cell)) * prime;
    key_ ^= key_ >> 29U;
    return *this;
  }
  PlaceHash& add(const Position& at) {
    for (const Axis axis : reference::kAllAxes) add(estimate(at[axis]));
    return *this;
  }
  std::uint64_t key() const { return key_; }

 private:
  double width_;
  std::uint64_t key_ = 0;
};

// The ring of an arc in its plane, and the turns that it makes.
struct Ring {
  double radius;
  double growth;  // of the radius, from the start to the end
  double turns;
};

Ring ring_of(const Motion& arc) {
  const PlaneVector start = from_centre(arc.record, arc.from);
  const PlaneVector end = from_centre(arc.record, arc.to());
  const double sp = estimate(start.p), sq = estimate(start.q);
  const double ep = estimate(end.p), eq = estimate(end.q);
  double part = std::atan2(sp * eq - sq * ep, sp * ep + sq * eq) / (2 * std::numbers::pi);
  if (arc.record.rot < 0) part = -part;
  if (part <= 0) part += 1;
  const double whole = std::max(std::fabs(static_cast<double>(arc.record.rot)) - 1, 0.0);
  const double from = std::hypot(sp, sq), to = std::hypot(ep, eq);
  return {(from + to) / 2, std::fabs(to - from), whole + part};
}

// How far a point of the unit circle is round from (1, 0), counterclockwise, along both axes
// together: 8 a turn.
double way_round(double p, double q) {
  for (double quarters = 0;; quarters += 2) {
    if (p > 0 && q >= 0) return quarters + 1 - p + q;
    p = std::exchange(q, -p);
  }
}

// Along both axes together; of a spiral as on its inner circle.
double way_of_arc(const Motion& arc) {
  const PlaneVector start = from_centre(arc.record, arc.from);
  const PlaneVector end = from_centre(arc.record, arc.to());
  const double sp = estimate(start.p), sq = estimate(start.q);
  const double ep = estimate(end.p), eq = estimate(end.q);
  const double from = std::hypot(sp, sq), to = std::hypot(ep, eq);
  // Beyond what a double holds nothing is estimated; the level's envelope decides.
  if (from <= 0 || to <= 0 || !std::isfinite(from) || !std::isfinite(to)) return 0;
  const int sense = arc.record.rot > 0 ? 1 : -1;
  double turned = sense * (way_round(ep / to, eq / to) - way_round(sp / from, sq / from));
  // Where the ends are as good as on one ray, the numbers say on which side.
  const bool is_whole =
      std::abs(turned) < kEstimate ? visible_sign(region::cross(start, end)) != sense : turned < 0;
  if (is_whole) turned += 8;
  const double turns = std::abs(static_cast<double>(arc.record.rot)) - 1;
  return (turned + 8 * turns) * std::min(from, to);
}

}  // namespace

bool comes_nearer(const Motion& motion, const Position& due, const Number& tolerance) {
  bool nearer = false;
  for (const Axis axis : reference::kAllAxes) {
    const Number before = exact::abs(due[axis] - motion.from[axis]);
    const Number after = exact::abs(due[axis] - motion.to()[axis]);
    if (after > before + tolerance) return false;
    nearer = nearer || after + tolerance < before;
  }
  return nearer;
}

bool is_in_pocket(const Position& at, const reference::PocketLevel& level) {
  const reference::PlaneAxes axes = reference::axes_of(level.plane);
  return exact::abs(at[axes.p] - level.centre[0]) <= level.pocket_radius &&
         exact::abs(at[axes.q] - level.centre[1]) <= level.pocket_radius;
}

// Without a tolerance a way can be cut into pieces without end.
StepProgress::StepProgress(const Number& tolerance)
    : width_(std::max(estimate(tolerance), kShort)) {}

void StepProgress::enter(std::size_t step) {
  if (step == step_) return;
  step_ = step;
  joined_ = 0;
  nearest_.reset();
  turns_ = 0;
  places_.clear();
}

StepProgress::Coordinates StepProgress::estimates(const Position& at) {
  Coordinates coordinates = {};
  for (const Axis axis : reference::kAllAxes) {
    coordinates[reference::index(axis)] = estimate(at[axis]);
  }
  return coordinates;
}

bool StepProgress::comes_nearer(const Position& at, const Position& due, std::size_t joined) {
  const bool is_another_way = !nearest_ || joined > joined_;
  if (is_another_way) due_ = estimates(due);
  Coordinates distance = estimates(at);
  for (std::size_t i = 0; i < distance.size(); ++i) distance[i] = std::abs(due_[i] - distance[i]);
  if (is_another_way) {
    joined_ = joined;
    nearest_ = distance;
    return false;
  }
  bool is_nearer = false;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (distance[i] > (*nearest_)[i] + width_) return false;
    is_nearer = is_nearer || distance[i] + width_ < (*nearest_)[i];
  }
  if (!is_nearer) return false;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (distance[i] + width_ < (*nearest_)[i]) (*nearest_)[i] = distance[i];
  }
  return true;
}

bool StepProgress::goes_round(double turns, double radius) {
  const double way = (turns - turns_) * 2 * std::numbers::pi * radius;
  if (!std::isfinite(way) || way <= kNoDirection * width_) return false;
  turns_ = turns;
  return true;
}

bool StepProgress::is_new_place(const Position& at) {
  if (places_.size() >= kMostPlaces) return false;
  const bool is_first = places_.empty();  // where the step is entered
  return places_.insert(PlaceHash(kNoDirection * width_).add(at).key()).second && !is_first;
}

Number ring_width(const Number& step, const Number& tolerance) {
  return max(tolerance, step / kRingsOfStep);
}

MilledAgain::MilledAgain(const Number& width) : width_(estimate(width)) {}

bool MilledAgain::allows(const Motion& cut) {
  PlaceHash motion = PlaceHash(width_).add(cut.from).add(cut.to());
  bool is_seen = PlaceHash(width_).add(cut.from).key() != PlaceHash(width_).add(cut.to()).key();
  if (cut.record.kind == RecordKind::arc) {
    const double p = estimate(cut.record.centre[0]), q = estimate(cut.record.centre[1]);
    const Ring ring = ring_of(cut);
    // Turns of a spiral that lie within the width of one ring.
    const double turns = ring.turns * width_ / std::max(ring.growth, width_);
    double& all = times_[PlaceHash(width_).add(p).add(q).add(ring.radius).key()];
    all += turns;
    if (all > static_cast<double>(kMostTimes) + kEstimate) return false;
    motion.add(p).add(q);
    is_seen = is_seen || ring.turns > 0.5;
  }
  return !is_seen || ++times_[motion.key()] <= static_cast<double>(kMostTimes);
}

// What an estimate finds too long by more than its error, is too long.
bool MilledWay::allows(const Motion& motion, const reference::PlaneAxes& axes) {
  const auto along = [&](Axis axis) {
    return std::abs(estimate(motion.to()[axis]) - estimate(motion.from[axis]));
  };
  const bool is_arc = motion.record.kind == RecordKind::arc;
  way_ += is_arc ? way_of_arc(motion) : along(axes.p) + along(axes.q);
  return way_ <= most_ * (1 + kEstimate);
}

}  // namespace gonogo::oracle
