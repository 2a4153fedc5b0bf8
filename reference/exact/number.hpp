// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact number of the reference and the judge. One name, four representations:
//   integers of 1e-6 in 64 bits where they suffice, GMP rationals, a + b*sqrt(c) with rational
//   a, b, c, and an enclosure that can be refined to any width where an angle or two different
//   roots enter. No operation rounds.
// An enclosure holds the expression that it came from, and is evaluated anew at each precision:
// write closed forms (z_k = r - k*q), not running sums.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gonogo::exact {

// Thrown by a comparison that 4096 bits cannot decide. The judge turns it into `oracle-gap`.
class Undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Node;  // a heap representation: rational, root or enclosure; counted, never changed

class Number {
 public:
  enum class Form { rational, root, enclosure };

  Number() noexcept = default;  // 0
  Number(int value) noexcept : Number(static_cast<std::int64_t>(value)) {}
  Number(std::int64_t value) noexcept;
  Number(double) = delete;
  Number(float) = delete;
  Number(const Number&) noexcept;
  Number(Number&&) noexcept;
  Number& operator=(const Number&) noexcept;
  Number& operator=(Number&&) noexcept;
  ~Number();

  // count * 1e-6.
  static Number millionths(std::int64_t count) noexcept;
  // (-1)^negative * magnitude / 10^scale.
  static Number decimal(bool negative, std::uint64_t magnitude, std::uint32_t scale);
  // The same from a string of digits, of any length.
  static Number decimal(bool negative, std::string_view digits, std::uint32_t scale);
  // mantissa * 2^exponent: the exact value of a binary floating-point number.
  static Number binary(std::int64_t mantissa, int exponent);
  // A number as it is written in a record: a decimal with an optional exponent, p/q, or a C99 hex
  // float; at most 1,000 characters, |exponent| at most 9,999. Nothing when it is none of these.
  static std::optional<Number> parse(std::string_view text);
  // a + b*sqrt(c), rational arguments. A rational when sqrt(c) is. Throws std::domain_error when
  // c < 0, std::invalid_argument when an argument is not rational.
  static Number root(const Number& a, const Number& b, const Number& c);
  // a[i] + b[i]*sqrt(c/d): two numbers of one root, made together because that is far cheaper.
  // REQUIRES: c >= 0, d > 0, all of them rational.
  static std::array<Number, 2> roots(const std::array<Number, 2>& a, const std::array<Number, 2>& b,
                                     const Number& c, const Number& d);
  // Known only to lie in [low, high], rational arguments: cannot be refined, so that a comparison
  // that the interval does not decide throws Undecided at once. std::invalid_argument when
  // high < low. Rational when they are equal.
  static Number between(const Number& low, const Number& high);

  Form form() const noexcept;
  bool is_rational() const noexcept { return form() == Form::rational; }

  // -1, 0 or 1. Exact for rationals and roots; an enclosure is refined until its sign shows.
  int sign() const;
  // Nothing where no refining shows it.
  std::optional<int> try_sign() const;

  friend Number operator+(const Number& a, const Number& b);
  friend Number operator-(const Number& a, const Number& b);
  friend Number operator*(const Number& a, const Number& b);
  // Throws std::domain_error when b is zero, Undecided when b may be zero.
  friend Number operator/(const Number& a, const Number& b);
  Number operator-() const;
  Number& operator+=(const Number& b) { return *this = *this + b; }
  Number& operator-=(const Number& b) { return *this = *this - b; }

  friend bool operator==(const Number& a, const Number& b) { return compare(a, b) == 0; }
  friend std::strong_ordering operator<=>(const Number& a, const Number& b) {
    return compare(a, b) <=> 0;
  }
  static int compare(const Number& a, const Number& b);

  // The largest integer that is not above the number, and the smallest that is not below it.
  // Undecided when an enclosure cannot be separated from an integer.
  Number floor() const;
  Number ceil() const;
  // The value when it is a whole number that fits.
  std::optional<std::int64_t> to_int64() const;

  // Rational bounds at most 2^-bits apart (equal for a rational; where a `between` is in it, as
  // close as that allows).
  std::array<Number, 2> bounds(int bits) const;
  // For rationals: numerator and denominator as decimal digits, lowest terms, denominator > 0.
  std::array<std::string, 2> fraction() const;
  // For roots: a, b, c of a + b*sqrt(c), as rationals.
  std::array<Number, 3> root_parts() const;

  // As in a record: the shortest of a terminating decimal, p/q, {"root":[a,b,c]},
  // {"enclosure":[lo,hi]} (hi - lo <= 1e-15). `append_json` puts quotes round the first two.
  void append_json(std::string& out) const;
  // The same for people: 12.5, 11/3, 1 + 2*sqrt(3), [1.25, 1.26].
  std::string text() const;
  // The number with so many decimals, rounded to nearest (ties away from zero). For an enclosure,
  // the middle of bounds 2^-64 of the last decimal apart is rounded.
  std::string decimal_text(int decimals) const;

 private:
  explicit Number(Node* node) noexcept : node_(node) {}
  friend struct NumberAccess;  // the out-of-line slow paths, declared in number_inline.hpp

  std::int64_t millionths_ = 0;  // the value when node_ is null
  Node* node_ = nullptr;
};

Number abs(const Number& value);
const Number& min(const Number& a, const Number& b);
const Number& max(const Number& a, const Number& b);
// Exact where the result is rational or one root; else an enclosure. REQUIRES: value >= 0, else
// std::domain_error; an enclosure that may be below zero counts as one that is not.
Number sqrt(const Number& value);
// base^(numerator/denominator): exact where that is rational or has one square root, else an
// enclosure. REQUIRES: a rational base, else std::invalid_argument; base > 0 and denominator > 0,
// else std::domain_error.
Number power(const Number& base, unsigned long numerator, unsigned long denominator = 1);
// cos and sin of an angle in degrees: exact at multiples of 30 and 45 degrees, else enclosures.
std::array<Number, 2> cos_sin_degrees(const Number& degrees);
// The same, where only one of them is wanted.
Number cos_degrees(const Number& degrees);
Number sin_degrees(const Number& degrees);
// The angle of the vector (x, y) in degrees, in [0, 360): exact on the axes and the diagonals and
// at multiples of 30 degrees where that is decidable, else an enclosure. REQUIRES: not both zero,
// else std::domain_error. Undecided where it may be 0 or just below 360.
Number angle_degrees(const Number& x, const Number& y);

}  // namespace gonogo::exact

#include "reference/exact/number_inline.hpp"  // IWYU pragma: export
