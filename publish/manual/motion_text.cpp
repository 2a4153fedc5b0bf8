// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/manual/motion_text.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace gonogo::oracle::manual {
namespace {

using reference::Axis;
using reference::AxisSet;
using reference::Position;
using reference::Record;
using reference::RecordKind;

constexpr int kShownDecimals = 6;

std::string feed_text(const Record& record, bool in_degrees = false) {
  return fmt::format("{} {}", shown_number(record.feed),
                     reference::feed_unit(record.feed_mode, in_degrees));
}

std::string arc_text(const Record& record) {
  const reference::PlaneAxes axes = reference::axes_of(record.plane);
  const int turns = std::abs(record.rot) - 1;
  return fmt::format("{} arc (G{}) about {}{} {}{} to {}{}, {}",
                     record.rot < 0 ? "clockwise" : "counterclockwise", plane_code(record.plane),
                     capital(axes.p), shown_number(record.centre[0]), capital(axes.q),
                     shown_number(record.centre[1]), point_text(record.to, record.axes),
                     turns > 0 ? fmt::format(" after {} whole turn{}", turns, turns > 1 ? "s" : "")
                               : std::string(),
                     feed_text(record));
}

}  // namespace

std::string shown_number(const reference::Number& value) {
  std::string text = value.is_rational() ? value.text() : std::string();
  if (text.empty() || text.find('/') != std::string::npos) {
    text = value.decimal_text(kShownDecimals);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

char capital(Axis axis) {
  return static_cast<char>(letter(axis) - 'a' + 'A');
}

std::string point_text(const Position& at, const AxisSet& axes) {
  std::string text;
  for (Axis axis : reference::kAllAxes) {
    if (!axes.has(axis)) continue;
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", capital(axis), shown_number(at[axis]));
  }
  return text;
}

namespace {

std::string motion_text(const Record& record, const Position& from) {
  const std::string to = point_text(record.to, record.axes);
  switch (record.kind) {
    case RecordKind::rapid:
      return "rapid to " + to;
    case RecordKind::feed:
      return fmt::format("feed to {}, {}", to, feed_text(record, turns_alone(record, from)));
    case RecordKind::arc:
      return arc_text(record);
    case RecordKind::arc3:
      return fmt::format("arc through {} to {}, {}", point_text(record.via, record.via_axes), to,
                         feed_text(record));
    case RecordKind::thread:
      return fmt::format("thread to {}, lead {} mm, start {} degrees", to,
                         shown_number(record.lead), shown_number(record.start));
    case RecordKind::dwell:
      return fmt::format("dwell of {} s", shown_number(record.seconds));
    case RecordKind::m:
      return fmt::format("M{}", record.m);
    case RecordKind::end:
      return "end at " + to;
  }
  return {};
}

}  // namespace

std::string MotionTexts::next(const Record& record) {
  std::string text = motion_text(record, at_);
  pass(record);
  return text;
}

void MotionTexts::pass(const Record& record) {
  for (const Axis axis : reference::kAllAxes) {
    if (record.axes.has(axis)) at_[axis] = record.to[axis];
  }
}

void MotionTexts::rename(const Position& shift) {
  for (const Axis axis : reference::kAllAxes) at_[axis] += shift[axis];
}

}  // namespace gonogo::oracle::manual
