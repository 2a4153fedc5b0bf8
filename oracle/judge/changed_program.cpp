// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/changed_program.hpp"

#include <algorithm>
#include <utility>

#include "reference/expander.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;

ChangedProgram::ChangedProgram(const reference::Profile& profile, const ProgramText& program,
                               Change change)
    : input_(program), change_(std::move(change)) {
  if (profile.takes_cr_for_blank()) input_.lines.take_cr_for_blank();
}

std::size_t ChangedProgram::read(char* data, std::size_t capacity) {
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

std::optional<AlarmReport> alarm_of(const reference::Profile& profile, const ProgramText& program,
                                    ChangedProgram::Change change, std::size_t most_items) {
  ChangedProgram bytes(profile, program, std::move(change));
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::judged);
  for (std::size_t items = 0; items < most_items; ++items) {
    const reference::Item* item = expander.next();
    if (item == nullptr) return std::nullopt;
    if (const auto* report = std::get_if<AlarmReport>(item)) return *report;
  }
  return std::nullopt;
}

}  // namespace gonogo::oracle
