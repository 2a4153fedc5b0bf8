// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line without its blanks, where blanks mean nothing; and from where each of its bytes came.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"
#include "grammar/byte_set.hpp"

namespace gonogo::grammar::x3 {

// NGC-COM-04: comments keep their blanks, in brackets and behind ';'.
class Squeezed {
 public:
  void take(std::string_view line) {
    text_.clear();
    places_.clear();
    std::size_t at = 0;
    while (at != line.size()) {
      std::size_t end = at + 1;
      if (line[at] == ';') {
        end = line.size();
      } else if (line[at] == '(') {
        const std::size_t close = line.find(')', at);
        end = close == std::string_view::npos ? line.size() : close + 1;
      } else if (kBlank.contains(line[at])) {
        ++at;
        continue;
      }
      for (; at != end; ++at) {
        text_.push_back(line[at]);
        places_.push_back(static_cast<std::uint32_t>(at));
      }
    }
    places_.push_back(static_cast<std::uint32_t>(line.size()));
  }

  std::string_view text() const { return text_; }

  // The same place of the line itself.
  Span unsqueezed(const Span& span) const {
    const std::uint32_t begin = places_[span.begin];
    return {begin, span.end == span.begin ? begin : places_[span.end - 1] + 1};
  }

 private:
  std::string text_;
  std::vector<std::uint32_t> places_;  // of each byte, and of the end
};

}  // namespace gonogo::grammar::x3
