// SPDX-License-Identifier: GPL-3.0-or-later
//
// R5: M functions and dwells out of their place among the motions.
#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <span>

#include "operator.hpp"

namespace gonogo::mutations {
namespace {

bool is_cutting(const Record& record) {
  return is_motion(record.kind) && record.kind != RecordKind::rapid;
}

using Numbers = std::initializer_list<std::int32_t>;
constexpr Numbers kStarts = {3, 4, 6, 7, 8, 35};
constexpr Numbers kStops = {0, 1, 5, 9, 60};
constexpr Numbers kEnds = {2, 17, 30};

std::optional<std::size_t> any_m(Edit& edit, Numbers numbers) {
  return edit.any([&](std::size_t i) {
    const Record& record = edit.right(i);
    return record.kind == RecordKind::m && std::ranges::find(numbers, record.m) != numbers.end();
  });
}

// The nearest record behind, or before, that is wanted.
template <typename Wanted>
std::optional<std::size_t> next_behind(const Edit& edit, std::size_t number, Wanted wanted) {
  for (std::size_t i = number + 1; i < edit.specimen.right.records.size(); ++i) {
    if (wanted(edit.right(i))) return i;
  }
  return std::nullopt;
}
template <typename Wanted>
std::optional<std::size_t> next_before(const Edit& edit, std::size_t number, Wanted wanted) {
  for (std::size_t i = number; i-- > 0;) {
    if (wanted(edit.right(i))) return i;
  }
  return std::nullopt;
}

bool is_path(const Record& record) {
  return is_motion(record.kind);
}
bool is_dwell(const Record& record) {
  return record.kind == RecordKind::dwell;
}

// To stand before record `place` of the right trace.
void move_before(Edit& edit, std::size_t number, std::size_t place) {
  const Record record = edit.right(number);
  edit.erase(number);
  edit.insert(place > number ? place - 1 : place, record);
}

bool start_behind_a_cut(Edit& edit) {
  const auto number = any_m(edit, kStarts);
  if (!number) return false;
  const auto cut = next_behind(edit, *number, is_cutting);
  if (cut) move_before(edit, *number, *cut + 1);
  return cut.has_value();
}

bool start_behind_a_dwell(Edit& edit) {
  const auto number = any_m(edit, kStarts);
  if (!number) return false;
  const auto dwell = next_behind(edit, *number, is_dwell);
  if (dwell) move_before(edit, *number, *dwell + 1);
  return dwell.has_value();
}

bool stop_before_a_cut(Edit& edit) {
  const auto number = any_m(edit, kStops);
  if (!number) return false;
  const auto cut = next_before(edit, *number, is_cutting);
  if (cut) move_before(edit, *number, *cut);
  return cut.has_value();
}

bool end_before_a_motion(Edit& edit) {
  const auto number = any_m(edit, kEnds);
  if (!number) return false;
  const auto motion = next_before(edit, *number, is_path);
  if (motion) move_before(edit, *number, *motion);
  return motion.has_value();
}

// Where two motions of one block meet, one of which cuts.
bool m_within_a_cycle(Edit& edit) {
  const auto number = edit.any_of_kind(RecordKind::m);
  const auto place = edit.any([&](std::size_t i) {
    if (i == 0 || !is_path(edit.right(i)) || !is_path(edit.right(i - 1))) return false;
    return edit.right(i).block == edit.right(i - 1).block &&
           (is_cutting(edit.right(i)) || is_cutting(edit.right(i - 1)));
  });
  if (!number || !place) return false;
  move_before(edit, *number, *place);
  return true;
}

// One that stops something, between the halves of the cut before it.
bool stop_within_a_cut(Edit& edit) {
  const auto number = any_m(edit, kStops);
  if (!number) return false;
  const auto cut = next_before(edit, *number, is_cutting);
  if (!cut || edit.right(*cut).kind != RecordKind::feed) return false;
  Record half = edit.right(*cut);
  for (const reference::Axis axis : reference::kAllAxes) {
    half.to[axis] = (edit.specimen.before[*cut][axis] + edit.specimen.after[*cut][axis]) / 2;
  }
  half.axes = reference::kEveryAxis;
  Record rest = half;
  rest.to = edit.specimen.after[*cut];
  const Record function = edit.right(*number);
  edit.erase(*number);
  edit.trace.records[*cut] = rest;
  edit.insert(*cut, function);
  edit.insert(*cut, half);
  return true;
}

bool m_behind_all(Edit& edit) {
  const auto last = next_before(edit, edit.specimen.right.records.size(), is_path);
  if (!last || !edit.any_of_kind(RecordKind::m)) return false;
  const auto records = std::span(edit.trace.records).first(*last + 1);
  const auto is_m = [](const Record& record) { return record.kind == RecordKind::m; };
  std::vector<Record> reordered;
  std::ranges::remove_copy_if(records, std::back_inserter(reordered), is_m);
  std::ranges::copy_if(records, std::back_inserter(reordered), is_m);
  std::ranges::copy(reordered, records.begin());
  return true;
}

bool dwell_over_a_motion(Edit& edit) {
  const auto number = edit.any_of_kind(RecordKind::dwell);
  if (!number) return false;
  const bool back = edit.chance.once_in(2);
  const auto motion =
      back ? next_before(edit, *number, is_path) : next_behind(edit, *number, is_path);
  if (motion) move_before(edit, *number, back ? *motion : *motion + 1);
  return motion.has_value();
}

}  // namespace

std::vector<Operator> m_operators() {
  std::vector<Operator> all = {
      {"start-behind-a-cut", "the spindle, coolant or clamp behind a cut", start_behind_a_cut},
      {"start-behind-a-dwell", "the spindle or coolant behind a dwell", start_behind_a_dwell},
      {"stop-before-a-cut", "a stop before the cut", stop_before_a_cut},
      {"stop-within-a-cut", "a stop between the halves of a cut", stop_within_a_cut},
      {"end-before-a-motion", "the end of the program before its last motion", end_before_a_motion},
      {"m-within-a-cycle", "an M function between the motions of a cycle", m_within_a_cycle},
      {"m-behind-all", "all M functions behind all motions", m_behind_all},
      {"dwell-over-a-motion", "a dwell a motion early or late", dwell_over_a_motion},
  };
  for (Operator& each : all) each.orders_events = true;
  return all;
}

}  // namespace gonogo::mutations
