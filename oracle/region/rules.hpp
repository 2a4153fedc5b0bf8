// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules of a level, for every kind of pocket.
#pragma once

#include <span>

#include "oracle/region/coverage.hpp"

namespace gonogo::oracle::region {

// Either kind of level.
struct AnyLevel : CommonLevel {
  explicit AnyLevel(const CommonLevel& terms)
      : CommonLevel(terms), turns(terms.open_turns.value_or(OpenTurns{terms.tolerance})) {}

  PlanePoint middle;
  RoundedRectangle area;  // about the middle
  std::optional<RoundedRectangle> cleared;
  std::optional<Number> step;
  bool by_border = false;  // lines clear like arcs, and only what runs along the border has a sense
  OpenTurns turns;         // what is open of them: asked for, or within the tolerance

  // Where the tool's centre may be.
  RoundedRectangle border() const { return with_radius(area, area.radius - tool_radius); }
};

// The first rule broken in the order sense, gouge, cover, step, order.
LevelVerdict judge_by_rules(const AnyLevel& terms, std::span<const LevelMotion> motions,
                            Method method);

// `judge_level` with a choice of method, for the tests.
LevelVerdict judge_level_by(Method method, const CircularLevel& level,
                            std::span<const LevelMotion> motions);
LevelVerdict judge_level_by(Method method, const RectangularLevel& level,
                            std::span<const LevelMotion> motions);

}  // namespace gonogo::oracle::region
