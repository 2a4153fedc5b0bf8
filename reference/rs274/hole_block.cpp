// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/hole_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {

// NGC-CYC-16: all that follows is along the axes of the plane in force.
HoleBlock::HoleBlock(BlockContext& block, OwnWord own)
    : block_(block), axes_(axes_of(block.machine.plane)), own_(own), initial_(block) {
  take_words();
  take_own_word();
  check_axes();
  count_ = repeats();
  if (words().r && words().depth) {
    levels_ = read_levels();
    // NGC-CYC-07
    const int depth = decided("NGC-CYC-07"_clause, "R - bottom", levels_->r_plane, levels_->bottom);
    if (depth == 0) warn_of_no_depth();
    if (depth < 0) {
      block_.alarm(AlarmClass::reference_plane, "NGC-CYC-07"_clause, 'R',
                   with_values("R, {} mm, lies below the bottom of the hole, {} mm.",
                               {levels_->r_plane, levels_->bottom}));
    }
  }
  // NGC-CYC-20; in inverse time none is in force.
  if (decided("NGC-CYC-20"_clause, "F", block_.machine.feed) <= 0 &&
      block_.readings.is("ngc.cycle.feed=needed"_reading)) {
    block_.need_feed("NGC-CYC-20"_clause);
  }
}

// NGC-CYC-03: often meant as a level to go back to, and read as the bottom.
void HoleBlock::warn_of_no_depth() const {
  const char depth = address_of(axes_.d);
  block_.out.warnings.push_back(
      {with_values(fmt::format("{} and R are both {{}} mm: the cycle drills nothing.", depth),
                   {levels_->bottom}),
       block_.places.place_of(depth).value_or(block_.places.behind())});
}

// NGC-CYC-02, NGC-CYC-03: those of the first block of a cycle hold until they are written anew.
void HoleBlock::take_words() {
  StickyWords& sticky = block_.machine.cycle.words;
  const BlockWords& words = block_.words;
  const char depth = address_of(axes_.d);
  if (words.has('R')) sticky.r = words.written('R');
  if (words.has(depth)) sticky.depth = words.written(depth);
  if (!sticky.r) block_.missing("NGC-CYC-02"_clause, 'R');
  if (!sticky.depth) block_.missing("NGC-CYC-02"_clause, depth);
}

// NGC-CYC-02, NGC-CYC-22
void HoleBlock::take_own_word() {
  if (own_ == OwnWord::none) return;
  const bool is_q = own_ == OwnWord::needs_q;
  const char address = is_q ? 'Q' : 'P';
  CycleState& cycle = block_.machine.cycle;
  std::optional<Number>& in_force = is_q ? cycle.words.q : cycle.words.p;
  if (block_.words.has(address)) {
    in_force = block_.words.written(address);
    if (is_q && decided("NGC-CYC-22"_clause, "Q", *in_force) <= 0) {
      block_.alarm(AlarmClass::value_sign, "NGC-CYC-22"_clause, 'Q',
                   with_values("The depth of a peck, {}, is not above zero.", {*in_force}));
      note_late(Found::over_the_hole);
      is_q_at_fault_ = true;
    } else if (!is_q && decided("NGC-CYC-22"_clause, "P", *in_force) < 0) {
      block_.alarm(AlarmClass::value_sign, "NGC-CYC-22"_clause, 'P',
                   with_values("A dwell of {} s is negative.", {*in_force}));
    }
  }
  if (!in_force && own_ != OwnWord::takes_p) {
    block_.missing("NGC-CYC-02"_clause, address);
    note_late(Found::above_the_place);
  }
  if (!is_q && in_force) cycle.last_p = dwell_ = *in_force;
}

// NGC-CYC-04, NGC-CYC-18
void HoleBlock::check_axes() {
  if (block_.codes.motion >= 0 && !block_.words.has_linear_axis_word()) {
    block_.missing("NGC-CYC-04"_clause, address_of(axes_.p));
  }
  for (const char address : {'A', 'C'}) {
    if (!block_.words.has(address)) continue;
    block_.alarm(AlarmClass::axis_not_in_plane, "NGC-CYC-18"_clause, address,
                 fmt::format("A cycle does not move {}.", address));
  }
}

// NGC-CYC-15: L. Any number when the rules are broken.
Number HoleBlock::repeats() {
  if (!block_.words.has('L')) return 1;
  const ClauseId clause = "NGC-CYC-15"_clause;
  const Number written = block_.words.written('L');
  const NearWhole count(written);
  const bool is_whole = count.counts_as_whole(Whole::repeats, block_.readings);
  if (!is_whole) {
    block_.alarm(AlarmClass::not_an_integer, clause, 'L',
                 with_values("The number of holes, {}, is not whole.", {written}));
  }
  const int sign = decided(clause, "L", is_whole ? count.nearest() : written);
  if (sign < 0) {
    block_.alarm(AlarmClass::value_sign, clause, 'L',
                 with_values("The number of holes, {}, is below zero.", {written}));
  } else if (sign == 0) {
    block_.alarm(AlarmClass::value_out_of_range, clause, 'L',
                 with_values("The number of holes, {}, counts as zero.", {written}));
  }
  return count.nearest();
}

