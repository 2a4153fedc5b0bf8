// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times derived by hand.
#include "oracle/judge/cycle_time.hpp"

#include <gtest/gtest.h>

namespace gonogo::oracle {
namespace {

Record to(RecordKind kind, const Number& x, const Number& y) {
  Record record;
  record.kind = kind;
  record.axes = {Axis::x, Axis::y};
  record.to[Axis::x] = x;
  record.to[Axis::y] = y;
  return record;
}

Record cut(RecordKind kind, const Number& x, const Number& y, const Number& feed) {
  Record record = to(kind, x, y);
  record.feed = feed;
  return record;
}

CycleTime time_of(const std::vector<Record>& records) {
  CycleTime time({});
  for (const Record& record : records) time.take(record);
  return time;
}

// From (0, 0) to (3, 4): 5 mm; at 100 mm/min 5/100 min = 3 s.
TEST(CycleTime, OfALineIsItsLengthOverItsFeed) {
  const CycleTime time = time_of({cut(RecordKind::feed, 3, 4, 100)});
  EXPECT_EQ(time.feed_seconds(), 3);
  EXPECT_EQ(time.revolutions(), 0);
}

// 5 mm at 1/2 mm a turn: 10 turns, and no seconds without a speed.
TEST(CycleTime, OfACutPerTurnIsTurns) {
  Record record = cut(RecordKind::feed, 3, 4, Number(1) / 2);
  record.feed_mode = reference::FeedMode::per_revolution;
  const CycleTime time = time_of({record});
  EXPECT_EQ(time.revolutions(), 10);
  EXPECT_EQ(time.feed_seconds(), 0);
}

// A quarter about (10, 0) from (0, 0) to (10, 10), clockwise: 10 pi / 2 = 5 pi mm, at 60 mm/min
// 5 pi s = 15.70796326794896619... s. Counterclockwise it is three times as much.
TEST(CycleTime, OfAnArcIsEnclosed) {
  Record arc = cut(RecordKind::arc, 10, 10, 60);
  arc.centre = {10, 0};
  arc.rot = -1;
  EXPECT_EQ(time_of({arc}).feed_seconds().decimal_text(12), "15.707963267949");
  EXPECT_EQ(time_of({arc}).feed_seconds().form(), Number::Form::enclosure);
  arc.rot = 1;
  EXPECT_EQ(time_of({arc}).feed_seconds().decimal_text(12), "47.123889803847");
}

// Once round a circle of 10 mm with 1 mm of height: the root of (20 pi)^2 + 1 = 62.839809 mm.
TEST(CycleTime, OfAHelixHasItsHeight) {
  Record arc = cut(RecordKind::arc, 0, 0, 60);
  arc.axes.add(Axis::z);
  arc.to[Axis::z] = 1;
  arc.centre = {10, 0};
  arc.rot = 1;
  EXPECT_EQ(time_of({arc}).feed_seconds().decimal_text(6), "62.839810");
}

// Two traverses of 5 mm, and dwells of 1.5 s and 0.5 s.
TEST(CycleTime, KeepsTraversesAndDwellsApart) {
  Record dwell;
  dwell.kind = RecordKind::dwell;
  dwell.seconds = Number(3) / 2;
  Record other = dwell;
  other.seconds = Number(1) / 2;
  const CycleTime time =
      time_of({to(RecordKind::rapid, 3, 4), dwell, to(RecordKind::rapid, 0, 0), other});
  EXPECT_EQ(time.rapid_length(), 10);
  EXPECT_EQ(time.dwell_seconds(), 2);
  EXPECT_EQ(time.feed_seconds(), 0);
}

// 12 mm along X and 5 along Y with a lead of 2 along the longer axis: 6 turns.
TEST(CycleTime, OfAThreadIsTurns) {
  Record thread = to(RecordKind::thread, 12, 5);
  thread.lead = 2;
  EXPECT_EQ(time_of({thread}).revolutions(), 6);
}

TEST(CycleTime, LeavesRotaryMotionsOut) {
  Record record = cut(RecordKind::feed, 3, 4, 100);
  record.axes.add(Axis::c);
  record.to[Axis::c] = 90;
  EXPECT_EQ(time_of({record}).left_out(), 1U);
  EXPECT_EQ(time_of({record}).feed_seconds(), 0);
}

}  // namespace
}  // namespace gonogo::oracle
