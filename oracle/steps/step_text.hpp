// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records, levels, alarms and points as the texts of a verdict.
#pragma once

#include <string>
#include <variant>

#include "oracle/records/point_text.hpp"
#include "oracle/records/subject_outcome.hpp"
#include "oracle/steps/reference_steps.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

std::string record_text(const reference::Record& record);
std::string level_text(const reference::PocketLevel& level);
// A thread with the pass that is due.
std::string thread_text(const reference::ThreadMilling& thread, const Number& pass);
std::string helix_text(const reference::HelixPocket& pocket);
std::string pocket_text(const reference::PocketMilling& pocket);
std::string alarms_text(const reference::AlarmReport& report);
std::string alarm_text(const SubjectAlarm& alarm);
// What a step of the reference says; nothing for those that need none.
std::string step_text(const ReferenceStep& step);
// The clause and the block of a step, or of an item; nothing for those that have none.
template <typename... Kinds>
reference::ClauseId clause_of(const std::variant<Kinds...>& step) {
  return std::visit(
      [](const auto& one) {
        if constexpr (requires { one.record.clause; })
          return one.record.clause;
        else if constexpr (requires { one.clause; })
          return one.clause;
        else
          return reference::kNoClause;
      },
      step);
}
template <typename... Kinds>
std::uint64_t block_of(const std::variant<Kinds...>& step) {
  return std::visit(
      [](const auto& one) {
        if constexpr (requires { one.record.block; })
          return one.record.block;
        else
          return one.block;
      },
      step);
}
// {"x":"1","z":"2"}
std::string point_text(const reference::Position& point, reference::AxisSet axes);
// Exact, as in a record but without quotes round it.
std::string exact_text(const reference::Number& value);

// A verdict on the subject's record number `number`, with its line and its text.
Verdict verdict_on(VerdictKind kind, const reference::Record& got, std::size_t number,
                   std::string message);
// What is not judged because two numbers cannot be distinguished.
Verdict undecided_verdict(const exact::Undecided& undecided);

}  // namespace gonogo::oracle
