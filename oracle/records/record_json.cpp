// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/record_json.hpp"

#include <fmt/format.h>

#include <limits>

#include "oracle/records/record_fault.hpp"
#include "oracle/records/record_keys.hpp"
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
using simdjson::dom::array;
using simdjson::dom::element;
using simdjson::dom::element_type;
using simdjson::dom::object;

std::string_view string_of(std::string_view key, const element& value) {
  std::string_view text;
  if (value.get(text) != simdjson::SUCCESS) fail_record("The key \"{}\" must be a string.", key);
  if (text.size() > kLongestString) {
    fail_record("The string of \"{}\" has more than {} characters.", key, kLongestString);
  }
  return text;
}

std::int64_t integer_of(std::string_view key, const element& value, std::int64_t low,
                        std::int64_t high) {
  std::int64_t number = 0;
  if (value.type() != element_type::INT64 || value.get(number) != simdjson::SUCCESS ||
      number < low || number > high) {
    fail_record("The key \"{}\" must be a JSON integer from {} to {}.", key, low, high);
  }
  return number;
}

Number rational_of(std::string_view key, const element& value) {
  const std::string_view text = string_of(key, value);
  if (auto number = Number::parse(text)) return *std::move(number);
  fail_record("\"{}\" of \"{}\" is not a number: write a decimal, p/q or a hexadecimal float.",
              excerpt(text, 60), key);
}

template <std::size_t N>
std::array<Number, N> rationals_of(std::string_view key, const element& value) {
  array items;
  if (value.get(items) != simdjson::SUCCESS || items.size() != N) {
    fail_record("A root or enclosure of \"{}\" must be an array of {} strings.", key, N);
  }
  std::array<Number, N> numbers;
  std::size_t i = 0;
  for (auto item : items) numbers[i++] = rational_of(key, item);
  return numbers;
}

Number enclosure_of(std::string_view key, const element& value) {
  static const Number kWidest = Number::decimal(false, 1, 15);
  auto [low, high] = rationals_of<2>(key, value);
  if (low > high) fail_record("The enclosure of \"{}\" has its bounds the wrong way round.", key);
  if (high - low > kWidest) fail_record("The enclosure of \"{}\" is wider than 1e-15.", key);
  return low == high ? low : Number::between(low, high);
}

Number root_of(std::string_view key, const element& value) {
  auto [a, b, c] = rationals_of<3>(key, value);
  if (c.sign() < 0) fail_record("The root of \"{}\" is taken of a negative number.", key);
  return Number::root(a, b, c);
}

Number number_of(std::string_view key, const element& value) {
  if (value.type() == element_type::STRING) return rational_of(key, value);
  object form;
  if (value.get(form) != simdjson::SUCCESS || form.size() != 1) {
    fail_record(
        "The number \"{}\" must be a string, {{\"root\":[a,b,c]}} or {{\"enclosure\":[lo,hi]}}.",
        key);
  }
  auto field = *form.begin();
  if (field.key == "root") return root_of(key, field.value);
  if (field.key == "enclosure") return enclosure_of(key, field.value);
  fail_record("The number \"{}\" has the unknown form \"{}\".", key, excerpt(field.key, 60));
}

AxisSet read_position(std::string_view key, const element& value, Position& at) {
  object axes;
  if (value.get(axes) != simdjson::SUCCESS) {
    fail_record("The key \"{}\" must be an object of axes.", key);
  }
  AxisSet named;
  for (auto field : axes) {
    constexpr std::string_view kLetters = "xyzac";
    const std::size_t place =
        field.key.size() == 1 ? kLetters.find(field.key[0]) : std::string_view::npos;
    if (place == std::string_view::npos) {
      fail_record("\"{}\" of \"{}\" is no axis: the axes are x, y, z, a and c.",
                  excerpt(field.key, 60), key);
    }
    const Axis axis = reference::kAllAxes[place];
    at[axis] = number_of(field.key, field.value);
    named.add(axis);
  }
  return named;
}

// The fields of one object by key. Those that the judge ignores are left out.
class Fields {
 public:
  explicit Fields(const object& source) {
    for (auto field : source) {
      if (field.key == "clause" || field.key.substr(0, 2) == "x-") continue;
      const std::optional<Key> key = record_key(field.key);
      if (!key) {
        fail_record("The key \"{}\" is unknown; a key of your own begins with x-.",
                    excerpt(field.key, 60));
      }
      values_[static_cast<std::size_t>(*key)] = field.value;
      present_ |= bit(*key);
    }
  }
  bool has(Key key) const { return (present_ & bit(key)) != 0; }
  const element& operator[](Key key) const { return values_[static_cast<std::size_t>(key)]; }
  std::string_view text(Key key) const { return string_of(name_of(key), (*this)[key]); }
  Number number(Key key) const { return number_of(name_of(key), (*this)[key]); }

