// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modal state of an RS274/NGC machine, and what a block sees of it.
#pragma once

#include "reference/block_base.hpp"
#include "reference/rs274/codes.hpp"
#include "reference/rs274/words.hpp"

namespace gonogo::reference::rs274 {

struct Machine : MotionState {
  WordModes modes;
  int motion = kNoMotion;  // 0, 1, 2, 3; kNoMotion also after G80
  Number rotary_feed;      // F as written: degrees per minute where rotary axes move alone
};

// One block in the hands of the file that carries its code.
struct BlockContext : BlockBase {
  Machine& machine;
  const BlockWords& words;
  const BlockCodes& codes;
  Letters letters = 0;      // of the words that its codes take, but for the motion
  bool runs_arc = false;    // G2 or G3 acts in the block
  bool p_is_turns = false;  // of the arc: P is there, and no other code of the block takes it
};

// The axis words of the block as an end point; the axes that it names.
AxisSet commanded_end_point(const BlockContext& block, Position& to);

// In basic_motion.cpp and arc.cpp.
void run_dwell(BlockContext& block);
void run_traverse(BlockContext& block);
void run_straight_feed(BlockContext& block);
void run_arc(BlockContext& block, int sense);

}  // namespace gonogo::reference::rs274
