// SPDX-License-Identifier: GPL-3.0-or-later
//
// Relations between programs: two programs that have to do the same, or the same elsewhere. They
// hold of any control, so that a subject can be tried against itself, without
// a word on what is right.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/generate/generator.hpp"

namespace gonogo::relations {

using generate::GeneratedProgram;
using reference::Number;

// How feeds and leads are held against each other: to the last digit, as places are, or not at all.
enum class Feeds : std::uint8_t { equal, near, any };

// The other program, and what of the first one has to come back.
struct Related {
  GeneratedProgram program;
  std::size_t turned = 0;  // so often X becomes Y, Y becomes Z and Z becomes X; before all else
  Number scale = 1;        // of lengths, feeds and leads
  std::array<Number, reference::kAxes> shift;        // of every place, mm
  std::array<bool, reference::kAxes> mirrored = {};  // before the shift
  std::vector<std::uint64_t>
      lines;  // [n - 1]: where line n of the first program stands; 0: nowhere
  std::vector<std::uint64_t>
      counts_as;  // [n - 1]: the line of the other program that its line n counts as; empty: itself
  std::vector<std::uint64_t>
      halved;  // lines of the first program whose one motion is made in two halves
  Feeds feeds = Feeds::equal;
  bool is_beginning = false;  // the other program ends where the first goes on
};

// Where X becomes Y, Y becomes Z and Z becomes X so often: a position, and a plane, whose axes go
// along with it (G17 becomes G19).
reference::Position turned(const reference::Position& position, std::size_t turns);
reference::Plane turned(reference::Plane plane, std::size_t turns);

// One way to make another program. A variant is one of several of the same kind.
struct Relation {
  std::string_view name;      // "translation"
  std::string_view sentence;  // what has to hold
  bool exact = true;          // to the last digit; else within the subject's resolution
  bool needs_lines = false;   // it says nothing of records without lines
  // How many variants there are of this program.
  std::size_t (*variants)(const GeneratedProgram& program);
  // Nothing where the program does not lend itself to it. REQUIRES: variant < variants(program).
  std::optional<Related> (*relate)(const GeneratedProgram& program, std::size_t variant);
};

std::span<const Relation> relations();
// Null: there is none of that name.
const Relation* find_relation(std::string_view name);

// The program elsewhere: its absolute places moved, or a work offset or frame before it.
std::optional<Related> translated(const GeneratedProgram& program);

}  // namespace gonogo::relations
