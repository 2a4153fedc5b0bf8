// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/common/fixed.hpp"

#include <algorithm>
#include <charconv>

namespace gonogo::expanders {
namespace {

constexpr int kDecimals = 9;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// The digits after the point, in counts; those beyond the last count round.
Fixed read_fraction(const char*& cursor, const char* end, Decimal& number) {
  Fixed fraction = 0;
  int places = 0;
  bool round_up = false;
  for (; cursor != end && is_digit(*cursor); ++cursor, ++places) {
    const int digit = *cursor - '0';
    if (places < kDecimals) {
      fraction = fraction * 10 + digit;
    } else {
      if (places == kDecimals) round_up = digit >= 5;
      if (digit != 0) number.finer = true;
    }
    // Keeps `places` small however many digits there are.
    places = std::min(places, kDecimals);
  }
  for (; places < kDecimals; ++places) fraction *= 10;
  number.rounded_up = round_up;
  return fraction + (round_up ? 1 : 0);
}

}  // namespace

bool read_decimal(const char*& cursor, const char* end, Decimal& number) {
  number = Decimal{};
  if (cursor != end && (*cursor == '-' || *cursor == '+')) number.minus = *cursor++ == '-';
  const char* first = cursor;
  Fixed whole = 0;
  for (; cursor != end && is_digit(*cursor); ++cursor) {
    if (whole <= kLargest / kOne) whole = whole * 10 + (*cursor - '0');
  }
  std::ptrdiff_t digits = cursor - first;
  Fixed fraction = 0;
  if (cursor != end && *cursor == '.') {
    first = ++cursor;
    fraction = read_fraction(cursor, end, number);
    digits += cursor - first;
  }
  if (digits == 0) return false;
  if (whole >= kLargest / kOne) {
    number.overflow = true;
    return true;
  }
  number.value = whole * kOne + fraction;
  if (number.minus) number.value = -number.value;
  return true;
}

std::size_t write_decimal(Fixed value, char* text) {
  char* out = text;
  if (value < 0) *out++ = '-';
  const Fixed size = magnitude(value);
  out = std::to_chars(out, text + kTextSize, size / kOne).ptr;
  Fixed fraction = size % kOne;
  if (fraction != 0) {
    *out++ = '.';
    while (fraction != 0) {
      fraction *= 10;
      *out++ = static_cast<char>('0' + fraction / kOne);
      fraction %= kOne;
    }
  }
  return static_cast<std::size_t>(out - text);
}

Wide scaled(Fixed value, Fixed numerator, Fixed denominator) {
  const Wide product = static_cast<Wide>(value) * numerator;
  const Wide half = denominator / 2;
  return (product < 0 ? product - half : product + half) / denominator;
}

}  // namespace gonogo::expanders
