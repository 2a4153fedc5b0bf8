// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modal state of an RS274/NGC machine, and what a block sees of it.
#pragma once

#include "reference/block_base.hpp"
#include "reference/rs274/codes.hpp"
#include "reference/rs274/cycle_state.hpp"
#include "reference/rs274/m_functions.hpp"
#include "reference/rs274/offsets.hpp"
#include "reference/rs274/words.hpp"

namespace gonogo::reference::rs274 {

// NGC-CYC-10: what G98 and G99 say; `unsaid` before either was given.
enum class Retract : std::uint8_t { unsaid, initial_level, r_plane };

// X and Y of a place, mm.
using PlaceInXy = std::array<Number, 2>;

// NGC-POL-01: how much farther from the origin, mm, and farther round it, degrees.
struct PolarStep {
  Number distance;
  Number angle;
};

// A place to which polar words have led from another one, so that a long row of increments is as
// exact as one. REQUIRES: `base` is not the origin, or no distance is added.
struct PolarPlace {
  PlaceInXy base;
  PolarStep added;

  PlaceInXy in_xy() const;
};

// M48 to M53: what an operator may change while the program runs.
struct Overrides {
  bool feed = true;
  bool speed = true;
  bool adaptive_feed = false;
  bool feed_hold = true;
  friend bool operator==(const Overrides&, const Overrides&) = default;
};

// Its position is that of the program, from the origin that the offsets give it.
struct Machine : MotionState {
  explicit Machine(const Profile& profile) : offsets(profile) {}

  WordModes modes;
  int motion = kNoMotion;           // as BlockCodes has it; kNoMotion also after G80
  std::uint64_t motion_ended = 0;   // the line of that G80; 0: none was in force
  Number rotary_feed;               // F as written: degrees per minute where rotary axes move alone
  bool is_feed_written = false;     // F is of the program, and not of power-on
  bool is_inverse_time = false;     // NGC-FED-01: F holds for its block, and feed is 0
  bool has_surface_speed = false;   // G96
  std::optional<PolarPlace> polar;  // of the position, where polar words have led there
  Retract retract = Retract::unsaid;
  int spindle = 5;         // M3, M4 or M5
  bool has_speed = false;  // S above zero
  bool has_mist = false;
  bool has_flood = false;
  Overrides overrides;
  CycleState cycle;
  Offsets offsets;
  ToolState tool;

  bool spindle_turns() const { return spindle != 5; }
};

// One block in the hands of the file that carries its code.
struct BlockContext : BlockBase {
  Machine& machine;
  const BlockWords& words;
  const BlockCodes& codes;
  Letters letters = 0;       // of the words that its codes take, except the motion
  bool runs_motion = false;  // the motion in force acts in the block
  Position start = {};       // of its motion, once offsets have acted, where the axes are turned
  bool turns_diameters = false;          // G7 or G8 changes the mode
  bool turns_plane = false;              // G17, G18 or G19 changes the plane
  std::optional<PolarPlace> polar = {};  // where polar words lead
  bool p_is_turns = false;  // of an arc: P is there, and no other code of the block takes it
  MFunctions functions = {};
};

// The axis words of the block as an end point, under G53 of the machine (NGC-OFS-13); the axes that
// it names.
AxisSet commanded_end_point(const BlockContext& block, Position& to);

// In offsets.cpp. What the code takes of the axis words; what it puts in force before distance
// modes and motion; the code of group 0, before the motion; and its rules.
bool takes_axis_words(const BlockCodes& codes);
void take_offsets(BlockContext& block);
void run_once(BlockContext& block);
void check_once(BlockContext& block);

// In basic_motion.cpp and arc.cpp.
void run_dwell(BlockContext& block);
// What the block dwells, where that is to be seen.
std::vector<Item> dwells_of(const BlockContext& block);
void run_traverse(BlockContext& block);
void run_straight_feed(BlockContext& block);
void run_arc(BlockContext& block, int sense);

// In motion.cpp: the motion in force.
void run_motion(BlockContext& block);
// Cycles and threads, each in a file of its own except G33 (synchronous.cpp) and the taps.
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
