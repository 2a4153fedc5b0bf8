// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <span>

#include "oracle/relation/event.hpp"

namespace gonogo::relation {

// The subject's events from one of its records on, from a place where it stands. Behind a renaming
// the same records start from a place with another name: that is another side.
class SubjectSide {
 public:
  // What it is given must outlive it. `turned`: the records of arcs that have their other turn.
  SubjectSide(std::span<const reference::Record> records, std::size_t first, const Position& from,
              const Tolerances& tolerances, std::span<const std::size_t> turned);
  // The last event is the close; REQUIRES: no event before `index` is.
  const Event& at(std::size_t index);
  // The exact place where the subject stands before an event that does not lie within a motion.
  const Position& place(std::size_t index);

 private:
  void extend();

  std::span<const reference::Record> records_;
  std::size_t next_;
  Position here_;
  const Tolerances& tolerances_;
  std::span<const std::size_t> turned_;
  std::deque<Event> events_;
  std::deque<Position> places_;
  std::optional<MotionEvents> motion_;
};

}  // namespace gonogo::relation
