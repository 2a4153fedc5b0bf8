// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge takes a motion that is the reference's own without looking further. That is right only
// if Curve, which has the rules, says of every such motion that it is the whole of it.
#include <gtest/gtest.h>

#include "oracle/motion/curve.hpp"
#include "tests/trials.hpp"

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;

Number any_length(Chance& chance) {
  const auto count = static_cast<std::int64_t>(chance.below(200'001)) - 100'000;
  return Number::millionths(count * chance.one_of(std::to_array<std::int64_t>({1, 1000, 10'000})));
}

// A line, a traverse or an arc: also a helix, a full circle, several turns, one whose radii differ,
// one that is too small to see.
Motion any_motion(Chance& chance) {
  Motion motion;
  Record& record = motion.record;
  record.kind = chance.one_of(
      std::to_array({RecordKind::rapid, RecordKind::feed, RecordKind::arc, RecordKind::arc}));
  record.feed = any_length(chance);
  for (const Axis axis : kAllAxes) {
    motion.from[axis] = any_length(chance);
    record.to[axis] = chance.once_in(2) ? motion.from[axis] : any_length(chance);
  }
  record.plane = chance.one_of(
      std::to_array({reference::Plane::g17, reference::Plane::g18, reference::Plane::g19}));
  record.rot = chance.one_of(std::to_array({-3, -2, -1, 1, 2, 3}));
  record.centre = {any_length(chance), any_length(chance)};
  return motion;
}

TEST(EqualMotion, IsTheWholeOfTheReferencesByTheRulesOfTheMatch) {
  Tolerances tolerances;
  tolerances.tolerance = Number::millionths(1000);
  each_trial(20'000, [&](Chance& chance) {
    const Motion motion = any_motion(chance);
    const CurveAnswer answer = Curve(motion, tolerances).follow({}, motion);
    std::string text;
    append_json(motion.record, text);
    ASSERT_EQ(answer.departure, Departure::none) << text << ": " << answer.reason;
    ASSERT_TRUE(answer.ways.front().done) << text;
  });
}

}  // namespace
}  // namespace gonogo::oracle
