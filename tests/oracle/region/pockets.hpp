// SPDX-License-Identifier: GPL-3.0-or-later
//
// Levels of pockets with rounded corners for the tests and the benchmark, in the pocket's frame:
// three ways to clear one, all exact, and all with the border last.
#pragma once

#include <string_view>
#include <vector>

#include "oracle/region/rectangle.hpp"
#include "oracle/region/rules.hpp"

namespace gonogo::oracle::region {

struct Pocket {
  RectangularLevel level;
  std::vector<LevelMotion> motions;
};

// Length, width and corner radius of the contour, tool radius, allowance R124; tolerance 0.001,
// counterclockwise, plunge at the centre.
Pocket pocket(std::string_view length, std::string_view width, std::string_view corner,
              std::string_view tool, std::string_view allowance);

// The points that the tool's centre may reach.
RoundedRectangle border_of(const Pocket& pocket);

void line_to(Pocket& pocket, const PlanePoint& to);
void arc_to(Pocket& pocket, const PlanePoint& to, const PlanePoint& centre, int rot);

// A straight line to the middle of the shape's lower side and once round it, counterclockwise or
// clockwise; along a shape that is a line forth and back.
void go_round(Pocket& pocket, const RoundedRectangle& shape, int sense);
// The border of the reachable area, the way the level says.
void finish(Pocket& pocket);

// Rows along p, `step` apart, that keep half a step from the border; then the border.
void zigzag(Pocket& pocket, const Number& step);
// Round shapes that grow by the step from the middle to the border.
void contour_parallel(Pocket& pocket, const Number& step);
// Circles of the given radius, not above the tool's, each `step` on from the last, in rows one and
// a half diameters apart; then the border.
void trochoidal(Pocket& pocket, const Number& radius, const Number& step);

LevelVerdict judge(const Pocket& pocket);

}  // namespace gonogo::oracle::region
