// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the reference changes its mind: the two neighbouring increments of a word between which
// what comes of a program is another thing. Found from outside, without a look at its predicates.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "reference/profile.hpp"

namespace gonogo::cover {

// A number in a program that may be varied.
struct VariedWord {
  std::string address;     // "R", "CR=", "R101="
  std::size_t line = 0;    // 1-based
  std::size_t begin = 0;   // of the number, in the program's text
  std::size_t length = 0;  // of the number
};

// The words of the lines `first` to `last` whose numbers are lengths or angles: not those of G, M,
// N, S, T, and none in brackets.
std::vector<VariedWord> varied_words(std::string_view program, std::size_t first, std::size_t last);

// One least increment below, on and above a predicate.
struct Triple {
  std::string address;
  std::string clause;  // what holds on one side alone
  std::string change;  // what changes, to distinguish triples of one kind
  std::array<std::string, 3> programs;
};

// The triples of one word, at most one between two of the values that are tried first: none, the
// least, half of the present value, the value itself and its multiples, and the ends of the range,
// on either side of zero. `decimals`: of the least increment. Programs of more than some hundred
// records, with a code that is not read, or with two clauses broken at once, give no triple.
std::vector<Triple> boundary_triples(const reference::Profile& profile, const std::string& program,
                                     const VariedWord& word, int decimals);

}  // namespace gonogo::cover
