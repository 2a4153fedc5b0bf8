// SPDX-License-Identifier: GPL-3.0-or-later
//
// G110 and G111, the circular pocket: roughed layer by layer, clockwise and counterclockwise.
#include <fmt/format.h>

#include "reference/gsk988ta/machine.hpp"
#include "reference/gsk988ta/pocket_paths.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// Everything that the motions of one pocket need; mm as true lengths.
struct Pocket {
  PlaneAxes axes;
  PocketLevel level;   // of every layer; `depth` is filled in layer by layer
  Position start;      // where the tool stands
  Position centre;     // of the plane, and other axes that are commanded
  AxisSet positioned;  // the axes of GSK-G110-06
  Number initial_plane;
  Number r_plane;
  Number bottom;
  Number infeed;     // Q
  Number clearance;  // abs(P)
  bool ends_at_initial_plane = true;
  bool open_path = true;    // judged by what it clears
  bool concentric = false;  // of the two given paths

  Number end_depth() const { return ends_at_initial_plane ? initial_plane : r_plane; }
};

Record motion(const Pocket& pocket, RecordKind kind, ClauseId clause, const Number& depth) {
  Record record;
  record.kind = kind;
  record.block = pocket.level.block;
  record.clause = clause;
  record.axes = {pocket.axes.d};
  record.to[pocket.axes.d] = depth;
  if (kind == RecordKind::feed) {
    record.feed = pocket.level.feed;
    record.feed_mode = pocket.level.feed_mode;
  }
  return record;
}

Record to_centre(const Pocket& pocket, ClauseId clause, AxisSet axes) {
  Record record = motion(pocket, RecordKind::rapid, clause, 0);
  record.axes = axes;
  record.to = pocket.centre;
  return record;
}

// The depth of a layer: k Q below the R plane, the last one at the bottom.
Number layer_depth(const Pocket& pocket, const Number& k) {
  const Number total = pocket.bottom - pocket.r_plane;
  const Number below = min(k * pocket.infeed, abs(total));
  return total.sign() < 0 ? pocket.r_plane - below : pocket.r_plane + below;
}

// GSK-G110-11: abs(P) above the last depth, never beyond the R plane.
Number approach_depth(const Pocket& pocket, const Number& last_depth) {
  const Number above = min(pocket.clearance, abs(last_depth - pocket.r_plane));
  return pocket.bottom < pocket.r_plane ? last_depth + above : last_depth - above;
}

Generator<Item> mill(Pocket pocket) {
  const AxisSet plane_axes = {pocket.axes.p, pocket.axes.q};
  co_yield to_centre(pocket, "GSK-G110-06"_clause, pocket.positioned);
  co_yield motion(pocket, RecordKind::rapid, "GSK-G110-07"_clause, pocket.r_plane);
  const Number total = abs(pocket.bottom - pocket.r_plane);
  if (total.sign() == 0) {
    // GSK-G110-17: no depth, no cut.
    co_yield motion(pocket, RecordKind::rapid, "GSK-G110-17"_clause, pocket.initial_plane);
    co_return;
  }
  const Number layers = (total / pocket.infeed).ceil();
  for (Number k = 1; k <= layers; k += 1) {  // GSK-G110-12
    const Number depth = layer_depth(pocket, k);
    if (k > 1) {
      co_yield motion(pocket, RecordKind::rapid, "GSK-G110-11"_clause,
                      approach_depth(pocket, layer_depth(pocket, k - 1)));
    }
    co_yield motion(pocket, RecordKind::feed, k > 1 ? "GSK-G110-11"_clause : "GSK-G110-08"_clause,
                    depth);
    pocket.level.depth = depth;
    if (pocket.open_path) {
      co_yield pocket.level;
    } else {
      Generator<Record> path =
          pocket.concentric ? concentric_circles(pocket.level) : semicircles(pocket.level);
      while (const Record* record = path.next()) co_yield *record;
    }
    co_yield motion(pocket, RecordKind::rapid, "GSK-G110-10"_clause, pocket.r_plane);
    co_yield to_centre(pocket, "GSK-G110-10"_clause, plane_axes);
  }
  if (pocket.ends_at_initial_plane) {
    co_yield motion(pocket, RecordKind::rapid, "GSK-G110-13"_clause, pocket.initial_plane);
  }
}

