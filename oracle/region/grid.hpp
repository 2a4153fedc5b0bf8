// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which bands come near a point: square cells over the area, found by descending a quadtree that is
// built where it is asked. Doubles only: a band that it misses makes the filter undecided, never
// wrong.
#pragma once

#include <span>
#include <vector>

#include "oracle/region/band.hpp"

namespace gonogo::oracle::region {

class Grid {
 public:
  // Cells over the square of the given half side about the origin. The bands must outlive the grid.
  Grid(std::span<const Band> bands, double half_side, double reach);

  // Valid as long as the grid.
  std::span<const std::uint32_t> near(double x, double y) const;
  // Those near any point of the box of the given half width, each once.
  std::vector<std::uint32_t> near_box(double x, double y, double half) const;

 private:
  // A square of cells and the bands near it.
  struct Square {
    int column;
    int row;
    int side;  // in cells
    std::vector<std::uint32_t> bands;
    std::size_t parts = 0;  // where its four quarters begin; 0: not asked for yet
    bool known = false;     // whether `bands` is filled
  };
  int index(double coordinate) const;
  const std::vector<std::uint32_t>& cell(int column, int row) const;
  void split(std::size_t square) const;
  void fill(Square& square, const std::vector<std::uint32_t>& candidates) const;

  std::span<const Band> bands_;
  double radius_;
  int side_ = 1;  // cells a side, a power of two
  double width_;  // of a cell
  mutable std::vector<Square> squares_;
};

}  // namespace gonogo::oracle::region
