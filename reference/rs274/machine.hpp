// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modal state of an RS274/NGC machine, and what a block sees of it.
#pragma once

#include "reference/block_base.hpp"
#include "reference/rs274/codes.hpp"
#include "reference/rs274/cycle_state.hpp"
#include "reference/rs274/words.hpp"

namespace gonogo::reference::rs274 {

// NGC-CYC-10: what G98 and G99 say; `unsaid` before either was given.
enum class Retract : std::uint8_t { unsaid, initial_level, r_plane };

struct Machine : MotionState {
  WordModes modes;
  int motion = kNoMotion;  // as BlockCodes has it; kNoMotion also after G80
  Number rotary_feed;      // F as written: degrees per minute where rotary axes move alone
  Retract retract = Retract::unsaid;
  int spindle = 5;  // M3, M4 or M5
  CycleState cycle;

  bool spindle_turns() const { return spindle != 5; }
};

// One block in the hands of the file that carries its code.
struct BlockContext : BlockBase {
  Machine& machine;
  const BlockWords& words;
  const BlockCodes& codes;
  Letters letters = 0;       // of the words that its codes take, but for the motion
  bool runs_motion = false;  // the motion in force acts in the block
  bool p_is_turns = false;   // of an arc: P is there, and no other code of the block takes it
};

// The axis words of the block as an end point; the axes that it names.
AxisSet commanded_end_point(const BlockContext& block, Position& to);

// In basic_motion.cpp and arc.cpp.
void run_dwell(BlockContext& block);
void run_traverse(BlockContext& block);
void run_straight_feed(BlockContext& block);
void run_arc(BlockContext& block, int sense);

// Cycles and threads, each in a file of its own.
void run_g33(BlockContext& block);
void run_g33_1(BlockContext& block);
void run_g73(BlockContext& block);
void run_g74(BlockContext& block);
void run_g76(BlockContext& block);
void run_g81(BlockContext& block);
void run_g82(BlockContext& block);
void run_g83(BlockContext& block);
void run_g84(BlockContext& block);
void run_g85(BlockContext& block);
void run_g86(BlockContext& block);
void run_g89(BlockContext& block);

}  // namespace gonogo::reference::rs274
