// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/milling.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// The axes that a block commands, without the depth axis; their end point.
AxisSet positioned_axes(const BlockContext& block, const PlaneAxes& axes, Position& to) {
  const AxisSet named = commanded_end_point(block, to);
  to[axes.d] = block.machine.position[axes.d];
  AxisSet positioned;
  for (Axis axis : kAllAxes) {
    if (axis != axes.d && named.has(axis)) positioned.add(axis);
  }
  return positioned;
}

// Zero counts as above zero where a reading lets it run.
bool is_above_zero(const BlockContext& block, const NeededWord& word, ClauseId clause) {
  const int sign = decided(clause, {&word.address, 1}, *word.value);
  return sign > 0 || (sign == 0 && word.zero_runs && block.readings.is(*word.zero_runs));
}

}  // namespace

Record MillingSite::motion(RecordKind kind, ClauseId clause) const {
  Record record;
  record.kind = kind;
  record.block = block;
  record.clause = clause;
  record.plane = plane;
  if (kind != RecordKind::rapid) {
    record.feed = feed;
    record.feed_mode = feed_mode;
  }
  return record;
}

Record MillingSite::rapid_depth(ClauseId clause, const Number& depth) const {
  Record record = motion(RecordKind::rapid, clause);
  record.axes = {axes.d};
  record.to[axes.d] = depth;
  return record;
}

Record MillingSite::feed_depth(ClauseId clause, const Number& depth) const {
  Record record = motion(RecordKind::feed, clause);
  record.axes = {axes.d};
  record.to[axes.d] = depth;
  return record;
}

Record MillingSite::return_at(bool at_feed, ClauseId clause) const {
  return at_feed ? feed_depth(clause, initial_plane) : rapid_depth(clause, initial_plane);
}

Record MillingSite::rapid_to_centre(ClauseId clause, AxisSet which) const {
  Record record = motion(RecordKind::rapid, clause);
  record.axes = which;
  record.to = centre;
  return record;
}

Record MillingSite::feed_to(ClauseId clause, const std::array<Number, 2>& to) const {
  Record record = motion(RecordKind::feed, clause);
  record.axes = {axes.p, axes.q};
  record.to[axes.p] = to[0];
  record.to[axes.q] = to[1];
  return record;
}

Record MillingSite::arc_to(ClauseId clause, const std::array<Number, 2>& to,
                           const std::array<Number, 2>& middle, std::int32_t rot) const {
  Record record = feed_to(clause, to);
  record.kind = RecordKind::arc;
  record.centre = middle;
  record.rot = rot;
  return record;
}

bool names_site(const BlockContext& block) {
  const PlaneAxes axes = axes_of(block.machine.plane);
  if (!block.words.has_axis_word(axes.d)) return false;
  if (block.words.has_axis_word(axes.p) && block.words.has_axis_word(axes.q)) return true;
  return block.readings.is("gsk.missing-axis=current"_reading);
}

MillingSite place_site(BlockContext& block, const Number& r, bool depth_from_initial) {
  const Machine& machine = block.machine;
  MillingSite site;
  site.block = block.line;
  site.plane = machine.plane;
  site.axes = axes_of(machine.plane);
  // GSK-G110-01: the centre; GSK-G110-06: and every commanded axis but d.
  site.positioned = positioned_axes(block, site.axes, site.centre);
  site.initial_plane = machine.milling.initial_plane;
  site.r_plane = site.initial_plane + r;
  site.feed = machine.feed;
  site.feed_mode = machine.feed_mode;
  // GSK-G110-18: as the depth axis X is a diameter as everywhere.
  const bool diameter = site.axes.d != Axis::x || block.readings.is("gsk.x-depth=diameter"_reading);
  const AxisWord depth = block.words.axis_word(site.axes.d, diameter).value();
  if (depth.incremental) {
    site.travel = depth_from_initial ? depth.value - r : depth.value;
    site.bottom = site.r_plane + site.travel;
  } else {
    site.bottom = depth.value;
    site.travel = site.bottom - site.r_plane;
  }
  return site;
}

Number r_of_pocket(const BlockContext& block) {
  const bool modal = block.readings.is("gsk.pocket.R=modal"_reading);
  const std::optional<Number> r =
      modal ? block.machine.milling.retained_r : block.words.length('R');
  return r.value_or(0);
}

