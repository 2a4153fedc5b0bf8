// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/range.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "reference/words.hpp"

namespace gonogo::reference {
namespace {

constexpr int kMostDigits = 7;                       // of a word, before the point
constexpr std::int64_t kWordBound = 10'000'000;      // the first number of more
constexpr std::int64_t kMachineBound = 100'000'000;  // mm
constexpr std::int64_t kCountBound = std::int64_t{1} << 31;

constexpr auto kPowers = [] {
  std::array<std::uint64_t, 20> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}();

// Whether the number has more digits before the point than `most`.
bool has_more_digits(const grammar::Decimal& value, std::uint32_t most) {
  if (!value.long_digits.empty()) return value.long_digits.size() > value.scale + most;
  const std::size_t digits = value.scale + most;
  return digits < kPowers.size() && value.magnitude >= kPowers[digits];
}

// Comparing an enclosure can cost as much as the whole block.
bool is_at_least(const Number& value, std::int64_t bound) {
  return value.form() != Number::Form::enclosure && abs(value) >= Number(bound);
}

}  // namespace

bool is_beyond_range(const grammar::Decimal& value) {
  return has_more_digits(value, kMostDigits);
}

bool is_beyond_range(const Number& value) {
  return is_at_least(value, kWordBound);
}

const grammar::Word* word_beyond_range(const grammar::Block& block) {
  constexpr std::string_view kNumbers = "GMNOT";  // of codes, functions, tools
  for (const grammar::Word& word : block.words) {
    if (!is_beyond_range(word.value) || kNumbers.find(word.address) != std::string_view::npos) {
      continue;
    }
    // P counts turns, too, which a range of their own bounds.
    if (word.address == 'P' && to_number(word.value) < Number(kCountBound)) continue;
    return &word;
  }
  return nullptr;
}

bool is_beyond_range(const Position& position) {
  return std::ranges::any_of(position.at,
                             [](const Number& place) { return is_at_least(place, kMachineBound); });
}

}  // namespace gonogo::reference
