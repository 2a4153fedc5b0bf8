// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bench's own statement of whether one trace can be read as another: is there a way to lay its
// motions along the right path, in order and without a gap? All ways are tried, where the judge
// follows one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "stroke.hpp"

namespace gonogo::mutations {

// Widths within which a place counts as another, mm.
struct Margin {
  double place = 0;     // of an end, and of a centre
  double arc = 0;       // of places along an arc
  double nil = 0;       // what may be omitted as negligible
  bool strict = false;  // what is too small to see, or of another kind, does not fit
};

// A part of the path that the manual leaves open, with conditions that each right path meets.
class OpenPart {
 public:
  virtual ~OpenPart() = default;
  // The condition that these motions break; empty where there is none.
  virtual std::string broken_by(std::span<const Stroke> strokes, const Margin& margin) const = 0;
};

// A motion or dwell of the right path, or an open part: then its strokes are those of the path
// that is shown.
struct PathElement {
  std::vector<Stroke> strokes;
  std::shared_ptr<const OpenPart> open;
};

enum class Fit {
  none,   // no way to read the one as the other
  open,   // only by another path through an open part, of which no condition is broken
  along,  // along the right path
};

struct MapResult {
  Fit fit = Fit::none;
  std::size_t reached = 0;  // the first motion that fits nowhere, of those read furthest
  std::string broken;       // the condition of an open part that decided
};

// The same path in as few motions as say it: what goes on in the same line or circle is one.
std::vector<Stroke> joined(std::span<const Stroke> strokes);

MapResult map_onto(std::span<const PathElement> path, std::span<const Stroke> got,
                   const Margin& margin);

}  // namespace gonogo::mutations
