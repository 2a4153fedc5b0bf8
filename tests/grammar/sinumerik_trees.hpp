// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trees of SINUMERIK, written short: G{1} CR={R1 2 *} I1=AC{5} MSG(), the terms in postfix order as
// the tree has them. Not the text that `print` gives.
#pragma once

#include "tests/grammar/trees.hpp"

namespace gonogo::grammar {

inline std::string short_form(const Term& term) {
  constexpr std::string_view kSteps[] = {"",     "R",   "neg", "sin", "cos", "tan",
                                         "sqrt", "abs", "+",   "-",   "*",   "/"};
  std::string out(kSteps[static_cast<std::size_t>(term.kind)]);
  if (term.kind <= TermKind::parameter) print(term.number, out);
  return out;
}

inline std::string short_form(const NamedWord& word, const Block& block) {
  std::string out = word.name;
  if (word.index) out += std::to_string(*word.index);
  if (word.has_equals) out += "=";
  if (word.dimension == Dimension::absolute) out += "AC";
  if (word.dimension == Dimension::incremental) out += "IC";
  if (word.is_call) out += "()";
  if (word.terms == 0) return out;
  for (std::uint32_t i = 0; i < word.terms; ++i) {
    out += (i == 0 ? "{" : " ") + short_form(block.terms[word.first_term + i]);
  }
  return out + "}";
}

inline std::string short_form(const Block& block) {
  std::string out;
  for (const NamedWord& word : block.named) {
    out += (out.empty() ? "" : " ") + short_form(word, block);
  }
  return out;
}

// The words of a line that is well formed.
inline std::string words_of(std::string_view line) {
  return short_form(parsed(Dialect::sinumerik, line));
}

}  // namespace gonogo::grammar
