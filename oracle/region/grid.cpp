// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/grid.hpp"

#include <algorithm>
#include <cmath>

namespace gonogo::oracle::region {

Grid::Grid(std::span<const Band> bands, double radius, double reach) : radius_(radius * 1.001) {
  // About as many cells as bands, none much smaller than the bands are wide.
  const double finest = std::max(reach, 2 * radius_ / std::sqrt(double(bands.size()) + 1));
  while (side_ < 1024 && 2 * radius_ / side_ > finest) side_ *= 2;
  width_ = 2 * radius_ / side_;
  cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
  for (std::uint32_t band = 0; band < bands.size(); ++band) insert(bands, band, {0, 0, side_});
}

int Grid::index(double coordinate) const {
  const double scaled = (coordinate + radius_) / width_;
  if (!(scaled > 0)) return 0;
  return scaled >= side_ ? side_ - 1 : static_cast<int>(scaled);
}

std::size_t Grid::cell(double x, double y) const {
  return static_cast<std::size_t>(index(y)) * static_cast<std::size_t>(side_) +
         static_cast<std::size_t>(index(x));
}

std::span<const std::uint32_t> Grid::near(double x, double y) const {
  return cells_[cell(x, y)];
}

std::vector<std::uint32_t> Grid::near_box(double x, double y, double half) const {
  std::vector<std::uint32_t> found;
  for (int row = index(y - half); row <= index(y + half); ++row) {
    for (int column = index(x - half); column <= index(x + half); ++column) {
      const auto& bands = cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                                 static_cast<std::size_t>(column)];
      found.insert(found.end(), bands.begin(), bands.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void Grid::insert(std::span<const Band> bands, std::uint32_t band, const Square& square) {
  const double half = square.side * width_ / 2;
  const double x = -radius_ + square.column * width_ + half;
  const double y = -radius_ + square.row * width_ + half;
  if (rough_distance(bands[band], x, y) > half * 1.415 + 1e-9 * radius_) return;
  if (square.side == 1) {
    cells_[cell(x, y)].push_back(band);
    return;
  }
  const int part = square.side / 2;
  for (const int row : {square.row, square.row + part}) {
    for (const int column : {square.column, square.column + part}) {
      insert(bands, band, {column, row, part});
    }
  }
}

}  // namespace gonogo::oracle::region
