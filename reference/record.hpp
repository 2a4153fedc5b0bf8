// SPDX-License-Identifier: GPL-3.0-or-later
//
// The trace: what a program makes the machine do, one record a motion. Names follow the NIST
// canonical machining functions.
#pragma once

#include <cstdint>
#include <string>

#include "reference/axis.hpp"
#include "reference/clause.hpp"

namespace gonogo::reference {

enum class RecordKind : std::uint8_t { rapid, feed, arc, arc3, thread, dwell, m, end };
std::string_view name(RecordKind kind);

enum class FeedMode : std::uint8_t { per_minute, per_revolution };

// One record. Fields that its kind does not use keep their defaults.
struct Record {
  RecordKind kind = RecordKind::rapid;
  FeedMode feed_mode = FeedMode::per_minute;
  Plane plane = Plane::g17;    // arc
  AxisSet axes;                // those that `to` names
  std::int32_t rot = 0;        // arc: sign + counterclockwise seen from +d, n - 1 whole turns first
  std::int32_t m = 0;          // m
  bool before_cut = false;     // m: it has to come before the cutting motions of its block
  bool among_motions = false;  // m: the text says between which motions and dwells it comes
  std::uint64_t block = 0;     // 1-based source line; 0: not known
  ClauseId clause = kNoClause;  // what says so
  // How finely the control computes the centre of an arc. No part of the trace.
  ClauseId centre_clause = kNoClause;
  Position to;                   // end point
  Number feed;                   // feed, arc, arc3: mm/min or mm/rev of the path
  std::array<Number, 2> centre;  // arc: along p and q
  Number lead;                   // thread: mm/rev along the longer axis
  Number start;                  // thread: spindle angle, degrees
  Number seconds;                // dwell
  AxisSet via_axes;              // arc3
  Position via;                  // arc3: intermediate point
};

// One that has to be filled in.
inline Record record_of(RecordKind kind, std::uint64_t block, ClauseId clause) {
  Record record;
  record.kind = kind;
  record.block = block;
  record.clause = clause;
  return record;
}

constexpr bool is_motion(RecordKind kind) {
  return kind <= RecordKind::thread;
}

// Whether the record, from there, moves rotary axes alone, as far as numbers can be told apart: its
// feed is then in degrees (docs/protocol.md).
bool turns_alone(const Record& record, const Position& from);
// "mm/min", "degrees/rev"
std::string_view feed_unit(FeedMode mode, bool in_degrees);

// One JSON object without the line end: {"k":"feed","b":3,"to":{"x":"1.5"},"f":"200",...}.
void append_json(const Record& record, std::string& out);

}  // namespace gonogo::reference
