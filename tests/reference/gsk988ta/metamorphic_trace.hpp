// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reference says of a program, in the axes of its plane.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "expanding.hpp"
#include "metamorphic_program.hpp"

namespace gonogo::reference::testing {

// An item in the axes of the plane, with all that a change of writing may not touch.
struct Seen {
  int kind = 0;  // of the item
  RecordKind record = RecordKind::rapid;
  std::uint64_t block = 0;
  ClauseId clause = kNoClause;
  std::array<bool, 3> named = {};
  std::array<Number, 3> to = {};  // of named axes
  std::array<Number, 2> centre = {};
  int rot = 0;
  Number feed;
  FeedMode feed_mode = FeedMode::per_minute;
  Number seconds;
  std::vector<Number> depths;  // further coordinates along d: of the planes of an open path
  std::vector<Number> sizes;   // lengths, counts and choices that stay the same everywhere
  std::vector<std::pair<AlarmClass, ClauseId>> alarms;  // in the order of their classes
};
using Trace = std::vector<Seen>;

// Exactly the same. Two enclosures are nowhere apart by more than 2^-256 mm, and the
// programs are too short for two different values to be as close.
bool same_value(const Number& a, const Number& b);
template <typename Numbers>
bool same_values(const Numbers& a, const Numbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_value);
}
bool operator==(const Seen& a, const Seen& b);

// An arc, or an open path: it has a centre.
inline bool has_centre(const Seen& seen) {
  return seen.rot != 0;
}

Trace look(const std::string& program, const Profile& profile, Plane plane,
           OpenPaths open_paths = OpenPaths::shown);
Trace look(const Model& model, const Writing& writing, OpenPaths open_paths = OpenPaths::shown);

}  // namespace gonogo::reference::testing
