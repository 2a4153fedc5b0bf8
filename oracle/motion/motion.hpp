// SPDX-License-Identifier: GPL-3.0-or-later
//
// A record together with where it starts, and the joining of motions that go on in one way.
#pragma once

#include <cstddef>
#include <optional>

#include "oracle/region/level.hpp"
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
  std::size_t number = 0;        // place of its (first) record in the trace, from 0
  std::size_t behind_first = 0;  // place of its last record, counted from the first

  const Position& to() const { return record.to; }
};

constexpr bool is_round(RecordKind kind) {
  return kind == RecordKind::arc || kind == RecordKind::arc3;
}

// What a motion of the reference says of its end: the linear axes that its record names and along
// which it moves, as far as a look shows. A subject may name more of them or fewer.
bool tells_end(const Motion& motion, Axis axis);
// How many coordinates that is, with those of an arc's centre.
std::size_t coordinates_in(const Motion& motion);

// The motion of a record that starts at `from`: axes that the record does not name stay.
Motion motion_from(const Position& from, const Record& record, std::size_t number);

// A motion that is another one to the last digit is the whole of it, by every rule of `Curve`:
// nearly always the case of a subject that computes in decimals. False says nothing: the numbers
// are not small, or the kind is another.
bool is_same_motion(const Motion& a, const Motion& b);
// Two points of small numbers that are the same; false where that takes more than a look.
bool is_same_point(const Position& a, const Position& b);

// The same point under the names that a renaming of the position gives: new less old coordinate.
void shift(Position& position, const Position& by);

// R2: whether no axis differs by more than `tolerance`.
bool agree(const Position& a, const Position& b, const Number& tolerance);
bool agree(const Number& a, const Number& b, const Number& tolerance);
// -1, 0 or 1: the sign as far as can be seen; exact, but 0 where an enclosure leaves it open.
int visible_sign(const Number& value);
// The largest difference of a linear axis, mm.
Number largest_difference(const Position& a, const Position& b);
// The axes along which the motion goes, by more than `tolerance`.
AxisSet moved_axes(const Motion& motion, const Number& tolerance);

// Directions about the centre of an arc, in the sense of its turning. Exact.
// The vector from the arc's centre to a point, in the arc's plane.
using PlaneVector = region::PlanePoint;
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
// Whether a motion whose ends agree within the tolerance goes round nevertheless: an arc of more
// than half a turn, a circle in space whose intermediate point lies elsewhere.
bool goes_round(const Motion& motion, const Number& tolerance);
// As a double, for estimates: to 2^-60, or to the width of an enclosure.
double estimate(const Number& value);
double estimate_length(const PlaneVector& v);
// Two units in the last place of a double of that size: by so much an operation of a control in
// doubles, with the conversion of its operand, may be off.
Number two_units_of_double(double size);
// Sweep of an arc in turns, for choosing between whole numbers of turns only.
double approximate_turns(const Motion& arc);

// The same motion, but an `arc3` whose points lie in line, the intermediate one between the ends,
// is its chord.
Motion straightened(Motion motion);
// An `arc3` in a plane parallel to a coordinate plane as `arc`; nothing where it is not, or where
// its points lie in line. Another motion as it is.
std::optional<Motion> as_arc(const Motion& motion);

// R1: joins `next` to `motion` when they are of equal kind, feed and block and continue the same
// line in the same direction, or the same circle in the same sense; rapids only along one axis,
// circles in space only up to a full turn together. What an enclosure leaves open counts as the
// same line or circle.
bool join(Motion& motion, const Motion& next);

}  // namespace gonogo::oracle
