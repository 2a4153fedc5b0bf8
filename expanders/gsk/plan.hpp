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

/// G94: from the position (A) by B and C to D and back.
struct FaceCycle {
  Fixed b_p = 0;
  Fixed c_p = 0;
  Fixed c_q = 0;
};

/// G110 and G111.
struct Pocket {
  Point centre{};  ///< all axes but the depth axis
  Axes axes = 0;   ///< that are positioned
  Fixed r_plane = 0;
  Fixed initial_plane = 0;
  Fixed depth = 0;  ///< from the R plane, signed
  Fixed step_down = 0;
  Fixed clearance = 0;
  Fixed step = 0;
  Fixed reach = 0;  ///< I - D: radius of the last circle
  int rot = 0;
};

using Plan = std::variant<Idle, Dwell, Home, Rename, Line, Arc, FaceCycle, Pocket>;

Flow prepare_dwell(Machine& machine, const Block& block, Plan& plan);
Flow prepare_home(Machine& machine, const Block& block, Plan& plan);
Flow prepare_rename(Machine& machine, const Block& block, Plan& plan);
Flow prepare_line(Machine& machine, const Block& block, Plan& plan);
Flow prepare_arc(Machine& machine, const Block& block, Plan& plan);
Flow prepare_face_cycle(Machine& machine, const Block& block, Plan& plan);
/// `entering`: the block's code enters the mode. `mills`: its axis words are the cycle's.
Flow prepare_pocket(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan);

bool perform(Machine& machine, const Idle& plan);
bool perform(Machine& machine, const Dwell& plan);
bool perform(Machine& machine, const Home& plan);
bool perform(Machine& machine, const Rename& plan);
bool perform(Machine& machine, const Line& plan);
bool perform(Machine& machine, const Arc& plan);
bool perform(Machine& machine, const FaceCycle& plan);
bool perform(Machine& machine, const Pocket& plan);

}  // namespace gonogo::expanders::gsk
