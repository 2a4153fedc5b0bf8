// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/tracer.hpp"
#include "expanders/gsk/alarms.hpp"
#include "expanders/gsk/state.hpp"

namespace gonogo::expanders::gsk {

/// A tracer that cuts at the feed and in the plane that are in force.
class Trace : public Tracer {
 public:
  Trace(const gonogo_sink_v1& sink, State& state)
      : Tracer(sink, state.position, state.line), state_(state) {}

  bool feed(const Point& to, Axes axes) { return Tracer::feed(to, axes, speed()); }
  bool feed_axis(std::size_t axis, Fixed to) { return Tracer::feed_axis(axis, to, speed()); }
  bool arc(Fixed centre_p, Fixed centre_q, int rot, const Point& to, Axes axes) {
    return Tracer::arc(*state_.plane, centre_p, centre_q, rot, to, axes, speed());
  }
  void alarm(const Alarm& alarm, std::uint64_t line) {
    Tracer::alarm(text_of(alarm.kind), alarm.word, line);
  }

 private:
  Feed speed() const { return {state_.feed, state_.per_revolution}; }

  const State& state_;
};

}  // namespace gonogo::expanders::gsk
