// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "expanders/gsk/machine.hpp"

namespace gonogo::expanders::gsk {

// What a block will do. Preparing a plan checks every rule of the block; performing it cannot fail
// (false: the sink has asked to stop). So an alarming block moves nothing.

struct Idle {};

/// G04.
struct Dwell {
  Fixed seconds = 0;
};

/// G28.
struct Home {
  Point via{};
  Axes axes = 0;
};

/// G50.
struct Rename {
  Point position{};
  Fixed initial_plane = 0;  ///< of the cycle in force, in the new coordinates
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

/// G90, G92 and G94: from the position (A) by B and C to D and back. B lies on the line of A along
/// one plane axis, which G94 takes as p and G90 and G92 as q.
struct TurningPath {
  Fixed b = 0;
  Fixed c_p = 0;
  Fixed c_q = 0;
};
struct FaceCycle {
  TurningPath path;
};
struct TurnCycle {
  TurningPath path;
};
struct ThreadCycle {
  TurningPath path;
  Fixed lead = 0;
};

/// Where a cycle of G110 to G117 works.
struct Site {
  Point centre{};  ///< all axes but the depth axis
  Axes axes = 0;   ///< that are positioned
  Fixed initial_plane = 0;
  Fixed r_plane = 0;
  Fixed depth = 0;  ///< from the R plane, signed
};

/// G110 and G111.
struct Pocket {
  Site site;
  Fixed step_down = 0;
  Fixed clearance = 0;
  Fixed step = 0;
  Fixed reach = 0;  ///< I - D: radius of the last circle
  int rot = 0;
};

/// G112 and G113.
struct Helix {
  Site site;
  Fixed reach = 0;  ///< I - D: radius of the helix
  int turns = 0;
  int rot = 0;
};

/// G114 to G117. Radii are the tool centre's.
struct ThreadMilling {
  Site site;
  int side = 1;       ///< the free side of the thread: 1 outwards (external), -1 inwards
  Fixed surface = 0;  ///< radius at which the tool touches the uncut part
  Fixed height = 0;   ///< P
  Fixed infeed = 0;   ///< Q; at most the height
  Fixed lead = 0;
  Fixed run_out = 0;  ///< J
  Fixed angle = 0;    ///< K, degrees from 0 to below 360
  int rot = 0;
};

using Plan = std::variant<Idle, Dwell, Home, Rename, Line, Arc, FaceCycle, TurnCycle, ThreadCycle,
                          Pocket, Helix, ThreadMilling>;

Flow prepare_dwell(Machine& machine, const Block& block, Plan& plan);
Flow prepare_home(Machine& machine, const Block& block, Plan& plan);
Flow prepare_rename(Machine& machine, const Block& block, Plan& plan);
Flow prepare_line(Machine& machine, const Block& block, Plan& plan);
Flow prepare_arc(Machine& machine, const Block& block, Plan& plan);
Flow prepare_face_cycle(Machine& machine, const Block& block, Plan& plan);
Flow prepare_turn_cycle(Machine& machine, const Block& block, Plan& plan);
Flow prepare_thread_cycle(Machine& machine, const Block& block, Plan& plan);
/// `entering`: the block's code enters the mode. `mills`: its axis words are the cycle's.
Flow prepare_pocket(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan);
Flow prepare_helix(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan);
Flow prepare_thread_milling(Machine& machine, const Block& block, bool mills, Plan& plan);

bool perform(Machine& machine, const Idle& plan);
bool perform(Machine& machine, const Dwell& plan);
bool perform(Machine& machine, const Home& plan);
bool perform(Machine& machine, const Rename& plan);
bool perform(Machine& machine, const Line& plan);
bool perform(Machine& machine, const Arc& plan);
bool perform(Machine& machine, const FaceCycle& plan);
bool perform(Machine& machine, const TurnCycle& plan);
bool perform(Machine& machine, const ThreadCycle& plan);
bool perform(Machine& machine, const Pocket& plan);
bool perform(Machine& machine, const Helix& plan);
bool perform(Machine& machine, const ThreadMilling& plan);

}  // namespace gonogo::expanders::gsk
