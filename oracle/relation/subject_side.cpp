// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/subject_side.hpp"

#include <algorithm>

namespace gonogo::relation {

using reference::Record;
using reference::RecordKind;

MotionEvents::MotionEvents(Event first, const Record& motion, const Position& from,
                           const Tolerances& tolerances, Turn turn)
    : event_(std::move(first)),
      cutter_(motion, from, tolerances.tolerance, turn),
      tau_(tolerances.tolerance) {
  event_.part = motion.kind == RecordKind::rapid ? Part::traverse : Part::cut;
  event_.block = motion.block;
  event_.start = from;
  event_.label = std::make_shared<Label>(label_of(motion, cutter_.is_flat(), tolerances));
}

std::optional<Event> MotionEvents::next() {
  const std::optional<Chord> chord = cutter_.next();
  if (!chord) return std::nullopt;
  Event piece = event_;
  piece.from = chord->from;
  piece.to = chord->to;
  piece.width = chord->width;
  const auto moves = [&](reference::Axis axis) {
    return abs(piece.from[axis] - piece.to[axis]) * 8 > tau_;
  };
  piece.one_axis = std::ranges::count_if(reference::kAllAxes, moves) == 1;
  event_.begins = false;
  ++event_.piece;
  return piece;
}

SubjectSide::SubjectSide(std::span<const Record> records, std::size_t first, const Position& from,
                         const Tolerances& tolerances, std::span<const std::size_t> turned)
    : records_(records), next_(first), here_(from), tolerances_(tolerances), turned_(turned) {}

const Event& SubjectSide::at(std::size_t index) {
  while (index >= events_.size()) extend();
  return events_[index];
}

const Position& SubjectSide::place(std::size_t index) {
  at(index);
  return places_[index];
}

void SubjectSide::extend() {
  if (motion_) {
    if (std::optional<Event> piece = motion_->next()) {
      events_.push_back(*std::move(piece));
      places_.push_back(here_);
      return;
    }
    here_ = end_of(records_[next_ - 1], here_);
    motion_.reset();
  }
  Event event;
  event.record = next_;
  event.from = event.to = rastered(here_, tolerances_.tolerance).at;
  if (next_ == records_.size()) {
    events_.push_back(std::move(event));
    places_.push_back(here_);
    return;
  }
  const Record& record = records_[next_++];
  event.item = std::make_shared<reference::Item>(record);
  event.block = record.block;
  if (is_motion(record.kind)) {
    const bool is_turned = std::ranges::count(turned_, event.record) != 0;
    motion_.emplace(std::move(event), record, here_, tolerances_,
                    is_turned ? Turn::the_other : Turn::as_written);
    return;
  }
  // Nothing is a dwell of no time.
  if (record.kind == RecordKind::dwell && agree(0, record.seconds, std::nullopt, tolerances_))
    return;
  if (record.kind == RecordKind::m && !tolerances_.compare_m) return;
  event.part = record.kind == RecordKind::end ? Part::close : Part::stop;
  events_.push_back(std::move(event));
  places_.push_back(here_);
}

}  // namespace gonogo::relation
