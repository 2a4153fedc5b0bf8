// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/number_range.hpp"

#include <algorithm>

namespace gonogo::fuzz {
namespace {

constexpr std::size_t kMostWhole = 9;
constexpr std::size_t kMostDecimals = 7;

bool is_number_digit(char c) {
  return c >= '0' && c <= '9';
}

// The digits that the text begins with, which are taken from it.
std::string_view take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_number_digit);
  const std::string_view taken = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(taken.size());
  return taken;
}

}  // namespace

bool has_short_numbers(std::string_view text) {
  while (!text.empty()) {
    const std::string_view whole = take_digits(text);
    const std::size_t first = std::min(whole.find_first_not_of('0'), whole.size());
    if (whole.size() - first > kMostWhole) return false;
    if (text.empty()) break;
    const bool at_point = text.front() == '.';
    text.remove_prefix(1);
    if (!at_point) continue;
    const std::string_view decimals = take_digits(text);
    // npos + 1 is 0: nothing but zeros.
    if (decimals.find_last_not_of('0') + 1 > kMostDecimals) return false;
  }
  return true;
}

}  // namespace gonogo::fuzz
