// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths of models: so many thousandths of a unit, and so many least increments of any size.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gonogo::cover {

struct Length {
  std::int64_t thousandths = 0;
  std::int64_t increments = 0;

  // "10", "-2.5", "10-e", "e", "-3e": a number with up to three decimals, and increments. Throws
  // ModelError.
  static Length parse(std::string_view text);
  // As a word of a program. REQUIRES: decimals, those of the least increment, in 3 to 5.
  std::string text(int decimals) const;
  // Below, at or above zero, as -1, 0 or 1; of a length that has both parts the thousandths decide.
  int sign() const;

  friend bool operator==(const Length&, const Length&) = default;
  friend Length operator+(Length a, Length b) {
    return {a.thousandths + b.thousandths, a.increments + b.increments};
  }
  friend Length operator-(Length a) { return {-a.thousandths, -a.increments}; }
  friend Length operator-(Length a, Length b) { return a + -b; }
  friend Length operator*(std::int64_t factor, Length a) {
    return {factor * a.thousandths, factor * a.increments};
  }
};

inline Length mm(std::int64_t count) {
  return {count * 1000, 0};
}
inline Length abs(Length a) {
  return a.sign() < 0 ? -a : a;
}

}  // namespace gonogo::cover
