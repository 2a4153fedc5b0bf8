// SPDX-License-Identifier: GPL-3.0-or-later
//
// The events of a side, in order: pieces of motions, and events that have no length.
#pragma once

#include <memory>

#include "oracle/relation/curve.hpp"
#include "oracle/relation/label.hpp"
#include "reference/outcome.hpp"

namespace gonogo::relation {

enum class Part : std::uint8_t {
  cut,        // a piece of a feed, an arc or a thread
  traverse,   // a rapid
  stop,       // a dwell or an M function
  renaming,   // of the reference: the position gets another name
  free_step,  // of the reference: a path that the manual leaves open
  close,      // the end, an alarm, what is not covered
};

struct Event {
  Part part = Part::close;
  Position from;  // rastered, where it begins and ends
  Position to;
  Position start;                      // where the motion of this piece begins
  Number width;                        // how far the curve may lie from the line between them
  std::shared_ptr<const Label> label;  // of a motion
  std::shared_ptr<const reference::Item> item;  // its source; for the subject a record
  std::uint64_t block = 0;
  std::size_t record = 0;  // the subject's, from 0
  std::size_t piece = 0;   // of its motion, from 0
  bool begins = true;      // it is the first piece of its motion
  bool one_axis = false;   // a traverse whose way is known: one axis alone moves

  bool is_motion() const { return part == Part::cut || part == Part::traverse; }
  const reference::Record& source() const { return std::get<reference::Record>(*item); }
};

// Whether two pieces of one side belong to one stretch: no label changes between them.
inline bool goes_on(const Event& event, const Event& next) {
  return event.is_motion() && next.is_motion() &&
         (event.label == next.label || is_same(*event.label, *next.label));
}

// The pieces of one motion of a side.
class MotionEvents {
 public:
  MotionEvents(Event first, const reference::Record& motion, const Position& from,
               const Tolerances& tolerances, Turn turn);
  std::optional<Event> next();

 private:
  Event event_;
  Cutter cutter_;
  Number tau_;
};

}  // namespace gonogo::relation
