// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program as text whose words can be replaced one by one, with the modes that they stand in.
// Lines stay lines, so that block numbers mean the same afterwards.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/profile.hpp"

namespace gonogo::identify {

struct TextWord {
  std::string address;                     // "X", "G", "CR", "R105", "LCYC75"
  std::optional<reference::Number> value;  // where it is a plain number
  grammar::Span where;                     // bytes of the line
  grammar::Span number;                    // of the number alone

  // "G94"; for an address that is no code the same with its value.
  std::string code() const;
  bool is_code() const { return address == "G" || address == "M"; }
};

struct TextBlock {
  std::string text;  // the line without its end
  std::string end;   // LF, CR LF, CR or nothing
  std::vector<TextWord> words;
  std::string motion;  // "G94": of the block itself, else the one in force; "": none
  bool own_motion = false;
  int plane = 17;
  bool inch = false;
  bool incremental = false;      // G91 of makers that have it
  bool x_radius = false;         // X words are radii
  bool absolute_centre = false;  // G90.1

  const TextWord* find(std::string_view address) const;
  // Whether the motion is that of a cycle.
  bool in_cycle() const;
  bool in_thread() const { return motion == "G32" || motion == "G82" || motion == "G92"; }
};

struct ProgramText {
  ProgramText(const reference::Profile& profile, std::string_view program);
  std::string text() const;

  std::vector<TextBlock> blocks;
};

// What to write for a word: nothing leaves it as it is, "" takes it out.
using WordEdit = std::function<std::optional<std::string>(const TextBlock&, const TextWord&)>;
// What to add after the last word of a block; "": nothing.
using BlockEdit = std::function<std::string(const TextBlock&)>;

// The program with its words edited. Nothing: nothing changes.
std::optional<std::string> edited(const ProgramText& program, const WordEdit& edit);
// The program with something added, block by block in the order of the program.
std::optional<std::string> edited_in_order(const ProgramText& program, const BlockEdit& add);
// The word with another value: X12.5, CR=3.
std::string with_value(const TextBlock& block, const TextWord& word,
                       const reference::Number& value);

}  // namespace gonogo::identify
