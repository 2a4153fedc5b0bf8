// SPDX-License-Identifier: GPL-3.0-or-later
//
// M functions: their numbers, their order and their groups.
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/block_base.hpp"
#include "reference/reading.hpp"

namespace gonogo::reference::rs274 {

// NGC-COM-01: the number of an M function; nothing when it is none, or has too many digits.
std::optional<std::int64_t> m_number(const grammar::Word& word, const ReadingsInUse& readings);
// The M functions of the block, those below M100 by their numbers.
using MFunctions = std::bitset<100>;
MFunctions m_functions_of(const grammar::Block& block, const ReadingsInUse& readings);
// The record of an M function.
Record function_record(std::uint64_t line, ClauseId clause, int m);
// What the M functions of the block put out, in the order of execution.
void take_m_functions(const grammar::Block& block, std::uint64_t line,
                      const ReadingsInUse& readings, BlockOutput& out);
// NGC-COM-01: of a modal group one M function, and four in all.
void check_m_groups(const grammar::Block& block, const ReadingsInUse& readings,
                    std::vector<Alarm>& alarms);

struct BlockContext;
// NGC-COM-09: an alarm where S or T has a number that it may not have.
void check_spindle_and_tool(BlockContext& block);
// The words of M50 to M53 and M61 to M68 (NGC-COM-09, NGC-COM-15).
void check_signals(BlockContext& block);

}  // namespace gonogo::reference::rs274
