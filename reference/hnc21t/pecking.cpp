// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hnc21t/pecking.hpp"

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>

namespace gonogo::reference::hnc21t {
namespace {

bool is_positive(const std::optional<ScaledLength>& word) {
  return word && word->value.sign() > 0;
}

// With more a judge would look too long for the first peck that can be seen.
constexpr std::int64_t kMostPecks = 1'000'000'000;

// e and dK as true lengths.
struct PeckLengths {
  Number withdrawal;
  Number step;
};

PeckLengths halved(const ScaledLength& e, const ScaledLength& step) {
  return {e.diameter ? e.value / 2 : e.value, step.diameter ? step.value / 2 : step.value};
}

// HNC-G75-01: along X radii, or diameters as a reading says. `depth`: what a peck of at least that
// depth reaches in one, however it is meant.
PeckLengths lengths_of(const BlockContext& block, Axis axis, const Number& depth) {
  const CommandWords& command = block.machine.command;
  const ScaledLength e = command.r.value_or(ScaledLength{});
  const ScaledLength& step = *command.q;
  const PeckLengths as_diameters = halved(e, step);
  const bool matters =
      axis == Axis::x && (e.diameter || step.diameter) && as_diameters.step < depth;
  if (matters && block.readings.is("hnc.g75.depth-scale=diameter"_reading)) {
    return as_diameters;
  }
  return {e.value, step.value};
}

// Where the depth of a peck counts from; matters only where the second peck does not end at the
// bottom both ways.
bool counts_from_withdrawn(const BlockContext& block, const Plunge& plunge, const Number& depth) {
  if (depth <= plunge.step * 2 - plunge.withdrawal) return false;
  return block.readings.is("hnc.peck.from=withdrawn"_reading);
}

void limit_pecks(BlockContext& block, const Plunge& plunge) {
  if (plunge.pecks <= Number(kMostPecks) || !block.out.alarms.empty()) return;
  block.not_covered(plunge.axis == Axis::z ? 74 : 75, 'Q',
                    "The gauge follows up to 1,000,000,000 pecks: the word Q asks for more.");
}

// Pecks and withdrawals to the depth.
void plan_pecks(BlockContext& block, Plunge& plunge, const PlungeClauses& clauses) {
  const Number depth = abs(plunge.bottom - plunge.top);
  const PeckLengths lengths = lengths_of(block, plunge.axis, depth);
  plunge.clause = clauses.pecks;
  plunge.step = lengths.step;
  plunge.withdrawal = lengths.withdrawal;
  if (decided(clauses.pecks, "depth - Q", depth, plunge.step) <= 0)
    return;  // one peck, and no withdrawal
  plunge.pecks = (depth / plunge.step).ceil();
  plunge.from_withdrawn = counts_from_withdrawn(block, plunge, depth);
  if (plunge.from_withdrawn) {
    const Number gain = plunge.step - plunge.withdrawal;
    if (decided(clauses.pecks, "Q - R", gain) <= 0) {
      block.alarm(AlarmClass::value_out_of_range, clauses.pecks, 'R',
                  with_values("Withdrawals of {} mm between pecks of {} mm never reach the bottom.",
                              {plunge.withdrawal, plunge.step}));
      return;
    }
    plunge.pecks = ((depth - plunge.withdrawal) / gain).ceil();
  }
  // HNC-G74-04: the first withdrawal is the one that may pass A.
  plunge.clamped = decided("HNC-G74-04"_clause, "R - Q", plunge.withdrawal, plunge.step) > 0 &&
                   block.readings.is("hnc.peck.clamp=start"_reading);
  plunge.withdraws_at_feed = block.readings.is("hnc.peck.withdraw=feed"_reading);
  limit_pecks(block, plunge);
}

// Whether the block may go the third way: of G75 the text has it for a groove with a width, of G74
// it has its number alone.
bool goes_third_way(const BlockContext& block, Axis axis) {
  if (!is_positive(block.machine.command.q)) return false;
  if (axis == Axis::z) return block.readings.is("hnc.g74.mode3=on"_reading);
  return block.words.has(kZ) && block.readings.is("hnc.g75.mode3=on"_reading);
}

// A traverse to X, or Z of a hole, and dK further at the feed.
void plan_approach(BlockContext& block, Plunge& plunge, const PlungeClauses& clauses) {
  if (!goes_third_way(block, plunge.axis)) return;
  const bool along_x = plunge.axis == Axis::x;
  if (plunge.direction == 0) {
    block.alarm(
        AlarmClass::direction_conflict, clauses.straight, addresses_of(plunge.axis).absolute,
        with_values(along_x ? "X is where the tool stands, at the radius {} mm: there is no "
                              "direction to plunge in."
                            : "Z is where the tool stands, at {} mm: there is no direction to "
                              "drill in.",
                    {plunge.bottom}));
    return;
  }
  const CommandWords& command = block.machine.command;
  const bool halves =
      along_x && command.q->diameter && block.readings.is("hnc.g75.depth-scale=diameter"_reading);
  const Number step = halves ? command.q->value / 2 : command.q->value;
  plunge.approach = plunge.bottom;
  plunge.bottom += step * plunge.direction;
}

void check_sign(BlockContext& block, ClauseId clause, char address, int least, const char* what) {
  if (!block.words.has(address)) return;
  if (decided(clause, {&address, 1}, block.words.written(address)) >= least) return;
  block.alarm(AlarmClass::value_sign, clause, address,
              fmt::format("{} is not a valid {}.", text_of(*block.words.word(address)), what));
}

}  // namespace

Number Plunge::depth_of_peck(const Number& k) const {
  return from_withdrawn ? k * step - (k - 1) * withdrawal : k * step;
}

Number Plunge::end_of_peck(const Number& k) const {
  return top + depth_of_peck(k) * direction;
}

Number Plunge::withdrawn_after(const Number& k) const {
  const Number depth = depth_of_peck(k) - withdrawal;
  return top + (clamped ? max(depth, 0) : depth) * direction;
}

void check_peck_words(BlockContext& block, ClauseId clause) {
  check_sign(block, clause, 'R', 0, "withdrawal");
  check_sign(block, clause, 'Q', 1, "depth of a peck");
}

Plunge plan_plunge(BlockContext& block, Axis axis, const Number& bottom,
                   const PlungeClauses& clauses) {
  const Number& top = block.machine.position[axis];
  Plunge plunge{.motions = CycleMotions(block),
                .clause = clauses.straight,
                .axis = axis,
                .top = top,
                .bottom = bottom,
                .direction = (bottom - top).sign(),
                .pecks = 1,
                .step = {},
                .withdrawal = {},
                .approach = {}};
  const CommandWords& command = block.machine.command;
  if (!is_positive(command.r)) {
    plan_approach(block, plunge, clauses);
  } else if (!command.q) {
    block.missing("HNC-G74-05"_clause, 'Q');
  } else if (is_positive(command.q)) {
    plan_pecks(block, plunge, clauses);
  }
  return plunge;
}

Generator<Item> run_plunge(Plunge plunge) {
  const CycleMotions& motions = plunge.motions;
  if (plunge.approach) co_yield motions.rapid(plunge.clause, plunge.axis, *plunge.approach);
  for (Number k = 1; k < plunge.pecks; k += 1) {
    co_yield motions.feed(plunge.clause, plunge.axis, plunge.end_of_peck(k));
    Record withdrawal = plunge.withdraws_at_feed
                            ? motions.feed(plunge.clause, plunge.axis, plunge.withdrawn_after(k))
                            : motions.rapid(plunge.clause, plunge.axis, plunge.withdrawn_after(k));
    co_yield withdrawal;
  }
  co_yield motions.feed(plunge.clause, plunge.axis, plunge.bottom);
  co_yield motions.rapid(plunge.clause, plunge.axis, plunge.top);
}

}  // namespace gonogo::reference::hnc21t
