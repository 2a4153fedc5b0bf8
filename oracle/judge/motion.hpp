// SPDX-License-Identifier: GPL-3.0-or-later
//
// A record together with where it starts; dropping and joining, by which both sides get one form.
#pragma once

#include <cstddef>
#include <optional>

#include "reference/record.hpp"

namespace gonogo::oracle {

using reference::Axis;
using reference::AxisSet;
using reference::Number;
using reference::Position;
using reference::Record;
using reference::RecordKind;

struct Motion {
  Record record;  // `to` holds every axis
  Position from;
  std::size_t number = 0;  // place of its (first) record in the trace, from 0

  const Position& to() const { return record.to; }
};

// The motion of a record that starts at `from`: axes that the record does not name stay.
Motion motion_from(const Position& from, const Record& record, std::size_t number);

// The same point under the names that a renaming of the position gives: new less old coordinate.
void shift(Position& position, const Position& by);

// Whether no axis differs by more than `tolerance`.
bool agree(const Position& a, const Position& b, const Number& tolerance);
bool agree(const Number& a, const Number& b, const Number& tolerance);
// The largest difference of an axis.
Number largest_difference(const Position& a, const Position& b);
// The axes along which the motion goes, by more than `tolerance`.
AxisSet moved_axes(const Motion& motion, const Number& tolerance);

// Directions about the centre of an arc, in the sense of its turning. Exact.
// The vector from the arc's centre to a point, in the arc's plane.
struct PlaneVector {
  Number p;
  Number q;
};
PlaneVector from_centre(const Record& arc, const Position& point);
// Compares the angles from `origin` to a and to b, in the sense of `sense`, both in [0, 360).
int compare_angles(const PlaneVector& origin, const PlaneVector& a, const PlaneVector& b,
                   int sense);
// Whether the point lies at the same angle as the origin.
bool same_direction(const PlaneVector& a, const PlaneVector& b);

// An arc whose end is its start goes all the way round; so does one with more than one turn.
bool makes_full_turn(const Motion& motion);
// An arc of more than half a turn is no small motion, however near its ends are.
bool nearly_full_turn(const Motion& motion);
// Sweep of an arc in turns, for choosing between whole numbers of turns only.
double approximate_turns(const Motion& arc);

// Joins `next` to `motion` when they are of equal kind, feed and block and continue the same line
// in the same direction, or the same circle in the same sense; rapids, along one axis alone.
bool join(Motion& motion, const Motion& next);

}  // namespace gonogo::oracle
