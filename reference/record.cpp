// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/record.hpp"

#include <algorithm>
#include <charconv>

#include "reference/outcome.hpp"

namespace gonogo::reference {
namespace {

constexpr std::array<std::string_view, 8> kKinds = {"rapid",  "feed",  "arc", "arc3",
                                                    "thread", "dwell", "m",   "end"};
constexpr std::array kAlarmNames = std::to_array<std::string_view>({
#define GONOGO_ALARM(name, text, sentence) text,
#include "reference/alarm_classes.def"
});

void append_integer(std::int64_t value, std::string& out) {
  std::array<char, 24> digits;
  auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

void append_position(std::string_view key, AxisSet axes, const Position& at, std::string& out) {
  out += key;
  bool first = true;
  for (Axis axis : kAllAxes) {
    if (!axes.has(axis)) continue;
    out += first ? "\"" : ",\"";
    out += letter(axis);
    out += "\":";
    at[axis].append_json(out);
    first = false;
  }
  out += '}';
}

void append_number(std::string_view key, const Number& value, std::string& out) {
  out += key;
  value.append_json(out);
}

bool differ(const Number& a, const Number& b) {
  try {
    return a != b;
  } catch (const exact::Undecided&) {
    return false;
  }
}

void append_feed(const Record& record, std::string& out) {
  append_number(",\"f\":", record.feed, out);
  if (record.feed_mode == FeedMode::per_revolution) out += ",\"fm\":\"rev\"";
}

void append_arc(const Record& record, std::string& out) {
  out += ",\"plane\":\"G";
  append_integer(plane_code(record.plane), out);
  out += '"';
  PlaneAxes axes = axes_of(record.plane);
  Position centre;
  centre[axes.p] = record.centre[0];
  centre[axes.q] = record.centre[1];
  append_position(",\"c\":{", {axes.p, axes.q}, centre, out);
  out += ",\"rot\":";
  append_integer(record.rot, out);
}

}  // namespace

std::string_view name(RecordKind kind) {
  return kKinds[static_cast<std::size_t>(kind)];
}

bool turns_alone(const Record& record, const Position& from) {
  const auto moves = [&](Axis axis) {
    return record.axes.has(axis) && differ(record.to[axis], from[axis]);
  };
  return std::ranges::none_of(kLinearAxes, moves) && std::ranges::any_of(kAllAxes, moves);
}

std::string_view feed_unit(FeedMode mode, bool in_degrees) {
  if (mode == FeedMode::per_revolution) return in_degrees ? "degrees/rev" : "mm/rev";
  return in_degrees ? "degrees/min" : "mm/min";
}

const Alarm& best_supported(const AlarmReport& report) {
  const auto basis = [](const Alarm& alarm) {
    return alarm.clause == kNoClause ? Basis::silent : clause(alarm.clause).basis();
  };
  return *std::ranges::min_element(report.alarms, {}, basis);
}

std::string_view name(AlarmClass alarm) {
  return kAlarmNames[static_cast<std::size_t>(alarm)];
}

std::optional<AlarmClass> alarm_class(std::string_view text) {
  for (std::size_t i = 0; i < kAlarmNames.size(); ++i) {
    if (kAlarmNames[i] == text) return static_cast<AlarmClass>(i);
  }
  return std::nullopt;
}

void append_json(const Record& record, std::string& out) {
  out += "{\"k\":\"";
  out += name(record.kind);
  out += '"';
  if (record.block != 0) {
    out += ",\"b\":";
    append_integer(static_cast<std::int64_t>(record.block), out);
  }
  if (record.kind == RecordKind::arc) append_arc(record, out);
  if (record.kind == RecordKind::arc3)
    append_position(",\"via\":{", record.via_axes, record.via, out);
  if (is_motion(record.kind) || record.kind == RecordKind::end) {
    append_position(",\"to\":{", record.axes, record.to, out);
  }
  switch (record.kind) {
    case RecordKind::feed:
    case RecordKind::arc:
    case RecordKind::arc3:
      append_feed(record, out);
      break;
    case RecordKind::thread:
      append_number(",\"lead\":", record.lead, out);
      append_number(",\"start\":", record.start, out);
      break;
    case RecordKind::dwell:
      append_number(",\"s\":", record.seconds, out);
      break;
    case RecordKind::m:
      out += ",\"m\":";
      append_integer(record.m, out);
      break;
    default:
      break;
  }
  // That a rule of our own ends the program is no part of the trace.
  if (record.clause != kNoClause && record.kind != RecordKind::end) {
    out += ",\"clause\":\"";
    out += clause_name(record.clause);
    out += '"';
  }
  out += '}';
}

}  // namespace gonogo::reference
