// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/reference_stream.hpp"

#include <algorithm>

#include "oracle/judge/plain_motion.hpp"
#include "oracle/judge/standing.hpp"
#include "oracle/judge/terms.hpp"

namespace gonogo::oracle {

ReferenceStream::ReferenceStream(const reference::Profile& profile, grammar::LineSource& lines,
                                 const JudgeTerms& terms)
    : terms_(terms),
      expander_(profile, lines, reference::OpenPaths::judged),
      position_(profile.initial.at),
      dropped_{position_, {}} {}

void ReferenceStream::take(const reference::Item& item) {
  const Record* record = std::get_if<Record>(&item);
  if (record != nullptr && record->kind == RecordKind::m) {
    if (!terms_.compare_m) return;
    if (record->among_motions) flush();
    ready_.push_back(*record);
    return;
  }
  if (record != nullptr && record->kind == RecordKind::dwell && record->seconds.sign() == 0) {
    return;
  }
  if (record != nullptr && is_motion(record->kind)) {
    take_motion(*record);
    return;
  }
  if (auto* renaming = std::get_if<reference::Renaming>(&item)) {
    shift(position_, renaming->shift);
    shift(dropped_, renaming->shift);
  }
  if (auto* thread = std::get_if<reference::ThreadMilling>(&item)) count_passes(*thread);
  flush();
  std::visit([this](const auto& step) { ready_.push_back(step); }, item);
}

void ReferenceStream::take_motion(const Record& record) {
  Motion motion = motion_from(position_, record, items_);
  position_ = motion.to();
  if (!terms_.compare_blocks) motion.record.block = 0;
  // J-CMP-04: joined before anything is dropped: what goes on in the same way belongs to the
  // motion, however small it is. Not over arcs: the subject's may be a full turn together, which it
  // has to be able to put out in between.
  const bool over_arcs = std::ranges::any_of(
      dropped_.motions, [](const Record& dropped) { return is_round(dropped.kind); });
  if (pending_ && !over_arcs && join(*pending_, motion)) {
    dropped_.stood = position_;
    return;
  }
  // J-CMP-03. Dropped: it stays where the last kept motion ended, and makes no turn.
  if (stays_at(dropped_.stood, motion, terms_)) {
    drop(motion);
    return;
  }
  if (!dropped_.motions.empty()) {
    motion.dropped = std::make_shared<const Dropped>(std::move(dropped_));
    dropped_.motions.clear();
  }
  dropped_in_a_row_ = 0;
  dropped_.stood = position_;
  flush();
  pending_ = std::move(motion);
}

// A pass is an entry, a helix, a run-out and a way back.
void ReferenceStream::count_passes(const reference::ThreadMilling& thread) {
  constexpr std::int64_t kRecordsOfPass = 4;
  constexpr std::int64_t kMost = 1'000'000'000;
  const std::int64_t passes = thread.passes().to_int64().value_or(kMost);
  passes_ += static_cast<std::size_t>(std::min(passes, kMost) * kRecordsOfPass);
}

// A cycle that goes back by as much as it goes forward moves nothing that can be seen, as often as
// it likes, and no record of the subject's comes between.
void ReferenceStream::drop(const Motion& motion) {
  // J-CONST-06.
  constexpr std::size_t kMostRemembered = 64;
  constexpr std::size_t kMostInARow = 1'000'000;
  if (++dropped_in_a_row_ > kMostInARow) {
    throw exact::Undecided("more than a million motions in a row are too small to see");
  }
  std::vector<Record>& motions = dropped_.motions;
  if (motions.size() == 2 * kMostRemembered) {
    motions.erase(motions.begin(), motions.begin() + kMostRemembered);
  }
  motions.push_back(motion.record);
}

void ReferenceStream::flush() {
  if (!pending_) return;
  ready_.push_back(*std::move(pending_));
  pending_.reset();
}

void ReferenceStream::stand_at(const Position& position) {
  go_on_from(position);
  expander_.stand_at(position);
  was_moved_ = true;
}

bool is_m_function(const ReferenceStep& step) {
  const Record* record = std::get_if<Record>(&step);
  return record != nullptr && record->kind == RecordKind::m;
}

const Record* placed_m_function(const ReferenceStep& step) {
  return is_m_function(step) && std::get<Record>(step).among_motions ? &std::get<Record>(step)
                                                                     : nullptr;
}

bool ReferenceStream::placed_m_function_ahead() {
  current();
  return std::ranges::any_of(
      ready_, [](const ReferenceStep& step) { return placed_m_function(step) != nullptr; });
}

// Until a step is ready that is no M function: those do not hold up the motions round them.
void ReferenceStream::pull() {
  while (std::ranges::all_of(ready_, is_m_function)) {
    const reference::Item* item = next_item();
    if (item == nullptr) return;
    take(*item);
  }
}

const reference::Item* ReferenceStream::next_item() {
  const reference::Item* item = expander_.next();
  if (item != nullptr) ++items_;
  return item;
}

const Motion* ReferenceStream::beyond_same(const Motion& last) const {
  const bool is_next = ready_.size() == 1 && pending_ && pending_->number == items_ &&
                       !pending_->dropped && dropped_.motions.empty();
  const auto* first = is_next ? std::get_if<Motion>(&ready_.front()) : nullptr;
  const bool is_same = first != nullptr && !first->dropped && is_same_motion(*first, last);
  return is_same && is_same_point(dropped_.stood, position_) ? &*pending_ : nullptr;
}

void ReferenceStream::go_on_behind(const PlainMotion& last, const reference::Item* ahead) {
  ready_.clear();
  pending_ = last.motion(items_ - (ahead == nullptr ? 0 : 1));
  go_on_from(pending_->to());
  if (ahead != nullptr) take(*ahead);
}

const ReferenceStep& ReferenceStream::current() {
  pull();
  return ready_.front();
}

const ReferenceStep& ReferenceStream::behind_m_functions() {
  pull();
  const auto step = std::ranges::find_if_not(ready_, is_m_function);
  return step == ready_.end() ? ready_.front() : *step;
}

bool ReferenceStream::renaming_ahead() {
  current();
  return std::ranges::any_of(ready_, [](const ReferenceStep& step) {
    return std::holds_alternative<reference::Renaming>(step);
  });
}

bool ReferenceStream::at_end() {
  const ReferenceStep& step = current();
  if (const Record* record = std::get_if<Record>(&step)) return record->kind == RecordKind::end;
  return std::holds_alternative<reference::AlarmReport>(step) ||
         std::holds_alternative<reference::NotCovered>(step);
}

void ReferenceStream::advance() {
  if (at_end()) return;
  if (auto* motion = std::get_if<Motion>(&ready_.front())) passed_ = motion->number;
  ready_.pop_front();
}

}  // namespace gonogo::oracle
