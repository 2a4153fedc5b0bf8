// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hnc21t/cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::hnc21t {

bool CommandWords::complete_from(const CommandWords& earlier) {
  bool lacks_any = false;
  const auto complete = [&](auto& word, const auto& before) {
    if (word || !before) return;
    word = before;
    lacks_any = true;
  };
  complete(i, earlier.i);
  complete(k, earlier.k);
  complete(c, earlier.c);
  complete(p, earlier.p);
  complete(r, earlier.r);
  complete(e, earlier.e);
  complete(q, earlier.q);
  complete(lead, earlier.lead);
  return lacks_any;
}

void CommandWords::scale_lengths(const Number& factor, bool counts) {
  if (i && !counts) i = *i * factor;
  if (k) k = *k * factor;
  for (std::optional<ScaledLength>* word : {&r, &e, &q}) {
    if (*word) (*word)->value = (*word)->value * factor;
  }
}

void carry_lengths(Machine& machine, const ReadingsInUse& readings) {
  const bool counts = machine.motion == 75;
  const bool ended_counts = machine.ended == 75;
  const bool has_ended = machine.ended != 0 && machine.ended_words.has_lengths(ended_counts);
  if (!machine.command.has_lengths(counts) && !has_ended) return;
  if (readings.is("hnc.retained=length"_reading)) return;
  const Number factor = machine.modes.inch ? inches(1) : Number(1) / inches(1);
  machine.command.scale_lengths(factor, counts);
  machine.ended_words.scale_lengths(factor, ended_counts);
}

// HNC-MOD-05: whether words live on through a code outside the group is asked where they are used.
void change_command(Machine& machine, int motion) {
  if (is_cycle(machine.motion) && !is_cycle(motion)) {
    if (machine.ended != 0) machine.command.complete_from(machine.ended_words);
    machine.ended = machine.motion;
    machine.ended_words = std::move(machine.command);
  } else if (is_cycle(motion) && (is_cycle(machine.motion) || machine.ended != motion)) {
    machine.ended = 0;
  }
  machine.motion = motion;
  machine.command = {};
}

namespace {

// HNC-MOD-05: the block cuts with the words of the same cycle before another motion code, or
// without them.
void take_ended_words(BlockContext& block) {
  Machine& machine = block.machine;
  if (machine.ended == 0 || !block.words.has_axis_word()) return;
  machine.ended = 0;
  CommandWords completed = machine.command;
  if (!completed.complete_from(machine.ended_words)) return;
  if (block.readings.is("hnc.modal.words=kept"_reading)) machine.command = std::move(completed);
}

}  // namespace

void take_command_words(BlockContext& block) {
  const BlockWords& words = block.words;
  CommandWords& command = block.machine.command;
  auto take = [&](char address, std::optional<Number>& into) {
    if (words.has(address)) into = words.written(address);
  };
  auto take_scaled = [&](char address, std::optional<ScaledLength>& into) {
    if (auto value = words.length(address)) into = {*value, words.modes().diameter};
  };
  take('C', command.c);
  take('P', command.p);
  take_scaled('R', command.r);
  take_scaled('E', command.e);
  take_scaled('Q', command.q);
  if (auto k = words.length('K')) command.k = k;
  if (block.machine.motion == 75) {
    take('I', command.i);
  } else if (auto i = words.length('I')) {
    command.i = i;
  }
  take_ended_words(block);
}

namespace {

// HNC-MOD-01, HNC-MOD-05: whether the block has the code of its cycle, or a word that the cycles
// alone retain.
bool speaks_of_cycle(const BlockContext& block) {
  const auto has_word = [&](char address) { return block.words.has(address); };
  return block.codes.motion >= 0 || std::ranges::any_of(std::string_view("IKRECAPJQ"), has_word);
}

// hnc.empty-block: whether the cycle runs again, to the end that it had. A groove may have had a
// width, which no block retains.
bool runs_again(const BlockContext& block, std::span<const AxisAddresses> needed) {
  const auto is_known = [&](const AxisAddresses& axis) {
    return block.machine.command.end(axis.axis).has_value();
  };
  const bool has_own = speaks_of_cycle(block) || block.words.has('F');
  return block.machine.motion != 75 && has_own && std::ranges::all_of(needed, is_known) &&
         block.readings.is("hnc.empty-block=repeat"_reading);
}

// HNC-MOD-05. Other makers write some of these cycles in two lines, the first of them without an
// end.
void note_no_travel(const BlockContext& block) {
  if (speaks_of_cycle(block)) block.out.accept("HNC-MOD-05"_clause);
  if (block.codes.motion < 0 || block.words.block().words.size() < 2) return;
  block.out.warnings.push_back(
      {fmt::format("G{} without X and Z cuts nothing: its words hold on, and the cycle of this "
                   "control stands in one line with its end point.",
                   block.codes.motion),
       block.places.place_of('G').value_or(block.places.behind())});
}

}  // namespace

bool does_nothing(const BlockContext& block, std::span<const AxisAddresses> needed) {
  if (!block.words.has_axis_word()) {
    if (runs_again(block, needed)) return false;
    note_no_travel(block);
    return true;
  }
  const auto lacks = [&](const AxisAddresses& axis) { return !block.words.has(axis); };
  return std::ranges::any_of(needed, lacks) &&
         block.readings.is("hnc.missing-axis=nothing"_reading);
}

std::optional<Number> cycle_end_point(BlockContext& block, const AxisAddresses& axis) {
  std::optional<Number>& last = block.machine.command.end(axis.axis);
  if (auto word = block.commanded(axis)) {
    last = word;
  } else if (!block.words.has_axis_word()) {
    return last;  // hnc.empty-block = repeat
  } else if (block.readings.is("hnc.missing-axis=none"_reading)) {
    last = block.machine.position[axis.axis];
  } else if (!last || !block.readings.is("hnc.missing-axis=keep"_reading)) {
    block.missing("HNC-MOD-03"_clause, axis.absolute);
    return std::nullopt;
  }
  return last;
}

std::optional<EndPoint> cycle_end_point(BlockContext& block) {
  std::optional<Number> x = cycle_end_point(block, kX);
  std::optional<Number> z = cycle_end_point(block, kZ);
  if (!x || !z) return std::nullopt;
  return EndPoint{*std::move(x), *std::move(z)};
}

namespace {

Record along(RecordKind kind, std::uint64_t block, ClauseId clause, Axis axis, const Number& to) {
  Record record;
  record.kind = kind;
  record.block = block;
  record.clause = clause;
  record.axes.add(axis);
  record.to[axis] = to;
  return record;
}

}  // namespace

Record CycleMotions::rapid(ClauseId clause, Axis axis, const Number& to) const {
  return along(RecordKind::rapid, block, clause, axis, to);
}

Record CycleMotions::feed(ClauseId clause, Axis axis, const Number& to) const {
  Record record = along(RecordKind::feed, block, clause, axis, to);
  record.feed = feed_in_force;
  record.feed_mode = feed_mode;
  return record;
}

}  // namespace gonogo::reference::hnc21t
