// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/plain_motion.hpp"

#include <algorithm>

namespace gonogo::oracle {
namespace {

using exact::NumberAccess;
using reference::kAxes;

bool is_small(const Number& value) {
  return NumberAccess::node(value) == nullptr;
}

bool take(const Number& value, std::int64_t& millionths) {
  millionths = NumberAccess::millionths(value);
  return is_small(value);
}

bool is(const Number& value, std::int64_t millionths) {
  return is_small(value) && NumberAccess::millionths(value) == millionths;
}

}  // namespace

Position position_of(const PlainMotion::Place& place) {
  Position position;
  for (std::size_t i = 0; i < kAxes; ++i) position.at[i] = Number::millionths(place[i]);
  return position;
}

bool take_place(const Position& position, PlainMotion::Place& place) {
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (!take(position.at[i], place[i])) return false;
  }
  return true;
}

bool PlainMotion::take(const Record& record, const Place& start) {
  if (record.kind > RecordKind::arc || record.block == 0) return false;
  kind = record.kind;
  axes = record.axes;
  block = record.block;
  clause = record.clause;
  from = start;
  to = start;
  for (const Axis axis : reference::kAllAxes) {
    if (!axes.has(axis)) continue;
    const auto i = index(axis);
    if (!oracle::take(record.to.at[i], to[i])) return false;
  }
  if (kind == RecordKind::rapid) return true;
  feed_mode = record.feed_mode;
  if (!oracle::take(record.feed, feed)) return false;
  if (kind == RecordKind::feed) return true;
  plane = record.plane;
  rot = record.rot;
  return oracle::take(record.centre[0], centre[0]) && oracle::take(record.centre[1], centre[1]);
}

bool PlainMotion::is(const Record& record) const {
  if (record.kind != kind || record.block != block) return false;
  for (const Axis axis : reference::kAllAxes) {
    const auto i = index(axis);
    const bool same = record.axes.has(axis) ? oracle::is(record.to.at[i], to[i]) : from[i] == to[i];
    if (!same) return false;
  }
  if (kind == RecordKind::rapid) return true;
  if (record.feed_mode != feed_mode || !oracle::is(record.feed, feed)) return false;
  if (kind == RecordKind::feed) return true;
  return record.plane == plane && record.rot == rot && oracle::is(record.centre[0], centre[0]) &&
         oracle::is(record.centre[1], centre[1]);
}

std::size_t PlainMotion::coordinates() const {
  const auto ends = std::ranges::count_if(reference::kLinearAxes, [&](Axis axis) {
    return axes.has(axis) && from[index(axis)] != to[index(axis)];
  });
  return static_cast<std::size_t>(ends) + (kind == RecordKind::arc ? 2 : 0);
}

bool PlainMotion::is_visible(const Tolerances& tolerances) const {
  // Up to here two doubles are off by less than a millionth together.
  constexpr std::int64_t kFarthest = std::int64_t{1} << 51;
  if (!is_small(tolerances.tolerance)) return false;
  const std::int64_t tau = NumberAccess::millionths(tolerances.tolerance);
  // Without a branch an axis: all axes at once.
  bool far = false;
  for (std::size_t i = 0; i < kAxes; ++i) {
    far |= std::abs(from[i]) > kFarthest;
    far |= std::abs(to[i]) > kFarthest;
  }
  if (far) return false;
  bool visible = false;
  for (std::size_t i = 0; i < kAxes; ++i) visible |= std::abs(to[i] - from[i]) > tau;
  return visible;
}

}  // namespace gonogo::oracle
