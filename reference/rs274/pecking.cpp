// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/pecking.hpp"

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-G83-08: whether the block has a D that counts.
bool has_clearance_word(const BlockContext& block) {
  return block.words.has('D') && block.readings.is("ngc.peck.d=clearance"_reading);
}

const Number kQuarter = Number::millionths(250'000);  // of a second

}  // namespace

PeckBlock::PeckBlock(BlockContext& block) : holes_(block, OwnWord::needs_q) {
  if (has_clearance_word(block) &&
      decided("NGC-G83-08"_clause, "D", block.words.written('D')) < 0) {
    block.alarm(AlarmClass::value_sign, "NGC-G83-08"_clause, 'D',
                with_values("The clearance above the last peck, {}, is below zero.",
                            {block.words.written('D')}));
  }
  if (holes_.is_sound() && block.readings.is("ngc.peck.dwell=quarter"_reading)) {
    holes_.dwell_for(kQuarter);
  }
}

// NGC-G83-07
Number PeckBlock::depth() const {
  return holes_.length_of(*holes_.words().q);
}

// NGC-G83-01: the least whole number with R - N q <= B, and one at least.
Number PeckBlock::count() const {
  const auto& [r_plane, bottom] = holes_.levels();
  return max(1, ((r_plane - bottom) / depth()).ceil());
}

// NGC-G83-04, NGC-G83-08
Number PeckBlock::clearance() const {
  const BlockContext& block = holes_.block();
  if (has_clearance_word(block)) return holes_.length_of(block.words.written('D'));
  if (block.readings.is("ngc.peck.clearance=one-mm"_reading)) {
    // The number of the machine's units, in those of the program.
    const bool is_inch_machine = block.profile.units == Units::inch;
    return holes_.length_of(is_inch_machine ? Number::millionths(50'000) : 1);
  }
  if (block.readings.is("ngc.peck.clearance=tenth-mm"_reading)) return Number::millionths(100'000);
  if (block.readings.is("ngc.peck.clearance=twentieth"_reading)) return depth() / 20;
  return inches(Number::millionths(10'000));
}

Number end_of_peck(const Holes& holes, const Number& depth, const Number& k) {
  return holes.r_plane - k * depth;
}

}  // namespace gonogo::reference::rs274
