// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs made by editing words one by one, with the modes that they stand in. Lines stay lines,
// so that block numbers mean the same afterwards.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fuzz/program/modes.hpp"

namespace gonogo::program {

// What to write for a word: nothing leaves it as it is, "" takes it out.
using WordEdit = std::function<std::optional<std::string>(const TextBlock&, const TextWord&)>;
// What to add after the last word of a block; "": nothing.
using BlockEdit = std::function<std::string(const TextBlock&)>;

// Whether a word goes.
using WordTest = std::function<bool(const TextBlock&, const TextWord&)>;

// The program with its words edited. Nothing: nothing changes.
std::optional<std::string> edited(const ProgramText& program, const WordEdit& edit);
// The program without the words that go. Nothing: none does.
std::optional<std::string> without_words(const ProgramText& program, const WordTest& goes);
// The program with something added, block by block in the order of the program.
std::optional<std::string> edited_in_order(const ProgramText& program, const BlockEdit& add);

}  // namespace gonogo::program
