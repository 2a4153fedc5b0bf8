// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/trace.hpp"

namespace gonogo::expanders::gsk {

gonogo_record_v1 Trace::make(gonogo_record_kind kind) const {
  gonogo_record_v1 record{};
  record.struct_size = sizeof record;
  record.kind = kind;
  record.block = state_.line;
  return record;
}

gonogo_number Trace::number(Fixed value) {
  char* text = text_.data() + used_;
  const std::size_t size = write_decimal(value, text);
  used_ += size;
  gonogo_number number{};
  number.form = GONOGO_NUMBER_TEXT;
  number.text = {text, size};
  return number;
}

void Trace::put_point(gonogo_record_v1& record, const Point& to, Axes axes) {
  for (std::size_t axis = 0; axis < to.size(); ++axis) {
    if ((axes & axis_bit(axis)) != 0) record.to[axis] = number(to[axis]);
  }
}

void Trace::put_feed(gonogo_record_v1& record) {
  record.f = number(state_.feed);
  record.feed_mode = state_.per_revolution ? GONOGO_FEED_PER_REVOLUTION : GONOGO_FEED_PER_MINUTE;
}

bool Trace::send(const gonogo_record_v1& record) {
  const int answer = sink_.record(sink_.context, &record);
  used_ = 0;
  return answer == 0;
}

bool Trace::line(gonogo_record_kind kind, const Point& to, Axes axes) {
  if (to == state_.position) return true;
  gonogo_record_v1 record = make(kind);
  put_point(record, to, axes);
  if (kind == GONOGO_FEED) put_feed(record);
  state_.position = to;
  return send(record);
}

bool Trace::rapid_axis(std::size_t axis, Fixed to) {
  Point point = state_.position;
  point[axis] = to;
  return rapid(point, axis_bit(axis));
}

bool Trace::feed_axis(std::size_t axis, Fixed to) {
  Point point = state_.position;
  point[axis] = to;
  return feed(point, axis_bit(axis));
}

bool Trace::thread(const Point& to, Axes axes, Fixed lead) {
  if (to == state_.position) return true;
  gonogo_record_v1 record = make(GONOGO_THREAD);
  put_point(record, to, axes);
  record.lead = number(lead);
  record.start = number(0);
  state_.position = to;
  return send(record);
}

bool Trace::thread_axis(std::size_t axis, Fixed to, Fixed lead) {
  Point point = state_.position;
  point[axis] = to;
  return thread(point, axis_bit(axis), lead);
}

bool Trace::arc(Fixed centre_p, Fixed centre_q, int rot, const Point& to, Axes axes) {
  const Plane& plane = *state_.plane;
  gonogo_record_v1 record = make(GONOGO_ARC);
  record.plane = static_cast<std::uint32_t>(plane.number);
  record.centre[0] = number(centre_p);
  record.centre[1] = number(centre_q);
  record.rot = rot;
  put_point(record, to, axes | axis_bit(plane.p) | axis_bit(plane.q));
  put_feed(record);
  state_.position = to;
  return send(record);
}

bool Trace::dwell(Fixed seconds) {
  if (seconds == 0) return true;
  gonogo_record_v1 record = make(GONOGO_DWELL);
  record.seconds = number(seconds);
  return send(record);
}

bool Trace::function(int m) {
  gonogo_record_v1 record = make(GONOGO_M);
  record.m = m;
  return send(record);
}

bool Trace::end() {
  gonogo_record_v1 record = make(GONOGO_END);
  put_point(record, state_.position, (1u << GONOGO_AXES) - 1u);
  return send(record);
}

void Trace::alarm(const Alarm& alarm, std::uint64_t line) {
  if (sink_.alarm == nullptr) return;
  const AlarmText text = text_of(alarm.kind);
  gonogo_alarm_v1 report{};
  report.struct_size = sizeof report;
  report.block = line;
  report.native = {text.native.data(), text.native.size()};
  report.klass = {text.klass.data(), text.klass.size()};
  report.word = alarm.word;
  sink_.alarm(sink_.context, &report);
}

void Trace::note(gonogo_note_level level, std::string_view message) {
  if (sink_.note != nullptr) sink_.note(sink_.context, level, {message.data(), message.size()});
}

}  // namespace gonogo::expanders::gsk
