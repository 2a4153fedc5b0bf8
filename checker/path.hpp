// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records as a path: motions with both ends, nil ones dropped, those that continue joined.
#pragma once

#include <functional>
#include <vector>

#include "checker/record.hpp"

namespace gonogo::checker {

// A motion, or a dwell.
struct Motion {
  Record record;  // of a joined motion: with the end of the last, and the rotation of all
  Position from;  // an axis of unknown position is left out
  Position to;
  bool is_open = false;   // is_open_path
  std::size_t place = 0;  // of the record, from 0
};

struct Path {
  std::vector<Motion> motions;
  std::vector<Record> functions;     // kind m
  std::vector<std::size_t> behind;   // of each function: how many of the motions come before it
  bool joins_over_function = false;  // one stood between motions that have become one
  Position end;
  // Something could not be decided about dropping and joining: a departure may be no departure.
  bool is_doubtful = false;
  bool drops = false;  // motions no longer than the tolerance
};

struct PathTolerances {
  Position start;
  Real tolerance;     // mm or degrees: points no farther apart agree
  long renaming = 0;  // from this line on positions are unknown until they are sent; 0: none
  std::function<bool(const Record&)> is_open = nullptr;
  // For a subject: whether an arc whose ends agree is a whole turn or none is seen when it is
  // matched.
  bool keeps_short_arcs = false;
};

Path make_path(const std::vector<Record>& records, const PathTolerances& tolerances);

// Whether no axis that is known on both sides differs by more than the tolerance.
Truth agree(const Position& p, const Position& q, const Real& tolerance);
// Whether the ends of a motion, and the point that an arc in space passes, agree with the place.
Truth stays_by(const Motion& motion, const Position& place, const Real& reach);
// The square of the distance in the plane.
Real distance2(const Plane& plane, const Position& p, const Position& q);
// The sine of the turn from p to q about the centre: positive when q lies up to half a turn
// counterclockwise of p.
Real cross(const Plane& plane, const Position& centre, const Position& p, const Position& q);
Real dot(const Plane& plane, const Position& centre, const Position& p, const Position& q);
// The rotation of two arcs about one centre as one; nothing: undecided.
std::optional<long> joined_rotation(const Motion& first, const Motion& second);

}  // namespace gonogo::checker
