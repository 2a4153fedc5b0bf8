// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/reference_stream.hpp"

#include "oracle/judge/terms.hpp"

namespace gonogo::oracle {

JudgeTerms make_terms(const SubjectInfo& subject, const reference::Profile& profile,
                      const std::optional<Number>& tolerance,
                      const std::optional<Number>& chord) {
  JudgeTerms terms;
  terms.tolerance = profile.resolution();
  if (subject.resolution) terms.tolerance = min(terms.tolerance, *subject.resolution);
  if (tolerance) terms.tolerance = *tolerance;
  if (chord) terms.chord = *chord;
  terms.resolution = subject.resolution;
  terms.feed_resolution = subject.feed_resolution;
  terms.binary64 = subject.numeric_kind == "binary64";
  terms.compare_blocks = subject.everything || subject.features.contains("blocks");
  terms.compare_m = subject.features.contains("m");
  return terms;
}

ReferenceStream::ReferenceStream(const reference::Profile& profile, grammar::LineSource& lines,
                                 const JudgeTerms& terms)
    : terms_(terms),
      expander_(profile, lines, reference::OpenPaths::judged),
      position_(profile.initial.at) {}

// Takes one item in; true when something became ready.
bool ReferenceStream::take(const reference::Item& item) {
  const Record* record = std::get_if<Record>(&item);
  if (record != nullptr && record->kind == RecordKind::m) {
    if (!terms_.compare_m) return false;
    ready_.emplace_back(*record);
    return true;
  }
  if (record != nullptr && record->kind == RecordKind::dwell && record->seconds.sign() == 0) {
    return false;
  }
  if (record != nullptr && is_motion(record->kind)) {
    Motion motion = motion_from(pending_ ? pending_end_ : position_, *record, items_);
    if (!terms_.compare_blocks) motion.record.block = 0;
    // Dropped: its ends agree, and it makes no turn. An arc that almost closes is no small motion.
    if (agree(motion.from, motion.to(), terms_.tolerance) &&
        !(record->kind == RecordKind::arc && approximate_turns(motion) > 0.5)) {
      dropped_arc_ = dropped_arc_ || record->kind == RecordKind::arc;
      return false;
    }
    if (pending_ && join(*pending_, motion)) {
      pending_end_ = motion.to();
      return false;
    }
    const bool flushed = pending_.has_value();
    if (flushed) {
      position_ = pending_end_;
      ready_.emplace_back(*std::move(pending_));
    }
    pending_end_ = motion.to();
    pending_ = std::move(motion);
    return flushed;
  }
  if (pending_) {
    position_ = pending_end_;
    ready_.emplace_back(*std::move(pending_));
    pending_.reset();
  }
  std::visit([this](const auto& step) { ready_.emplace_back(step); }, item);
  return true;
}

void ReferenceStream::pull() {
  while (ready_.empty()) {
    const reference::Item* item = expander_.next();
    if (item == nullptr) return;
    ++items_;
    take(*item);
  }
}

const ReferenceStep& ReferenceStream::current() {
  pull();
  return ready_.front();
}

bool ReferenceStream::at_end() {
  const ReferenceStep& step = current();
  if (const Record* record = std::get_if<Record>(&step)) return record->kind == RecordKind::end;
  return std::holds_alternative<reference::AlarmReport>(step) ||
         std::holds_alternative<reference::NotCovered>(step);
}

void ReferenceStream::advance() {
  if (at_end()) return;
  ready_.pop_front();
  dropped_arc_ = false;
}

}  // namespace gonogo::oracle
