// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/record.hpp"

#include <algorithm>

namespace gonogo::checker {
namespace {

constexpr std::array<std::string_view, 8> kKinds = {"rapid",  "feed",  "arc", "arc3",
                                                    "thread", "dwell", "m",   "end"};

RecordKind read_kind(const std::string& text) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i] == text) return static_cast<RecordKind>(i);
  }
  throw Fault("A record of the kind \"" + text + "\" is unknown.");
}

Real real_of(const Json& value, std::string_view key) {
  const Json* found = value.find(key);
  if (found == nullptr) throw Fault("The key \"" + std::string(key) + "\" is missing.");
  return read_real(*found);
}

void read_feed(const Json& value, Record& record) {
  record.feed = real_of(value, "f");
  const Json* mode = value.find("fm");
  if (mode == nullptr) return;
  if (mode->text != "min" && mode->text != "rev") throw Fault("fm is neither min nor rev.");
  record.per_revolution = mode->text == "rev";
}

Plane read_plane(std::string_view name) {
  if (name == "G17") return {0, 1, 2};
  if (name == "G18") return {2, 0, 1};
  if (name == "G19") return {1, 2, 0};
  throw Fault("The plane \"" + std::string(name) + "\" is unknown.");
}

void read_arc(const Json& value, Record& record) {
  record.plane = read_plane(value.text_of("plane"));
  record.centre = read_position(value.member("c", Json::Kind::object));
  record.rotation = value.integer_of("rot");
  if (record.rotation == 0) throw Fault("rot of an arc is 0.");
  for (const std::size_t axis : {record.plane.first, record.plane.second}) {
    if (!record.centre[axis]) throw Fault("The centre of an arc lacks an axis of its plane.");
    if (!record.to[axis]) throw Fault("The end of an arc lacks an axis of its plane.");
  }
  if (record.centre[record.plane.third]) throw Fault("The centre of an arc has a third axis.");
}

}  // namespace

std::string_view name(RecordKind kind) {
  return kKinds[static_cast<std::size_t>(kind)];
}

Position read_position(const Json& value) {
  Position position;
  for (const auto& [axis, number] : value.members) {
    const std::size_t which = axis.size() == 1 ? kAxisNames.find(axis[0]) : std::string::npos;
    if (which == std::string::npos) throw Fault("The axis \"" + axis + "\" is unknown.");
    position[which] = read_real(number);
  }
  return position;
}

Record read_record(const Json& value) {
  Record record;
  record.kind = read_kind(value.text_of("k"));
  if (value.find("b") != nullptr) record.block = value.integer_of("b");
  if (const Json* clause = value.find("clause")) record.clause = clause->text;
  const bool moves = record.kind != RecordKind::dwell && record.kind != RecordKind::m;
  if (moves) record.to = read_position(value.member("to", Json::Kind::object));
  switch (record.kind) {
    case RecordKind::feed:
      read_feed(value, record);
      break;
    case RecordKind::arc:
      read_feed(value, record);
      read_arc(value, record);
      break;
    case RecordKind::arc3:
      read_feed(value, record);
      record.via = read_position(value.member("via", Json::Kind::object));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!record.to[axis] || !record.via[axis]) throw Fault("An arc3 names x, y and z.");
      }
      break;
    case RecordKind::thread:
      record.lead = real_of(value, "lead");
      record.start = real_of(value, "start");
      break;
    case RecordKind::dwell:
      record.seconds = real_of(value, "s");
      break;
    case RecordKind::m:
      record.m = value.integer_of("m");
      break;
    case RecordKind::rapid:
    case RecordKind::end:
      break;
  }
  return record;
}

Alarm read_alarm(const Json& value) {
  Alarm alarm;
  if (const Json* kind = value.find("class")) alarm.kind = kind->text;
  constexpr std::ptrdiff_t kMostClasses = 3;  // whoever names many names none
  if (std::ranges::count(alarm.kind, ' ') >= kMostClasses) alarm.kind.clear();
  if (value.find("b") != nullptr) alarm.block = value.integer_of("b");
  return alarm;
}

std::string text(const Position& position) {
  std::string line;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!position[axis]) continue;
    if (!line.empty()) line += ' ';
    line += kAxisNames[axis];
    line += '=' + position[axis]->text();
  }
  return line;
}

std::string text(const Record& record) {
  std::string line(name(record.kind));
  if (record.block != 0) line += " b " + std::to_string(record.block);
  if (record.kind == RecordKind::m) return line + " M" + std::to_string(record.m);
  if (record.kind == RecordKind::dwell) return line + ' ' + record.seconds.text() + " s";
  line += " to " + text(record.to);
  const bool cuts = record.kind == RecordKind::feed || record.kind == RecordKind::arc ||
                    record.kind == RecordKind::arc3;
  if (cuts) line += " f " + record.feed.text() + (record.per_revolution ? " per revolution" : "");
  if (record.kind == RecordKind::arc) {
    line += " rot " + std::to_string(record.rotation) + " about " + text(record.centre);
  }
  if (record.kind == RecordKind::thread) {
    line += " lead " + record.lead.text() + " start " + record.start.text();
  }
  return line;
}

}  // namespace gonogo::checker
