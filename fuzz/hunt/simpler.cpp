// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/simpler.hpp"

#include <cstdlib>

namespace gonogo::hunt {

using program::SmallDecimal;

namespace {

// Shorter texts are simpler; of equal ones, that with the smaller value.
bool is_simpler(const SmallDecimal& a, const SmallDecimal& b) {
  const std::string x = a.text();
  const std::string y = b.text();
  if (x.size() != y.size()) return x.size() < y.size();
  const auto [p, q] = same_scale(a, b);
  return std::abs(p) < std::abs(q);
}

}  // namespace

std::vector<SmallDecimal> simpler_values(const SmallDecimal& number) {
  std::vector<SmallDecimal> values = {{0, 0}, {1, 0},  {2, 0},
                                      {5, 0}, {10, 0}, {-number.value, number.scale}};
  SmallDecimal cut = number;
  std::vector<SmallDecimal> shorter;
  while (cut.scale > 0) {
    cut = {cut.value / 10, cut.scale - 1};
    shorter.push_back(cut);
  }
  values.insert(values.end(), shorter.rbegin(), shorter.rend());
  for (std::int64_t step = 1'000'000; step >= 10; step /= 10) {
    values.push_back({cut.value / step * step, 0});
  }
  values.push_back({cut.value / 2, 0});
  std::erase_if(values, [&](const SmallDecimal& value) { return !is_simpler(value, number); });
  return values;
}

void replace_number(program::TextLine& line, const SmallDecimal& number,
                    const SmallDecimal& value) {
  for (program::TextWord& word : line.words) {
    if (!code_of(word).empty()) continue;
    // Back to front, so that the places before stay.
    const std::vector<program::NumberPlace> places = numbers_of(word);
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
      if (place->number.text() != number.text()) continue;
      word.text.replace(place->begin, place->end - place->begin, value.text());
    }
  }
}

std::string plain_text(const program::TextWord& word) {
  if (!is_word(word)) return word.text;
  std::string text = code_of(word);
  if (!text.empty()) return text;
  for (const char c : word.text) {
    if (c == ' ' || c == '\t') continue;
    text += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return text;
}

}  // namespace gonogo::hunt
