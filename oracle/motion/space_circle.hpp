// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circles in space through three points (`arc3`), by rational arithmetic: centre, normal and
// squared radius follow from the points without a root, and so do points of the circle.
#pragma once

#include <array>
#include <optional>

#include "oracle/motion/motion.hpp"

namespace gonogo::oracle {

// x, y, z; also a vector. It has the operations of the kernel of reference/geometry/, for code that
// does without that kernel.
using SpacePoint = std::array<Number, 3>;

SpacePoint space_point(const Position& point);
SpacePoint operator-(const SpacePoint& a, const SpacePoint& b);
Number dot(const SpacePoint& a, const SpacePoint& b);
SpacePoint cross(const SpacePoint& a, const SpacePoint& b);
bool is_rational(const SpacePoint& point);

// The intermediate point of an arc3, with the other axes where it starts.
Position via_of(const Motion& arc3);

struct SpaceCircle {
  SpacePoint centre;
  SpacePoint normal;  // seen against it, the three points follow each other counterclockwise
  Number radius_2;
};

// Nothing where the points lie in line.
std::optional<SpaceCircle> circle_through(const SpacePoint& a, const SpacePoint& via,
                                          const SpacePoint& b);

// Whether a point of the circle lies in the box round `point`: the box and the circle's plane have
// a convex polygon in common, whose nearest and farthest points from the centre enclose the radius.
// REQUIRES: all rational.
bool passes_box(const SpaceCircle& circle, const SpacePoint& point, const Number& tolerance);

// The part of a turn, in [0, 1), from one point to another about the circle's axis. An estimate.
double part_of_turn(const SpaceCircle& circle, const SpacePoint& from, const SpacePoint& to);

// A point of the circle through three points about half way from b to c, on the side of b c that is
// not a's: a turned to infinity, the circle is the line through b and c. REQUIRES: all rational and
// different.
SpacePoint middle_seen_from(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c);

}  // namespace gonogo::oracle
