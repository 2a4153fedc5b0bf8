// SPDX-License-Identifier: GPL-3.0-or-later
//
// What makes related programs out of the lines of one.
#pragma once

#include <string>
#include <vector>

#include "fuzz/program/modes.hpp"
#include "fuzz/relations/relation.hpp"

namespace gonogo::relations {

using program::ProgramText;
using program::TextBlock;
using program::TextLine;
using program::TextWord;
using reference::Code;
using reference::Group;
using reference::Kind;
using reference::Profile;
using reference::Role;
using reference::Setting;

// Every line stands where it stood.
std::vector<std::uint64_t> same_lines(std::size_t count);
// The program with a block before its first one, behind its head. Nothing where it has none, or the
// first one may be left out.
std::optional<Related> with_block_before(const GeneratedProgram& program, std::string block);

// Whether the code takes places along one or two of X, Y and Z alone: it knows them by their names.
bool names_own_axes(const Code& code);
// Whether the code is a cycle that goes on in steps, as one in pecks does.
bool is_in_steps(const Code& code);
// Whether a cycle's path is left to the control, which may lay it otherwise in the other program.
bool has_open_path(const ProgramText& text);
// Whether words cannot be distinguished for sure: blanks within them, codes that are only nearly
// those that they may count as, and codes that the gauge does not read; or whether they are not the
// ways and feeds that they say.
bool has_unclear_words(const ProgramText& text);
// Whether blanks have cut words of the block.
bool has_cut_words(const TextBlock& block);
// Whether the program has a code or a word for which `is_it` holds.
bool any_code(const ProgramText& text, bool (*is_it)(const Code&));
bool any_role(const ProgramText& text, bool (*is_it)(Role));
// The plane of all blocks with words; nothing: there are several.
std::optional<reference::Plane> only_plane(const ProgramText& text, const Profile& profile);

// The linear axis along which the word stands, and how.
struct AlongAxis {
  std::size_t axis;
  Role role;
};
// Nothing: it stands along none.
std::optional<AlongAxis> axis_of(const TextWord& word, const TextBlock& block,
                                 const reference::Descriptor& table);

// The program mirrored at the plane across an axis (0: X). Nothing where that cannot be said with
// its words.
std::optional<Related> mirrored(const GeneratedProgram& program, std::size_t axis);

// Whether the blocks may run in another order than they stand, or which modes they put in force is
// not clear.
bool has_unclear_order(const ProgramText& text);
// Words that are calculated, and lines that may run more than once: what stands in a block says
// little of what it does.
bool is_calculated(const ProgramText& text);
// Whether a block is there to be run: it has a word, and the machine does not pass it over.
bool is_run(const TextBlock& block, const Profile& profile);
// The number of a word that is an address and a number: X5, CR=5. Nothing: it is more than that.
std::optional<Number> plain_value(const TextWord& word);
// Whether the number can be written with the decimals that every control takes: three of
// millimetres, four of inches.
bool is_writable(const Number& number, bool inch);

// Whether a word of the number has room: near the ends of their ranges words are refused.
bool has_room(const Number& number);

// The program in the other unit of length, by 1 inch = 127/5 mm: the same part.
std::optional<Related> in_other_unit(const GeneratedProgram& program);
// The same numbers in the other unit of length: a similar part.
std::optional<Related> same_numbers(const GeneratedProgram& program);
// The program with X for Y, Y for Z and Z for X, so often, and its planes with them.
// REQUIRES: turns is 1 or 2.
std::optional<Related> in_other_plane(const GeneratedProgram& program, std::size_t turns);

// Increments can be written by words of their own, U V W, and by a mode, G91.
std::size_t ways_of_increments(const GeneratedProgram& program);
// Absolute end points of traverses, lines and arcs written as increments.
// REQUIRES: way < ways_of_increments(program).
std::optional<Related> by_increments(const GeneratedProgram& program, std::size_t way);
// Straight motions written as two, each half as long.
std::optional<Related> in_halves(const GeneratedProgram& program);
// Cycles that make several holes by one block (L under G91 and G98) written as so many blocks.
std::optional<Related> unrolled(const GeneratedProgram& program);

}  // namespace gonogo::relations
