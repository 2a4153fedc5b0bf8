// SPDX-License-Identifier: GPL-3.0-or-later
//
// A fast path before dropping, joining and matching: motions in small numbers, which the judge
// uses only while both sides have the same ones.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "oracle/motion/motion.hpp"
#include "oracle/motion/tolerances.hpp"

namespace gonogo::oracle {

// A rapid, feed or arc whose numbers are all whole millionths. Lengths in millionths of a
// millimetre.
struct PlainMotion {
  using Place = std::array<std::int64_t, reference::kAxes>;

  RecordKind kind = RecordKind::rapid;
  reference::FeedMode feed_mode = reference::FeedMode::per_minute;
  reference::Plane plane = reference::Plane::g17;
  AxisSet axes;  // that the record names
  std::int32_t rot = 0;
  std::uint64_t block = 0;
  reference::ClauseId clause = reference::kNoClause;
  Place from = {};
  Place to = {};
  std::int64_t feed = 0;                    // feed, arc
  std::array<std::int64_t, 2> centre = {};  // arc

  // Becomes the motion of a record that starts at `from`. False, and the rest unspecified, where
  // the record is another kind, its line is not known, or a number takes more.
  bool take(const Record& record, const Place& from);

  // Whether the record, from the same start, is the same motion to the last digit.
  bool is(const Record& record) const;

  // What coordinates_in() gives for such a motion.
  std::size_t coordinates() const;

  // Whether it is longer than the tolerance along an axis, by more than a subject's doubles may be
  // off, so that neither side drops it.
  bool is_visible(const Tolerances& tolerances) const;
};

// A place in millionths; false where a number takes more. And back.
bool take_place(const Position& position, PlainMotion::Place& place);
Position position_of(const PlainMotion::Place& place);

// A filter before the reader of a trace, in plain_line.cpp: whether the line is this motion's
// record in JSON, with its keys in the order of `append_json`, no blanks, and the motion's clause
// or none. False says nothing: the line has to be read.
// REQUIRES: the motion is of a record, whose feed is not negative.
bool is_line_of(const PlainMotion& motion, std::string_view line);

}  // namespace gonogo::oracle
