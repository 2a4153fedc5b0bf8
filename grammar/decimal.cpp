// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/decimal.hpp"

#include <cstddef>
#include <utility>

#include "grammar/byte_set.hpp"

namespace gonogo::grammar {
namespace {

constexpr std::ptrdiff_t kMostDigits = 18;  // of which every number fits 64 bits with its sign

// Takes digits into `magnitude`, which wraps around when there are too many of them.
inline const char* take_digits(const char* first, const char* last, std::uint64_t& magnitude) {
  for (; first != last && kDigit.contains(*first); ++first) {
    magnitude = magnitude * 10 + static_cast<std::uint64_t>(*first - '0');
  }
  return first;
}

// Sets the magnitude of [first, last), digits with a point among them, without leading zeros.
void set_long_magnitude(const char* first, const char* last, Decimal& value) {
  std::string digits;
  for (; first != last; ++first) {
    if (*first == '.' || (*first == '0' && digits.empty())) continue;
    digits.push_back(*first);
  }
  value.magnitude = 0;
  if (static_cast<std::ptrdiff_t>(digits.size()) > kMostDigits) {
    value.long_digits = std::move(digits);
  } else {
    take_digits(digits.data(), digits.data() + digits.size(), value.magnitude);
  }
}

}  // namespace

const char* read_decimal(const char* first, const char* last, Decimal& value) {
  if (first != last && kSign.contains(*first)) {
    value.negative = *first == '-';
    ++first;
  }
  const char* const begin = first;
  first = take_digits(first, last, value.magnitude);
  std::ptrdiff_t digits = first - begin;
  if (first != last && *first == '.') {
    const char* const fraction = ++first;
    first = take_digits(first, last, value.magnitude);
    value.scale = static_cast<std::uint32_t>(first - fraction);
    digits += first - fraction;
  }
  if (digits == 0) return nullptr;
  if (digits > kMostDigits) set_long_magnitude(begin, first, value);
  return first;
}

const char* read_whole(const char* first, const char* last, Decimal& value) {
  const char* const begin = first;
  first = take_digits(first, last, value.magnitude);
  if (first == begin) return nullptr;
  if (first - begin > kMostDigits) set_long_magnitude(begin, first, value);
  return first;
}

}  // namespace gonogo::grammar
