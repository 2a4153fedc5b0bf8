// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a subject rounds: of the coordinates that agree with the reference's, how many are exact or
// correctly rounded, and the coarsest decimal grid and the modes that the others fit. It describes
// a subject, and decides nothing. Parts add up to the same whole in any order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/exact/number.hpp"

namespace gonogo::oracle {

using exact::Number;

enum class RoundingMode : std::uint8_t { nearest, toward_zero, away_from_zero, down, up };
inline constexpr std::size_t kRoundingModes = 5;
std::string_view name(RoundingMode mode);  // "toward zero"

// Where `nearest` takes a value midway between two of the grid.
enum class HalvesRule : std::uint8_t { away_from_zero, toward_zero, to_even, up, down };
inline constexpr std::size_t kHalvesRules = 5;
std::string_view name(HalvesRule rule);  // "away from zero"

// Coordinates that are not exact, one or more.
class RoundedCoordinates {
 public:
  static constexpr int kFinestDecimals = 9;

  RoundedCoordinates();
  // What was due, and another number.
  RoundedCoordinates(const Number& exact, const Number& got);
  void add(const RoundedCoordinates& other);

  std::size_t count() const { return count_; }
  // Whether there is a decimal grid of 1 mm to 1e-9 mm on which all of them lie.
  bool has_grid() const { return count_ != 0 && decimals_ <= kFinestDecimals; }
  // Least increment of the coarsest one, mm; 0: none.
  Number increment() const;
  // The modes that all of them fit on that grid; several of them look the same.
  std::vector<RoundingMode> modes() const;
  // The rules that all halves fit, where `nearest` is one of the modes; all: there was no half.
  std::vector<HalvesRule> halves() const;
  // So many least increments is one off at most, a whole number rounded up; 0: no grid.
  std::int64_t increments_off() const;
  // "on a grid of 0.001 mm, within 1 of it, nearest"
  std::string text() const;

  nlohmann::ordered_json json() const;
  static std::optional<RoundedCoordinates> from_json(const nlohmann::ordered_json& source);

  bool operator==(const RoundedCoordinates&) const = default;

 private:
  // The decimals of the finest grid that each mode or rule fits on. What it does on a grid it
  // does on every coarser one.
  template <std::size_t N>
  using Finest = std::array<std::int8_t, N>;

  std::string modes_text() const;

  std::size_t count_ = 0;
  std::int8_t decimals_ = 0;  // of the coarsest grid; above kFinestDecimals: none
  Finest<kRoundingModes> modes_;
  Finest<kHalvesRules> halves_;
  std::int64_t most_off_ = 0;  // in units of the finest grid, rounded up
};

class RoundingCensus {
 public:
  // A coordinate that agrees with the reference's within the tolerance, mm. `is_correct`: it is the
  // correctly rounded value, as the subject declares its numbers.
  void take(const Number& exact, const Number& got, bool is_correct);
  // So many that are exact.
  void take_exact(std::size_t count) { exact_ += count; }
  void add(const RoundingCensus& other);

  bool empty() const { return exact_ + open_ + inexact() == 0; }
  std::size_t exact() const { return exact_; }
  const RoundedCoordinates& correct() const { return correct_; }  // and not exact
  const RoundedCoordinates& off() const { return off_; }          // neither
  RoundedCoordinates rounded() const;                             // both
  std::size_t inexact() const { return correct_.count() + off_.count(); }
  // "12 exact, 3 correctly rounded; on a grid of 0.001 mm, within 1 of it, nearest"; the two kinds
  // each for itself where no mode fits both.
  std::string text() const;

  // As in a results file (docs/formats.md).
  nlohmann::ordered_json json() const;
  // Nothing: it is none.
  static std::optional<RoundingCensus> from_json(const nlohmann::ordered_json& source);

  bool operator==(const RoundingCensus&) const = default;

 private:
  std::size_t exact_ = 0;
  std::size_t open_ = 0;  // of which it is unknown
  RoundedCoordinates correct_;
  RoundedCoordinates off_;
};

}  // namespace gonogo::oracle