// NGC-CYC-06: what R counts from under G91.
Number HoleBlock::r_base() const {
  const Number& here = block_.machine.position[axes_.d];
  const bool begins_here = initial_.always([&](const Number& initial) { return initial == here; });
  if (here.sign() == 0 && begins_here) return here;
  const ReadingsInUse& readings = block_.readings;
  if (readings.is("ngc.cycle.g91-r=initial"_reading)) {
    return initial_.of([](const Number& initial) { return initial; });
  }
  return readings.is("ngc.cycle.g91-r=absolute"_reading) ? 0 : here;
}

// NGC-CYC-05, NGC-CYC-06: `base` is what R counts from under G91.
CycleLevels HoleBlock::levels_from(const Number& base) const {
  const Number r = length_of(*words().r);
  const Number depth = length_of(*words().depth);
  if (!block_.machine.modes.incremental) return {r, depth};
  return {base + r, base + r + depth};
}

CycleLevels HoleBlock::levels_of_numbers() const {
  return levels_from(block_.machine.modes.incremental ? r_base() : 0);
}

// NGC-CYC-03: the numbers in force, read anew; under ngc.cycle.sticky = level what is not written
// stays where it is.
CycleLevels HoleBlock::read_levels() const {
  const std::optional<CycleLevels>& kept = block_.machine.cycle.levels;
  const bool writes_r = block_.words.has('R');
  const bool writes_depth = block_.words.has(address_of(axes_.d));
  if (!kept || (writes_r && writes_depth)) return levels_of_numbers();
  const auto keeps = [&] { return block_.readings.is("ngc.cycle.sticky=level"_reading); };
  if (writes_r) {
    const CycleLevels numbers = levels_of_numbers();
    if (numbers.bottom == kept->bottom || !keeps()) return numbers;
    return {numbers.r_plane, kept->bottom};
  }
  CycleLevels levels = *kept;
  if (writes_depth) {
    const bool from_r = block_.machine.modes.incremental;
    levels.bottom = length_of(*words().depth) + (from_r ? levels.r_plane : 0);
  }
  const auto is_kept = [&](const Number& base) { return levels_from(base) == levels; };
  const bool alike =
      is_kept(0) && is_kept(block_.machine.position[axes_.d]) && initial_.always(is_kept);
  return !alike && keeps() ? levels : levels_of_numbers();
}

HoleAhead HoleBlock::ahead() const {
  Position hole;
  commanded_end_point(block_, hole);
  hole[axes_.d] = levels_->r_plane;
  return {block_, initial_, hole};
}

Number HoleBlock::clear() const {
  return clear_level(ahead());
}

void HoleBlock::missing_dwell(ClauseId clause) {
  block_.missing(clause, 'P');
  note_late(Found::above_the_place);
}

// NGC-CYC-29
void HoleBlock::note_late(Found found) {
  ++late_;
  found_ = std::min(found_, found);
}

void HoleBlock::alarm_at_hole(AlarmClass alarm, ClauseId clause, WordName word,
                              std::string message) {
  block_.alarm(alarm, clause, word, std::move(message));
  note_late(Found::over_the_hole);
}

// NGC-CYC-29: what a control has moved when it finds what is wrong, unless something else is;
// behind the dwell of a G4 of the block (NGC-CYC-27).
void HoleBlock::stop() {
  if (late_ != block_.out.alarms.size() || !levels_) return;
  const HoleAhead hole = ahead();
  const bool at_place = found_ == Found::above_the_place;
  std::vector<Item> dwells = dwells_of(block_);
  const bool stays =
      at_place ? always_approached(hole, [](const Approach& way) { return way.lifts == 0; })
               : always_approached(hole, [](const Approach& way) { return way.traverses.empty(); });
  if ((stays && dwells.empty()) || !block_.readings.is("ngc.cycle.alarm-at=late"_reading)) return;
  if (is_q_at_fault_ && block_.readings.is("ngc.cycle.alarm-at-q=block"_reading)) return;
  Approach moved = approach(hole);
  if (at_place) moved.traverses.resize(moved.lifts);
  block_.out.before_alarm = std::move(dwells);
  std::ranges::copy(moved.traverses, std::back_inserter(block_.out.before_alarm));
}

void HoleBlock::run(Hole hole) {
  if (!is_sound()) return stop();
  Machine& machine = block_.machine;
  const HoleAhead first = ahead();
  Holes holes{.line = block_.line,
              .axes = axes_,
              .start = machine.position,
              .approach = approach(first).traverses,
              .first = {first.hole[axes_.p], first.hole[axes_.q]},
              .count = count_,
              .r_plane = levels_->r_plane,
              .bottom = levels_->bottom,
              .clear = ends_at_r_plane_ ? levels_->r_plane : clear_level(first),
              .feed_in_force = machine.feed,
              .feed_mode = machine.feed_mode,
              .dwell_time = dwell_,
              .spindle = machine.spindle};
  // NGC-CYC-13, NGC-CYC-14
  if (machine.modes.incremental && block_.words.is_polar()) holes.polar = polar_steps(block_);
  if (machine.modes.incremental) {
    holes.step = {holes.first[0] - holes.start[axes_.p], holes.first[1] - holes.start[axes_.q]};
  }
  machine.cycle.levels = levels_;
  block_.out.name_plane("R plane", axes_.d, holes.r_plane);
  // NGC-CYC-26
  const std::array<Number, 2> last = holes.place(holes.count);
  machine.position[axes_.p] = last[0];
  machine.position[axes_.q] = last[1];
  machine.position[axes_.d] = holes.clear;
  block_.out.cycle = run_holes(std::move(holes), std::move(hole));
}

}  // namespace gonogo::reference::rs274
