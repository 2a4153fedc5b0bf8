// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a block is made of, as far as a subject may do one part and skip another.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "fuzz/program/modes.hpp"

namespace gonogo::hunt {

// "code G2", "word A", "text (" (what is no word), "spelling tab" (a way to write), "feature
// planes", "fraction F" (its number is not whole), "block G1+F+X" (which codes and words stand
// together, in any order).
using Parts = std::set<std::string>;

// Parts that come with others, and are to blame only where those are not: 0 for codes, words,
// texts and spellings, then features, fractions, blocks.
int rank_of_part(std::string_view part);
inline constexpr int kBlockRank = 3;

Parts parts_of_word(const program::TextBlock& block, const program::TextWord& word);
// With those of its words.
Parts parts_of_block(const program::TextBlock& block, const reference::Descriptor& table);

// The block without the ways to write that are not admitted, where that takes no word away: gaps,
// the order of words. As it stands where they are all admitted.
std::string rewritten(const program::TextBlock& block,
                      const std::function<bool(const std::string& part)>& admits);

// The words of a block and nothing else, as plainly as they can be written, with a line end; with
// their numbers, or with other numbers that any subject reads: "X12" for "X+12.50", "F1" for "F.5".
enum class Numbers : std::uint8_t { as_written, whole };
std::string plainly(const program::TextBlock& block, Numbers numbers = Numbers::as_written);

}  // namespace gonogo::hunt
