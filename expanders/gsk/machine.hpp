// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/machine.hpp"
#include "expanders/common/plan.hpp"
#include "expanders/gsk/faults.hpp"
#include "expanders/gsk/profile.hpp"

namespace gonogo::expanders::gsk {

using Block = LetterBlock;

/// Modal code of group 01; the last three are the turning cycles G90, G92 and G94.
enum class Motion {
  kRapid,
  kLine,
  kArcClockwise,
  kArcCounterclockwise,
  kTurnCycle,
  kThreadCycle,
  kFaceCycle
};

inline constexpr bool is_turning_cycle(Motion motion) {
  return motion >= Motion::kTurnCycle;
}

/// Modal code of group 10, in the order of the codes from G110.
enum class Cycle {
  kNone,
  kPocketClockwise,
  kPocketCounterclockwise,
  kHelixClockwise,
  kHelixCounterclockwise,
  kExternalThreadClockwise,
  kExternalThreadCounterclockwise,
  kInternalThreadClockwise,
  kInternalThreadCounterclockwise
};

/// The two senses of a cycle are one mode (GSK-MOD-01).
enum class Mode { kNone, kPocket, kHelix, kExternalThread, kInternalThread };

inline constexpr Mode mode_of(Cycle cycle) {
  return static_cast<Mode>((static_cast<int>(cycle) + 1) / 2);
}
inline constexpr bool is_thread_milling(Mode mode) {
  return mode == Mode::kExternalThread || mode == Mode::kInternalThread;
}
/// Sign of `rot`: the even codes turn clockwise.
inline constexpr int sense_of(Cycle cycle) {
  return static_cast<int>(cycle) % 2 == 1 ? -1 : 1;
}

/// A length that a modal word left behind.
struct Retained {
  bool present = false;
  bool incremental = false;
  Fixed value = 0;
};

/// What G90, G92 and G94 keep from block to block, in mm.
struct TurningStore {
  std::array<Retained, 3> end{};  // X, Y, Z
  Retained taper;

  bool empty() const {
    return !end[0].present && !end[1].present && !end[2].present && !taper.present;
  }
};

/// What G110 to G113 keep from block to block, in mm; no word of G114 to G117 is modal.
struct PocketStore {
  Retained radius;       // I
  Retained step;         // L
  Retained step_down;    // Q
  Retained tool_radius;  // D
  Retained r_plane;      // R, from the initial plane
  Retained clearance;    // P
  Retained turns;        // L of G112, in counts of a turn
};

/// The words of G114 to G117, of one block or kept (reading gsk.thread.modal).
struct ThreadWords {
  Retained lead;      // I
  Retained diameter;  // E
  Retained height;    // P
  Retained tool;      // D
  Retained infeed;    // Q
  Retained run_out;   // J
  Retained angle;     // K, degrees from 0 to below 360
};

/// All that one block hands to the next.
struct State {
  Point position{};
  const Plane* plane = &plane_of(18);
  bool inch = false;
  bool per_revolution = false;
  Fixed feed = 0;  // mm a minute or a revolution; 0: none in force
  Fixed lead = 0;  // F of G92, mm a revolution; 0: none in force
  Motion motion = Motion::kRapid;
  Motion path_motion = Motion::kRapid;  // the last that is no turning cycle
  Cycle cycle = Cycle::kNone;
  TurningStore turning;
  PocketStore pocket;
  ThreadWords thread;
  Fixed initial_plane = 0;  // of the cycle in force
};

/// What every code works on.
class Machine : public expanders::Machine {
 public:
  Machine(const MachineProfile& machine_profile, const gonogo_sink_v1& sink,
          Planted<Fault> planted);
  State state;
  bool motion_coded = false;  ///< a code of group 01 stands in the block

  const Plane& plane() const { return *state.plane; }
  /// Notes the first rule that the block breaks.
  void raise(AlarmKind kind, char word = 0) { complain(kind, word, 0); }
  /// Complains where a cut has no feed (GSK-COM-04).
  void check_feed() {
    if (state.feed == 0) raise(AlarmKind::kFeedMissing);
  }

  // At the feed and in the plane that are in force.
  bool cut(const Point& to, Axes axes) { return tracer.feed(to, axes, feed()); }
  bool cut_axis(std::size_t axis, Fixed to) { return tracer.feed_axis(axis, to, feed()); }
  bool arc(Fixed centre_p, Fixed centre_q, int rot, const Point& to, Axes axes) {
    return tracer.arc(plane(), centre_p, centre_q, rot, to, axes, feed());
  }

 private:
  Feed feed() const { return {state.feed, state.per_revolution}; }
};

/// The word or words of one axis in a block.
struct AxisWord {
  bool present = false;
  bool incremental = false;
  char address = 0;
  Fixed value = 0;  ///< true length in mm, or degrees
};

// In words.cpp.

/// The word of `axis` (X, Y, Z or C). `as_diameter`: an X word is halved where the machine
/// programs diameters.
AxisWord axis_word(const Machine& machine, const Block& block, std::size_t axis,
                   bool as_diameter = true);
/// The length of `address` in mm, or its degrees; the word must be there.
Fixed length_of(const Machine& machine, const Block& block, char address);
Fixed angle_of(const Machine& machine, const Block& block, char address);
/// Stores the length of `address` when the block has it.
void take(const Machine& machine, const Block& block, char address, Retained& store);
/// Coordinate that `word` commands when it is counted from `from`.
template <typename Word>
Fixed target_of(const Word& word, Fixed from) {
  if (!word.present) return from;
  return word.incremental ? from + word.value : word.value;
}
/// The commanded point of the block, counted from the position; `axes` are those commanded.
Point commanded_point(Machine& machine, const Block& block, Axes& axes);
/// Rules that hold for the words of every block (GSK-COM-01, GSK-COM-03).
void check_words(Machine& machine, const Block& block);
/// The ranges of the words of the cycle in force, in the unit in which they are written
/// (GSK-COM-06).
void check_ranges(Machine& machine, const Block& block);

// The motions of blocks: each prepares a plan.

void prepare_dwell(Machine& machine, const Block& block, Plan& plan);
void prepare_home(Machine& machine, const Block& block, Plan& plan);
void prepare_rename(Machine& machine, const Block& block, Plan& plan);
void prepare_line(Machine& machine, const Block& block, Plan& plan);
void prepare_arc(Machine& machine, const Block& block, Plan& plan);
void prepare_face_cycle(Machine& machine, const Block& block, Plan& plan);
void prepare_turn_cycle(Machine& machine, const Block& block, Plan& plan);
void prepare_thread_cycle(Machine& machine, const Block& block, Plan& plan);
/// `entering`: the block's code enters the mode. `mills`: its axis words are the cycle's.
void prepare_pocket(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan);
void prepare_helix(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan);
void prepare_thread_milling(Machine& machine, const Block& block, bool mills, Plan& plan);

}  // namespace gonogo::expanders::gsk
