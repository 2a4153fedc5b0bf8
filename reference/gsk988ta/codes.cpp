// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/codes.hpp"

#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/descriptor.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// GSK-COM-02, GSK-COM-08 (a code with decimals); GSK-COM-07.
constexpr GCodeTable kTable{table::kCodes, "GSK-COM-02"_clause, "GSK-COM-07"_clause};

}  // namespace

bool repeats_group(const grammar::Block& block) {
  return kTable.repeats_group(block);
}

void read_codes(const grammar::Block& block, bool last_wins, CodeReading& reading) {
  kTable.read(block, last_wins, reading);
  reading.codes = {.once = reading.of(Group::once),
                   .motion = reading.of(Group::motion),
                   .cycle = reading.of(Group::cycle),
                   .feed_mode = reading.of(Group::feed_mode),
                   .units = reading.of(Group::units),
                   .plane = reading.of(Group::plane)};
}

const Code* code_of(int number) {
  return kTable.find_tenths(number * 10);
}

}  // namespace gonogo::reference::gsk988ta
