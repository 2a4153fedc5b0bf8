// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the codes of offsets and of tool lengths share.
#pragma once

#include "reference/rs274/machine.hpp"

namespace gonogo::reference::rs274 {

Position sum(Position a, const Position& b);
Position difference(Position a, const Position& b);

// NGC-OFS-01: what a block put out, in coordinates of the machine; its motions begin `at`.
void move_out(const Frame& frame, const Position& at, BlockOutput& out);

// The words of the block along its axes: mm, or degrees.
template <typename Take>
void each_axis_word(const BlockContext& block, Take take) {
  for (const AxisLetter& letter : kAxisLetters) {
    if (const std::optional<Number> value = block.words.along(letter)) take(letter.axis, *value);
  }
}

// A word that has to be whole; nothing after an alarm.
std::optional<Number> whole_word(BlockContext& block, ClauseId clause, char address);

// Puts other offsets in force; nothing moves, so that the program has other coordinates.
void settle_change(Machine& machine, const Offsets& before);
template <typename Change>
void change_offsets(Machine& machine, Change change) {
  const Offsets before = machine.offsets;
  change(machine.offsets);
  settle_change(machine, before);
}

// The place that is `places` of the machine along `axes` and `from` of the program along the
// others. Where the program is turned, X and Y are both among the axes then.
Position at_machine_places(const Frame& frame, const Position& from, AxisSet& axes,
                           const Position& places);

// Where an origin has to lie, in place of `origin`, so that the position gets the coordinates of
// the block's words, in axes turned by `angle` and with the offset `shift` of G92.
Position origin_by_words(const BlockContext& block, const Position& origin, const Number& angle,
                         const Position& shift);

// NGC-OFS-17: G10 L1, L10 and L11.
void set_tool(BlockContext& block, std::int64_t what);

// Whether G43.1 or G43.2 takes the axis words.
inline bool sets_tool_length(const BlockCodes& codes) {
  return codes.tool_length == 431 || codes.tool_length == 432;
}
void take_tool_length(BlockContext& block);

}  // namespace gonogo::reference::rs274
