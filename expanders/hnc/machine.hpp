// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/machine.hpp"
#include "expanders/common/plan.hpp"
#include "expanders/hnc/faults.hpp"
#include "expanders/hnc/profile.hpp"

namespace gonogo::expanders::hnc {

using Block = LetterBlock;

/// Modal code of the motion group.
enum class Motion {
  kRapid,
  kLine,
  kArcClockwise,
  kArcCounterclockwise,
  kThread,       // G32
  kDrill,        // G74
  kGroove,       // G75
  kTurn,         // G80
  kFace,         // G81
  kThreadCycle,  // G82
};

Motion motion_of(int code);

inline constexpr bool is_cycle(Motion motion) {
  return motion >= Motion::kDrill;
}
/// F and J are the lead.
inline constexpr bool is_thread(Motion motion) {
  return motion == Motion::kThread || motion == Motion::kThreadCycle;
}

/// A number that a modal word left behind.
struct Retained {
  bool present = false;
  Fixed value = 0;
};

/// What a cycle, or G32, keeps from block to block until the command changes. Lengths are true
/// millimetres, so that a later change of units does not change them.
struct CycleStore {
  Retained taper;       // I of G80 and G82, K of G81
  Retained withdrawal;  // R of G74 and G75
  Retained infeed;      // Q of G74 and G75
  Retained steps;       // I (P) of G75, a count in counts of one
  Retained run_out_z;   // R of G82
  Retained run_out_x;   // E of G82
  Retained starts;      // C of G82, in counts of one
  Retained angle;       // P of G82, degrees
  Fixed lead = 0;       // mm a revolution; 0: none in force
  Fixed feed = 0;       // own to the command (reading hnc.modal.f)
  Retained end_x;       // C of the last block that ran, base frame
  Retained end_z;
};

/// All that one block hands to the next.
struct State {
  Point position{};              // in the base frame
  const Point* frame = nullptr;  // offset of the work frame in force; null: none
  bool incremental = false;
  bool inch = false;
  bool diameter = true;
  bool per_revolution = false;
  Fixed feed = 0;  // mm a minute or a revolution; 0: none in force
  bool feed_programmed = false;
  Motion motion = Motion::kRapid;
  bool named = false;  // the block has the code of the motion
  CycleStore store;
  Motion kept_of = Motion::kRapid;  // the cycle that may take up `kept` again; no cycle: none
  CycleStore kept;
  Fixed line_lead = 0;  // the last of G32
};

/// What every code works on.
class Machine : public expanders::Machine {
 public:
  Machine(const MachineProfile& machine_profile, const gonogo_sink_v1& sink,
          Planted<Fault> planted);
  State state;
};

inline constexpr AddressSet kAxisAddresses{"XZUW"};
inline constexpr Axes kBothAxes = axis_bit(GONOGO_X) | axis_bit(GONOGO_Z);

/// The word of X or Z in a block.
struct AxisWord {
  bool present = false;
  bool incremental = false;
  char address = 0;
  Fixed value = 0;  ///< true length in mm
};

// In words.cpp. Places are in the base frame.

/// `axis`: GONOGO_X or GONOGO_Z.
AxisWord axis_word(const Machine& machine, const Block& block, std::size_t axis);
/// Place that the block commands along `axis`; the position without a word. Complains when it is
/// out of reach.
Fixed target(Machine& machine, const Block& block, std::size_t axis);
/// Place that the words of the block command; `axes` are those commanded.
Point commanded_point(Machine& machine, const Block& block, Axes& axes);
/// The length of `address` in mm; the word must be there.
Fixed length_of(const Machine& machine, const Block& block, char address);
/// Stores the length, or the bare number, of `address` when the block has it.
void take_length(const Machine& machine, const Block& block, char address, Retained& store);
void take_number(const Block& block, char address, Retained& store);
/// Rules that hold for the words of every block (HNC-COM-01).
void check_words(Machine& machine, const Block& block);
/// The ordinary feed.
Feed feed_in_force(const Machine& machine);

// The motions of blocks: each prepares a plan.

void prepare_dwell(Machine& machine, const Block& block, Plan& plan);
void prepare_rename(Machine& machine, const Block& block, Plan& plan);
void prepare_line(Machine& machine, const Block& block, Plan& plan);
void prepare_arc(Machine& machine, const Block& block, Plan& plan);
void prepare_thread(Machine& machine, const Block& block, Plan& plan);
void prepare_drill(Machine& machine, const Block& block, Plan& plan);
void prepare_groove(Machine& machine, const Block& block, Plan& plan);
void prepare_turn_cycle(Machine& machine, const Block& block, Plan& plan);
void prepare_face_cycle(Machine& machine, const Block& block, Plan& plan);
void prepare_thread_cycle(Machine& machine, const Block& block, Plan& plan);

// What the cycles have in common.

/// C.
struct CycleEnd {
  Fixed x = 0;
  Fixed z = 0;
};

/// Whether the block of a cycle moves nothing: it has no axis word, unless under the reading
/// hnc.empty-block = repeat its own words run the cycle again, or under the reading
/// hnc.missing-axis = nothing lacks one that the cycle needs.
bool is_idle(const Machine& machine, const Block& block, bool needs_x, bool needs_z);
/// The coordinates that a running cycle block commands; those that it does not need are the
/// position's (HNC-MOD-03). Complains about what is missing.
CycleEnd cycle_end(Machine& machine, const Block& block, bool needs_x, bool needs_z);
/// The command has changed, from `before` with what it had stored: takes up what the readings keep
/// through other codes.
void take_up_words(Machine& machine, Motion before, const CycleStore& left);
/// Keeps C for blocks that leave a coordinate out.
void keep_end(Machine& machine, const CycleEnd& end);
/// The feed of a cycle; complains when there is none in force (HNC-COM-01, HNC-MOD-04).
Feed cycle_feed(Machine& machine);
/// `from` + `by`; complains when it is out of reach.
Fixed moved(Machine& machine, Fixed from, Fixed by);
/// From A to `b` along `first`, with `feed` to C and, unless it is at rapid, out along `first`,
/// then back to A.
bool cut_around(Machine& machine, std::size_t first, Fixed b, const CycleEnd& end, const Feed& feed,
                bool rapid_out);

/// A hole or groove along one axis, from the position.
struct Pecks {
  std::size_t axis = GONOGO_Z;
  Fixed bottom = 0;
  Fixed infeed = 0;      ///< dK, when there is a withdrawal
  Fixed withdrawal = 0;  ///< e; 0: straight to the bottom
  Feed feed;
  bool approached = false;  ///< rapid down to `approach` first
  Fixed approach = 0;
};

/// Takes in R and Q of G74 and G75 (HNC-G74-01). `halved`: they are diameter values.
void take_pecks(Machine& machine, const Block& block, bool halved);
/// Fills in how the pecks of a running block go, from what is in force.
void prepare_pecks(Machine& machine, const Block& block, Pecks& pecks);
/// Mode 3, where the reading of the cycle is on and dK is in force: the end point is where the cut
/// begins, dK how far it goes on.
void prepare_approach(Machine& machine, bool is_on, Pecks& pecks);
/// From the position to the bottom, with withdrawals between (HNC-G74-02).
bool perform_pecks(Machine& machine, const Pecks& pecks);

}  // namespace gonogo::expanders::hnc
