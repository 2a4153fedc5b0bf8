// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "expanders/common/axes.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders {

/// A controller's own number of an alarm and the class that the gauge knows it by.
struct AlarmText {
  std::string_view native;
  std::string_view klass;
};

/// A speed along the path, mm a minute or a revolution.
struct Feed {
  Fixed value = 0;
  bool per_revolution = false;
};

/// Moves the axes: keeps the position up to date and sends the records. Each motion returns false
/// when the sink has asked to stop; motions without length send nothing. Uses no memory beyond one
/// record.
class Tracer {
 public:
  /// Both places belong to the caller; `line` is the number of the block at work.
  Tracer(const gonogo_sink_v1& sink, Point& position, const std::uint64_t& line)
      : sink_(sink), position_(position), line_(line) {}

  /// Traverse; `axes` are named in the record.
  bool rapid(const Point& to, Axes axes);
  bool rapid_axis(std::size_t axis, Fixed to) { return rapid(along(axis, to), axis_bit(axis)); }
  /// Straight cut.
  bool feed(const Point& to, Axes axes, const Feed& feed);
  bool feed_axis(std::size_t axis, Fixed to, const Feed& speed) {
    return feed(along(axis, to), axis_bit(axis), speed);
  }
  /// Cut synchronous to the spindle; `lead` mm a revolution, `start` its angle in degrees.
  bool thread(const Point& to, Axes axes, Fixed lead, Fixed start = 0);
  bool thread_axis(std::size_t axis, Fixed to, Fixed lead, Fixed start = 0) {
    return thread(along(axis, to), axis_bit(axis), lead, start);
  }
  /// Arc or helix in `plane` about (centre_p, centre_q), a full turn when it ends where it began;
  /// `rot` +n counterclockwise, -n clockwise: n - 1 full turns and the one to the end. Names both
  /// plane axes and `axes`.
  bool arc(const Plane& plane, Fixed centre_p, Fixed centre_q, int rot, const Point& to, Axes axes,
           const Feed& feed);
  /// Arc in space through `via`, by X, Y and Z; `axes` are named in the record.
  bool space_arc(const Point& via, const Point& to, Axes axes, const Feed& feed);
  bool dwell(Fixed seconds);
  bool function(int number);
  /// Closes the trace with the position of all axes.
  bool end();

  void alarm(const AlarmText& text, char word, std::uint64_t line) const;
  void note(gonogo_note_level level, std::string_view message) const;

 private:
  Point along(std::size_t axis, Fixed to) const;
  gonogo_record_v1 make(gonogo_record_kind kind) const;
  gonogo_number number(Fixed value);
  void put_point(gonogo_record_v1& record, const Point& to, Axes axes);
  void put_feed(gonogo_record_v1& record, const Feed& feed);
  bool send(const gonogo_record_v1& record);

  const gonogo_sink_v1& sink_;
  Point& position_;
  const std::uint64_t& line_;
  // The numbers of one record.
  std::array<char, 10 * kTextSize> text_{};
  std::size_t used_ = 0;
};

}  // namespace gonogo::expanders
