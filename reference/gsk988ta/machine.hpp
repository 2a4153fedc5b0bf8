// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modal state of a GSK 988TA, and what a block sees of it.
#pragma once

#include <array>
#include <optional>

#include "reference/block_base.hpp"
#include "reference/gsk988ta/codes.hpp"
#include "reference/gsk988ta/words.hpp"

namespace gonogo::reference::gsk988ta {

// What the cutting cycle in force (G90, G92, G94) retains: the end point axis by axis, and R
// (GSK-G94-06, GSK-G90-06, GSK-G92-06). True lengths in mm.
struct RetainedCut {
  std::array<std::optional<AxisWord>, 3> end_point;  // by linear axis
  Number taper;

  bool empty() const { return !end_point[0] && !end_point[1] && !end_point[2] && taper == 0; }
  void clear() { *this = {}; }
};
constexpr bool is_cutting_cycle(int motion) {
  return motion == 90 || motion == 92 || motion == 94;
}

constexpr CycleFamily family_of(int code) {
  if (code == 110 || code == 111) return CycleFamily::pocket;
  if (code == 112 || code == 113) return CycleFamily::helix;
  return code >= 114 && code <= 117 ? CycleFamily::thread : CycleFamily::none;
}
// The even codes turn clockwise.
constexpr int sense_of(int cycle_code) {
  return cycle_code % 2 == 0 ? -1 : +1;
}

// The words of a thread, of one block or retained under a reading of GSK-MOD-04. Lengths in mm.
struct ThreadWords {
  std::optional<Number> lead;            // I
  std::optional<Number> height;          // P
  std::optional<Number> infeed;          // Q
  std::optional<Number> tool;            // D
  std::optional<Number> diameter;        // E
  std::optional<Number> run_out_length;  // J
  std::optional<Number> run_out_angle;   // K, degrees
};

// What the milling cycle in force retains (GSK-G110-02, GSK-G112-01). True lengths in mm.
struct MillingMode {
  int code = 0;  // 110 to 117 while the mode is in force
  Number initial_plane;
  std::optional<Number> radius;  // I
  std::optional<Number> step;    // L of G110
  std::optional<Number> turns;   // L of G112 under the reading gsk.helix.L = modal
  std::optional<Number> infeed;  // Q
  std::optional<Number> tool;    // D
  // R and P under the reading gsk.pocket.R = modal.
  std::optional<Number> retained_r;
  std::optional<Number> retained_clearance;
  ThreadWords thread;  // the last of each in the mode

  CycleFamily family() const { return family_of(code); }
  // Those of the words that are lengths.
  std::array<std::optional<Number>*, 12> lengths() {
    return {&radius,          &step,
            &infeed,          &tool,
            &retained_r,      &retained_clearance,
            &thread.lead,     &thread.height,
            &thread.infeed,   &thread.tool,
            &thread.diameter, &thread.run_out_length};
  }
};

struct Machine : MotionState {
  Units units = Units::mm;
  bool has_feed = false;      // F was written, maybe as zero or less
  bool feed_in_inch = false;  // F was written under G20
  int motion = 0;             // group 01: 0, 1, 2, 3, 90, 92, 94
  int motion_before_cut = 0;  // the last of it that is no cutting cycle
  RetainedCut cut;
  Number thread_lead;               // F of G92, 0: none
  bool thread_run_out_off = false;  // J or K of G92 was given as 0
  MillingMode milling;
};

// One block in the hands of the file that carries its code.
struct BlockContext : BlockBase {
  Machine& machine;
  const BlockWords& words;
  const BlockCodes& codes;
  OpenPaths open_paths;
  bool entered_cycle = false;  // the mode of a milling cycle begins with this block
  bool entered_cut = false;    // G90, G92 or G94 begins with this block
  bool changed_pair = false;   // G110 to G111, G112 to G113 or back

  // GSK-COM-04, GSK-COM-08: an alarm when no feed is in force.
  void need_feed();
  // The code that it runs, except one of group 00: a milling cycle, or one of group 01. Null:
  // none.
  const Code* code_in_force() const {
    return code_of(machine.milling.code != 0 ? machine.milling.code : machine.motion);
  }
};

// GSK-COM-10, GSK-COM-12: says of the block that it runs on although it has words without effect.
void note_unused_words(const BlockContext& block);

// J-ALM-04: what else the alarms of the block may be. Of an unstated rule the catalog says it.
void admit_other_classes(const BlockContext& block);

// GSK-COM-05, in basic_motion.cpp and arc.cpp.
void run_dwell(BlockContext& block);
void run_reference_point(BlockContext& block);
void run_rename_position(BlockContext& block);
void run_positioning(BlockContext& block);
void run_straight_feed(BlockContext& block);
void run_arc(BlockContext& block, int sense);
// The axis words of the block as an end point; the axes that it names.
AxisSet commanded_end_point(const BlockContext& block, Position& to);

// The words that G110 and G112 keep in force, and that none is missing (GSK-MOD-02). `mills`: the
// block says where, so they must be above zero too.
void latch_g110(BlockContext& block, bool mills);
void latch_g112(BlockContext& block, bool mills);
// The same of G114, of whose words none need be in force.
void latch_g114(BlockContext& block);

// The cycles, one file each.
void run_g90(BlockContext& block);
void run_g92(BlockContext& block);
void run_g94(BlockContext& block);
void run_g110(BlockContext& block);
void run_g112(BlockContext& block);
void run_g114(BlockContext& block);

}  // namespace gonogo::reference::gsk988ta
