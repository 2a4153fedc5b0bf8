// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small programs in the axes p, q, d of a plane, and the ways in which one of them can be written.
// Lengths are counts of the least increment.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "reference/profile.hpp"

namespace gonogo::reference::testing {

using Point = std::array<std::int64_t, 3>;  // along p, q, d

enum class StepKind : std::uint8_t { rapid, feed, centre_arc, radius_arc, taper, pocket, dwell };

struct Step {
  StepKind kind = StepKind::rapid;
  bool per_revolution = false;
  // End points, absolute. Cycles have more than one where blocks without their code follow: end
  // points of the taper, centres and bottoms of pockets.
  std::vector<Point> ends;
  std::array<bool, 3> named = {true, true, true};  // which axis words stand
  int sense = -1;                                  // of arcs and pockets
  std::int64_t r = 0;  // R: of the arc, of the taper (along p), to the R plane (along d)
  std::array<std::int64_t, 2> offset = {0, 0};  // of the arc's centre
  std::int64_t pocket_radius = 0;               // I
  std::int64_t step = 0;                        // L
  std::int64_t infeed = 0;                      // Q
  std::int64_t clearance = 0;                   // P
  std::int64_t tool = 0;                        // D
  std::int64_t feed = 0;                        // F, or milliseconds
};

struct Model {
  Point start = {0, 0, 0};
  std::vector<Step> steps;
};

// Programs of up to eight steps; a few of them break a rule.
rc::Gen<Model> models();

// The program elsewhere, and its mirror images.
Model translated(Model model, const Point& shift);
Model mirrored_in_q(Model model);
Model mirrored_in_d(Model model);

// What a count of the least increment is written as: 0.001 mm, 0.001 inch, or that in millimetres.
enum class Lengths : std::uint8_t { mm, inch, inch_in_mm };

struct Writing {
  Plane plane = Plane::g18;
  bool diameter = true;
  bool incremental = false;
  Lengths lengths = Lengths::mm;
};

struct Word {
  char address;
  std::string number;
};
using Words = std::vector<Word>;  // of one block

std::vector<Words> write(const Model& model, const Writing& writing);
// The machine that a written program starts on.
Profile machine(const Model& model, const Writing& writing);
// One block a line, words apart by one space.
std::string text(const std::vector<Words>& blocks);

void operator<<(std::ostream& out, const Model& model);

}  // namespace gonogo::reference::testing
