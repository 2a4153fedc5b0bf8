// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "expanders/gsk/alarms.hpp"
#include "expanders/gsk/state.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders::gsk {

/// Moves the axes: keeps the state's position up to date and sends the records. Each function
/// returns false when the sink has asked to stop. Motions without length send nothing.
class Trace {
 public:
  Trace(const gonogo_sink_v1& sink, State& state) : sink_(sink), state_(state) {}

  /// Traverse; `axes` are named in the record.
  bool rapid(const Point& to, Axes axes) { return line(GONOGO_RAPID, to, axes); }
  /// Straight cut at the feed in force.
  bool feed(const Point& to, Axes axes) { return line(GONOGO_FEED, to, axes); }
  /// Cut synchronous to the spindle from its angle 0; `lead` mm a revolution.
  bool thread(const Point& to, Axes axes, Fixed lead);
  /// Arc or helix in the state's plane about (centre_p, centre_q), a full turn when it ends where
  /// it began; `rot` +n counterclockwise, -n clockwise: n - 1 full turns and the one to the end.
  /// Names both plane axes and `axes`.
  bool arc(Fixed centre_p, Fixed centre_q, int rot, const Point& to, Axes axes);
  bool dwell(Fixed seconds);
  bool function(int number);
  /// Closes the trace with the position of all axes.
  bool end();

  /// Moves one axis, at rapid or at feed.
  bool rapid_axis(std::size_t axis, Fixed to);
  bool feed_axis(std::size_t axis, Fixed to);
  bool thread_axis(std::size_t axis, Fixed to, Fixed lead);

  void alarm(const Alarm& alarm, std::uint64_t line);
  void note(gonogo_note_level level, std::string_view message);

 private:
  bool line(gonogo_record_kind kind, const Point& to, Axes axes);
  gonogo_record_v1 make(gonogo_record_kind kind) const;
  gonogo_number number(Fixed value);
  void put_point(gonogo_record_v1& record, const Point& to, Axes axes);
  void put_feed(gonogo_record_v1& record);
  bool send(const gonogo_record_v1& record);

  const gonogo_sink_v1& sink_;
  State& state_;
  // The numbers of one record.
  std::array<char, 10 * kTextSize> text_{};
  std::size_t used_ = 0;
};

}  // namespace gonogo::expanders::gsk
