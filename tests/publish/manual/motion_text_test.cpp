// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/manual/motion_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "publish/manual/example_run.hpp"

namespace gonogo::oracle::manual {
namespace {

using Texts = std::vector<std::string>;

Texts motions_of(std::string_view program) {
  Texts texts;
  for (const ExampleStep& step : try_program(example_profile("rs274", ""), program).steps) {
    if (step.moves) texts.push_back(step.text);
  }
  return texts;
}

// docs/protocol.md: f is the speed along the path, or that of a rotary axis that moves alone. X0 of
// the second block is where the machine stands; in the third X moves, and F counts millimetres.
TEST(MotionText, the_feed_of_a_rotary_axis_that_moves_alone_is_in_degrees) {
  EXPECT_EQ(motions_of("G20 G94\nG1 A90 F360\nG21\nG1 X0 A180 F360\nG1 X1 A0\nG1 X2\nM2\n"),
            (Texts{"feed to A90, 360 degrees/min", "feed to X0 A180, 360 degrees/min",
                   "feed to X1 A0, 360 mm/min", "feed to X2, 360 mm/min"}));
}

// 10 mm and 90 degrees at F0.5.
TEST(MotionText, a_feed_of_a_revolution_is_one_in_both_units) {
  EXPECT_EQ(motions_of("G95 S100 M3\nG1 X10 F0.5\nG1 C90\nM2\n"),
            (Texts{"feed to X10, 0.5 mm/rev", "feed to C90, 0.5 degrees/rev"}));
}

// A record that is not shown moves the machine as well.
TEST(MotionText, counts_records_that_are_passed_over) {
  reference::Record there;
  there.kind = reference::RecordKind::feed;
  there.axes = {reference::Axis::x};
  there.to[reference::Axis::x] = 5;
  there.feed = 100;
  reference::Record turn = there;
  turn.axes.add(reference::Axis::a);
  turn.to[reference::Axis::a] = 90;
  MotionTexts whole{reference::Position{}};
  EXPECT_EQ(whole.next(turn), "feed to X5 A90, 100 mm/min");
  MotionTexts part{reference::Position{}};
  part.pass(there);
  EXPECT_EQ(part.next(turn), "feed to X5 A90, 100 degrees/min");
}

}  // namespace
}  // namespace gonogo::oracle::manual
