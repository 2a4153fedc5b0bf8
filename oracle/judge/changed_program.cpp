// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/changed_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <variant>

#include "oracle/region/constants.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

using reference::AlarmClass;
using reference::AlarmReport;

namespace {

// What a line becomes; nothing: the program ends before it.
using LineChange = std::function<std::optional<std::string_view>(const grammar::Line& line)>;

// The program with other lines.
class ChangedProgram : public grammar::ByteSource {
 public:
  // What it is given must outlive it.
  ChangedProgram(const reference::Profile& profile, const ProgramText& program,
                 const LineChange& change)
      : input_(program), change_(change) {
    if (profile.takes_cr_for_blank()) input_.lines.take_cr_for_blank();
  }

  std::size_t read(char* data, std::size_t capacity) override {
    if (at_ == text_.size()) {
      grammar::Line line;
      if (!input_.lines.next(line)) return 0;
      const std::optional<std::string_view> left = change_(line);
      if (!left) return 0;
      text_ = *left;
      text_ += '\n';
      at_ = 0;
    }
    const std::size_t count = std::min(capacity, text_.size() - at_);
    std::copy_n(text_.data() + at_, count, data);
    at_ += count;
    return count;
  }

 private:
  ProgramInput input_;
  const LineChange& change_;
  std::string text_;
  std::size_t at_ = 0;
};

// The alarm with which it ends; nothing: it has none among so many items.
std::optional<AlarmReport> alarm_with(const reference::Profile& profile, const ProgramText& program,
                                      const LineChange& change, std::size_t most_items) {
  ChangedProgram bytes(profile, program, change);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::judged);
  for (std::size_t items = 0; items < most_items; ++items) {
    const reference::Item* item = expander.next();
    if (item == nullptr) return std::nullopt;
    if (const auto* report = std::get_if<AlarmReport>(item)) return *report;
  }
  return std::nullopt;
}

}  // namespace

std::optional<AlarmReport> alarm_of(const reference::Profile& profile, const ProgramText& program) {
  const auto as_it_is = [](const grammar::Line& line) { return std::optional(line.text); };
  return alarm_with(profile, program, as_it_is, kMostItems);
}

namespace {

// The line with blanks for the words at fault.
std::string without_faults(std::string_view line, const reference::AlarmReport& report) {
  std::string text(line);
  for (const reference::Alarm& alarm : report.alarms) {
    const std::size_t begin = std::min<std::size_t>(alarm.where.begin, text.size());
    const std::size_t end = std::min<std::size_t>(alarm.where.end, text.size());
    if (begin < end)
      std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(begin), end - begin, ' ');
  }
  return text;
}

}  // namespace

bool alarms_without(const reference::Profile& profile, const ProgramText& program,
                    const reference::AlarmReport& report, const SubjectAlarm& alarm) {
  std::string left;
  const auto alarms = [&](bool keeps_rest) {
    const auto change = [&](const grammar::Line& line) -> std::optional<std::string_view> {
      if (line.number != report.block) return line.text;
      left = keeps_rest ? without_faults(line.text, report) : std::string();
      return left;
    };
    const auto found = alarm_with(profile, program, change, kMostItems);
    const bool is_later = found && found->block > report.block;
    const bool is_block = is_later && (alarm.block == 0 || found->block == alarm.block);
    return is_block && admits(*found, alarm.alarm_class);
  };
  try {
    return alarms(false) || alarms(true);
  } catch (const exact::Undecided&) {
    return false;  // nothing says that it does
  }
}

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
  std::optional<AlarmReport> report = alarm_with(profile, program, cut, kMostItems / kMostTimes);
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
