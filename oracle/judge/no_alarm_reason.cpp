// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/no_alarm_reason.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

#include "oracle/judge/changed_program.hpp"
#include "oracle/region/constants.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle {

using reference::ClauseId;
using reference::kNoClause;
using reference::Record;
using reference::RecordKind;
using reference::share_a_name;

namespace {

// The clause of an item and its block; none of those that say neither.
struct ItemPlace {
  ClauseId clause = kNoClause;
  std::uint64_t block = 0;
};

ItemPlace clause_place_of(const reference::Item& item) {
  return std::visit(
      [](const auto& one) -> ItemPlace {
        if constexpr (requires { one.clause; }) {
          return {one.clause, one.block};
        } else {
          return {kNoClause, one.block};
        }
      },
      item);
}

// M functions of a block may stand anywhere in it, and a dwell of no time is nothing.
bool has_its_place(const reference::Item& item) {
  const auto* record = std::get_if<Record>(&item);
  if (record == nullptr) return true;
  const bool is_nothing = record->kind == RecordKind::dwell && record->seconds.sign() == 0;
  return record->kind != RecordKind::m && !is_nothing;
}

class AlarmSearch {
 public:
  AlarmSearch(const AlarmPlace& place, std::string_view alarm_class)
      : place_(place), class_(alarm_class) {}

  // R7: the catalog says which alarms are the other answer.
  void accept(std::uint64_t block, ClauseId clause) {
    const bool is_there = place_.block == 0 || block == place_.block;
    if (is_there && share_a_name(reference::clause(clause).refusals, class_)) accepted_ = clause;
  }

  // Whether to go on.
  bool take(const reference::Item& item) {
    ++items_;
    if (accepted_ && has_its_place(item)) answer_before_item();
    if (found_.answer == NoAlarmReason::Answer::other || items_ >= kMostItems) return false;
    const auto* record = std::get_if<Record>(&item);
    const ItemPlace from = clause_place_of(item);
    if (record != nullptr && record->kind == RecordKind::end) {
      // What stands behind the end is not run.
      if (first_ == kNoClause) first_ = record->clause;
      return false;
    }
    const bool is_there = place_.block != 0 ? from.block == place_.block : items_ >= place_.at;
    if (is_there && first_ == kNoClause) first_ = from.clause;
    // A call or a loop comes back to blocks with smaller numbers.
    if (items_ < place_.undone) return true;
    return place_.block != 0 && (from.block <= place_.block || accepted_);
  }

  // Nothing: the block can be read, and moves nothing.
  NoAlarmReason found() const {
    if (found_.answer != NoAlarmReason::Answer::none) return found_;
    return {first_, NoAlarmReason::Answer::none};
  }

 private:
  // The block that runs on has its first step here. The subject's alarm is the other answer where
  // nothing of this step has come, or of a later one, and all that is before it.
  void answer_before_item() {
    const bool is_late = items_ < place_.at || (items_ == place_.at && place_.is_begun);
    // In a block that has a number what is undone before it is a departure of its own.
    const bool is_early = place_.block == 0 && items_ > place_.undone;
    const bool tells_late = is_late && place_.block != 0;
    if (tells_late) found_ = {*accepted_, NoAlarmReason::Answer::late};
    if (!is_late && !is_early) found_ = {*accepted_, NoAlarmReason::Answer::other};
    accepted_.reset();
  }

  const AlarmPlace& place_;
  std::string_view class_;
  std::size_t items_ = 0;
  std::optional<ClauseId> accepted_;  // of a block whose first step has not come
  NoAlarmReason found_;
  ClauseId first_ = kNoClause;
};

}  // namespace

NoAlarmReason reason_for_no_alarm(const reference::Profile& profile, const ProgramText& program,
                                  const AlarmPlace& place, std::string_view alarm_class) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  AlarmSearch search(place, alarm_class);
  expander.on_acceptance(
      [&](std::uint64_t block, ClauseId clause) { search.accept(block, clause); });
  try {
    while (const reference::Item* item = expander.next()) {
      if (!search.take(*item)) break;
    }
  } catch (const exact::Undecided&) {
    // What was found so far stands.
  }
  NoAlarmReason found = search.found();
  if (found.clause == kNoClause) {
    found.clause = reference::find_dialect(profile.dialect)->syntax_clause;
  }
  return found;
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
    const auto found = alarm_of(profile, program, change, kMostItems);
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

}  // namespace gonogo::oracle