  void check(std::string_view kind, std::uint32_t required, std::uint32_t allowed) const {
    for (std::size_t i = 0; i < kKeys; ++i) {
      const std::uint32_t mask = 1U << i;
      if ((required & ~present_ & mask) != 0) {
        fail_record("A record \"{}\" needs the key \"{}\".", kind, kKeyNames[i]);
      }
      if ((present_ & ~allowed & mask) != 0) {
        fail_record("A record \"{}\" takes no key \"{}\".", kind, kKeyNames[i]);
      }
    }
  }

 private:
  std::array<element, kKeys> values_;
  std::uint32_t present_ = 0;
};

std::uint64_t block_of(const Fields& fields) {
  if (!fields.has(Key::b)) return 0;
  return static_cast<std::uint64_t>(
      integer_of("b", fields[Key::b], 1, std::numeric_limits<std::int64_t>::max()));
}

SubjectAlarm alarm_of(const Fields& fields) {
  SubjectAlarm alarm;
  alarm.block = block_of(fields);
  if (fields.has(Key::alarm_class)) alarm.alarm_class = visible(fields.text(Key::alarm_class));
  require_few_classes(alarm.alarm_class);
  if (fields.has(Key::native)) alarm.native = visible(fields.text(Key::native));
  if (fields.has(Key::word)) {
    alarm.word = reference::WordName(fields.text(Key::word));
  }
  if (alarm.alarm_class.empty() && alarm.native.empty()) {
    fail_record("An alarm needs \"class\" or \"native\".");
  }
  return alarm;
}

void read_feed(const Fields& fields, Record& record) {
  record.feed = fields.number(Key::f);
  if (!fields.has(Key::fm)) return;
  const std::string_view mode = fields.text(Key::fm);
  if (mode == "rev") {
    record.feed_mode = FeedMode::per_revolution;
  } else if (mode != "min") {
    fail_record("\"fm\" must be \"min\" or \"rev\".");
  }
}

void read_arc(const Fields& fields, Record& record) {
  const std::string_view plane = fields.text(Key::plane);
  if (plane != "G17" && plane != "G18" && plane != "G19") {
    fail_record("\"plane\" must be \"G17\", \"G18\" or \"G19\".");
  }
  record.plane = plane == "G17" ? Plane::g17 : plane == "G18" ? Plane::g18 : Plane::g19;
  const auto [p, q, d] = reference::axes_of(record.plane);
  Position centre;
  const AxisSet named = read_position("c", fields[Key::c], centre);
  if (named != AxisSet{p, q}) fail_record("\"c\" must have the two axes of the plane {}.", plane);
  record.centre = {centre[p], centre[q]};
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  record.rot = static_cast<std::int32_t>(integer_of("rot", fields[Key::rot], -kMost, kMost));
  if (record.rot == 0) fail_record("\"rot\" of an arc must not be 0.");
  require_axes("to", record.axes, {p, q});
}

Record record_of(const Shape& shape, const Fields& fields) {
  fields.check(shape.name, shape.required, shape.allowed);
  Record record;
  record.kind = shape.kind;
  record.block = block_of(fields);
  if (fields.has(Key::to)) record.axes = read_position("to", fields[Key::to], record.to);
  if (fields.has(Key::f)) read_feed(fields, record);
  switch (shape.kind) {
    case RecordKind::arc:
      read_arc(fields, record);
      break;
    case RecordKind::arc3:
      record.via_axes = read_position("via", fields[Key::via], record.via);
      // A circle in space needs three whole points.
      require_axes("via", record.via_axes, {Axis::x, Axis::y, Axis::z});
      require_axes("to", record.axes, {Axis::x, Axis::y, Axis::z});
      break;
    case RecordKind::thread:
      record.lead = fields.number(Key::lead);
      record.start = fields.number(Key::start);
      break;
    case RecordKind::dwell:
      record.seconds = fields.number(Key::s);
      break;
    case RecordKind::m:
      record.m = static_cast<std::int32_t>(
          integer_of("m", fields[Key::m], 0, std::numeric_limits<std::int32_t>::max()));
      break;
    default:
      break;
  }
  return record;
}

}  // namespace

TraceLine read_trace_line(const object& source) try {
  const Fields fields(source);
  if (!fields.has(Key::k)) fail_record("A record needs the key \"k\".");
  const std::string_view kind = fields.text(Key::k);
  for (const Shape& shape : kShapes) {
    if (shape.name == kind) return record_of(shape, fields);
  }
  if (kind != "alarm") fail_record("The record kind \"{}\" is unknown.", excerpt(kind, 60));
  fields.check("alarm", 0, kAlarmKeys | bit(Key::k));
  return alarm_of(fields);
} catch (const RecordFault& fault) {
  return TraceFault{fault.message};
}

std::variant<SubjectAlarm, TraceFault> read_alarm(const object& source) try {
  const Fields fields(source);
  fields.check("alarm", 0, kAlarmKeys);
  return alarm_of(fields);
} catch (const RecordFault& fault) {
  return TraceFault{fault.message};
}

std::variant<Number, TraceFault> read_number(std::string_view key, const element& value) try {
  return number_of(key, value);
} catch (const RecordFault& fault) {
  return TraceFault{fault.message};
}

}  // namespace gonogo::oracle
