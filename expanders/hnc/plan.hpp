// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <variant>

#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {

// What a block will do. Preparing a plan checks every rule of the block and complains to the
// machine; performing it cannot fail (false: the sink has asked to stop). So an alarming block
// moves nothing. Places are in the base frame.

struct Idle {};

/// G04.
struct Dwell {
  Fixed seconds = 0;
};

/// G92.
struct Rename {
  Point position{};
};

/// G00 and G01.
struct Line {
  Point to{};
  Axes axes = 0;
  bool cut = false;
};

/// G02 and G03.
struct Arc {
  Point to{};
  Axes axes = 0;
  Fixed centre_p = 0;
  Fixed centre_q = 0;
  int rot = 0;
};

/// G32.
struct Thread {
  Point to{};
  Axes axes = 0;
  Fixed lead = 0;
};

/// A hole or groove along one axis, from the position.
struct Pecks {
  std::size_t axis = GONOGO_Z;
  Fixed bottom = 0;
  Fixed infeed = 0;      ///< dK, when there is a withdrawal
  Fixed withdrawal = 0;  ///< e; 0: straight to the bottom
  Feed feed;
};

/// G74.
struct Drill {
  Pecks pecks;
  Fixed x = 0;  ///< for the fault that goes there first
};

/// G75.
struct Groove {
  Pecks pecks;
  bool approached = false;  ///< rapid down to `approach` first
  Fixed approach = 0;
  Fixed width = 0;  ///< signed
  Fixed steps = 0;  ///< the count; 0: a single groove
};

/// G80 to G82: C, and the coordinate of B that is not A's.
struct Cut {
  Fixed b = 0;
  Fixed c_x = 0;
  Fixed c_z = 0;
};
struct TurnCycle {
  Cut cut;
  Feed feed;
};
struct FaceCycle {
  Cut cut;
  Feed feed;
};
struct ThreadCycle {
  Cut cut;
  Fixed lead = 0;
  Fixed run_out_x = 0;  ///< from C
  Fixed run_out_z = 0;
  Fixed passes = 1;
  Fixed first = 0;    ///< spindle angle of the first pass, degrees
  Fixed between = 0;  ///< from one pass to the next
};

using Plan = std::variant<Idle, Dwell, Rename, Line, Arc, Thread, Drill, Groove, TurnCycle,
                          FaceCycle, ThreadCycle>;

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

bool perform(Machine& machine, const Idle& plan);
bool perform(Machine& machine, const Dwell& plan);
bool perform(Machine& machine, const Rename& plan);
bool perform(Machine& machine, const Line& plan);
bool perform(Machine& machine, const Arc& plan);
bool perform(Machine& machine, const Thread& plan);
bool perform(Machine& machine, const Drill& plan);
bool perform(Machine& machine, const Groove& plan);
bool perform(Machine& machine, const TurnCycle& plan);
bool perform(Machine& machine, const FaceCycle& plan);
bool perform(Machine& machine, const ThreadCycle& plan);

}  // namespace gonogo::expanders::hnc
