// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/unreadable_block.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "oracle/judge/changed_program.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

using reference::AlarmClass;
using reference::AlarmReport;

namespace {

// A word that is missing may have come behind the fault; what these say stays.
constexpr std::array kStandingAlarms = {
    AlarmClass::undefined_code,     AlarmClass::duplicate_word, AlarmClass::conflicting_words,
    AlarmClass::value_out_of_range, AlarmClass::value_sign,     AlarmClass::not_an_integer};

// Those of some classes between blanks.
std::string standing_among(std::string_view classes) {
  std::string standing;
  for (const AlarmClass one : kStandingAlarms) {
    if (reference::has_name(classes, reference::name(one))) {
      standing += fmt::format("{} ", reference::name(one));
    }
  }
  return standing;
}

// The alarms of the block where it is cut there; nothing: none.
std::optional<AlarmReport> alarms_of_cut(const reference::Profile& profile,
                                         const ProgramText& program, std::uint64_t block,
                                         std::size_t length) {
  const auto cut = [&](const grammar::Line& line) {
    const std::string_view left = line.number == block ? line.text.substr(0, length) : line.text;
    return line.number <= block ? std::optional(left) : std::nullopt;
  };
  // Fewer than elsewhere, for each cut is run.
  std::optional<AlarmReport> report = alarm_of(profile, program, cut, kMostItems / kMostTimes);
  return report && report->block == block ? report : std::nullopt;
}

}  // namespace

bool has_alarm_before_fault(const reference::Profile& profile, const ProgramText& program,
                            const AlarmReport& report, std::string_view alarm_class) {
  const std::string standing = standing_among(alarm_class);
  if (!report.syntax || standing.empty()) return false;
  std::size_t length = report.syntax->where.begin;
  for (std::size_t cuts = 0; cuts < kMostCuts; ++cuts, --length) {
    const auto before = alarms_of_cut(profile, program, report.block, length);
    if (!before) return false;
    if (!before->syntax) return admits(*before, standing);
    if (length == 0) return false;
  }
  return false;
}

}  // namespace gonogo::oracle
