// SPDX-License-Identifier: GPL-3.0-or-later
//
// What makes related programs out of the lines of one.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/hunt/program_text.hpp"
#include "fuzz/relations/relation.hpp"

namespace gonogo::fuzz {

// Every line stands where it stood.
std::vector<std::uint64_t> same_lines(std::size_t count);
// The program with a block before its first one, behind its head. Nothing where it has none, or the
// first one may be left out.
std::optional<Related> with_block_before(const GeneratedProgram& program, std::string block);

// Whether a word of the line, or of one of the lines, is the code: "G2" where G02 is written.
bool holds(const TextLine& line, std::string_view code);
bool holds_any(const std::vector<TextLine>& lines, std::initializer_list<std::string_view> codes);
// Whether blanks stand within words. They take them apart here, and what they say with them.
bool has_bare_g(const std::vector<TextLine>& lines);
// The same, or codes that are only nearly those that they may count as.
bool has_unclear_words(const std::vector<TextLine>& lines);
// A block that the machine passes over unread.
bool is_left_out(const TextLine& line, const reference::Profile& profile);

// The program mirrored at the plane across an axis (0: X). Nothing where that cannot be said with
// its words.
std::optional<Related> mirrored(const GeneratedProgram& program, std::size_t axis);

}  // namespace gonogo::fuzz
