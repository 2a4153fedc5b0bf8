// SPDX-License-Identifier: GPL-3.0-or-later
//
// Relations between programs: two programs that have to do the same, or the same elsewhere,
// whatever it is. They hold of any control, so that a subject can be tried against itself, without
// a word on what is right.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "generate/generator.hpp"

namespace gonogo::relations {

using reference::Number;

// The other program, and what of the first one has to come back.
struct Related {
  generate::GeneratedProgram program;
  std::array<Number, reference::kAxes> shift;        // of every place, mm
  std::array<bool, reference::kAxes> mirrored = {};  // before the shift
  std::vector<std::uint64_t>
      lines;                  // [n - 1]: where line n of the first program stands; 0: nowhere
  bool is_beginning = false;  // the other program ends where the first goes on
};

// One way to make another program. A variant is one of several of the same kind.
struct Relation {
  std::string_view name;      // "translation"
  std::string_view sentence;  // what has to hold
  bool exact = true;          // to the last digit; else within the subject's resolution
  // How many variants there are of this program.
  std::size_t (*variants)(const generate::GeneratedProgram& program);
  // Nothing where the program does not lend itself to it. REQUIRES: variant < variants(program).
  std::optional<Related> (*relate)(const generate::GeneratedProgram& program, std::size_t variant);
};

std::span<const Relation> relations();
// Null: there is none of that name.
const Relation* find_relation(std::string_view name);

// The program elsewhere: its absolute places moved, or a work offset or frame before it.
std::optional<Related> translated(const generate::GeneratedProgram& program);

}  // namespace gonogo::relations
