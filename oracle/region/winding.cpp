// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/winding.hpp"

#include <cmath>
#include <numbers>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

// A ring that closes goes back by a whole turn; a link straight across the middle, or
// an arc beside it, by no more than half of one.
constexpr double kMostBack = kQuarterTurn * 6 * std::numbers::pi;

struct Place {
  double x, y;
};

Place place(const PlanePoint& point) {
  const IntervalVector enclosed = enclose(point);
  return {median(enclosed.x()), median(enclosed.y())};
}

double distance(const Place& a, const Place& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

Winding::Winding(const PlanePoint& middle, int sense, const Number& longest, const Number& blur)
    : middle_(middle),
      sense_(sense),
      longest_(enclose(longest).sup()),
      blur_(enclose(blur).sup()) {}

// Counted along the sense. The angle between the ends of an arc is the one that it turns by where
// its circle goes round the middle (of several turns one says enough: nothing is left to go back),
// and the smaller one where it does not.
double Winding::angle_of(const LevelMotion& motion) const {
  constexpr double kTurn = std::numbers::pi * 2;
  const Place a = place(motion.from - middle_);
  const Place b = place(motion.to - middle_);
  if (std::hypot(a.x, a.y) <= blur_ || std::hypot(b.x, b.y) <= blur_) return 0;
  const double angle = sense_ * std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  if (motion.is_arc && motion.rot != 0) {
    const Place c = place(motion.centre - middle_);
    const bool goes_round = std::hypot(c.x, c.y) < std::max(distance(a, c), distance(b, c)) + blur_;
    return goes_round && (angle <= 0 || whole_turns(motion.rot) > 0) ? angle + kTurn : angle;
  }
  const bool travels = distance(a, b) > longest_ || std::fabs(angle) > kTurn * kQuarterTurn / 2;
  return travels ? std::max(0.0, angle) : angle;
}

Against Winding::add(const LevelMotion& motion) {
  back_ = std::max(0.0, back_ - angle_of(motion));
  if (back_ > kMostBack + kEstimate) return Against::yes;
  return back_ > kMostBack - kEstimate ? Against::undecided : Against::no;
}

}  // namespace gonogo::oracle::region
