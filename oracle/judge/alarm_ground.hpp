// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why the reference does not alarm where a subject does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "oracle/judge/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

// Where a subject alarms: in a block, or, where it has no line numbers, behind one item of the
// reference and before another (from 1).
struct AlarmPlace {
  std::uint64_t block = 0;  // 0: not known
  std::size_t behind = 0;
  std::size_t before = std::numeric_limits<std::size_t>::max();
};

// The clause under which the program is right there: a rule that no text states, where the block
// runs on by one, or where such a rule ends the program before it; else the clause of the first
// record of the block; else that a block can be read. Runs the reference anew, as far as there.
reference::ClauseId clause_of_right(const reference::Profile& profile, const ProgramText& program,
                                    const AlarmPlace& place);

}  // namespace gonogo::oracle
