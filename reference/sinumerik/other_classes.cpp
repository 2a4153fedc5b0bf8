// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-04: the classes that another reader gives a broken rule. Alarm 14040 of the control is that
// of every arc that cannot be, 14048 of every wrong TURN.
#include "reference/clause.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

bool is_below_zero(const BlockWords& words, Address address) {
  return words.has(address) && words.written(address).sign() < 0;
}

void admit_by_rule(const BlockWords& words, Alarm& alarm) {
  switch (alarm.alarm) {
    case AlarmClass::not_an_integer:
    case AlarmClass::value_sign:
      return alarm.also.add(AlarmClass::value_out_of_range);
    case AlarmClass::value_out_of_range:
      for (const Address address : {Address::ar, Address::turn}) {
        const bool is_sign = alarm.word == name_of(address) && is_below_zero(words, address);
        if (is_sign) alarm.also.add(AlarmClass::value_sign);
      }
      return;
    case AlarmClass::feed_missing:
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

void admit_other_classes(BlockContext& block) {
  for (Alarm& alarm : block.out.alarms) {
    if (!is_silent(alarm.clause)) admit_by_rule(block.words, alarm);
  }
}

}  // namespace gonogo::reference::sinumerik
