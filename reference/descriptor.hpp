// SPDX-License-Identifier: GPL-3.0-or-later
//
// A dialect as one table: its codes, and the words that each takes. The interpreter reads codes by
// it. What a subject may declare, and what tools know of codes and words, comes from it too.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/code.hpp"

namespace gonogo::reference {

// What a subject may declare of the dialect.
struct DialectFeature {
  std::string_view name;
  std::string_view text;
  bool is_of_text = false;  // no code or word shows it
};

// The clause by which a code repeats, its words hold, or a mode stays in force in later blocks.
enum class Holds : std::uint8_t { motion, words, mode };
struct HoldingRule {
  Holds what;
  std::string_view codes;  // what the names of the codes begin with; empty: all
  Group group;             // of a mode
  ClauseId clause;
};

struct Descriptor {
  std::span<const DialectFeature> features;
  // G codes by their numbers, then names in the order of their bytes, then M functions.
  std::span<const Code> codes;
  std::span<const CodeWord> everywhere;  // beside every code
  std::span<const IgnoredWords> passed_everywhere;
  std::span<const HoldingRule> holding;

  // By its name without leading zeros: "G1", "CIP". Null: the table has no row of that name. A row
  // of a family is found by each of its codes.
  const Code* find(std::string_view name) const;
  // The word as the code takes it, or any code; null: neither. `code` may be null.
  const CodeWord* find_word(const Code* code, std::string_view address) const;
  // The code that puts it in force, the first one of the kind that is read; null: there is none.
  const Code* find(Setting setting) const;
  const Code* find(Kind kind) const;
  // The clause by which this holds of the code; kNoClause: the catalog has none.
  ClauseId clause_of_holding(Holds what, const Code& code) const;
};

// The other code of its pair, which turns the other way; null: it does not turn.
const Code* opposite_of(const Descriptor& descriptor, const Code& code);

// Whether the address is one that the word stands for: R105 is one of R<n>.
bool stands_for(const CodeWord& word, std::string_view address);

// A G code as it is printed: "G01", "G90.1".
std::string code_name(int tenths);

// A code of the maker that the gauge does not read.
struct OutsideCode {
  std::string code;        // "G71", "G505 to G599"
  std::string_view title;  // what the maker calls it
};
std::vector<OutsideCode> outside_codes(const Descriptor& descriptor);
// Those without effect on the path, and the letters of the words that have none.
std::vector<std::string> codes_without_effect(const Descriptor& descriptor);

// What a code is programmed with: "X Z end point; R taper (modal)"; "" without words.
std::string words_text(const Code& code);

// Words that are ignored beside codes, as they are printed; rules of codes that stand one after
// the other are one.
struct PassedWords {
  std::string codes;  // "G80", "G110, G111", "G02, G03 with R", "every block"
  std::string words;  // "K R E"
  ClauseId clause;
  std::string_view why;
};
std::vector<PassedWords> passed_words(const Descriptor& descriptor);

}  // namespace gonogo::reference
