// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/common/tracer.hpp"

namespace gonogo::expanders {

Point Tracer::along(std::size_t axis, Fixed to) const {
  Point point = position_;
  point[axis] = to;
  return point;
}

gonogo_record_v1 Tracer::make(gonogo_record_kind kind) const {
  gonogo_record_v1 record{};
  record.struct_size = sizeof record;
  record.kind = kind;
  record.block = line_;
  return record;
}

// The text lives until the record is sent.
gonogo_number Tracer::number(Fixed value) {
  char* text = text_.data() + used_;
  const std::size_t size = write_decimal(value, text);
  used_ += size;
  gonogo_number number{};
  number.form = GONOGO_NUMBER_TEXT;
  number.text = {text, size};
  return number;
}

void Tracer::put_point(gonogo_record_v1& record, const Point& to, Axes axes) {
  for (std::size_t axis = 0; axis < to.size(); ++axis) {
    if ((axes & axis_bit(axis)) != 0) record.to[axis] = number(to[axis]);
  }
}

void Tracer::put_feed(gonogo_record_v1& record, const Feed& feed) {
  record.f = number(feed.value);
  record.feed_mode = feed.per_revolution ? GONOGO_FEED_PER_REVOLUTION : GONOGO_FEED_PER_MINUTE;
}

bool Tracer::send(const gonogo_record_v1& record) {
  const int answer = sink_.record(sink_.context, &record);
  used_ = 0;
  return answer == 0;
}

bool Tracer::rapid(const Point& to, Axes axes) {
  if (to == position_) return true;
  gonogo_record_v1 record = make(GONOGO_RAPID);
  put_point(record, to, axes);
  position_ = to;
  return send(record);
}

bool Tracer::feed(const Point& to, Axes axes, const Feed& feed) {
  if (to == position_) return true;
  gonogo_record_v1 record = make(GONOGO_FEED);
  put_point(record, to, axes);
  put_feed(record, feed);
  position_ = to;
  return send(record);
}

bool Tracer::thread(const Point& to, Axes axes, Fixed lead, Fixed start) {
  if (to == position_) return true;
  gonogo_record_v1 record = make(GONOGO_THREAD);
  put_point(record, to, axes);
  record.lead = number(lead);
  record.start = number(start);
  position_ = to;
  return send(record);
}

bool Tracer::arc(const Plane& plane, Fixed centre_p, Fixed centre_q, int rot, const Point& to,
                 Axes axes, const Feed& feed) {
  gonogo_record_v1 record = make(GONOGO_ARC);
  record.plane = static_cast<std::uint32_t>(plane.number);
  record.centre[0] = number(centre_p);
  record.centre[1] = number(centre_q);
  record.rot = rot;
  put_point(record, to, axes | axis_bit(plane.p) | axis_bit(plane.q));
  put_feed(record, feed);
  position_ = to;
  return send(record);
}

bool Tracer::space_arc(const Point& via, const Point& to, Axes axes, const Feed& feed) {
  gonogo_record_v1 record = make(GONOGO_ARC3);
  for (const std::size_t axis : {GONOGO_X, GONOGO_Y, GONOGO_Z}) {
    record.via[axis] = number(via[axis]);
  }
  put_point(record, to, axes);
  put_feed(record, feed);
  position_ = to;
  return send(record);
}

bool Tracer::dwell(Fixed seconds) {
  if (seconds == 0) return true;
  gonogo_record_v1 record = make(GONOGO_DWELL);
  record.seconds = number(seconds);
  return send(record);
}

bool Tracer::function(int m) {
  gonogo_record_v1 record = make(GONOGO_M);
  record.m = m;
  return send(record);
}

bool Tracer::end() {
  gonogo_record_v1 record = make(GONOGO_END);
  put_point(record, position_, kAllAxes);
  return send(record);
}

void Tracer::alarm(const AlarmText& text, char word, std::uint64_t line) const {
  if (sink_.alarm == nullptr) return;
  gonogo_alarm_v1 report{};
  report.struct_size = sizeof report;
  report.block = line;
  report.native = {text.native.data(), text.native.size()};
  report.klass = {text.klass.data(), text.klass.size()};
  report.word = word;
  sink_.alarm(sink_.context, &report);
}

void Tracer::note(gonogo_note_level level, std::string_view message) const {
  if (sink_.note != nullptr) sink_.note(sink_.context, level, {message.data(), message.size()});
}

}  // namespace gonogo::expanders
