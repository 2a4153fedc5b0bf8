// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of every thread (GSK-G114-04, 06, 10, 11), read off the records.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

double field_or(const std::string& record, const std::string& key, double otherwise) {
  const std::size_t place = record.find(key);
  return place == std::string::npos ? otherwise : std::stod(record.substr(place + key.size()));
}

// A valid thread of at most ten passes about the origin, in G17, with the R plane at Z-1.
struct Thread {
  bool internal = *rc::gen::arbitrary<bool>();
  bool clockwise = *rc::gen::arbitrary<bool>();
  long tool = *rc::gen::inRange(1'000L, 20'000L);
  long diameter = 2 * tool + *rc::gen::inRange(1L, 50'000L);
  long height = *rc::gen::inRange(1L, tool + 1);
  long infeed = *rc::gen::inRange(std::max(1L, height / 10), 2 * height + 1);
  long lead = *rc::gen::inRange(1L, 9'000L);
  long depth = *rc::gen::inRange(1L, 30'000L);
  long run_out = height + *rc::gen::inRange(0L, 3'000L);
  long angle = *rc::gen::inRange(0L, 360'001L);

  std::string program() const {
    const int code = (internal ? 116 : 114) + (clockwise ? 0 : 1);
    return "G17 G" + std::to_string(code) + " X0 Y0 R-1 W-" + millimetres(depth) + " I" +
           millimetres(lead) + " J" + millimetres(run_out) + " K" + millimetres(angle) + " E" +
           millimetres(diameter) + " P" + millimetres(height) + " Q" + millimetres(infeed) + " D" +
           millimetres(tool) + " F100\n";
  }
  double side() const { return internal ? -1 : 1; }
  double surface() const {
    return static_cast<double>(diameter) / 2000 + side() * static_cast<double>(tool) / 1000;
  }
  long passes() const { return (height + infeed - 1) / infeed; }
  // Radius of the n-th helix.
  double radius(long pass) const {
    return surface() - side() * static_cast<double>(std::min(pass * infeed, height)) / 1000;
  }
};

// A motion with its ends filled in.
struct MotionWithEnds {
  std::string record;
  double from[3];
  double to[3];
};

std::vector<MotionWithEnds> motions_with_ends(const Outcome& outcome) {
  std::vector<MotionWithEnds> motions;
  double at[3] = {0, 0, 0};
  for (const std::string& record : outcome.records) {
    if (record.starts_with("end")) break;
    MotionWithEnds motion{record, {at[0], at[1], at[2]}, {}};
    at[0] = motion.to[0] = field_or(record, " x=", at[0]);
    at[1] = motion.to[1] = field_or(record, " y=", at[1]);
    at[2] = motion.to[2] = field_or(record, " z=", at[2]);
    motions.push_back(motion);
  }
  return motions;
}

bool is_helix(const MotionWithEnds& motion) {
  return motion.record.starts_with("arc17") && motion.from[2] != motion.to[2];
}

RC_GTEST_PROP(GskThreadProperty, HelicesHaveTheRadiusTheLeadAndTheSense, ()) {
  const Thread thread;
  long pass = 0;
  for (const MotionWithEnds& motion : motions_with_ends(run(thread.program()))) {
    if (!is_helix(motion)) continue;
    ++pass;
    RC_ASSERT(motion.record.starts_with("arc17 c=0,0 "));
    RC_ASSERT(std::abs(std::hypot(motion.from[0], motion.from[1]) - thread.radius(pass)) < kNear);
    RC_ASSERT(std::abs(std::hypot(motion.to[0], motion.to[1]) - thread.radius(pass)) < kNear);
    const long turns = (thread.depth + thread.lead - 1) / thread.lead;
    RC_ASSERT(field_or(motion.record, "rot=", 0) ==
              static_cast<double>(thread.clockwise ? -turns : turns));
    // From -p, depth / lead turns.
    const double share = static_cast<double>(thread.depth % thread.lead) /
                         static_cast<double>(thread.lead) * 2 * M_PI;
    RC_ASSERT(std::abs(motion.to[0] + thread.radius(pass) * std::cos(share)) < kNear);
    RC_ASSERT(motion.from[2] == -1.0);
    RC_ASSERT(std::abs(motion.to[2] + 1 + static_cast<double>(thread.depth) / 1000) < kNear);
  }
  RC_ASSERT(pass == thread.passes());
}

RC_GTEST_PROP(GskThreadProperty, BelowTheRPlaneOnlyHelixRunOutAndRetractMove, ()) {
  const Thread thread;
  int since_helix = 9;
  long pass = 0;
  for (const MotionWithEnds& motion : motions_with_ends(run(thread.program()))) {
    since_helix = is_helix(motion) ? 0 : since_helix + 1;
    if (is_helix(motion)) ++pass;
    const bool below = std::min(motion.from[2], motion.to[2]) < -1;
    // The helix, its run-out, and the rapid straight up.
    RC_ASSERT(below == (since_helix <= 2 && thread.run_out > 0));
    if (since_helix == 2) {
      RC_ASSERT(motion.record.starts_with("rapid z=-1"));
      const double radius = std::hypot(motion.to[0], motion.to[1]);
      // In a bore a J of more than the way to the other wall ends in it.
      const double j = static_cast<double>(thread.run_out) / 1000;
      const bool fits = j <= thread.surface() + thread.radius(pass);
      RC_ASSERT(thread.internal ? radius < thread.surface() + kNear || !fits
                                : radius > thread.surface() - kNear);
    }
  }
}

RC_GTEST_PROP(GskThreadProperty, RunOutEndsOnTheFreeSideAtTheAngle, ()) {
  const Thread thread;
  const std::vector<MotionWithEnds> motions = motions_with_ends(run(thread.program()));
  long pass = 0;
  for (std::size_t i = 0; i + 1 < motions.size(); ++i) {
    if (!is_helix(motions[i])) continue;
    ++pass;
    const double angle =
        static_cast<double>(thread.angle) / 180'000 * M_PI * (thread.clockwise ? -1 : 1);
    const double radius =
        thread.radius(pass) + thread.side() * static_cast<double>(thread.run_out) / 1000;
    const double scale = radius / thread.radius(pass);
    const double* at = motions[i].to;
    const double x = scale * (at[0] * std::cos(angle) - at[1] * std::sin(angle));
    const double y = scale * (at[0] * std::sin(angle) + at[1] * std::cos(angle));
    RC_ASSERT(std::abs(motions[i + 1].to[0] - x) < kNear * (1 + std::abs(scale)));
    RC_ASSERT(std::abs(motions[i + 1].to[1] - y) < kNear * (1 + std::abs(scale)));
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
