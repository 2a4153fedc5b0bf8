// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether motions of a subject make up one motion of the expectation.
#pragma once

#include <vector>

#include "checker/match.hpp"
#include "checker/path.hpp"

namespace gonogo::checker {

// How far the subject's motion brings the expected one.
enum class Step { done, part, departs, undecided };

struct StepAnswer {
  Step step = Step::done;
  std::string why;
};

// Follows one expected motion.
class MotionMatch {
 public:
  // Both must outlive it.
  MotionMatch(const Motion& want, const Tolerances& tolerances);
  // The next motion of the subject.
  StepAnswer take(const Motion& got);

 private:
  // Where along a line a point may be: t from 0 to 1 with every lower <= t <= every upper bound.
  struct Bounds {
    std::vector<Real> lower{Real(0)};
    std::vector<Real> upper{Real(1)};
  };
  StepAnswer check_words(const Motion& got) const;
  StepAnswer take_rapid(const Motion& got);
  StepAnswer take_line(const Motion& got);
  Truth bounds_of(const Position& point, Bounds& bounds) const;
  Truth goes_back(const Bounds& bounds) const;
  StepAnswer take_arc(const Motion& got);
  StepAnswer arc_so_far(const Motion& so_far) const;
  StepAnswer part_of_arc(const Motion& so_far) const;
  StepAnswer take_arc3(const Motion& got) const;
  StepAnswer answer(Truth done, const std::string& what) const;

  const Motion& want_;
  const Tolerances& tolerances_;
  Position ahead_;               // of a traverse: the farthest so far of each axis, from its end
  std::vector<Real> passed_;     // of a line: lower bounds of the points so far
  std::optional<Motion> piece_;  // of an arc: what the subject has done of it
};

// R3. Feeds, and leads, which are lengths: equal, or no farther off than rounding as
// declared makes them.
Truth feed_agrees(const Real& want, const Real& got, const Tolerances& tolerances);
Truth lead_agrees(const Real& want, const Real& got, const Tolerances& tolerances);
Truth angle_agrees(const Real& want, const Real& got, const Tolerances& tolerances);
// sqrt(x) <= sqrt(y) + t, for x, y, t not negative.
Truth root_at_most(const Real& x, const Real& y, const Real& t);

}  // namespace gonogo::checker
