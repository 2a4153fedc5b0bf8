// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hnc21t/other_classes.hpp"

#include "reference/clause.hpp"

namespace gonogo::reference::hnc21t {
namespace {

// Whether the word that the alarm is about has a number, and none above zero.
bool is_not_positive(const BlockWords& words, const Alarm& alarm) {
  if (alarm.word.text().size() != 1) return false;
  const char address = alarm.word.text().front();
  return words.has(address) && words.written(address).sign() <= 0;
}

void admit_by_rule(const BlockWords& words, Alarm& alarm) {
  switch (alarm.alarm) {
    case AlarmClass::not_an_integer:
      if (is_not_positive(words, alarm)) alarm.also.add(AlarmClass::value_sign);
      return alarm.also.add(AlarmClass::value_out_of_range);
    case AlarmClass::value_sign:
    case AlarmClass::retract_ratio:
      return alarm.also.add(AlarmClass::value_out_of_range);
    case AlarmClass::undefined_code:  // an address that the control lacks
      if (alarm.word == WordName('G')) return;
      alarm.also.add(AlarmClass::unused_word);
      return alarm.also.add(AlarmClass::conflicting_words);
    case AlarmClass::retract_pair:
    case AlarmClass::feed_missing:
    case AlarmClass::lead_missing:
      return alarm.also.add(AlarmClass::missing_word);
    case AlarmClass::arc_radius:
      return alarm.also.add(AlarmClass::arc_end_point);
    case AlarmClass::arc_end_point:
      return alarm.also.add(AlarmClass::arc_radius);
    default:
      return;
  }
}

}  // namespace

void admit_other_classes(const BlockWords& words, std::vector<Alarm>& alarms) {
  for (Alarm& alarm : alarms) {
    if (!is_silent(alarm.clause)) admit_by_rule(words, alarm);
  }
}

}  // namespace gonogo::reference::hnc21t
