// SPDX-License-Identifier: GPL-3.0-or-later
//
// The address that an alarm is about: X, CR, R101, TURN. For people and results, never judged.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace gonogo::reference {

// Up to seven letters; longer ones are cut.
class WordName {
 public:
  constexpr WordName() = default;
  constexpr WordName(char letter) : text_{letter} {}
  constexpr explicit WordName(std::string_view text) {
    std::copy_n(text.begin(), std::min(text.size(), text_.size() - 1), text_.begin());
  }
  constexpr bool empty() const { return text_[0] == 0; }
  constexpr std::string_view text() const { return text_.data(); }
  friend constexpr bool operator==(const WordName&, const WordName&) = default;

 private:
  std::array<char, 8> text_{};
};

}  // namespace gonogo::reference
