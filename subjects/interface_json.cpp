// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the C interface to the pipe protocol.
#include <array>
#include <charconv>
#include <cmath>

#include "oracle/records/text.hpp"
#include "subjects/interface_record.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::Plane;

template <class Integer>
void append_integer(Integer value, std::string& out) {
  std::array<char, 24> digits;
  out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

// The exact value in any locale: printf's %a writes the locale's decimal point.
void append_double(double value, std::string& out) {
  constexpr double kWhole = 9007199254740992;  // 2^53: integers below are exact
  if (std::abs(value) < kWhole && std::trunc(value) == value) {
    return append_integer(static_cast<std::int64_t>(value), out);
  }
  std::array<char, 40> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(value),
                                 std::chars_format::hex)
                       .ptr;
  out += std::signbit(value) ? "-0x" : "0x";
  out.append(digits.data(), end);
}

void append_number(const gonogo_number& number, std::string& out) {
  if (number.form == GONOGO_NUMBER_TEXT) {
    return append_json_string(readable(view(number.text)), out);
  }
  out += '"';
  append_double(number.binary64, out);
  out += '"';
}

void append_member(std::string_view key, const gonogo_number& number, std::string& out) {
  if (number.form == GONOGO_NUMBER_ABSENT) return;
  out += ",\"";
  out += key;
  out += "\":";
  append_number(number, out);
}

// {"x":"1","z":"2"}
class AxesWriter {
 public:
  AxesWriter(std::string_view key, std::string& out) : out_(out) {
    out_ += ",\"";
    out_ += key;
    out_ += "\":{";
  }
  ~AxesWriter() { out_ += '}'; }
  AxesWriter(const AxesWriter&) = delete;
  AxesWriter& operator=(const AxesWriter&) = delete;

  void add(Axis axis, const gonogo_number& number) {
    if (number.form == GONOGO_NUMBER_ABSENT) return;
    out_ += first_ ? "\"" : ",\"";
    out_ += reference::letter(axis);
    out_ += "\":";
    append_number(number, out_);
    first_ = false;
  }
  void add(const gonogo_number (&numbers)[GONOGO_AXES]) {
    for (Axis axis : reference::kAllAxes) add(axis, numbers[reference::index(axis)]);
  }

 private:
  std::string& out_;
  bool first_ = true;
};

void append_arc(const gonogo_record_v1& source, std::string& out) {
  out += ",\"plane\":\"G";
  append_integer(source.plane, out);
  out += '"';
  const auto [p, q, d] = reference::axes_of(static_cast<Plane>(source.plane - 17));
  AxesWriter centre("c", out);
  centre.add(p, source.centre[0]);
  centre.add(q, source.centre[1]);
}

}  // namespace

void append_json(const gonogo_record_v1& source, std::string& out) {
  out += "{\"k\":\"";
  out += reference::name(static_cast<reference::RecordKind>(source.kind - GONOGO_RAPID));
  out += '"';
  if (source.block != 0) {
    out += ",\"b\":";
    append_integer(source.block, out);
  }
  if (source.kind == GONOGO_ARC) {
    append_arc(source, out);
    out += ",\"rot\":";
    append_integer(source.rot, out);
  }
  if (source.kind != GONOGO_DWELL && source.kind != GONOGO_M) {
    AxesWriter("to", out).add(source.to);
  }
  if (source.kind == GONOGO_ARC3) AxesWriter("via", out).add(source.via);
  append_member("f", source.f, out);
  if (source.feed_mode == GONOGO_FEED_PER_REVOLUTION) out += ",\"fm\":\"rev\"";
  append_member("lead", source.lead, out);
  append_member("start", source.start, out);
  append_member("s", source.seconds, out);
  if (source.kind == GONOGO_M) {
    out += ",\"m\":";
    append_integer(source.m, out);
  }
  out += '}';
}

void append_json(const SubjectAlarm& alarm, std::string& out) {
  out += '{';
  auto member = [&](std::string_view key, std::string_view value) {
    if (value.empty()) return;
    if (out.back() != '{') out += ',';
    append_json_string(key, out);
    out += ':';
    append_json_string(readable(value), out);
  };
  member("native", alarm.native);
  member("class", alarm.alarm_class);
  member("word", alarm.word.text());
  if (alarm.block != 0) {
    out += out.back() == '{' ? "\"b\":" : ",\"b\":";
    append_integer(alarm.block, out);
  }
  out += '}';
}

}  // namespace gonogo::oracle
