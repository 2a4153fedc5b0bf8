// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace gonogo::oracle::site {

// A title as the name of a folder and a part of an address: letters in lower case, digits, dots and
// hyphens; "run" where none of these is left.
inline std::string folder_stem(std::string_view title) {
  constexpr std::size_t kLongest = 60;
  std::string stem;
  for (const char c : title.substr(0, kLongest)) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || upper;
    if (kept) {
      stem += upper ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!stem.empty() && stem.back() != '-') {
      stem += c == '.' && stem.back() != '.' ? '.' : '-';
    }
  }
  while (!stem.empty() && (stem.back() == '-' || stem.back() == '.')) stem.pop_back();
  return stem.empty() ? "run" : stem;
}

}  // namespace gonogo::oracle::site
