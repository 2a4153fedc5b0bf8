// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/silence.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "reference/outcome.hpp"

namespace gonogo::relation {

using reference::AlarmClass;

bool is_silent(reference::ClauseId clause) {
  return clause != reference::kNoClause &&
         reference::clause(clause).basis() == reference::Basis::silent;
}

namespace {

struct OtherAnswer {
  reference::ClauseId clause;
  AlarmClass alarm;
};
std::span<const OtherAnswer> other_answers() {
  using reference::operator""_clause;
  static constexpr std::array kAnswers = {
      OtherAnswer{"SIE-G1-04"_clause, AlarmClass::spindle_stopped},
      OtherAnswer{"SIE-COM-04"_clause, AlarmClass::duplicate_word},
      OtherAnswer{"GSK-COM-10"_clause, AlarmClass::unused_word},
      OtherAnswer{"HNC-COM-07"_clause, AlarmClass::unused_word},
      OtherAnswer{"GSK-COM-12"_clause, AlarmClass::value_sign},
      OtherAnswer{"GSK-COM-12"_clause, AlarmClass::value_out_of_range},
      OtherAnswer{"HNC-COM-04"_clause, AlarmClass::value_sign},
      OtherAnswer{"HNC-COM-04"_clause, AlarmClass::value_out_of_range},
      OtherAnswer{"GSK-COM-13"_clause, AlarmClass::syntax},
      OtherAnswer{"GSK-COM-13"_clause, AlarmClass::duplicate_word},
      OtherAnswer{"HNC-COM-06"_clause, AlarmClass::syntax},
      OtherAnswer{"HNC-COM-06"_clause, AlarmClass::duplicate_word},
      OtherAnswer{"NGC-OWD-09"_clause, AlarmClass::syntax}};
  return kAnswers;
}

}  // namespace

bool is_other_answer(reference::ClauseId clause, std::string_view alarm_class) {
  return std::ranges::any_of(other_answers(), [&](const OtherAnswer& other) {
    return other.clause == clause && reference::has_name(alarm_class, reference::name(other.alarm));
  });
}

}  // namespace gonogo::relation
