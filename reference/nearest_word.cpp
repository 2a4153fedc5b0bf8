// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/nearest_word.hpp"

#include <algorithm>
#include <string_view>

namespace gonogo::reference {
namespace {

// How many letters have to be changed, left out or put in between two words.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string in_small_letters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t kNear = 3;
  std::string best;
  std::size_t least = std::min(kNear, word.size() / 2) + 1;
  for (const std::string& one : known) {
    const std::size_t here = distance(in_small_letters(word), in_small_letters(one));
    if (here >= least) continue;
    least = here;
    best = one;
  }
  return best;
}

std::string did_you_mean(const std::string& word) {
  return word.empty() ? word : "Did you mean " + word + "? ";
}

}  // namespace gonogo::reference
