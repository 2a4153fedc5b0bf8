// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/interface_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/records/record_fault.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::AxisSet;
using reference::FeedMode;
using reference::Plane;
using reference::Position;
using reference::Record;
using reference::RecordKind;

constexpr std::size_t kLongestNumber = 1000;

// The value of a finite double, exactly: 53 bits of mantissa.
Number exact_value(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return Number::binary(static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53);
}

void check_number(std::string_view key, const gonogo_number& source) {
  if (source.form > GONOGO_NUMBER_BINARY64) {
    fail_record("The number \"{}\" has the unknown form {}.", key, source.form);
  }
  if (source.form == GONOGO_NUMBER_BINARY64 && !std::isfinite(source.binary64)) {
    fail_record("The number \"{}\" is not finite.", key);
  }
  if (source.form == GONOGO_NUMBER_TEXT && source.text.size > kLongestNumber) {
    fail_record("The number \"{}\" has more than {} characters.", key, kLongestNumber);
  }
}

Number number_of(std::string_view key, const gonogo_number& source) {
  check_number(key, source);
  if (source.form == GONOGO_NUMBER_ABSENT) fail_record("The number \"{}\" is missing.", key);
  if (source.form == GONOGO_NUMBER_BINARY64) return exact_value(source.binary64);
  if (auto number = Number::parse(view(source.text))) return *std::move(number);
  fail_record("\"{}\" of \"{}\" is not a number: write a decimal, p/q or a hexadecimal float.",
              excerpt(view(source.text), 60), key);
}

AxisSet read_position(const gonogo_number (&source)[GONOGO_AXES], Position& at) {
  AxisSet named;
  for (Axis axis : reference::kAllAxes) {
    const gonogo_number& number = source[reference::index(axis)];
    if (number.form == GONOGO_NUMBER_ABSENT) continue;
    const char key = reference::letter(axis);
    at[axis] = number_of({&key, 1}, number);
    named.add(axis);
  }
  return named;
}

bool given(const gonogo_number& number) {
  return number.form != GONOGO_NUMBER_ABSENT;
}

template <std::size_t N>
bool any_given(const gonogo_number (&numbers)[N]) {
  return std::ranges::any_of(numbers, given);
}

template <class Source>
void check_size(std::string_view what, const Source& source) {
  if (source.struct_size >= sizeof source) return;
  fail_record("{} has struct_size {}; version 1 has {}.", what, source.struct_size, sizeof source);
}

void refuse_unused(const gonogo_record_v1& source, RecordKind kind) {
  auto check = [&](bool used, bool set, std::string_view key) {
    if (!used && set) fail_record("A record \"{}\" has no \"{}\".", reference::name(kind), key);
  };
  const bool arc = kind == RecordKind::arc;
  const bool arc3 = kind == RecordKind::arc3;
  const bool thread = kind == RecordKind::thread;
  const bool cut = kind == RecordKind::feed || arc || arc3;
  check(kind != RecordKind::dwell && kind != RecordKind::m, any_given(source.to), "to");
  check(arc3, any_given(source.via), "via");
  check(cut, given(source.f), "f");
  check(cut, source.feed_mode != 0, "feed_mode");
  check(arc, source.plane != 0, "plane");
  check(arc, any_given(source.centre), "centre");
  check(arc, source.rot != 0, "rot");
  check(thread, given(source.lead), "lead");
  check(thread, given(source.start), "start");
  check(kind == RecordKind::dwell, given(source.seconds), "seconds");
  check(kind == RecordKind::m, source.m != 0, "m");
}

void check_arc(const gonogo_record_v1& source) {
  if (source.plane < 17 || source.plane > 19) fail_record("\"plane\" must be 17, 18 or 19.");
  if (source.rot == 0 || source.rot == INT32_MIN) {
    fail_record("\"rot\" of an arc must not be 0 and must lie above -2^31.");
  }
}