void position_only(BlockContext& block) {
  Position to;
  const AxisSet moved = positioned_axes(block, axes_of(block.machine.plane), to);
  if (moved.empty() || !block.readings.is("gsk.missing-axis=position"_reading)) return;
  Record record = block.motion(RecordKind::rapid, "GSK-G110-14"_clause, {});
  record.axes = moved;
  record.to = to;
  block.machine.position = to;
  block.put(std::move(record));
}

void name_planes(const BlockContext& block, const MillingSite& site) {
  block.out.name_plane("R plane", site.axes.d, site.r_plane);
  block.out.name_plane("initial plane", site.axes.d, site.initial_plane);
  block.out.name_axis('d', site.axes.d);
}

void check_direction(BlockContext& block, const MillingSite& site, ClauseId clause) {
  const Number r = site.r_plane - site.initial_plane;
  if (decided(clause, "R * depth", r.sign() * site.travel.sign()) >= 0) return;
  block.alarm(
      AlarmClass::direction_conflict, clause, 'R',
      with_values(
          "R leads by {} mm from where the tool stands, and the bottom lies the other way, {} mm "
          "from R.",
          {r, site.travel}));
}

void check_depth(BlockContext& block, const MillingSite& site) {
  if (decided("GSK-G110-17"_clause, "depth", site.travel) != 0) {
    block.need_feed();
  } else if (block.readings.is("gsk.zero-depth=alarm"_reading)) {
    block.alarm(AlarmClass::value_out_of_range, "GSK-G110-17"_clause,
                addresses_of(site.axes.d).absolute,
                with_values("R and the bottom are both {} mm: there is no depth to be milled.",
                            {site.r_plane}));
  }
}

void check_needed(BlockContext& block, std::span<const NeededWord> words, bool mills,
                  ClauseId missing, ClauseId positive) {
  for (const NeededWord& word : words) {
    if (!word.value) {
      block.missing(missing, word.address);
      continue;
    }
    // GSK-G110-19: a radius of the tool of zero is in the range of the table.
    const bool is_bare_tool =
        word.address == 'D' && block.machine.milling.family() != CycleFamily::thread;
    const ClauseId clause = is_bare_tool ? "GSK-G110-19"_clause : word.positive.value_or(positive);
    if (mills && !is_above_zero(block, word, clause)) {
      const bool here = block.words.has(word.address);
      block.alarm(AlarmClass::value_out_of_range, clause, word.address,
                  with_values(fmt::format("{}{} is {{}} and not above zero.",
                                          here ? "" : "The retained ", word.address),
                              {*word.value}));
    }
  }
}

void check_tool_radius(BlockContext& block, ClauseId clause) {
  const MillingMode& mode = block.machine.milling;
  if (!mode.radius || !mode.tool) return;
  if (decided(clause, "I - D", *mode.radius, *mode.tool) > 0) return;
  block.alarm(AlarmClass::tool_too_large, clause, 'I',
              with_values("The pocket's radius of {} mm is not larger than the tool's of {} mm.",
                          {*mode.radius, *mode.tool}));
}

void carry_milling(const BlockContext& block) {
  Machine& machine = block.machine;
  const auto lengths = machine.milling.lengths();
  const auto is_given = [](const std::optional<Number>* word) { return word->has_value(); };
  if (block.entered_cycle || std::ranges::none_of(lengths, is_given)) return;
  if (block.readings.is("gsk.pocket.retained=length"_reading)) return;
  const Number factor = machine.units == Units::inch ? inches(1) : Number(1) / inches(1);
  for (std::optional<Number>* word : lengths) {
    if (*word) *word = **word * factor;
  }
}

void latch_pocket_words(BlockContext& block) {
  MillingMode& mode = block.machine.milling;
  if (block.changed_pair && block.readings.is("gsk.pocket.pair=each"_reading)) {
    mode.radius = mode.step = mode.turns = mode.infeed = mode.tool = std::nullopt;
  }
  const BlockWords& words = block.words;
  if (auto value = words.length('I')) mode.radius = value;
  if (auto value = words.length('D')) mode.tool = value;
  if (auto value = words.length('R')) mode.retained_r = value;
  if (mode.family() == CycleFamily::helix) {
    if (words.has('L')) mode.turns = words.written('L');
    return;
  }
  if (auto value = words.length('L')) mode.step = value;
  if (auto value = words.length('Q')) mode.infeed = value;
  if (auto value = words.length('P')) mode.retained_clearance = value;
}

bool is_entry(const BlockContext& block) {
  return block.entered_cycle ||
         (block.changed_pair && block.readings.is("gsk.pocket.pair=each"_reading));
}

}  // namespace gonogo::reference::gsk988ta
