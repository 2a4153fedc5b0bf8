// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-04: the classes that another reader gives a broken rule. No text of the maker names any.
#include "reference/clause.hpp"
#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// Whether the word that the alarm is about has a number, and none above zero.
bool is_not_positive(const BlockWords& words, const Alarm& alarm) {
  if (alarm.word.text().size() != 1) return false;
  const char address = alarm.word.text().front();
  return words.has(address) && words.written(address).sign() <= 0;
}

void admit_by_rule(const BlockWords& words, Alarm& alarm) {
  switch (alarm.alarm) {
    case AlarmClass::value_out_of_range:
      if (is_not_positive(words, alarm)) alarm.also.add(AlarmClass::value_sign);
      return;
    case AlarmClass::not_an_integer:
    case AlarmClass::taper_limit:
    case AlarmClass::tool_too_large:
    case AlarmClass::step_too_large:
    case AlarmClass::depth_exceeds_tool:
      return alarm.also.add(AlarmClass::value_out_of_range);
    case AlarmClass::feed_missing:
    case AlarmClass::lead_missing:
      return alarm.also.add(AlarmClass::missing_word);
    case AlarmClass::duplicate_word:  // of two codes of one group
      if (alarm.word == 'G') alarm.also.add(AlarmClass::conflicting_words);
      return;
    case AlarmClass::axis_not_in_plane:
      alarm.also.add(AlarmClass::conflicting_words);
      return alarm.also.add(AlarmClass::unused_word);
    case AlarmClass::arc_radius:
      return alarm.also.add(AlarmClass::arc_end_point);
    case AlarmClass::arc_end_point:
      return alarm.also.add(AlarmClass::arc_radius);
    default:
      return;
  }
}

}  // namespace

void admit_other_classes(const BlockContext& block) {
  for (Alarm& alarm : block.out.alarms) {
    if (!is_silent(alarm.clause)) admit_by_rule(block.words, alarm);
  }
}

}  // namespace gonogo::reference::gsk988ta
