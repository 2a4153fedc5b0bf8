// SPDX-License-Identifier: GPL-3.0-or-later
//
// What fuzzers that mutate NC text are given: the codes and words of a dialect's table, and what
// fuzz/program/dictionaries has beside them. In the format that libFuzzer and AFL++ read: an entry a
// line between quotation marks, \\ \" and \xAB within it; '#' begins a comment.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gonogo::program {

// libFuzzer ignores a dictionary that has a longer entry.
inline constexpr std::size_t kLongestEntry = 64;

struct Dictionary {
  std::string_view dialect;
  std::vector<std::string> entries;  // words ("G94", "X50") and whole blocks ("G80 X48 Z-20 F150")
};

// The entries, or the number of the first line that is neither entry nor comment nor empty.
std::variant<std::vector<std::string>, std::size_t> read_dictionary(std::string_view text);

// Those that are built in, in the order of the dialects.
std::span<const Dictionary> dictionaries();
// A dialect's as a file; those of all dialects in one where there is no such dialect.
std::string dictionary_text(std::string_view dialect);
// Null: there is no such dialect.
const Dictionary* find_dictionary(std::string_view dialect);

}  // namespace gonogo::program