// Everything but the values of the numbers.
void check_form(const gonogo_record_v1& source) {
  check_size("A record", source);
  if (source.kind < GONOGO_RAPID || source.kind > GONOGO_END) {
    fail_record("The record kind {} is unknown.", source.kind);
  }
  const auto kind = static_cast<RecordKind>(source.kind - GONOGO_RAPID);
  refuse_unused(source, kind);
  if (source.feed_mode > GONOGO_FEED_PER_REVOLUTION) {
    fail_record("\"feed_mode\" has the unknown value {}.", source.feed_mode);
  }
  if (kind == RecordKind::arc) check_arc(source);
  if (source.m < 0) fail_record("\"m\" must not be negative.");
}

void read_arc(const gonogo_record_v1& source, Record& record) {
  record.plane = static_cast<Plane>(source.plane - 17);
  record.centre = {number_of("centre[0]", source.centre[0]),
                   number_of("centre[1]", source.centre[1])};
  record.rot = source.rot;
  const auto [p, q, d] = reference::axes_of(record.plane);
  require_axes("to", record.axes, {p, q});
}

void read_feed(const gonogo_record_v1& source, Record& record) {
  record.feed = number_of("f", source.f);
  record.feed_mode = static_cast<FeedMode>(source.feed_mode);
}

Record record_of(const gonogo_record_v1& source) {
  check_form(source);
  Record record;
  record.kind = static_cast<RecordKind>(source.kind - GONOGO_RAPID);
  record.block = source.block;
  record.axes = read_position(source.to, record.to);
  switch (record.kind) {
    case RecordKind::feed:
      read_feed(source, record);
      break;
    case RecordKind::arc:
      read_feed(source, record);
      read_arc(source, record);
      break;
    case RecordKind::arc3:
      read_feed(source, record);
      record.via_axes = read_position(source.via, record.via);
      require_axes("via", record.via_axes, {Axis::x, Axis::y, Axis::z});
      require_axes("to", record.axes, {Axis::x, Axis::y, Axis::z});
      break;
    case RecordKind::thread:
      record.lead = number_of("lead", source.lead);
      record.start = number_of("start", source.start);
      break;
    case RecordKind::dwell:
      record.seconds = number_of("seconds", source.seconds);
      break;
    case RecordKind::m:
      record.m = source.m;
      break;
    default:
      break;
  }
  return record;
}

SubjectAlarm alarm_of(const gonogo_alarm_v1& source) {
  check_size("An alarm", source);
  SubjectAlarm alarm;
  alarm.block = source.block;
  alarm.native = visible(view(source.native));
  alarm.alarm_class = visible(view(source.klass));
  require_few_classes(alarm.alarm_class);
  alarm.word = source.word;
  if (alarm.native.empty() && alarm.alarm_class.empty()) {
    fail_record("An alarm needs a class or the subject's own text.");
  }
  return alarm;
}

void check_numbers(const gonogo_record_v1& source) {
  for (Axis axis : reference::kAllAxes) {
    const char letter = reference::letter(axis);
    check_number({&letter, 1}, source.to[reference::index(axis)]);
    check_number({&letter, 1}, source.via[reference::index(axis)]);
  }
  for (const gonogo_number& number : source.centre) check_number("centre", number);
  check_number("f", source.f);
  check_number("lead", source.lead);
  check_number("start", source.start);
  check_number("seconds", source.seconds);
}

}  // namespace

std::string_view view(const gonogo_text& text) {
  return text.data == nullptr ? std::string_view() : std::string_view(text.data, text.size);
}

std::variant<Record, TraceFault> convert_record(const gonogo_record_v1& source) try {
  return record_of(source);
} catch (const RecordFault& fault) {
  return TraceFault{fault.message};
}

std::optional<TraceFault> form_fault(const gonogo_record_v1& source) try {
  check_form(source);
  check_numbers(source);
  return std::nullopt;
} catch (const RecordFault& fault) {
  return TraceFault{fault.message};
}

std::variant<SubjectAlarm, TraceFault> convert_alarm(const gonogo_alarm_v1& source) try {
  return alarm_of(source);
} catch (const RecordFault& fault) {
  return TraceFault{fault.message};
}

}  // namespace gonogo::oracle
