// SPDX-License-Identifier: GPL-3.0-or-later
//
// HNC-COM-01 without arcs: G00, G01, G04, G32, G92, and the work offsets.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/hnc21t/machine.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::hnc21t {
namespace {

// HNC-MOD-04: whether F of a thread, and F of a cycle, is the ordinary feed matters only where it
// differs.
const std::optional<Number>& feed_in_force(const BlockContext& block) {
  const Machine& machine = block.machine;
  const auto own_of = [&](const FeedWords& words) -> const std::optional<Number>& {
    return is_cycle(machine.motion) ? machine.command.feed : words.plain;
  };
  const FeedWords* words = &machine.feeds;
  const FeedWords& any_f = machine.any_f;
  const bool differ = words->latest != any_f.latest || own_of(*words) != own_of(any_f);
  if (differ && block.readings.is("hnc.g32.lead=feed"_reading)) words = &any_f;
  const std::optional<Number>& own = own_of(*words);
  return own == words->latest || block.readings.is("hnc.modal.f=feed"_reading) ? words->latest
                                                                               : own;
}

// HNC-MOD-04: the lead of a G32 that has none of its own: that of the last one, or F, which is one
// word, as a lead.
std::optional<Lead> earlier_lead(const BlockContext& block) {
  using enum Lead::Kind;
  const Machine& machine = block.machine;
  if (machine.line_lead && block.readings.is("hnc.g32.lead=kept"_reading)) {
    return machine.line_lead;
  }
  if (!machine.any_f.latest || !block.readings.is("hnc.g32.lead=feed"_reading)) return std::nullopt;
  const std::optional<Number>& feed = feed_in_force(block);
  if (!feed || feed->sign() <= 0) return std::nullopt;
  return machine.modes.inch ? Lead{*feed / inches(1), f_under_g20} : Lead{*feed, millimetres};
}

}  // namespace

void BlockContext::need_feed() {
  const std::optional<Number>& feed = feed_in_force(*this);
  machine.feed = feed.value_or(0);
  BlockBase::need_feed(feed ? "HNC-COM-04"_clause : "HNC-COM-01"_clause);
}

Number BlockContext::offset(Axis axis) const {
  if (machine.offset >= 0) return machine.offsets[static_cast<std::size_t>(machine.offset)][axis];
  const Number& first = machine.offsets.front()[axis];
  if (first.sign() == 0) return 0;
  return readings.is("hnc.offset.initial=G54"_reading) ? first : Number(0);
}

std::optional<Number> BlockContext::commanded(const AxisAddresses& axis) const {
  const std::optional<AxisWord> word = words.axis_word(axis);
  if (!word) return std::nullopt;
  return word->value + (word->incremental ? state.position[axis.axis] : offset(axis.axis));
}

// HNC-G82-07: J is an inch lead, or as a reading says so many threads to the inch.
Number BlockContext::lead() const {
  const Lead& lead = machine.command.lead.value();
  switch (lead.kind) {
    case Lead::Kind::millimetres:
      break;
    case Lead::Kind::f_under_g20:
      return readings.is("hnc.lead.unit=units"_reading) ||
                     readings.is("hnc.lead.unit=units-tpi"_reading)
                 ? inches(lead.value)
                 : lead.value;
    case Lead::Kind::j:
      if (lead.value.sign() <= 0) break;  // an alarm of its block
      return readings.is("hnc.lead.unit=tpi"_reading) ||
                     readings.is("hnc.lead.unit=units-tpi"_reading)
                 ? inches(1) / lead.value
                 : inches(lead.value);
  }
  return lead.value;
}

AxisSet commanded_end_point(const BlockContext& block, Position& to) {
  AxisSet axes;
  to = block.machine.position;
  for (const AxisAddresses& addresses : kAxisAddresses) {
    std::optional<Number> end = block.commanded(addresses);
    if (!end) continue;
    axes.add(addresses.axis);
    to[addresses.axis] = *std::move(end);
  }
  return axes;
}

void run_positioning(BlockContext& block) {
  Position to;
  const AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return;
  block.put(block.motion_to(RecordKind::rapid, "HNC-COM-01"_clause, axes, to));
}

void run_straight_feed(BlockContext& block) {
  Position to;
  const AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return;
  block.need_feed();
  block.put(block.motion_to(RecordKind::feed, "HNC-COM-01"_clause, axes, to));
}

// G32: one thread pass, straight or taper. Its run-out and its starts are not in the text.
void run_thread(BlockContext& block) {
  for (char address : {'R', 'E', 'P', 'C', 'Q', 'K', 'I'}) {
    if (!block.words.has(address) || block.words.written(address).sign() == 0) continue;
    block.not_covered(
        32, address,
        fmt::format("G32 with the word {} (a run-out, a start angle or several starts) is a form "
                    "of the code that the gauge does not read.",
                    address));
    return;
  }
  Position to;
  const AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return;
  std::optional<Lead>& lead = block.machine.command.lead;
  if (!lead) lead = earlier_lead(block);
  if (!lead) {
    block.alarm(AlarmClass::lead_missing, "HNC-MOD-04"_clause, 'F',
                "The block cuts a thread, but no lead is in force.");
    return;
  }
  Record thread = block.motion_to(RecordKind::thread, "HNC-COM-01"_clause, axes, to);
  thread.lead = block.lead();
  block.put(std::move(thread));
}

// G04: in which unit P is, is open.
void run_dwell(BlockContext& block) {
  if (!block.words.has('P')) {
    block.missing("HNC-COM-04"_clause, 'P');
    return;
  }
  Record record;
  record.kind = RecordKind::dwell;
  record.block = block.line;
  record.clause = "HNC-COM-01"_clause;
  const Number& written = block.words.written('P');
  const int sign = decided("HNC-COM-04"_clause, "P", written);
  if (sign < 0) {
    block.alarm(AlarmClass::value_sign, "HNC-COM-04"_clause, 'P',
                with_values("The dwell P{} is negative.", {written}));
  }
  const bool in_milliseconds = sign <= 0 || block.readings.is("hnc.dwell.unit=ms"_reading);
  record.seconds = in_milliseconds ? written / 1000 : written;
  block.put(std::move(record));
}

// G92: the position gets new work coordinates; X and Z are absolute, under G91 too.
void run_rename_position(BlockContext& block) {
  Position to = block.machine.position;
  for (const AxisAddresses& addresses : kAxisAddresses) {
    const std::optional<AxisWord> word = block.words.axis_word(addresses);
    if (!word) continue;
    const Axis axis = addresses.axis;
    const bool absolute = block.words.has(addresses.absolute);
    to[axis] = word->value + (absolute ? block.offset(axis) : to[axis]);
  }
  block.rename(to);
}

}  // namespace gonogo::reference::hnc21t
