// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference's side of a comparison: its steps by their numbers, each asked for when it is
// looked at, and kept until no reading of the subject's motions looks back at it.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "oracle/motion/curve.hpp"
#include "oracle/steps/m_functions.hpp"
#include "oracle/steps/queue.hpp"
#include "oracle/steps/watched_reference.hpp"

namespace gonogo::oracle {

// What the subject has to do next: a motion, a dwell, something whose path is open, or the end (an
// `end` record, an alarm, not covered), which is the last step unless it is unstated. M functions
// stand between them.
using ReferenceStep =
    std::variant<Motion, Record, reference::PocketLevel, reference::HelixPocket,
                 reference::ThreadMilling, reference::PocketMilling, reference::Renaming,
                 reference::AlarmReport, reference::NotCovered>;

bool is_end(const ReferenceStep& step);
// Whether the tool cuts.
bool cuts(const ReferenceStep& step);
const Record* dwell_of(const ReferenceStep& step);  // null: another step

class ReferenceSteps {
 public:
  // `watched`: as of a WatchedReference.
  ReferenceSteps(const reference::Profile& profile, const ProgramText& program,
                 const Tolerances& tolerances, const AssignmentSet* watched, Forking forking);

  struct Step {
    ReferenceStep what;
    Position place;                // where the reference stands before it
    std::size_t item = 0;          // its number among the items of the reference, from 1
    std::uint64_t block = 0;       // its line, declared or not; 0: it has none
    std::uint64_t cut_block = 0;   // the line of the last cut before it
    std::uint64_t left_block = 0;  // the line of the step before it; 0: it is the first
    std::size_t m_functions = 0;   // how many of them come before it
    mutable std::shared_ptr<const Curve> curve = {};  // of a motion, once it has been asked for
  };

  // REQUIRES: no step before this one is the last one, and this one has not been forgotten.
  const Step& at(std::size_t number);
  // For messages: null where it is forgotten, or nobody has asked for it yet.
  const Step* known(std::size_t number) const;
  // For a step that is a motion.
  const std::shared_ptr<const Curve>& curve_of(const Step& step) const;
  void forget_before(std::size_t number);

  // M functions that the subject has not passed on, in their order: of so many that are due before
  // a step (Step::m_functions), and of all steps that were asked for.
  std::span<const DueMFunction> waiting(std::size_t m_functions) const {
    const std::size_t due = m_functions - std::min(m_functions, taken_m_functions_);
    return waiting().first(std::min(due, m_functions_.size()));
  }
  std::span<const DueMFunction> waiting() const {
    return {m_functions_.begin(), m_functions_.end()};
  }
  // The first of them has come.
  void take_m_function();
  // Brings one of them to the front (R5): it stands so far behind the first, and in its block.
  void bring_forward(std::size_t place);
  // Nobody asks for those that follow.
  void leave_out_m_functions() { leaves_out_m_functions_ = true; }

  // After step `number`, whose path is open, the reference goes on from where the subject left it.
  // `moves_machine`: blocks that follow start from there, too. False where it goes on from
  // elsewhere already, because the subject's motions have been read in another way.
  [[nodiscard]] bool go_on_from(std::size_t number, const Position& place, bool moves_machine);
  // Whether blocks start from where the subject was: then items depend on what it did.
  bool was_moved() const { return was_moved_; }

  // For the filter of equal records, while no step is kept from `number` on: the reference's next
  // item, and what it leaves off with: where the reference stands, and the item that is not used up
  // (null: none).
  bool is_next(std::size_t number) const { return number == first_ + steps_.size(); }
  const reference::Item* next_item();
  const Position& place() const { return place_; }
  void resume(const Position& place, const reference::Item* item);

  // Items that the reference has put out so far.
  std::size_t items() const { return items_; }
  // The same, with the records that the passes of a thread would be.
  std::size_t items_and_passes() const { return items_ + passes_; }
  WatchedReference& watched() { return expander_; }
  const reference::ReadingsInUse& readings() const { return expander_.readings(); }
  // Whether line numbers have ascended, and go on so.
  bool is_in_order() const { return expander_.is_in_order(); }
  // The text of the line that alarms, at the alarm.
  std::string failed_words() const { return expander_.failed_words(); }

 private:
  void take(const reference::Item& item);
  void count_passes(const reference::ThreadMilling& thread);

  const Tolerances& tolerances_;
  WatchedReference expander_;
  std::deque<Step> steps_;
  std::size_t first_ = 0;  // number of the first step that is kept
  Position place_;         // where the steps so far end
  Queue<DueMFunction> m_functions_;
  std::size_t taken_m_functions_ = 0;
  bool leaves_out_m_functions_;
  std::uint64_t cut_block_ = 0;       // as of a step, of the item that came last
  std::uint64_t next_cut_block_ = 0;  // and of the next one
  std::uint64_t left_block_ = 0;
  std::uint64_t next_left_block_ = 0;
  std::size_t items_ = 0;
  std::size_t passes_ = 0;
  std::map<std::size_t, Position> settled_;  // where open paths ended, of the steps that are kept
  bool was_moved_ = false;
  bool is_at_silent_end_ = false;
};

}  // namespace gonogo::oracle