// GSK-G110-02, GSK-MOD-02: every block of the mode takes in I, L, Q and D, milling or not.
void take_in_words(BlockContext& block) {
  PocketMode& mode = block.machine.pocket;
  if (block.changed_pair && block.readings.is(ReadingKey::pocket_pair, "each")) {
    mode.radius = mode.step = mode.infeed = mode.tool = std::nullopt;
  }
  const BlockWords& words = block.words;
  if (auto value = words.length('I')) mode.radius = value;
  if (auto value = words.length('L')) mode.step = value;
  if (auto value = words.length('Q')) mode.infeed = value;
  if (auto value = words.length('D')) mode.tool = value;
  if (auto value = words.length('R')) mode.retained_r = value;
  if (auto value = words.length('P')) mode.retained_clearance = value;
}

void check_retained_words(BlockContext& block, bool mills) {
  const PocketMode& mode = block.machine.pocket;
  const std::array<std::pair<char, const std::optional<Number>*>, 4> needed = {
      {{'I', &mode.radius}, {'L', &mode.step}, {'Q', &mode.infeed}, {'D', &mode.tool}}};
  for (const auto& [address, value] : needed) {
    if (!value->has_value()) {
      block.missing("GSK-G110-02"_clause, address);
    } else if (mills && (*value)->sign() <= 0 && !block.words.has(address)) {
      block.alarm(AlarmClass::value_out_of_range, "GSK-G110-16"_clause, address,
                  fmt::format("The retained {} is not above zero.", address));
    } else if (mills && (*value)->sign() <= 0) {
      block.alarm(AlarmClass::value_out_of_range, "GSK-G110-16"_clause, address,
                  fmt::format("{} must be above zero.", address));
    }
  }
}

// GSK-G110-03: equality is an alarm in both.
void check_tool(BlockContext& block) {
  const PocketMode& mode = block.machine.pocket;
  if (mode.radius && mode.tool && *mode.radius <= *mode.tool) {
    block.alarm(AlarmClass::tool_too_large, "GSK-G110-03"_clause, 'I',
                fmt::format("The pocket radius {} is not larger than the tool radius {}.",
                            mode.radius->text(), mode.tool->text()));
  }
  if (mode.step && mode.tool && *mode.step >= *mode.tool * 2) {
    block.alarm(AlarmClass::step_too_large, "GSK-G110-03"_clause, 'L',
                fmt::format("The step {} is not smaller than the tool diameter {}.",
                            mode.step->text(), (*mode.tool * 2).text()));
  }
}

// The words of a block that mills, as positions.
Pocket place_pocket(BlockContext& block) {
  const Machine& machine = block.machine;
  const bool modal = block.readings.is(ReadingKey::pocket_r, "modal");
  Pocket pocket;
  pocket.axes = axes_of(machine.plane);
  pocket.start = machine.position;
  // GSK-G110-01: the centre; GSK-G110-06: and every commanded axis but d.
  pocket.positioned = commanded_end_point(block, pocket.centre);
  pocket.centre[pocket.axes.d] = machine.position[pocket.axes.d];
  AxisSet positioned;
  for (Axis axis : kAllAxes) {
    if (axis != pocket.axes.d && pocket.positioned.has(axis)) positioned.add(axis);
  }
  pocket.positioned = positioned;
  // GSK-MOD-03: R and P hold for their block.
  const std::optional<Number> r = modal ? machine.pocket.retained_r : block.words.length('R');
  const std::optional<Number> clearance =
      modal ? machine.pocket.retained_clearance : block.words.length('P');
  pocket.initial_plane = machine.pocket.initial_plane;
  pocket.r_plane = pocket.initial_plane + r.value_or(0);
  pocket.clearance =
      clearance ? abs(*clearance) : block.readings.length(ReadingKey::pocket_p_omitted);
  // GSK-G110-18: as the depth axis X is a diameter as everywhere.
  const bool diameter =
      pocket.axes.d != Axis::x || block.readings.is(ReadingKey::x_depth, "diameter");
  const AxisWord depth = block.words.axis_word(pocket.axes.d, diameter).value();
  pocket.bottom = depth.incremental ? pocket.r_plane + depth.value : depth.value;
  return pocket;
}

