// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hnc21t/codes.hpp"

#include "reference/clause_literal.hpp"
#include "reference/hnc21t/descriptor.hpp"

namespace gonogo::reference::hnc21t {
namespace {

constexpr GCodeTable kTable{table::kCodes, "HNC-COM-01"_clause, "HNC-COM-02"_clause};

}  // namespace

void read_codes(const grammar::Block& block, CodeReading& reading) {
  kTable.read(block, false, reading);
  reading.codes = {.once = reading.of(Group::once),
                   .motion = reading.of(Group::motion),
                   .plane = reading.of(Group::plane),
                   .units = reading.of(Group::units),
                   .diameter = reading.of(Group::diameter),
                   .offset = reading.of(Group::offset),
                   .distance = reading.of(Group::distance),
                   .feed_mode = reading.of(Group::feed_mode)};
}

const Code* code_that_runs(const BlockCodes& codes, int motion) {
  return kTable.find_tenths((codes.once >= 0 ? codes.once : motion) * 10);
}

}  // namespace gonogo::reference::hnc21t
