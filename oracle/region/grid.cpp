// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {

Grid::Grid(std::span<const Band> bands, double half_side, double reach)
    : bands_(bands), radius_(half_side / kAlmost) {
  // About as many cells as bands, none much smaller than the bands are wide.
  const double finest = std::max(reach, 2 * radius_ / std::sqrt(double(bands.size()) + 1));
  while (side_ < kMostCells && 2 * radius_ / side_ > finest) side_ *= 2;
  width_ = 2 * radius_ / side_;
  squares_.push_back({0, 0, side_, std::vector<std::uint32_t>(bands.size()), 0, true});
  std::iota(squares_[0].bands.begin(), squares_[0].bands.end(), 0U);
}

int Grid::index(double coordinate) const {
  const double scaled = (coordinate + radius_) / width_;
  if (!(scaled > 0)) return 0;
  return scaled >= side_ ? side_ - 1 : static_cast<int>(scaled);
}

const std::vector<std::uint32_t>& Grid::cell(int column, int row) const {
  std::size_t square = 0;
  while (squares_[square].side > 1) {
    if (squares_[square].parts == 0) split(square);
    const Square& whole = squares_[square];
    const int half = whole.side / 2;
    const std::size_t part = whole.parts + (row >= whole.row + half ? 2U : 0U) +
                             (column >= whole.column + half ? 1U : 0U);
    if (!squares_[part].known) fill(squares_[part], whole.bands);
    square = part;
  }
  return squares_[square].bands;
}

void Grid::split(std::size_t square) const {
  const int column = squares_[square].column;
  const int row = squares_[square].row;
  const int half = squares_[square].side / 2;
  squares_[square].parts = squares_.size();
  for (const int its_row : {row, row + half}) {
    for (const int its_column : {column, column + half}) {
      squares_.push_back({its_column, its_row, half, {}, 0, false});
    }
  }
}

void Grid::fill(Square& square, const std::vector<std::uint32_t>& candidates) const {
  const double half = square.side * width_ / 2;
  const double x = -radius_ + square.column * width_ + half;
  const double y = -radius_ + square.row * width_ + half;
  for (const std::uint32_t band : candidates) {
    if (rough_distance(bands_[band], x, y) >
        half * std::numbers::sqrt2 / kAlmost + kBeside * radius_)
      continue;
    square.bands.push_back(band);
  }
  square.known = true;
}

std::span<const std::uint32_t> Grid::near(double x, double y) const {
  return cell(index(x), index(y));
}

std::vector<std::uint32_t> Grid::near_box(double x, double y, double half) const {
  std::vector<std::uint32_t> found;
  for (int row = index(y - half); row <= index(y + half); ++row) {
    for (int column = index(x - half); column <= index(x + half); ++column) {
      const auto& bands = cell(column, row);
      found.insert(found.end(), bands.begin(), bands.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace gonogo::oracle::region
