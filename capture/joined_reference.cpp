// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/joined_reference.hpp"

#include <utility>

#include "oracle/motion/places.hpp"

namespace gonogo::oracle {

JoinedReference::JoinedReference(const reference::Profile& profile, grammar::LineSource& lines,
                                 const Tolerances& tolerances)
    : tolerances_(tolerances),
      expander_(profile, lines, reference::OpenPaths::judged),
      position_(profile.initial.at),
      stood_(position_) {}

void JoinedReference::take(const reference::Item& item) {
  const Record* record = std::get_if<Record>(&item);
  const bool is_no_step =
      record != nullptr && (record->kind == RecordKind::m ||
                            (record->kind == RecordKind::dwell && record->seconds.sign() == 0));
  if (is_no_step) return;
  if (record != nullptr && is_motion(record->kind)) return take_motion(*record);
  if (auto* renaming = std::get_if<reference::Renaming>(&item)) {
    shift(position_, renaming->shift);
    shift(stood_, renaming->shift);
  }
  flush();
  std::visit([this](const auto& step) { ready_.push_back(step); }, item);
}

void JoinedReference::take_motion(const Record& record) {
  constexpr std::size_t kMostInARow = 1'000'000;
  Motion motion = motion_from(position_, record, items_);
  position_ = motion.to();
  if (!tolerances_.compare_blocks) motion.record.block = 0;
  if (pending_ && !over_arcs_ && join(*pending_, motion)) {
    stood_ = position_;
    return;
  }
  if (stays_at(stood_, motion, tolerances_)) {
    over_arcs_ = over_arcs_ || is_round(record.kind);
    if (++left_out_ > kMostInARow) {
      throw exact::Undecided("more than a million motions in a row are too small to see");
    }
    return;
  }
  over_arcs_ = false;
  left_out_ = 0;
  stood_ = position_;
  flush();
  pending_ = std::move(motion);
}

void JoinedReference::flush() {
  if (pending_) ready_.push_back(*std::exchange(pending_, std::nullopt));
}

const ReferenceStep& JoinedReference::current() {
  while (ready_.empty()) {
    const reference::Item* item = expander_.next();
    ++items_;
    take(*item);
  }
  return ready_.front();
}

void JoinedReference::advance() {
  if (!at_end()) ready_.pop_front();
}

}  // namespace gonogo::oracle
