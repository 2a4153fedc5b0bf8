// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sinumerik/word_use.hpp"

#include <array>

namespace gonogo::reference::sinumerik {
namespace {

// SIE-WRD-01
constexpr auto kPassedWords = std::to_array<PassedWords>({
    {"every block", "S T D H H<n>=", "SIE-MOD-02"_clause,
     "the spindle, the tool and auxiliary functions do not shape the path (G4 and LCYC75 look at "
     "S, T and D)"},
    {"every block", "NAME:", "SIE-LEX-01"_clause, "a label only says where a jump would lead"},
    {"G0", "F", "SIE-G1-01"_clause, "the feed is taken in; a traverse has none"},
});

}  // namespace

std::span<const PassedWords> passed_words() {
  return kPassedWords;
}

}  // namespace gonogo::reference::sinumerik
