// SPDX-License-Identifier: GPL-3.0-or-later
//
// What makes related programs out of the lines of one.
#pragma once

#include <string>

#include "fuzz/hunt/program_text.hpp"
#include "fuzz/relations/relation.hpp"

namespace gonogo::fuzz {

// Every line stands where it stood.
std::vector<std::uint64_t> same_lines(std::size_t count);
// The program with a block before its first one, behind its head. Nothing where it has none, or the
// first one may be left out.
std::optional<Related> with_block_before(const GeneratedProgram& program, std::string block);

}  // namespace gonogo::fuzz
