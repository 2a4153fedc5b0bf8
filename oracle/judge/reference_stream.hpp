// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference's side of a comparison: motions with their starts, dropped and joined as the judge
// wants them, and everything that lies between.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "oracle/judge/motion.hpp"
#include "oracle/judge/queue.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

struct JudgeTerms;
struct PlainMotion;

// What the subject has to do next. M functions come as they are met.
using ReferenceStep =
    std::variant<Motion, Record, reference::PocketLevel, reference::HelixPocket,
                 reference::ThreadMilling, reference::PocketMilling, reference::Renaming,
                 reference::AlarmReport, reference::NotCovered>;

bool is_m_function(const ReferenceStep& step);
// The M function that a cycle has among its motions (J-CMP-05); null: another step.
const Record* placed_m_function(const ReferenceStep& step);

class ReferenceStream {
 public:
  ReferenceStream(const reference::Profile& profile, grammar::LineSource& lines,
                  const JudgeTerms& terms);

  // The current step: a motion, a dwell, an M function, a level, or the end (an `end` record, an
  // alarm, not covered), which stays.
  const ReferenceStep& current();
  // The first step that is no M function, which do not hold up the motions round them.
  const ReferenceStep& behind_m_functions();
  // Goes on to the next one.
  void advance();
  bool at_end();

  // What the filter of equal records takes past the steps, and where it leaves off.
  // The motion behind the current step, where that is `last` and nothing else is between or waits;
  // else null. Once it is taken, `next_item` comes behind it.
  const Motion* beyond_same(const Motion& last) const;
  const reference::Item* next_item();
  // `last` waits to be joined, and `ahead` (null: nothing yet) has been put out behind it.
  void go_on_behind(const PlainMotion& last, const reference::Item* ahead);

  // After a level the reference goes on from where the subject left it: the cycle says where it
  // ends in the plane.
  void go_on_from(const Position& position) {
    position_ = position;
    dropped_ = {position, {}};
    dropped_in_a_row_ = 0;
  }
  // After a path that is open the reference stands where the subject left it; blocks that follow
  // start from there in the plane. Only while that step is the current one: nothing of a later
  // block has been asked for then.
  void stand_at(const Position& position);
  // Whether that was ever said: then items hang on what the subject did.
  bool was_moved() const { return was_moved_; }
  const Position& position() const { return position_; }
  // What was dropped since the last motion that was kept. Of the current step, unless that is a
  // motion, which says it itself.
  const Dropped& dropped() const { return dropped_; }
  // Whether an M function that has a place among motions is due now, or right after the current
  // step.
  bool placed_m_function_ahead();
  // Whether the position gets a new name now, or right after the current step.
  bool renaming_ahead();
  // The place of the last motion that was left behind, as `Motion::number`; 0: none.
  std::size_t passed() const { return passed_; }
  // Items that the reference has put out so far.
  std::size_t items() const { return items_; }
  // The same, with the records that the passes of a thread would be.
  std::size_t items_and_passes() const { return items_ + passes_; }
  const reference::ReadingsInUse& readings() const { return expander_.readings(); }
  // The text of the line that alarms, at the alarm.
  std::string_view failed_line() const { return expander_.failed_line(); }

 private:
  void pull();
  void take(const reference::Item& item);
  void take_motion(const Record& record);
  void count_passes(const reference::ThreadMilling& thread);
  void drop(const Motion& motion);
  void flush();

  const JudgeTerms& terms_;
  reference::Expander expander_;
  Position position_;  // where the motions so far end
  Dropped dropped_;    // since the last one that was kept, which ends where it `stood`
  std::optional<Motion> pending_;
  Queue<ReferenceStep> ready_;
  std::size_t items_ = 0;
  std::size_t passes_ = 0;
  std::size_t passed_ = 0;
  std::size_t dropped_in_a_row_ = 0;
  bool was_moved_ = false;
};

}  // namespace gonogo::oracle
