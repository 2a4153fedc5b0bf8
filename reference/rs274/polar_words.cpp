// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/polar_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {
namespace {

PlaceInXy place_of(const BlockContext& block) {
  return {block.machine.position[Axis::x], block.machine.position[Axis::y]};
}

Number squared_distance(const PlaceInXy& place) {
  return place[0] * place[0] + place[1] * place[1];
}

PlaceInXy turned(const PlaceInXy& place, const Number& angle) {
  const auto [cosine, sine] = exact::cos_sin_degrees(angle);
  return {place[0] * cosine - place[1] * sine, place[0] * sine + place[1] * cosine};
}

PlaceInXy scaled(const PlaceInXy& place, const Number& factor) {
  return {place[0] * factor, place[1] * factor};
}

// Under G91, and where the angle is left out, a motion has its direction from where it begins.
bool needs_direction(const BlockContext& block) {
  return block.machine.modes.incremental || !block.words.has('^');
}

void leave_out(BlockContext& block, std::string message) {
  block.not_covered("polar-word", block.words.has('@') ? '@' : '^', std::move(message));
}

bool stands_twice(const BlockContext& block, char address) {
  return std::ranges::count(block.words.block().words, address, &grammar::Word::address) > 1;
}

// NGC-POL-04
bool is_read(const BlockContext& block) {
  const int motion = block.machine.motion;
  const bool ends = motion >= 0 && motion <= 3;
  const bool stays_in_xy = block.machine.plane == Plane::g17 && !block.turns_plane;
  return (ends || is_hole_cycle(motion)) && stays_in_xy && !takes_axis_words(block.codes) &&
         block.codes.once != 530 && !block.machine.modes.diameter;
}

Number distance_of(const PlaceInXy& place) {
  return exact::sqrt(squared_distance(place));
}

// Where the motion begins: there the place has a direction.
PolarPlace start_of(const BlockContext& block) {
  if (block.machine.polar) return *block.machine.polar;
  return {place_of(block), {}};
}

Number holes_of(const BlockContext& block) {
  const bool has_count = is_hole_cycle(block.machine.motion) && block.words.has('L');
  return has_count ? NearWhole(block.words.written('L')).nearest() : 1;
}

Number distance_of(const PolarPlace& place) {
  return distance_of(place.base) + place.added.distance;
}

// On this side of the origin.
bool is_ahead(const PolarPlace& place) {
  return distance_of(place).sign() > 0;
}

// NGC-POL-02: under G90.
PolarPlace absolute_place(const BlockContext& block) {
  const BlockWords& words = block.words;
  const PolarPlace from = start_of(block);
  const Number distance = words.length('@').value_or(distance_of(from));
  if (words.has('^')) return {{distance, 0}, {0, words.written('^')}};
  return {from.base, {distance - distance_of(from.base), from.added.angle}};
}

PolarPlace place_after(const BlockContext& block, const Number& steps) {
  return block.machine.modes.incremental ? polar_steps(block).after(steps) : absolute_place(block);
}

// NGC-POL-04: of holes in a row the way through the origin.
bool passes_origin(const BlockContext& block) {
  const Number holes = holes_of(block);
  return block.machine.modes.incremental && holes > 1 &&
         !is_ahead(polar_steps(block).after(holes - 1));
}

}  // namespace

PlaceInXy PolarPlace::in_xy() const {
  if (squared_distance(base).sign() == 0) return base;  // NGC-POL-03: it has no direction
  const PlaceInXy place = turned(base, added.angle);
  if (added.distance.sign() == 0) return place;
  return scaled(place, 1 + added.distance / distance_of(base));
}

// NGC-POL-01
PolarPlace PolarSteps::after(const Number& steps) const {
  return {from.base,
          {from.added.distance + step.distance * steps, from.added.angle + step.angle * steps}};
}

PolarSteps polar_steps(const BlockContext& block) {
  const BlockWords& words = block.words;
  return {start_of(block),
          {words.length('@').value_or(0), words.has('^') ? words.written('^') : 0}};
}

PlaceInXy polar_end(const BlockContext& block) {
  return place_after(block, 1).in_xy();
}

void keep_polar_place(BlockContext& block) {
  const BlockCodes& codes = block.codes;
  const bool stays = !block.runs_motion && !block.words.has_axis_word() && codes.once < 0 &&
                     codes.offset < 0 && codes.tool_length < 0;
  if (!stays) block.machine.polar = std::move(block.polar);
}

void check_polar_words(BlockContext& block) {
  if (!block.words.is_polar() || block.out.not_covered) return;
  const bool has_motion = block.runs_motion || takes_axis_words(block.codes);
  if (!has_motion) return;  // NGC-MOD-01: an alarm of its own
  if (!is_read(block)) {
    return leave_out(block,
                     "The gauge reads polar words of G0 to G3 and of cycles, in G17, without G53 "
                     "and G7.");
  }
  if (stands_twice(block, '@') || stands_twice(block, '^')) {
    return leave_out(block, "No text says which of two polar words counts.");
  }
  const ClauseId clause = "NGC-POL-03"_clause;
  for (const char address : {'X', 'Y'}) {
    if (!block.words.has(address)) continue;
    block.alarm(AlarmClass::conflicting_words, clause, address,
                fmt::format("{} stands beside a polar word.", address));
  }
  const Number squared = squared_distance(place_of(block));
  const bool is_at_origin = needs_direction(block) && squared.sign() == 0;
  if (is_at_origin && !block.machine.modes.incremental) {
    leave_out(block, "No text says what the angle is at the origin.");
  } else if (is_at_origin) {
    block.alarm(AlarmClass::missing_word, clause, 'X',
                with_values("The motion begins at the origin, {} mm and {} mm, which has no angle.",
                            {place_of(block)[0], place_of(block)[1]}));
  } else if (passes_origin(block)) {
    leave_out(block, "The gauge follows no row of holes through the origin.");
  } else if (block.out.alarms.empty()) {
    block.polar = place_after(block, holes_of(block));
    if (!is_ahead(*block.polar)) block.polar.reset();
  }
}

}  // namespace gonogo::reference::rs274
