// SPDX-License-Identifier: GPL-3.0-or-later
//
// LCYC75: rectangular and circular pockets and slots.
#include "reference/sinumerik/lcyc75.hpp"

#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::sinumerik {
namespace {

// SIE-LC75-01: where the pocket lies, in base coordinates.
void place(const CycleCall& call, PocketMilling& pocket) {
  const Machine& machine = call.block.machine;
  const PlaneAxes axes = call.block.plane_axes();
  Position centre = machine.position;
  centre[axes.p] = call.parameter(116);
  centre[axes.q] = call.parameter(117);
  centre[axes.d] = 0;
  const Position base = machine.frame.to_base(centre);
  const Number& zero = base[axes.d];
  pocket.plane = machine.plane;
  pocket.centre = {base[axes.p], base[axes.q]};
  pocket.direction = machine.frame.direction_in(machine.plane);
  pocket.clearance = zero + call.clearance();
  pocket.reference_plane = zero + call.parameter(103);
  pocket.retract = zero + call.retract();
  pocket.floor = zero + call.parameter(104);
}

// SIE-LC75-05, SIE-LC75-07, SIE-LC75-08, SIE-LC75-10, SIE-LC75-11: what is left to the path.
// SIE-LC75-02: slots and circles are rectangles with the largest corners that fit.
void size(const CycleCall& call, const Number& tool_radius, PocketMilling& pocket) {
  const Number corner = corner_radius(call);
  const Number allowance = call.parameter(124);
  const Number allowance_in_depth = call.parameter(125);
  pocket.tool_radius = tool_radius;
  pocket.finishing = call.parameter(127) == Number(2);
  if (pocket.finishing) {
    pocket.length = call.parameter(118);
    pocket.width = call.parameter(119);
    pocket.corner_radius = max(corner, tool_radius);
    pocket.allowance = allowance;
    pocket.contour_only = allowance.sign() > 0 && allowance_in_depth.sign() == 0;
    pocket.rough_floor = min(pocket.floor + allowance_in_depth, pocket.reference_plane);
    pocket.one_level = !call.block.readings.is("sie.finish.levels=split"_reading);
  } else {
    pocket.length = call.parameter(118) - allowance * 2;
    pocket.width = call.parameter(119) - allowance * 2;
    pocket.corner_radius = max(corner - allowance, tool_radius);
    pocket.floor = pocket.floor + allowance_in_depth;
    pocket.rough_floor = pocket.floor;
  }
}

// SIE-LC75-06
void divide(const CycleCall& call, PocketMilling& pocket) {
  const ReadingsInUse& readings = call.block.readings;
  pocket.infeed = call.parameter(121);
  pocket.levels = readings.is("sie.infeed=equal"_reading)      ? Levels::equal
                  : readings.is("sie.infeed=max-rest"_reading) ? Levels::max_rest
                                                               : Levels::open;
  if (pocket.levels == Levels::open) return;
  pocket.levels_from_clearance = readings.is("sie.infeed-from=clearance"_reading);
}

// SIE-LC75-14
void leave_feed(Machine& machine, const Number& plane_feed) {
  const bool was_open = machine.feed_of_cycle && machine.feed_of_cycle->replaces_one_of_before;
  machine.feed_of_cycle = FeedOfCycle{plane_feed, machine.feed_is_of_before || was_open};
  machine.feed_is_of_before = false;
}

// SIE-LC75-09: without a sense, if that is no alarm, one of them.
int sense_of(const CycleCall& call) {
  const Number direction = call.parameter(126);
  const bool is_clockwise = direction.sign() == 0
                                ? call.block.readings.is("sie.lc75.no-sense=g2"_reading)
                                : direction == Number(2);
  return is_clockwise ? -1 : 1;
}

}  // namespace

void run_lcyc75(const CycleCall& call) {
  BlockContext& block = call.block;
  const std::optional<Number> tool_radius = check_pocket(call);
  if (!tool_radius) return;
  PocketMilling pocket;
  pocket.block = block.line;
  pocket.clause = "SIE-LC75-04"_clause;
  place(call, pocket);
  size(call, *tool_radius, pocket);
  divide(call, pocket);
  pocket.sense = sense_of(call);
  pocket.depth_feed = call.parameter(122);
  pocket.plane_feed = call.parameter(123);
  pocket.feed_mode = block.machine.feed_mode;
  name_planes(call);
  // SIE-LC75-13: one traverse to R101. The way down from there is printed of roughing alone.
  const PlaneAxes axes = block.plane_axes();
  put_cycle_motion(
      call, RecordKind::rapid, pocket.finishing ? "SIE-LC75-13"_clause : pocket.clause,
      {{axes.p, call.parameter(116)}, {axes.q, call.parameter(117)}, {axes.d, call.retract()}});
  if (!pocket.finishing) {
    put_cycle_motion(call, RecordKind::rapid, pocket.clause, {{axes.d, call.clearance()}});
  }
  const bool named = block.readings.is("sie.pocket.path=contour-parallel"_reading);
  if (call.open_paths == OpenPaths::shown || named) {
    block.out.cycle = contour_parallel(pocket);
  } else {
    block.put_item(pocket);
  }
  // SIE-LC75-13: it ends above the centre at R101.
  block.machine.position[axes.d] = call.retract();
  block.machine.base[axes.d] = pocket.retract;
  block.machine.mark.reset();
  leave_feed(block.machine, pocket.plane_feed);
  end_cycle(block);
}

}  // namespace gonogo::reference::sinumerik
