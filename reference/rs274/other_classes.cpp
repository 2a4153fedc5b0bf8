// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/other_classes.hpp"

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/code.hpp"

namespace gonogo::reference::rs274 {
namespace {

// Interpreters refuse these below zero as soon as they read them, before anything takes them.
constexpr Letters kWithoutSign = letters_of("D F H L P Q S T");
constexpr Letters kWhole = letters_of("H L T");
constexpr int kLastCode = 99;

bool is_at_code(const Alarm& alarm) {
  return alarm.word == WordName('G') || alarm.word == WordName('M');
}

// The word that the alarm is at; null: one that is missing, or none. Words stand as they were
// written.
const grammar::Word* word_of(const grammar::Block& block, const Alarm& alarm) {
  const auto begin = [](const grammar::Word& word) { return word.where.begin; };
  const auto found = std::ranges::lower_bound(block.words, alarm.where.begin, {}, begin);
  const bool is_there = found != block.words.end() && begin(*found) == alarm.where.begin &&
                        alarm.word == WordName(found->address);
  return is_there ? &*found : nullptr;
}

// J-ALM-04: one thing that has two names.
void admit_by_rule(Alarm& alarm) {
  const auto admit = [&](auto... classes) { (alarm.also.add(classes), ...); };
  switch (alarm.alarm) {
    case AlarmClass::value_sign:
    case AlarmClass::not_an_integer:
      return admit(AlarmClass::value_out_of_range);
    case AlarmClass::axis_not_in_plane:
      return admit(AlarmClass::unused_word, AlarmClass::conflicting_words);
    case AlarmClass::conflicting_words:  // two codes that take one axis word
      if (!is_at_code(alarm)) admit(AlarmClass::unused_word);
      if (alarm.clause == "NGC-OFS-15"_clause) admit(AlarmClass::duplicate_word);
      return;
    case AlarmClass::value_out_of_range:  // a parameter without a value
      if (alarm.clause == "NGC-PAR-03"_clause) admit(AlarmClass::missing_word);
      return;
    case AlarmClass::duplicate_word:  // two codes of a group
      if (is_at_code(alarm)) admit(AlarmClass::conflicting_words);
      return;
    case AlarmClass::missing_word:  // a motion for axis words; a number that counts as one outside
      if (is_at_code(alarm)) admit(AlarmClass::unused_word);
      if (alarm.clause == "NGC-OFS-03"_clause) admit(AlarmClass::value_out_of_range);
      if (alarm.clause == "NGC-POL-03"_clause) {  // a place without an angle
        admit(AlarmClass::value_out_of_range, AlarmClass::conflicting_words);
      }
      return;
    case AlarmClass::lead_missing:
    case AlarmClass::feed_missing:
      return admit(AlarmClass::missing_word);
    case AlarmClass::no_tool:
      return admit(AlarmClass::value_out_of_range);
    case AlarmClass::arc_radius:
      return admit(AlarmClass::arc_end_point);
    case AlarmClass::arc_end_point:
      return admit(AlarmClass::arc_radius);
    case AlarmClass::syntax:  // a line number
      if (alarm.word == WordName('N')) {
        admit(AlarmClass::value_out_of_range, AlarmClass::not_an_integer);
      }
      return;
    default:
      return;
  }
}

// J-ALM-04: what else the number is, beside what the alarm says of its word.
void admit_by_number(Alarm& alarm, char address, const Number& number) {
  const auto admit = [&](AlarmClass other) {
    alarm.also.add(other);
    alarm.also.add(AlarmClass::value_out_of_range);
  };
  const bool is_below = number.sign() < 0;
  const bool is_whole = number == number.floor();
  if (is_at_code(alarm)) {
    const bool is_none =
        alarm.alarm == AlarmClass::undefined_code || alarm.alarm == AlarmClass::not_an_integer;
    if (!is_none) return;
    alarm.also.add(AlarmClass::undefined_code);
    if (is_below) admit(AlarmClass::value_sign);
    if (!is_whole) alarm.also.add(AlarmClass::not_an_integer);
    if (number > Number(kLastCode)) alarm.also.add(AlarmClass::value_out_of_range);
    return;
  }
  const bool is_bounded =
      alarm.alarm == AlarmClass::value_out_of_range || alarm.alarm == AlarmClass::feed_missing;
  const bool has_no_sign = (kWithoutSign & letter_bit(address)) != 0;
  if (number.sign() <= 0 && is_bounded) admit(AlarmClass::value_sign);
  if (is_below && has_no_sign) admit(AlarmClass::value_sign);
  if (!is_whole && (kWhole & letter_bit(address)) != 0) admit(AlarmClass::not_an_integer);
}

}  // namespace

void admit_other_classes(const grammar::Block& block, std::vector<Alarm>& alarms) {
  for (Alarm& alarm : alarms) {
    admit_by_rule(alarm);
    const grammar::Word* const word = word_of(block, alarm);
    if (word != nullptr) admit_by_number(alarm, word->address, to_number(word->value));
  }
}

}  // namespace gonogo::reference::rs274
