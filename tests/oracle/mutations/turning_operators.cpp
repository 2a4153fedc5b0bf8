// SPDX-License-Identifier: GPL-3.0-or-later
//
// Senses, turns and rings.
#include <cmath>

#include "operator.hpp"
#include "oracle/motion/motion.hpp"

namespace gonogo::mutations {
namespace {

using reference::Position;

void other_sense(Edit& edit, std::size_t number) {
  std::int32_t& rot = edit.trace.records[number].rot;
  rot = -rot;
}

bool all_other_senses(Edit& edit) {
  if (!edit.any_of_kind(RecordKind::arc)) return false;
  for (Record& record : edit.trace.records) record.rot = -record.rot;
  return true;
}

void turn_more(Edit& edit, std::size_t number) {
  std::int32_t& rot = edit.trace.records[number].rot;
  rot += rot < 0 ? -1 : 1;
}

void turns_without_end(Edit& edit, std::size_t number) {
  std::int32_t& rot = edit.trace.records[number].rot;
  rot += rot < 0 ? -1'000'000'000 : 1'000'000'000;
}

bool turn_less(Edit& edit) {
  const auto number = edit.any([&](std::size_t i) {
    return edit.right(i).kind == RecordKind::arc && std::abs(edit.right(i).rot) > 1;
  });
  if (!number) return false;
  std::int32_t& rot = edit.trace.records[*number].rot;
  rot += rot < 0 ? 1 : -1;
  return true;
}

// Moves the end of a circle that closes by half a tolerance along it, in its sense or against it.
bool move_end_along(Edit& edit, bool ahead, std::int32_t more_turns) {
  const auto number = edit.any([&](std::size_t i) {
    const Record& record = edit.right(i);
    if (record.kind != RecordKind::arc || edit.size_of(i) < 0.1) return false;
    const reference::PlaneAxes axes = axes_of(record.plane);
    const Position& from = edit.specimen.before[i];
    const Position& to = edit.specimen.after[i];
    return oracle::visible_sign(from[axes.p] - to[axes.p]) == 0 &&
           oracle::visible_sign(from[axes.q] - to[axes.q]) == 0;
  });
  if (!number) return false;
  Record& arc = edit.trace.records[*number];
  const reference::PlaneAxes axes = axes_of(arc.plane);
  const double p = value_of(arc.to[axes.p] - arc.centre[0]);
  const double q = value_of(arc.to[axes.q] - arc.centre[1]);
  const double sense = (arc.rot < 0 ? -1 : 1) * (ahead ? 1 : -1);
  const double part = sense * value_of(edit.times_tolerance(0.5)) / std::hypot(p, q);
  const auto millionths = [](double value) {
    return Number::millionths(std::llround(value * 1e6));
  };
  arc.to[axes.p] += millionths(-q * part);
  arc.to[axes.q] += millionths(p * part);
  arc.rot += (arc.rot < 0 ? -1 : 1) * more_turns;
  return true;
}

// The classic slip: a circle whose end is not the start to the last bit is no circle.
// Turns with those of an arc, or against them, before or after it.
bool ring(Edit& edit, std::int32_t turns) {
  const auto number = edit.any([&](std::size_t i) {
    return edit.right(i).kind == RecordKind::arc && edit.size_of(i) > 0.1;
  });
  if (!number) return false;
  const bool after = edit.chance.once_in(2);
  Record full = edit.right(*number);
  full.axes = reference::kEveryAxis;
  full.to = after ? edit.specimen.after[*number] : edit.specimen.before[*number];
  full.rot = (full.rot < 0 ? -1 : 1) * turns;
  edit.insert(*number + (after ? 1 : 0), full);
  return true;
}

// A ring in the middle of a helix, at half its height; or where a traverse leads up.
bool ring_at_half_height(Edit& edit) {
  const auto arc = edit.any([&](std::size_t i) {
    return edit.right(i).kind == RecordKind::arc && edit.size_of(i) > 0.1;
  });
  if (!arc) return false;
  const reference::PlaneAxes axes = axes_of(edit.right(*arc).plane);
  std::size_t up = *arc + 1;
  while (up < edit.trace.records.size() && edit.right(up).kind != RecordKind::rapid) ++up;
  if (up == edit.trace.records.size()) return false;
  const Number low = edit.specimen.before[up][axes.d];
  const Number high = edit.specimen.after[up][axes.d];
  if (std::abs(value_of(high - low)) < 0.01) return false;
  Position middle = edit.specimen.before[up];
  middle[axes.d] = (low + high) / 2;
  Record part = edit.motion_to(RecordKind::rapid, edit.right(up).block, middle);
  Record full = edit.right(*arc);
  full.block = edit.right(up).block;
  full.axes = reference::kEveryAxis;
  full.to = middle;
  full.rot = edit.chance.once_in(2) ? 1 : -1;
  const double radius =
      plane_radius(axes, place_of(middle), {value_of(full.centre[0]), value_of(full.centre[1])});
  if (radius < 0.1) return false;
  edit.insert(up, full);
  edit.insert(up, part);
  return true;
}

// The other of the two arcs between its ends.
void long_way_round(Edit& edit, std::size_t number) {
  Record& arc = edit.trace.records[number];
  const reference::PlaneAxes axes = axes_of(arc.plane);
  const Position& from = edit.specimen.before[number];
  const Position& to = edit.specimen.after[number];
  // The centre on the other side of the chord.
  arc.centre[0] = from[axes.p] + to[axes.p] - arc.centre[0];
  arc.centre[1] = from[axes.q] + to[axes.q] - arc.centre[1];
}

}  // namespace

std::vector<Operator> turning_operators() {
  return {
      {"other-sense", "an arc turns the other way", to_any(RecordKind::arc, other_sense)},
      {"all-other-senses", "all arcs turn the other way", all_other_senses},
      {"turn-more", "an arc has a turn more", to_any(RecordKind::arc, turn_more)},
      {"turns-without-end", "an arc has a thousand million turns more",
       to_any(RecordKind::arc, turns_without_end)},
      {"turn-less", "an arc has a turn less", turn_less},
      {"ends-just-ahead", "a circle ends half a tolerance past its start",
       [](Edit& edit) { return move_end_along(edit, true, 0); }},
      {"turn-more-just-short", "a circle has a turn more, but for half a tolerance",
       [](Edit& edit) { return move_end_along(edit, false, 1); }},
      {"ring-with", "a full ring more, in the sense of the arc",
       [](Edit& edit) { return ring(edit, 1); }},
      {"ring-against", "a full ring more, against the arc",
       [](Edit& edit) { return ring(edit, -1); }},
      {"twenty-against", "twenty turns against the arc",
       [](Edit& edit) { return ring(edit, -20); }},
      {"ring-at-half-height", "a full ring on the way up", ring_at_half_height},
      {"other-side", "an arc about a centre on the other side of its chord",
       to_any(RecordKind::arc, long_way_round)},
  };
}

}  // namespace gonogo::mutations
