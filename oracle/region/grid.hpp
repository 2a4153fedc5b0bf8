// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which bands come near a point: square cells over the disc, found by descending a quadtree.
// Doubles only: a band that it misses makes the filter undecided, never wrong.
#pragma once

#include <span>
#include <vector>

#include "oracle/region/band.hpp"

namespace gonogo::oracle::region {

class Grid {
 public:
  // Cells over the square round the disc about the origin.
  Grid(std::span<const Band> bands, double radius, double reach);

  std::span<const std::uint32_t> near(double x, double y) const;
  // Those near any point of the box of the given half width, each once.
  std::vector<std::uint32_t> near_box(double x, double y, double half) const;

 private:
  struct Square {
    int column;
    int row;
    int side;  // in cells
  };
  std::size_t cell(double x, double y) const;
  int index(double coordinate) const;
  void insert(std::span<const Band> bands, std::uint32_t band, const Square& square);

  double radius_;
  int side_ = 1;  // cells a side, a power of two
  double width_;  // of a cell
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace gonogo::oracle::region
