// SPDX-License-Identifier: GPL-3.0-or-later
//
// The geometry of a record as the bench sees it: apart from the judge's, and in doubles. All that
// is said of it is said with a margin that is a thousand times what doubles lose.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "reference/outcome.hpp"

namespace gonogo::mutations {

using reference::Number;
using reference::Record;
using reference::RecordKind;

using Place = std::array<double, reference::kAxes>;  // mm, degrees
using Vector = std::array<double, 3>;                // x, y, z

double value_of(const Number& number);
Place place_of(const reference::Position& position);
// The largest difference of an axis.
double apart(const Place& a, const Place& b);
double length_of(const Vector& v);
// How far along p and q a place is from a point of the plane.
double plane_radius(const reference::PlaneAxes& axes, const Place& at,
                    const std::array<double, 2>& centre);

// A motion or a dwell. An arc has radii that lead linearly from start to end.
struct Stroke {
  const Record* record = nullptr;
  std::size_t number = 0;  // of the record in its trace
  Place from{};
  Place to{};
  Place renamed{};  // by how much its places are named otherwise than at the start
  bool is_round = false;
  bool meets_itself = false;  // round: the end is the start, so that it is a full turn for certain
  Vector centre{};            // round: in the plane of the circle; u, v span it
  Vector u{};
  Vector v{};
  double start_angle = 0;  // from u towards v
  double sweep = 0;        // radians, signed from u towards v
  double from_radius = 0;
  double to_radius = 0;
  double via_apart = 0;  // arc3 that is no circle: its intermediate point from its start

  RecordKind kind() const { return record->kind; }
  bool is_dwell() const { return record->kind == RecordKind::dwell; }
  // A place in the names of the start: G50 and G92 move nothing.
  Place unnamed(const Place& place) const;
  // 0 at the start, 1 at the end.
  Place at(double part) const;
  // Whether it may be meant as none: its ends agree within the tolerance, and it makes no turn
  // (J-PATH-06).
  bool is_nil(double tolerance) const;
  // The same, but that a turn of it is none is certain.
  bool is_surely_nil(double tolerance) const;
};

// A new name of the position, G50 or G92: from the first record of a later block on.
struct NewName {
  std::uint64_t block = 0;
  Place shift{};
};

// The motions and dwells of a trace.
std::vector<Stroke> strokes_of(std::span<const Record> records, const Place& start,
                               std::span<const NewName> names);

}  // namespace gonogo::mutations
