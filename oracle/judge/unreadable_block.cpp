// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/unreadable_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "oracle/region/constants.hpp"
#include "reference/expander.hpp"

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

// The program as far as a block, of which only the first bytes are left.
class CutProgram : public grammar::ByteSource {
 public:
  CutProgram(const reference::Profile& profile, const ProgramText& program, std::uint64_t block,
             std::size_t length)
      : input_(program), block_(block), length_(length) {
    if (profile.takes_cr_for_blank()) input_.lines.take_cr_for_blank();
  }

  std::size_t read(char* data, std::size_t capacity) override {
    if (at_ == text_.size() && !next_line()) return 0;
    const std::size_t count = std::min(capacity, text_.size() - at_);
    std::copy_n(text_.data() + at_, count, data);
    at_ += count;
    return count;
  }

 private:
  bool next_line() {
    grammar::Line line;
    if (!input_.lines.next(line) || line.number > block_) return false;
    text_ = line.text.substr(0, line.number == block_ ? length_ : std::string::npos);
    text_ += '\n';
    at_ = 0;
    return true;
  }

  ProgramInput input_;
  std::uint64_t block_;
  std::size_t length_;
  std::string text_;
  std::size_t at_ = 0;
};

// The alarms of the block where it is cut there; nothing: none.
std::optional<AlarmReport> alarms_of_cut(const reference::Profile& profile,
                                         const ProgramText& program, std::uint64_t block,
                                         std::size_t length) {
  CutProgram bytes(profile, program, block, length);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::judged);
  // Fewer than elsewhere, for each cut is run.
  for (std::size_t items = 0; items < kMostItems / kMostTimes; ++items) {
    const reference::Item* item = expander.next();
    if (item == nullptr) return std::nullopt;
    const auto* report = std::get_if<AlarmReport>(item);
    if (report != nullptr && report->block == block) return *report;
  }
  return std::nullopt;
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
