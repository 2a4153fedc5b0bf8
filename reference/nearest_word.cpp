// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/nearest_word.hpp"

#include <algorithm>
#include <string_view>

namespace gonogo::reference {
namespace {

// How many letters have to be changed, left out, put in or swapped with the next between two words.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        rows[i][j] = i + j;
        continue;
      }
      const std::size_t changed = rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U);
      rows[i][j] = std::min({changed, rows[i - 1][j] + 1, rows[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
      }
    }
  }
  return rows.back().back();
}

// The beginning of a name stands for it.
bool begins(std::string_view word, std::string_view known) {
  return word.size() >= 2 && known.starts_with(word);
}

std::string in_small_letters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t kNear = 3;
  constexpr std::size_t kLongest = 64;  // of what somebody may have meant
  std::string best;
  if (word.size() > kLongest) return best;
  std::size_t least = std::min(kNear, word.size() / 2) + 1;
  for (const std::string& one : known) {
    const std::string small = in_small_letters(word);
    const std::string other = in_small_letters(one);
    // The same word in other letters is nearer than any, though it begins with itself.
    const bool is_same = small == other;
    const std::size_t here = !is_same && begins(small, other) ? 1 : distance(small, other);
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
