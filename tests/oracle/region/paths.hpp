// SPDX-License-Identifier: GPL-3.0-or-later
//
// Levels of a circular pocket for the tests, and an independent look at the judge's answers.
#pragma once

#include <string_view>
#include <vector>

#include "oracle/region/rules.hpp"

namespace gonogo::oracle::region {

// The number as it is written.
Number mm(std::string_view text);

struct Job {
  CircularLevel level;
  std::vector<LevelMotion> motions;
};

// I16 L3 D4 clockwise about the origin with a tolerance of 0.001: E has radius 12, the step rule
// reaches 1.501, the cover rule 4.001.
CircularLevel i16_l3_d4(int sense = -1);

// Appends a motion that starts where the last one ended (the plunge point before the first).
void line_to(Job& job, const PlanePoint& to);
void arc_to(Job& job, const PlanePoint& to, const PlanePoint& centre, int rot);

// A radial line to the angle's direction (p, q), a unit vector, and a full circle there.
void circle(Job& job, const Number& radius, const PlanePoint& direction);
Job concentric(const CircularLevel& level, const std::vector<Number>& radii);

// Ends s_k on alternating sides, first +p, abs(s_k) = min(k L/2, E); then the circle of radius E.
Job semicircles(const CircularLevel& level, bool closing_circle = true);

Job moved(Job job, const PlanePoint& by);
// Every coordinate of the motions to the nearest 0.001.
Job rounded(Job job);

LevelVerdict judge(const Job& job);

// What is wrong with a NO-GO, derived again from the motions; empty when the witness holds.
std::string flaw_of_finding(const Job& job, const Finding& finding);
// A place that a GO leaves uncovered by more than 1e-6, sampled densely in doubles; empty: none.
std::string flaw_of_go(const Job& job);

}  // namespace gonogo::oracle::region
