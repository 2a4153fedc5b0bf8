// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/unreadable_block.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "reference/expander.hpp"

namespace gonogo::relation {

using reference::AlarmClass;
using reference::AlarmReport;

namespace {

// What is missing may stand behind the fault; these stay in any case.
constexpr std::array kLasting = {AlarmClass::undefined_code,     AlarmClass::duplicate_word,
                                 AlarmClass::conflicting_words,  AlarmClass::value_sign,
                                 AlarmClass::value_out_of_range, AlarmClass::not_an_integer};

// The lines of the program, each with what `part` leaves of it; until that is nothing.
template <typename Part>
std::string lines_of(const reference::Profile& profile, std::string_view program, Part part) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  if (profile.takes_cr_for_blank()) lines.take_cr_for_blank();
  std::string text;
  for (grammar::Line line; lines.next(line);) {
    const std::optional<std::string_view> left = part(line);
    if (!left) break;
    text += *left;
    text += '\n';
  }
  return text;
}

// The program as far as a place of one of its lines.
std::string cut_at(const reference::Profile& profile, std::string_view program, std::uint64_t block,
                   std::size_t length) {
  return lines_of(profile, program, [&](const grammar::Line& line) {
    const std::string_view left = line.number == block ? line.text.substr(0, length) : line.text;
    return line.number <= block ? std::optional(left) : std::nullopt;
  });
}

// Without a block, or with blanks for its words at fault.
std::string without(const reference::Profile& profile, std::string_view program,
                    const AlarmReport& report, bool keeps_rest) {
  std::string left;
  return lines_of(profile, program, [&](const grammar::Line& line) {
    if (line.number != report.block) return std::optional(line.text);
    left = keeps_rest ? line.text : std::string_view();
    for (const reference::Alarm& alarm : report.alarms) {
      for (std::size_t at = alarm.where.begin; at < alarm.where.end && at < left.size(); ++at) {
        left[at] = ' ';
      }
    }
    return std::optional(std::string_view(left));
  });
}

// The alarm with which the program ends; nothing: without one.
std::optional<AlarmReport> alarm_of(const reference::Profile& profile, std::string_view program) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::judged);
  std::optional<AlarmReport> found;
  while (const reference::Item* item = expander.next()) {
    if (const auto* report = std::get_if<AlarmReport>(item)) found = *report;
  }
  return found;
}

}  // namespace

bool alarms_without(const reference::Profile& profile, std::string_view program,
                    const AlarmReport& report, const oracle::SubjectAlarm& alarm) {
  return std::ranges::any_of(std::array{false, true}, [&](bool keeps_rest) {
    const auto found = alarm_of(profile, without(profile, program, report, keeps_rest));
    const bool is_later = found && found->block > report.block;
    const bool is_block = is_later && (alarm.block == 0 || found->block == alarm.block);
    return is_block && admits(*found, alarm.alarm_class);
  });
}

bool alarms_before_fault(const reference::Profile& profile, std::string_view program,
                         const AlarmReport& report, std::string_view alarm_class) {
  if (!report.syntax) return false;
  // Back to where the line can be read.
  for (std::size_t length = report.syntax->where.begin + 1; length-- > 0;) {
    const auto found = alarm_of(profile, cut_at(profile, program, report.block, length));
    if (!found || found->block != report.block) return false;
    if (found->syntax) continue;
    return std::ranges::any_of(kLasting, [&](AlarmClass one) {
      return reference::has_name(alarm_class, name(one)) && admits(*found, name(one));
    });
  }
  return false;
}

}  // namespace gonogo::relation
