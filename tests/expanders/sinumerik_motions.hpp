// SPDX-License-Identifier: GPL-3.0-or-later
// The motions of a run as numbers.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "harness.hpp"

namespace gonogo::expanders::testing {

struct Motion {
  char kind = 'r';  ///< r: rapid, f: feed, a: arc, d: dwell
  std::string text;
  std::size_t block = 0;
  std::array<double, 3> from{};
  std::array<double, 3> to{};
  std::array<double, 2> centre{};  ///< of an arc, in its plane
  int rot = 0;
  double f = 0;
};

/// Rapids, feeds, arcs and dwells, from the zero point on.
std::vector<Motion> motions_of(const Outcome& outcome);

/// The same as text; straight motions with the axes only that move.
std::string moving(const Outcome& outcome);

/// The places along axis 2 at which feeds along it alone end.
std::vector<double> plunges(const Outcome& outcome, std::size_t axis = 2);

}  // namespace gonogo::expanders::testing
