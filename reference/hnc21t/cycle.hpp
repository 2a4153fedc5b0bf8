// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the cycles G74, G75 and G80 to G82 have in common: the words that they retain and the
// programmed end point. A is where the tool stands, C the end point.
#pragma once

#include <span>

#include "reference/hnc21t/machine.hpp"

namespace gonogo::reference::hnc21t {

// HNC-MOD-01: another motion code, or the one in force as a command of its own, takes the place of
// the command.
void change_command(Machine& machine, int motion);
// HNC-MOD-05: the units have changed; what retained lengths are in the new ones is a reading.
void carry_lengths(Machine& machine, const ReadingsInUse& readings);
// HNC-MOD-01: words of this block replace the retained ones.
void take_command_words(BlockContext& block);
// HNC-MOD-03: whether the block lacks an axis that the cycle needs, and so does nothing, as one
// without any axis word does.
bool does_nothing(const BlockContext& block, std::span<const AxisAddresses> needed);
// HNC-MOD-03: C along an axis that the cycle needs; an alarm and nothing where it is missing.
std::optional<Number> cycle_end_point(BlockContext& block, const AxisAddresses& axis);
// Both axes of it.
struct EndPoint {
  Number x;
  Number z;
  // With the other axes of a position.
  Position over(Position at) const {
    at[Axis::x] = x;
    at[Axis::z] = z;
    return at;
  }
};
std::optional<EndPoint> cycle_end_point(BlockContext& block);

// A motion along one axis by a cycle that yields its motions one at a time.
struct CycleMotions {
  std::uint64_t block = 0;
  Number feed_in_force;
  FeedMode feed_mode = FeedMode::per_minute;

  explicit CycleMotions(const BlockContext& context)
      : block(context.line),
        feed_in_force(context.machine.feed),
        feed_mode(context.machine.feed_mode) {}
  Record rapid(ClauseId clause, Axis axis, const Number& to) const;
  Record feed(ClauseId clause, Axis axis, const Number& to) const;
};

}  // namespace gonogo::reference::hnc21t
