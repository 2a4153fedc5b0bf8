// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "expanders/ngc/machine.hpp"

namespace gonogo::expanders::ngc {

// What a block will do. Preparing a plan checks every rule of the block and complains to the
// machine; performing it cannot fail (false: the sink has asked to stop). So an alarming block
// moves nothing.

struct Idle {};

/// G0 and G1.
struct Line {
  Point to{};
  Axes axes = 0;
  bool cut = false;
  Feed feed;
};

/// G2 and G3.
struct Arc {
  int plane = 17;
  Point to{};
  Axes axes = 0;
  Fixed centre_p = 0;
  Fixed centre_q = 0;
  int rot = 0;
  Feed feed;
};

struct Plan {
  Fixed dwell = 0;  ///< seconds; before the motion
  std::variant<Idle, Line, Arc> motion;
};

void prepare_dwell(Machine& machine, const Block& block, Plan& plan);
void prepare_line(Machine& machine, const Block& block, Plan& plan);
void prepare_arc(Machine& machine, const Block& block, Plan& plan);

bool perform(Machine& machine, const Idle& motion);
bool perform(Machine& machine, const Line& motion);
bool perform(Machine& machine, const Arc& motion);

}  // namespace gonogo::expanders::ngc
