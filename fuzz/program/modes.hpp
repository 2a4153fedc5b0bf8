// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program with what its codes put in force, block by block, read off the text by the dialect's
// table: enough to say what its words mean, because a program may alarm before it gets there.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/program/text.hpp"
#include "reference/axis.hpp"
#include "reference/descriptor.hpp"
#include "reference/profile.hpp"

namespace gonogo::program {

struct BlockModes {
  const reference::Code* own = nullptr;     // a code of the block that does something; the last one
  const reference::Code* motion = nullptr;  // the motion or cycle in force; null: it is not known
  reference::Plane plane = reference::Plane::g17;
  bool inch = false;
  bool incremental = false;
  bool absolute_centre = false;
  bool inverse_time = false;  // F is of its own block
  bool x_radius = false;      // X words are radii

  bool moves_beside = false;  // the motion in force runs, too, beside a dwell
  // What the block runs: its own code, else the one in force. Null: none.
  const reference::Code* code() const { return own != nullptr ? own : motion; }
  // What moves in the block: of a dwell beside a motion the motion.
  const reference::Code* moving() const { return moves_beside ? motion : code(); }
  std::string_view code_name() const { return code() == nullptr ? "" : code()->name; }
  bool is_of(reference::Kind kind) const { return code() != nullptr && code()->kind == kind; }
  bool in_cycle() const { return is_of(reference::Kind::cycle) || in_thread(); }
  // Whether F is the lead of a thread.
  bool in_thread() const;
};

struct TextBlock : TextLine {
  BlockModes modes;
  std::vector<std::string> codes;  // of each word the code that it is: "G1"; else empty

  // REQUIRES: it is one of the words.
  const std::string& code_of(const TextWord& word) const {
    return codes[static_cast<std::size_t>(&word - words.data())];
  }
  // A word by its name, "X" or "R105"; null: there is none.
  const TextWord* find(std::string_view name) const;
  bool has_code(std::string_view code) const;
  // What the word is to the block: to its own code, the motion in force, any code. Null:
  // nothing.
  const reference::CodeWord* role_of(const TextWord& word,
                                     const reference::Descriptor& table) const;
};

struct ProgramText {
  ProgramText(const reference::Profile& profile, std::string_view program);
  std::string text() const;
  // The code that a line runs, from 1; "" where it runs none, or there is none.
  std::string_view code_at(std::uint64_t line) const {
    const bool is_there = line > 0 && line <= blocks.size();
    const reference::Code* const code = is_there ? blocks[line - 1].modes.moving() : nullptr;
    return code == nullptr ? std::string_view() : code->name;
  }

  const reference::Descriptor* table;  // of the dialect
  std::vector<TextBlock> blocks;
};

// A block that the machine skips unread.
bool is_left_out(const TextLine& line, const reference::Profile& profile);

}  // namespace gonogo::program
