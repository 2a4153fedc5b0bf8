// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/alarm_ground.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

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
struct Ground {
  ClauseId clause = kNoClause;
  std::uint64_t block = 0;
};

Ground ground_of(const reference::Item& item) {
  return std::visit(
      [](const auto& one) -> Ground {
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

// The program with an empty line in place of one block.
class ProgramWithoutBlock : public grammar::ByteSource {
 public:
  ProgramWithoutBlock(const reference::Profile& profile, const ProgramText& program,
                      std::uint64_t block)
      : input_(program), block_(block) {
    if (profile.takes_cr_for_blank()) input_.lines.take_cr_for_blank();
  }

  std::size_t read(char* data, std::size_t capacity) override {
    grammar::Line line;
    if (at_ == text_.size()) {
      if (!input_.lines.next(line)) return 0;
      text_ = line.number == block_ ? std::string_view() : line.text;
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
  std::uint64_t block_;
  std::string text_;
  std::size_t at_ = 0;
};

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
    if (found_.answer == AlarmGround::Answer::other || items_ >= kMostItems) return false;
    const auto* record = std::get_if<Record>(&item);
    const Ground ground = ground_of(item);
    if (record != nullptr && record->kind == RecordKind::end) {
      // What stands behind the end is not run.
      if (first_ == kNoClause) first_ = record->clause;
      return false;
    }
    const bool is_there = place_.block != 0 ? ground.block == place_.block : items_ >= place_.at;
    if (is_there && first_ == kNoClause) first_ = ground.clause;
    // A call or a loop comes back to blocks with smaller numbers.
    if (items_ < place_.undone) return true;
    return place_.block != 0 && (ground.block <= place_.block || accepted_);
  }

  // Nothing: the block can be read, and moves nothing.
  AlarmGround found() const {
    if (found_.answer != AlarmGround::Answer::none) return found_;
    return {first_, AlarmGround::Answer::none};
  }

 private:
  // The block that runs on has its first step here. The subject's alarm is the other answer where
  // nothing of this step has come, or of a later one, and all that is before it.
  void answer_before_item() {
    const bool is_late = items_ < place_.at || (items_ == place_.at && place_.is_begun);
    // In a block that has a number what is undone before it is a departure of its own.
    const bool is_early = place_.block == 0 && items_ > place_.undone;
    const bool tells_late = is_late && place_.block != 0;
    if (tells_late) found_ = {*accepted_, AlarmGround::Answer::late};
    if (!is_late && !is_early) found_ = {*accepted_, AlarmGround::Answer::other};
    accepted_.reset();
  }

  const AlarmPlace& place_;
  std::string_view class_;
  std::size_t items_ = 0;
  std::optional<ClauseId> accepted_;  // of a block whose first step has not come
  AlarmGround found_;
  ClauseId first_ = kNoClause;
};

}  // namespace

AlarmGround ground_of_alarm(const reference::Profile& profile, const ProgramText& program,
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
  AlarmGround found = search.found();
  if (found.clause == kNoClause) {
    found.clause = reference::find_dialect(profile.dialect)->syntax_clause;
  }
  return found;
}

bool alarms_without_block(const reference::Profile& profile, const ProgramText& program,
                          std::uint64_t block, const SubjectAlarm& alarm) {
  ProgramWithoutBlock bytes(profile, program, block);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::judged);
  try {
    const reference::Item* item = expander.next();
    for (std::size_t items = 0; item != nullptr && items < kMostItems; ++items) {
      const auto* report = std::get_if<reference::AlarmReport>(item);
      if (report != nullptr) {
        return report->block == alarm.block && admits(*report, alarm.alarm_class);
      }
      item = expander.next();
    }
  } catch (const exact::Undecided&) {
    // Nothing says that it does.
  }
  return false;
}

}  // namespace gonogo::oracle
