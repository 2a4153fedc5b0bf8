// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-MOD-01: the motion in force.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "reference/clause_literal.hpp"
#include "reference/rs274/machine.hpp"
#include "reference/rs274/modes.hpp"

namespace gonogo::reference::rs274 {
namespace {

struct Motion {
  int number;
  void (*run)(BlockContext& block);
};
constexpr Motion kMotions[] = {
    {0, run_traverse},
    {1, run_straight_feed},
    {2, [](BlockContext& block) { run_arc(block, -1); }},
    {3, [](BlockContext& block) { run_arc(block, +1); }},
    {33, run_g33},
    {kG33Point1, run_g33_1},
    {73, run_g73},
    {74, run_g74},
    {76, run_g76},
    {81, run_g81},
    {82, run_g82},
    {83, run_g83},
    {84, run_g84},
    {85, run_g85},
    {86, run_g86},
    {89, run_g89},
};

// NGC-OFS-16: whether turned axes take the motion out of the planes that records have.
bool leaves_plane(BlockContext& block) {
  const int motion = block.machine.motion;
  const bool is_of_plane = is_arc(motion) && block.machine.plane != Plane::g17;
  const bool has_lead = motion == 33 || motion == kG33Point1 || motion == 76;
  if (!block.machine.offsets.frame.is_turned || (!is_of_plane && !has_lead)) return false;
  block.not_covered("rotation", 'G',
                    "The gauge reads no thread, and of arcs those in G17 alone, while G10 L2 R "
                    "turns the axes X and Y.");
  return true;
}

}  // namespace

void run_motion(BlockContext& block) {
  const Machine& machine = block.machine;
  const bool lacks_motion = machine.motion == kNoMotion && block.words.has_axis_word();
  if (lacks_motion && !takes_axis_words(block.codes)) {
    block.alarm(
        AlarmClass::missing_word, "NGC-MOD-01"_clause, 'G',
        machine.motion_ended != 0
            ? fmt::format("No motion is in force for the axis words: G80 of line {} ended it.",
                          machine.motion_ended)
            : std::string("No motion is in force for the axis words: none was given yet."));
  }
  if (!block.runs_motion || leaves_plane(block) || !fits_modes(block)) return;
  const Motion* const motion = std::ranges::find(kMotions, machine.motion, &Motion::number);
  if (motion != std::end(kMotions)) motion->run(block);
}

}  // namespace gonogo::reference::rs274
