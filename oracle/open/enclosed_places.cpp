// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/enclosed_places.hpp"

#include <algorithm>
#include <array>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

bool is_enclosed(const Number& value) {
  return value.form() == Number::Form::enclosure;
}

// A rational number no more than 2^-kShortBits from one that is only enclosed. One that cannot be
// enclosed so closely stays as it is.
Number rational_near(const Number& value) {
  if (!is_enclosed(value)) return value;
  const std::array<Number, 2> bounds = value.bounds(kShortBits + 4);
  if (bounds[1] - bounds[0] > Number::binary(1, -kShortBits)) return value;
  const Number scale = Number::binary(1, kShortBits + 4);
  return (bounds[0] * scale).floor() / scale;
}

// Whether an arc ends where it starts, as far as its enclosures tell.
bool closes(const Motion& motion, const reference::PlaneAxes& axes) {
  return motion.record.kind == RecordKind::arc &&
         visible_sign(motion.to()[axes.p] - motion.from[axes.p]) == 0 &&
         visible_sign(motion.to()[axes.q] - motion.from[axes.q]) == 0;
}

}  // namespace

region::PlanePoint plane_point_near(const Position& at, const reference::PlaneAxes& axes) {
  return {rational_near(at[axes.p]), rational_near(at[axes.q])};
}

region::LevelMotion level_motion_near(const Motion& motion, const reference::PlaneAxes& axes) {
  const Record& record = motion.record;
  region::LevelMotion part;
  part.is_arc = record.kind == RecordKind::arc;
  part.from = plane_point_near(motion.from, axes);
  part.to = closes(motion, axes) ? part.from : plane_point_near(motion.to(), axes);
  if (part.is_arc) part.centre = {rational_near(record.centre[0]), rational_near(record.centre[1])};
  part.rot = record.rot;
  part.record = motion.number;
  return part;
}

// The ends and the centre of an arc, and so its radius, may each be off on two axes.
Number slack_of_enclosures(const Motion& motion, const reference::PlaneAxes& axes) {
  const bool is_any = is_enclosed(motion.to()[axes.p]) || is_enclosed(motion.to()[axes.q]) ||
                      is_enclosed(motion.from[axes.p]) || is_enclosed(motion.from[axes.q]) ||
                      std::ranges::any_of(motion.record.centre, is_enclosed);
  return is_any ? Number::binary(1, -kShortBits + 3) : Number(0);
}

}  // namespace gonogo::oracle
