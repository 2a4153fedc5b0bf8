// SPDX-License-Identifier: GPL-3.0-or-later
//
// M functions, dwells, alarms and the end.
#include <algorithm>

#include "operator.hpp"

namespace gonogo::mutations {
namespace {

using oracle::RunEnd;

bool alarms(const Edit& edit) {
  return edit.specimen.right.end.kind == RunEnd::Kind::alarm;
}

void add_m(Edit& edit, std::size_t number) {
  Record record;
  record.kind = RecordKind::m;
  record.m = 8;
  record.block = edit.right(number).block;
  edit.insert(number, record);
}

// Over a motion of another block, or to a place anywhere.
bool move_m(Edit& edit) {
  const auto number = edit.any_of_kind(RecordKind::m);
  const auto motion = edit.any_motion();
  if (!number || !motion) return false;
  const Record record = edit.right(*number);
  edit.erase(*number);
  edit.insert(*motion < *number ? *motion : *motion - 1, record);
  return true;
}

void change_dwell(Edit& edit, std::size_t number) {
  Number& seconds = edit.trace.records[number].seconds;
  seconds =
      edit.chance.once_in(2) ? seconds * 1000 + Number(1) : seconds + Number::millionths(10'000);
}

void add_dwell(Edit& edit, std::size_t number) {
  Record record;
  record.kind = RecordKind::dwell;
  record.seconds = Number(1) / 2;
  record.block = edit.right(number).block;
  edit.insert(number + edit.chance.below(2), record);
}

bool no_alarm(Edit& edit) {
  if (!alarms(edit)) return false;
  edit.trace.end = RunEnd{};
  return true;
}

bool alarm_where_none_is(Edit& edit) {
  const auto number = edit.any_motion();
  if (alarms(edit) || !number) return false;
  edit.trace.end.kind = RunEnd::Kind::alarm;
  edit.trace.end.alarm.block = edit.right(*number).block;
  edit.trace.end.alarm.alarm_class = "value-out-of-range";
  // With the motions of the blocks before it.
  std::erase_if(edit.trace.records, [&](const Record& record) {
    return record.kind == RecordKind::end || record.block >= edit.right(*number).block;
  });
  return true;
}

bool alarm_in_another_class(Edit& edit) {
  if (!alarms(edit)) return false;
  // In a block that cannot be read an undefined code before that place is as good (R6).
  for (const auto other : {reference::AlarmClass::no_tool, reference::AlarmClass::pocket_size,
                           reference::AlarmClass::lead_missing}) {
    if (std::ranges::find(edit.specimen.admissible, other) == edit.specimen.admissible.end()) {
      edit.trace.end.alarm.alarm_class = reference::name(other);
      return true;
    }
  }
  return false;
}

bool alarm_in_a_later_block(Edit& edit) {
  if (!alarms(edit)) return false;
  ++edit.trace.end.alarm.block;
  return true;
}

bool alarm_in_an_earlier_block(Edit& edit) {
  if (!alarms(edit) || edit.specimen.right.end.alarm.block < 2) return false;
  --edit.trace.end.alarm.block;
  const std::uint64_t block = edit.trace.end.alarm.block;
  std::erase_if(edit.trace.records, [&](const Record& record) { return record.block >= block; });
  return true;
}

bool alarm_before_all_motion(Edit& edit) {
  if (!alarms(edit) || !edit.any_motion()) return false;
  edit.trace.records.clear();
  return true;
}

bool alarm_after_motion_of_its_block(Edit& edit) {
  if (!alarms(edit)) return false;
  reference::Position to = edit.specimen.profile.initial.at;
  if (!edit.specimen.after.empty()) to = edit.specimen.after.back();
  to[edit.chance.one_of(reference::kLinearAxes)] += edit.off();
  edit.trace.records.push_back(
      edit.motion_to(RecordKind::rapid, edit.specimen.right.end.alarm.block, to));
  return true;
}

void other_end_position(Edit& edit, std::size_t number) {
  edit.trace.records[number].to[edit.chance.one_of(reference::kAllAxes)] += edit.off();
}

}  // namespace

std::vector<Operator> event_operators() {
  return {
      {"drop-m", "an M function is missing", to_any(RecordKind::m, &Edit::erase)},
      {"add-m", "an M function more", to_any_motion(add_m)},
      {"repeat-m", "an M function comes twice",
       to_any(RecordKind::m, [](Edit& edit, std::size_t i) { edit.insert(i, edit.right(i)); })},
      {"change-m", "another M function",
       to_any(RecordKind::m, [](Edit& edit, std::size_t i) { ++edit.trace.records[i].m; })},
      {"move-m", "an M function stands elsewhere among the motions", move_m},
      {"drop-dwell", "a dwell is missing", to_any(RecordKind::dwell, &Edit::erase)},
      {"change-dwell", "a dwell is longer", to_any(RecordKind::dwell, change_dwell)},
      {"add-dwell", "a dwell more", to_any_motion(add_dwell)},
      {"no-alarm", "the alarm is missing", no_alarm},
      {"alarm-where-none-is", "an alarm in a program without fault", alarm_where_none_is},
      {"alarm-in-another-class", "the alarm is of another class", alarm_in_another_class},
      {"alarm-in-a-later-block", "the alarm names the next block", alarm_in_a_later_block},
      {"alarm-in-an-earlier-block", "the alarm comes a block too early", alarm_in_an_earlier_block},
      {"alarm-before-all-motion", "the alarm comes before any motion", alarm_before_all_motion},
      {"alarm-after-motion", "the alarm comes after motion of its block",
       alarm_after_motion_of_its_block},
      {"other-end-position", "the end says another place",
       to_any(RecordKind::end, other_end_position)},
  };
}

}  // namespace gonogo::mutations
