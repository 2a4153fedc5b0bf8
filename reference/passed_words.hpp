// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words that the gauge passes over, each by a rule that a clause states. Every word of a block
// is used by its code, stands in such a list, breaks a rule, or ends the program as not covered.
#pragma once

#include <string_view>

#include "reference/clause.hpp"

namespace gonogo::reference {

// One rule of a dialect.
struct PassedWords {
  std::string_view codes;  // beside which they stand: "G80", "every block"
  std::string_view words;  // "K R E"
  ClauseId clause;
  std::string_view why;  // a sentence
};

}  // namespace gonogo::reference
