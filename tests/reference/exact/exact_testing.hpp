// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the exact number share.
#pragma once

#include <gmpxx.h>

#include <string>
#include <string_view>

#include "reference/exact/number.hpp"

namespace gonogo::exact {

// gtest prints a number by its text.
inline void PrintTo(const Number& value, std::ostream* out) {
  *out << value.text();
}

namespace testing {

// A number from its text; a text that is none throws.
inline Number num(std::string_view text) {
  return Number::parse(text).value();
}

inline std::string json(const Number& value) {
  std::string out;
  value.append_json(out);
  return out;
}

inline bool is_small(const Number& value) {
  return NumberAccess::node(value) == nullptr;
}

// The two bounds enclose the exact value and are as close as asked for.
inline bool enclosed(const Number& value, const Number& exact, int bits) {
  const auto [low, high] = value.bounds(bits);
  return low <= exact && exact <= high && high - low <= Number::binary(1, -bits);
}

inline mpq_class model_of(const Number& value) {
  const auto [numerator, denominator] = value.fraction();
  return mpq_class(mpz_class(numerator), mpz_class(denominator));
}

}  // namespace testing
}  // namespace gonogo::exact
