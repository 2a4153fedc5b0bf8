// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/no_alarm_reason.hpp"

#include <optional>
#include <variant>

#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle {

using reference::ClauseId;
using reference::kNoClause;
using reference::Record;
using reference::RecordKind;
using reference::share_a_name;

namespace {

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
    const std::uint64_t block = block_of(item);
    if (record != nullptr && record->kind == RecordKind::end) {
      // What stands behind the end is not run.
      if (first_ == kNoClause) first_ = record->clause;
      return false;
    }
    const bool is_there = place_.block != 0 ? block == place_.block : items_ >= place_.at;
    if (is_there && first_ == kNoClause) first_ = clause_of(item);
    // A call or a loop comes back to blocks with smaller numbers.
    if (items_ < place_.undone) return true;
    return place_.block != 0 && (block <= place_.block || accepted_);
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

}  // namespace gonogo::oracle
