// SPDX-License-Identifier: GPL-3.0-or-later
//
// What makes related programs out of the lines of one.
#pragma once

#include <string>
#include <vector>

#include "program/modes.hpp"
#include "relations/relation.hpp"

namespace gonogo::relations {

// Every line stands where it stood.
std::vector<std::uint64_t> same_lines(std::size_t count);
// The program with a block before its first one, behind its head. Nothing where it has none, or the
// first one may be left out.
std::optional<Related> with_block_before(const generate::GeneratedProgram& program,
                                         std::string block);

// Whether words cannot be told apart for sure: blanks within them, codes that are only nearly those
// that they may count as, and codes that the gauge does not read.
bool has_unclear_words(const program::ProgramText& text);
// Whether the program has a code or a word for which `is_it` holds.
bool any_code(const program::ProgramText& text, bool (*is_it)(const reference::Code&));
bool any_role(const program::ProgramText& text, bool (*is_it)(reference::Role));
// The plane of all blocks with words; nothing: there are several.
std::optional<reference::Plane> only_plane(const program::ProgramText& text,
                                           const reference::Profile& profile);

// The linear axis along which the word stands, and how.
struct AlongAxis {
  std::size_t axis;
  reference::Role role;
};
// Nothing: it stands along none.
std::optional<AlongAxis> axis_of(const program::TextWord& word, const program::TextBlock& block,
                                 const reference::Descriptor& table);

// The program mirrored at the plane across an axis (0: X). Nothing where that cannot be said with
// its words.
std::optional<Related> mirrored(const generate::GeneratedProgram& program, std::size_t axis);

}  // namespace gonogo::relations
