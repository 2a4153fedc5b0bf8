// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/reference_steps.hpp"

#include <algorithm>
#include <utility>

#include "oracle/region/constants.hpp"
#include "reference/silent_end.hpp"

namespace gonogo::oracle {

bool is_end(const ReferenceStep& step) {
  if (const Record* record = std::get_if<Record>(&step)) return record->kind == RecordKind::end;
  return std::holds_alternative<reference::AlarmReport>(step) ||
         std::holds_alternative<reference::NotCovered>(step);
}

namespace {

// Whether the tool cuts, of an item or a step. The kinds that are not named are open paths.
struct Cuts {
  bool operator()(const Record& record) const {
    return is_motion(record.kind) && record.kind != RecordKind::rapid;
  }
  bool operator()(const Motion& motion) const { return (*this)(motion.record); }
  bool operator()(const reference::Renaming&) const { return false; }
  bool operator()(const reference::AlarmReport&) const { return false; }
  bool operator()(const reference::NotCovered&) const { return false; }
  bool operator()(const auto&) const { return true; }
};

std::uint64_t line_of(const reference::Item& item) {
  return std::visit([](const auto& one) { return one.block; }, item);
}

}  // namespace

bool cuts(const ReferenceStep& step) {
  return std::visit(Cuts{}, step);
}

const Record* dwell_of(const ReferenceStep& step) {
  const auto* record = std::get_if<Record>(&step);
  return record != nullptr && record->kind == RecordKind::dwell ? record : nullptr;
}

ReferenceSteps::ReferenceSteps(const reference::Profile& profile, const ProgramText& program,
                               const Tolerances& tolerances, const AssignmentSet* watched,
                               Forking forking)
    : tolerances_(tolerances),
      expander_(profile, program, watched, forking),
      place_(profile.initial.at),
      leaves_out_m_functions_(!tolerances.compare_m) {}

const reference::Item* ReferenceSteps::next_item() {
  if (is_at_silent_end_) expander_.go_past_end();
  const reference::Item* item = expander_.next();
  if (item == nullptr) return item;
  ++items_;
  is_at_silent_end_ = is_silent_end(*item);
  cut_block_ = next_cut_block_;
  if (std::visit(Cuts{}, *item)) next_cut_block_ = line_of(*item);
  left_block_ = next_left_block_;
  const auto* const record = std::get_if<Record>(item);
  if (record == nullptr || record->kind != RecordKind::m) next_left_block_ = line_of(*item);
  return item;
}

const ReferenceSteps::Step& ReferenceSteps::at(std::size_t number) {
  while (number >= first_ + steps_.size()) take(*next_item());
  return steps_[number - first_];
}

const ReferenceSteps::Step* ReferenceSteps::known(std::size_t number) const {
  const bool is_kept = number >= first_ && number < first_ + steps_.size();
  return is_kept ? &steps_[number - first_] : nullptr;
}

const std::shared_ptr<const Curve>& ReferenceSteps::curve_of(const Step& step) const {
  if (!step.curve) step.curve = std::make_shared<Curve>(std::get<Motion>(step.what), tolerances_);
  return step.curve;
}

void ReferenceSteps::forget_before(std::size_t number) {
  while (first_ < number && !steps_.empty()) {
    steps_.pop_front();
    ++first_;
  }
  settled_.erase(settled_.begin(), settled_.lower_bound(first_));
}

void ReferenceSteps::take(const reference::Item& item) {
  const Record* record = std::get_if<Record>(&item);
  if (record != nullptr && record->kind == RecordKind::m) {
    if (leaves_out_m_functions_) return;
    const bool is_fixed = record->among_motions || ends_program(*record);
    return m_functions_.push_back({*record, first_ + steps_.size(), is_fixed});
  }
  if (record != nullptr && record->kind == RecordKind::dwell && record->seconds.sign() == 0) {
    return;
  }
  Step& step = steps_.emplace_back();
  step.place = place_;
  step.item = items_;
  step.block = line_of(item);
  step.cut_block = cut_block_;
  step.left_block = left_block_;
  step.m_functions = taken_m_functions_ + m_functions_.size();
  if (record != nullptr && is_motion(record->kind)) {
    Motion motion = motion_from(place_, *record, items_);
    if (!tolerances_.compare_blocks) motion.record.block = 0;
    place_ = motion.to();
    step.what = std::move(motion);
    return;
  }
  if (auto* renaming = std::get_if<reference::Renaming>(&item)) shift(place_, renaming->shift);
  if (auto* thread = std::get_if<reference::ThreadMilling>(&item)) count_passes(*thread);
  std::visit([&](const auto& one) { step.what = one; }, item);
}

void ReferenceSteps::take_m_function() {
  m_functions_.pop_front();
  ++taken_m_functions_;
}

// It is then due before the steps of its block that stood before it.
void ReferenceSteps::bring_forward(std::size_t place) {
  const std::uint64_t block = waiting()[place].record.block;
  m_functions_.bring_forward(place);
  for (Step& step : steps_) {
    if (step.block == block && step.m_functions <= taken_m_functions_ + place) ++step.m_functions;
  }
}

// A pass is an entry, a helix, a run-out and a way back.
void ReferenceSteps::count_passes(const reference::ThreadMilling& thread) {
  constexpr auto kMost = static_cast<std::int64_t>(kMostItems);
  const std::int64_t passes = thread.passes().to_int64().value_or(kMost);
  passes_ += static_cast<std::size_t>(std::min(passes, kMost)) * kRecordsOfPass;
}

bool ReferenceSteps::go_on_from(std::size_t number, const Position& place, bool moves_machine) {
  const auto [known, is_new] = settled_.try_emplace(number, place);
  if (!is_new) return known->second == place;
  place_ = place;
  if (moves_machine) {
    expander_.stand_at(place);
    was_moved_ = true;
  }
  return true;
}

void ReferenceSteps::resume(const Position& place, const reference::Item* item) {
  place_ = place;
  if (item != nullptr) take(*item);
}

}  // namespace gonogo::oracle
