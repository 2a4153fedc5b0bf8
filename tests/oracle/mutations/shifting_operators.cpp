// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places beside the right ones: by 1.5 tolerances and more.
#include <algorithm>

#include "operator.hpp"

namespace gonogo::mutations {
namespace {

using reference::Axis;
using reference::kLinearAxes;

// Whether a circle that closes stands level with its centre on all axes but this one: moved along
// it, its end stays on the ray of its start, and the numbers do not tell a whole turn from none.
bool ends_on_ray(const Edit& edit, std::size_t number, Axis axis) {
  const Record& record = edit.trace.records[number];
  const reference::Position& start = edit.specimen.before[number];
  if (record.kind != reference::RecordKind::arc || start != edit.specimen.after[number])
    return false;
  const reference::PlaneAxes axes = reference::axes_of(record.plane);
  return (axis == axes.p && record.centre[1] == start[axes.q]) ||
         (axis == axes.q && record.centre[0] == start[axes.p]);
}

// R4: a traverse that stops on its way along an axis, where the next one goes on along that axis.
bool stops_on_the_way(const Edit& edit, std::size_t number, Axis axis) {
  const auto& records = edit.trace.records;
  const std::size_t next = number + 1;
  if (next >= records.size() || records[number].kind != RecordKind::rapid ||
      records[next].kind != RecordKind::rapid) {
    return false;
  }
  const Number& stop = records[number].to[axis];
  const Number due = edit.specimen.after[number][axis] - stop;
  const Number come = stop - edit.specimen.before[number][axis];
  const bool goes_on = std::ranges::all_of(kLinearAxes, [&](Axis other) {
    return other == axis || edit.specimen.after[next][other] == edit.specimen.after[number][other];
  });
  return goes_on && (due * come).sign() > 0;
}

// The end of one motion beside its place; the next leads where it led.
bool shift_end(Edit& edit) {
  const auto number = edit.any_motion();
  if (!number) return false;
  Record& record = edit.trace.records[*number];
  const Axis axis = edit.chance.one_of(kLinearAxes);
  const Number by = edit.off();
  if (ends_on_ray(edit, *number, axis)) return false;
  record.to[axis] = edit.specimen.after[*number][axis] + by;
  record.axes.add(axis);
  edit.lead_next_to_its_end(*number);
  return !stops_on_the_way(edit, *number, axis);
}

// The same, and what follows stays where it is then, on axes that it does not name.
bool shift_end_for_good(Edit& edit) {
  const auto number = edit.any_motion();
  if (!number) return false;
  Record& record = edit.trace.records[*number];
  const Axis axis = edit.chance.one_of(kLinearAxes);
  const Number by = edit.off();
  if (ends_on_ray(edit, *number, axis)) return false;
  record.to[axis] = edit.specimen.after[*number][axis] + by;
  record.axes.add(axis);
  return !stops_on_the_way(edit, *number, axis);
}

void shift_rotary_end(Edit& edit, std::size_t number) {
  Record& record = edit.trace.records[number];
  const Axis axis = edit.chance.one_of(std::to_array({Axis::a, Axis::c}));
  record.to[axis] = edit.specimen.after[number][axis] + edit.off();
  record.axes.add(axis);
  edit.lead_next_to_its_end(number);
}

// All from one motion on moved along an axis: an offset that is wrong.
bool shift_rest(Edit& edit) {
  const auto number = edit.any_motion();
  if (!number) return false;
  const Axis axis = edit.chance.one_of(kLinearAxes);
  const Number by = edit.off();
  for (std::size_t i = *number; i < edit.trace.records.size(); ++i) {
    Record& record = edit.trace.records[i];
    if (!is_motion(record.kind)) continue;
    if (i == *number) {
      record.axes.add(axis);
      record.to[axis] = edit.specimen.after[i][axis];
    }
    if (record.axes.has(axis)) record.to[axis] += by;
    if (record.kind == RecordKind::arc) {
      const reference::PlaneAxes axes = axes_of(record.plane);
      if (axes.p == axis) record.centre[0] += by;
      if (axes.q == axis) record.centre[1] += by;
    } else if (record.kind == RecordKind::arc3) {
      record.via[axis] += by;
    }
  }
  return true;
}

void shift_centre(Edit& edit, std::size_t number) {
  edit.trace.records[number].centre[edit.chance.below(2)] += edit.off();
}

void shift_via(Edit& edit, std::size_t number) {
  edit.trace.records[number].via[edit.chance.one_of(kLinearAxes)] += edit.off();
}

// An arc about its centre, farther out or nearer: gouged walls, wrong passes.
bool widen_arc(Edit& edit, const Number& by) {
  const auto number = edit.any([&](std::size_t i) {
    return edit.right(i).kind == RecordKind::arc && i > 0 && is_motion(edit.right(i - 1).kind);
  });
  if (!number) return false;
  Record& arc = edit.trace.records[*number];
  const reference::PlaneAxes axes = axes_of(arc.plane);
  const std::array<double, 2> centre = {value_of(arc.centre[0]), value_of(arc.centre[1])};
  const auto widened = [&](reference::Position at) -> std::optional<reference::Position> {
    const double radius = plane_radius(axes, place_of(at), centre);
    if (radius < 0.2) return std::nullopt;
    constexpr double kParts = 1e9;
    const Number scale =
        by / Number(static_cast<std::int64_t>(radius * kParts)) * Number(1'000'000'000);
    at[axes.p] += (at[axes.p] - arc.centre[0]) * scale;
    at[axes.q] += (at[axes.q] - arc.centre[1]) * scale;
    return at;
  };
  const auto from = widened(edit.specimen.before[*number]);
  const auto to = widened(edit.specimen.after[*number]);
  if (!from || !to) return false;
  Record& before = edit.trace.records[*number - 1];
  before.axes.add(axes.p);
  before.axes.add(axes.q);
  before.to = edit.specimen.after[*number - 1];
  before.to[axes.p] = (*from)[axes.p];
  before.to[axes.q] = (*from)[axes.q];
  arc.to = *to;
  arc.axes = reference::kEveryAxis;
  edit.lead_next_to_its_end(*number);
  return true;
}

// Radius values where diameters are due, or the other way round.
// SIE-LC75-11: before finishing the tool may go on down in what roughing left.
bool comes_before_finishing(const Specimen& specimen, std::size_t number) {
  const std::size_t next = number + 1;
  if (next >= specimen.part.size() || specimen.part[next] != PartKind::pocket_milling) return false;
  const auto& item = specimen.items[specimen.part_number[next]];
  return specimen.part[number] != PartKind::pocket_milling &&
         std::get<reference::PocketMilling>(item).finishing;
}

bool scale_axis(Edit& edit) {
  const auto number = edit.any_motion();
  if (!number) return false;
  const Axis axis = edit.chance.one_of(kLinearAxes);
  Record& record = edit.trace.records[*number];
  record.to[axis] =
      edit.specimen.after[*number][axis] * (edit.chance.once_in(2) ? Number(2) : Number(1) / 2);
  record.axes.add(axis);
  edit.lead_next_to_its_end(*number);
  return !comes_before_finishing(edit.specimen, *number) && !stops_on_the_way(edit, *number, axis);
}

void mirror_axis(Edit& edit, std::size_t number) {
  const Axis axis = edit.chance.one_of(kLinearAxes);
  Record& record = edit.trace.records[number];
  record.to[axis] = -edit.specimen.after[number][axis];
  record.axes.add(axis);
  edit.lead_next_to_its_end(number);
}

}  // namespace

std::vector<Operator> shifting_operators() {
  return {
      {"shift-end", "one end lies beside its place", shift_end},
      {"shift-end-for-good", "from one end on an axis is off", shift_end_for_good},
      {"shift-rotary-end", "one end has a rotary axis elsewhere", to_any_motion(shift_rotary_end)},
      {"shift-rest", "from one motion on all lies beside", shift_rest},
      {"shift-centre", "an arc has its centre beside", to_any(RecordKind::arc, shift_centre)},
      {"shift-via", "a circle in space leads through another point",
       to_any(RecordKind::arc3, shift_via)},
      {"widen-arc", "an arc lies 0.05 farther out",
       [](Edit& edit) { return widen_arc(edit, Number::millionths(50'000)); }},
      {"narrow-arc", "an arc lies 0.05 farther in",
       [](Edit& edit) { return widen_arc(edit, Number::millionths(-50'000)); }},
      {"scale-axis", "a radius is taken as a diameter or the other way round", scale_axis},
      {"mirror-axis", "an end has the other sign", to_any_motion(mirror_axis)},
  };
}

}  // namespace gonogo::mutations
