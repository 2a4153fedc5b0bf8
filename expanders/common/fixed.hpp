// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace gonogo::expanders {

/// The controller's number: 64-bit fixed point, one count = 1e-9 of a millimetre, degree, second or
/// millimetre a minute. Every input increment, its half (diameters) and its inch value are whole
/// counts.
using Fixed = std::int64_t;
using Wide = __int128;

inline constexpr Fixed kOne = 1'000'000'000;
inline constexpr Fixed kFullTurn = 360 * kOne;  // degrees
/// No coordinate is larger: sums and differences of two fit in Fixed, their squares in Wide.
inline constexpr Fixed kLargest = 4'000'000'000 * kOne;

/// A number as it was written, in counts of the written unit.
struct Decimal {
  Fixed value = 0;          ///< rounded to the nearest count
  bool minus = false;       ///< stood before it, before 0 too
  bool overflow = false;    ///< larger than kLargest; `value` is then without meaning
  bool finer = false;       ///< had digits other than 0 beyond the counts
  bool rounded_up = false;  ///< `value` is further from 0 than what was written
};

/// Reads [sign] digits [. digits] at `cursor` and moves it on; at least one digit, before or after
/// the point. False when there is none: `cursor` is then unspecified.
bool read_decimal(const char*& cursor, const char* end, Decimal& number);

inline constexpr std::size_t kTextSize = 24;
/// Writes `value` as the shortest decimal ("-12.5") and returns its length, at most kTextSize.
std::size_t write_decimal(Fixed value, char* text);

/// `value` * numerator / denominator to the nearest count, halves away from zero.
Wide scaled(Fixed value, Fixed numerator, Fixed denominator);

inline Fixed magnitude(Fixed value) {
  return value < 0 ? -value : value;
}
inline int sign_of(Fixed value) {
  return (value > 0) - (value < 0);
}
inline bool fits(Wide value) {
  return value <= kLargest && value >= -kLargest;
}

}  // namespace gonogo::expanders
