// SPDX-License-Identifier: GPL-3.0-or-later
//
// The records of a trace: what a machine is told to do, one motion each.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "checker/real.hpp"

namespace gonogo::checker {

inline constexpr std::size_t kAxes = 5;
inline constexpr std::string_view kAxisNames = "xyzac";

// What is known of a position; lengths in mm, angles in degrees.
using Position = std::array<std::optional<Real>, kAxes>;

// The axes of a plane as places in a Position: first, second, and the one across it.
struct Plane {
  std::size_t first = 0;
  std::size_t second = 1;
  std::size_t third = 2;
  bool operator==(const Plane&) const = default;
};

enum class RecordKind { rapid, feed, arc, arc3, thread, dwell, m, end };

struct Record {
  RecordKind kind = RecordKind::rapid;
  long block = 0;  // source line, from 1; 0: not given
  Position to;     // what is named
  Real feed;       // mm/min, or mm/rev
  bool per_revolution = false;
  Plane plane;         // arc
  Position centre;     // arc: the two axes of the plane
  long rotation = 0;   // arc
  Position via;        // arc3
  Real lead, start;    // thread: mm/rev, degrees
  Real seconds;        // dwell
  long m = 0;          // m
  std::string clause;  // of a vector
};

// An alarm as a subject gave it; `kind` is empty when it has no class of the gauge.
struct Alarm {
  std::string kind;
  long block = 0;  // 0: not given
};

// Throws Fault.
Position read_position(const Json& value);
Record read_record(const Json& value);
Alarm read_alarm(const Json& value);

std::string_view name(RecordKind kind);
std::string text(const Position& position);
// "feed b 3 to x=1 z=11/3", for messages.
std::string text(const Record& record);

}  // namespace gonogo::checker