// GSK-G110-04: R = 0 agrees with all, and so does a pocket without depth.
void check_directions(BlockContext& block, const Pocket& pocket) {
  const Number r = pocket.r_plane - pocket.initial_plane;
  const Number depth = pocket.bottom - pocket.r_plane;
  if (r.sign() * depth.sign() < 0) {
    block.alarm(AlarmClass::direction_conflict, "GSK-G110-04"_clause, 'R',
                "R leads away from the bottom of the pocket.");
  }
  if (depth.sign() != 0) {
    block.need_feed();
  } else if (block.readings.is(ReadingKey::zero_depth, "alarm")) {
    block.alarm(AlarmClass::value_out_of_range, "GSK-G110-17"_clause,
                addresses_of(pocket.axes.d).absolute, "The pocket has no depth.");
  }
}

void fill_level(BlockContext& block, Pocket& pocket) {
  const Machine& machine = block.machine;
  PocketLevel& level = pocket.level;
  level.block = block.line;
  level.clause = "GSK-G110-09"_clause;
  level.plane = machine.plane;
  level.centre = {pocket.centre[pocket.axes.p], pocket.centre[pocket.axes.q]};
  level.pocket_radius = machine.pocket.radius.value_or(0);
  level.tool_radius = machine.pocket.tool.value_or(0);
  level.step = machine.pocket.step.value_or(0);
  level.sense = machine.pocket.code == 110 ? -1 : +1;
  level.feed = machine.feed;
  level.feed_mode = machine.feed_mode;
  pocket.infeed = machine.pocket.infeed.value_or(0);
  // GSK-G110-09: the path is open unless a reading names one.
  const bool any = block.readings.is(ReadingKey::pocket_path, "any");
  pocket.open_path = any && block.open_paths == OpenPaths::judged;
  pocket.concentric = block.readings.is(ReadingKey::pocket_path, "concentric");
  pocket.ends_at_initial_plane = block.readings.is(ReadingKey::pocket_end, "initial");
}

// GSK-G110-14 under gsk.missing-axis = position: the plane axes that are there are positioned.
void position_only(BlockContext& block, const PlaneAxes& axes) {
  Pocket pocket;
  AxisSet named = commanded_end_point(block, pocket.centre);
  AxisSet moved;
  for (Axis axis : kAllAxes) {
    if (axis != axes.d && named.has(axis)) moved.add(axis);
  }
  if (moved.empty()) return;
  Record record = block.motion(RecordKind::rapid, "GSK-G110-14"_clause, {});
  record.axes = moved;
  pocket.centre[axes.d] = block.machine.position[axes.d];
  record.to = pocket.centre;
  block.machine.position = pocket.centre;
  block.put(std::move(record));
}

}  // namespace

void run_g110(BlockContext& block) {
  const PlaneAxes axes = axes_of(block.machine.plane);
  take_in_words(block);
  const bool mills = block.words.has_axis_word(axes.p) && block.words.has_axis_word(axes.q) &&
                     block.words.has_axis_word(axes.d);
  // GSK-MOD-02: the entry block and every block that mills need all four.
  const bool entry = block.entered_cycle ||
                     (block.changed_pair && block.readings.is(ReadingKey::pocket_pair, "each"));
  if (entry || mills) check_retained_words(block, mills);
  if (!mills) {
    // GSK-G110-14
    if (block.readings.is(ReadingKey::missing_axis, "position")) position_only(block, axes);
    return;
  }
  check_tool(block);
  Pocket pocket = place_pocket(block);
  check_directions(block, pocket);
  fill_level(block, pocket);
  if (!block.out.alarms.empty()) return;

  Position& position = block.machine.position;
  position = pocket.centre;
  position[axes.d] = pocket.bottom == pocket.r_plane ? pocket.initial_plane : pocket.end_depth();
  block.out.cycle = mill(std::move(pocket));
}

}  // namespace gonogo::reference::gsk988ta
