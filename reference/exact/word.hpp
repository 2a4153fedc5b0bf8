// SPDX-License-Identifier: GPL-3.0-or-later
//
// 64-bit integers to and from GMP's. GMP's own functions for them take `long`, which has 32 bits on
// WebAssembly; a limb has 64 everywhere.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <limits>
#include <optional>

namespace gonogo::exact {

static_assert(GMP_NUMB_BITS == 64, "a limb of GMP carries the small form");

using Word = std::uint64_t;

inline Word magnitude_of(std::int64_t value) {
  const auto bits = static_cast<Word>(value);
  return value < 0 ? 0 - bits : bits;
}

inline void assign(mpz_ptr to, Word magnitude, bool negative = false) {
  mpz_limbs_write(to, 1)[0] = magnitude;
  mpz_limbs_finish(to, negative ? -1 : 1);
}

inline mpz_class integer_of(Word value) {
  mpz_class integer;
  assign(integer.get_mpz_t(), value);
  return integer;
}
inline mpz_class integer_of(std::int64_t value) {
  mpz_class integer;
  assign(integer.get_mpz_t(), magnitude_of(value), value < 0);
  return integer;
}

// The lowest 64 bits of |value|.
inline Word low_word(const mpz_class& value) {
  return mpz_getlimbn(value.get_mpz_t(), 0);
}
// Whether |value| is a Word.
inline bool fits_word(const mpz_class& value) {
  return mpz_size(value.get_mpz_t()) <= 1;
}

inline std::optional<std::int64_t> int64_of(const mpz_class& value) {
  constexpr auto kMost = static_cast<Word>(std::numeric_limits<std::int64_t>::max());
  const Word magnitude = low_word(value);
  const bool negative = sgn(value) < 0;
  if (!fits_word(value) || magnitude > kMost + (negative ? 1 : 0)) return std::nullopt;
  return static_cast<std::int64_t>(negative ? 0 - magnitude : magnitude);
}

}  // namespace gonogo::exact
