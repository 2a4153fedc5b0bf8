// SPDX-License-Identifier: GPL-3.0-or-later
//
// G75, grooving of the inner and outer diameter: from A, where the tool stands, along X to the
// bottom of the groove and out; with a width, again at each step along Z.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/hnc21t/pecking.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::hnc21t {
namespace {

// The plunges of one block; mm as true lengths.
struct Groove {
  Plunge plunge;
  Number start;      // Z of A
  Number width;      // signed
  Number plunges;    // how many
  Number intervals;  // that the width is divided into; 0: the one plunge is at its far end
  bool wide = false;
  bool returns = true;  // to A, after the last plunge

  // HNC-G75-04: the exact quotient, also where it does not terminate.
  Number place(const Number& n) const {
    if (!wide) return start;
    return intervals.sign() == 0 ? start + width : start + width * n / intervals;
  }
};

bool is_positive_whole(const Number& value) {
  return value.sign() > 0 && value == value.floor();
}

bool has_bad_count(const BlockContext& block, char address) {
  return block.words.has(address) && !is_positive_whole(block.words.written(address));
}

bool counted_by_p(const BlockContext& block) {
  return block.readings.is("hnc.g75.i=P"_reading);
}

// The number of steps is a positive whole one, in every block that writes it.
void check_count(BlockContext& block) {
  const bool bad_i = has_bad_count(block, 'I');
  const bool bad_p = has_bad_count(block, 'P');
  if (!bad_i && !bad_p) return;
  const char address = counted_by_p(block) ? 'P' : 'I';
  if (address == 'I' ? !bad_i : !bad_p) return;
  block.alarm(
      AlarmClass::not_an_integer, "HNC-G75-04"_clause, address,
      fmt::format("{} is no positive whole number of steps.", text_of(*block.words.word(address))));
}

// HNC-G75-04, HNC-G75-05: the number of steps of a block with a width; nothing for a single groove.
std::optional<Number> steps_of(BlockContext& block) {
  const CommandWords& command = block.machine.command;
  const bool wide = block.words.has(kZ);
  // The reading matters where the two addresses say different things.
  const bool differ = wide ? command.i != command.p : block.words.has('I') != block.words.has('P');
  const char address = differ && counted_by_p(block) ? 'P' : 'I';
  const std::optional<Number>& count = address == 'P' ? command.p : command.i;
  if (wide && !count) {
    block.missing("HNC-G75-06"_clause, address);
  } else if (!wide && block.words.has(address)) {
    block.missing("HNC-G75-06"_clause, 'Z');
  }
  return wide ? count : std::nullopt;
}

Generator<Item> run_groove(Groove groove) {
  const CycleMotions& motions = groove.plunge.motions;
  for (Number n = 0; n < groove.plunges; n += 1) {
    if (n.sign() > 0 || groove.place(n) != groove.start) {
      co_yield motions.rapid("HNC-G75-04"_clause, Axis::z, groove.place(n));
    }
    Generator<Item> plunge = run_plunge(groove.plunge);
    while (const Item* item = plunge.next()) co_yield *item;
  }
  if (groove.wide && groove.returns) {
    co_yield motions.rapid("HNC-G75-04"_clause, Axis::z, groove.start);
  }
}

// The places along Z of a groove with a width.
void widen(BlockContext& block, Groove& groove, const Number& steps) {
  groove.wide = true;
  groove.width = block.commanded(kZ).value() - groove.start;
  const bool as_many = block.readings.is("hnc.g75.steps=i"_reading);
  groove.plunges = as_many ? steps : steps + 1;
  groove.intervals = groove.plunges - 1;
  if (groove.width.sign() == 0) {
    const bool may_be_one = groove.plunges > Number(1);
    if (may_be_one && block.readings.is("hnc.g75.zero-width=once"_reading)) groove.plunges = 1;
    return;
  }
  groove.returns = block.readings.is("hnc.g75.end=start"_reading);
  if (!groove.returns) block.machine.position[Axis::z] = groove.start + groove.width;
}

}  // namespace

void run_g75(BlockContext& block) {
  // HNC-G75-02, HNC-G75-03: pecks with withdrawals, or one plunge.
  constexpr PlungeClauses kClauses{"HNC-G75-02"_clause, "HNC-G75-03"_clause};
  check_peck_words(block, "HNC-G75-01"_clause);
  check_count(block);
  if (does_nothing(block, std::array{kX})) return;
  const Position a = block.machine.position;
  const std::optional<Number> bottom = cycle_end_point(block, kX);
  block.need_feed();
  const std::optional<Number> steps = steps_of(block);
  Groove groove{.plunge = plan_plunge(block, Axis::x, bottom.value_or(a[Axis::x]), kClauses),
                .start = a[Axis::z],
                .width = {},
                .plunges = 1,
                .intervals = {}};
  if (!block.out.alarms.empty() || block.out.not_covered) return;
  if (steps) widen(block, groove, *steps);
  block.out.cycle = run_groove(std::move(groove));
}

}  // namespace gonogo::reference::hnc21t
