// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a subject rounds: the coarsest decimal grid and the modes that every coordinate fits which is
// not exactly the reference's. It describes a subject, and decides nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reference/exact/number.hpp"

namespace gonogo::oracle {

using exact::Number;

enum class RoundingMode : std::uint8_t { nearest, toward_zero, away_from_zero, down, up };
inline constexpr std::size_t kRoundingModes = 5;
std::string_view name(RoundingMode mode);  // "toward zero"

class RoundingCensus {
 public:
  RoundingCensus();

  // A coordinate that agrees with the reference's within the tolerance, mm.
  void take(const Number& exact, const Number& got);

  std::size_t exact() const { return exact_; }
  std::size_t rounded() const { return rounded_; }
  // Least increment of the coarsest grid on which all rounded coordinates lie, mm; 0: none of
  // 1 mm to 1e-9 mm, or nothing was rounded.
  Number increment() const;
  // The modes that all of them fit on that grid; of several none can be told from the others.
  std::vector<RoundingMode> modes() const;
  // So many least increments is a coordinate off at most, a whole number rounded up; 0: no grid.
  Number increments_off() const;
  // "coordinates: 12 exact, 3 on a grid of 0.001 mm, within 1 of it; nearest"
  std::string text() const;

 private:
  struct Grid {
    Number increment;
    bool fits = true;
    std::array<bool, kRoundingModes> modes;
    Number most_off;  // in increments
  };
  const Grid* grid() const;

  std::vector<Grid> grids_;  // coarsest first
  std::size_t exact_ = 0;
  std::size_t rounded_ = 0;
  std::size_t open_ = 0;  // that cannot be told from a value between two of the grid
};

}  // namespace gonogo::oracle
