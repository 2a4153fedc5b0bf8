// SPDX-License-Identifier: GPL-3.0-or-later
//
// G82, the thread cutting cycle: straight and taper, with a run-out, with several starts. From A,
// where the tool stands, to B, along the thread to C, out and back. HNC-G82-10: feed hold and the
// acceleration constant Q change nothing in the path; older controls lack the word.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/hnc21t/cycle.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::hnc21t {
namespace {

// HNC-G82-05, HNC-G82-10
void check_constant(BlockContext& block) {
  const BlockWords& words = block.words;
  if (!words.has('Q')) return;
  if (block.readings.is("hnc.g82.q=alarm"_reading)) {
    block.alarm(AlarmClass::undefined_code, "HNC-G82-10"_clause, 'Q',
                "A control before the versions 7.11 and 4.03 has no word Q of G82.");
  } else if (decided("HNC-G82-05"_clause, "Q", words.written('Q')) < 0) {
    block.alarm(AlarmClass::value_sign, "HNC-G82-05"_clause, 'Q',
                with_values("The acceleration constant Q of the run-out, {}, is negative.",
                            {words.written('Q')}));
  }
}

// HNC-G82-05, HNC-G82-06: Q and the number of starts, in every block that writes them.
void check_thread_words(BlockContext& block) {
  const BlockWords& words = block.words;
  check_constant(block);
  if (!words.has('C')) return;
  const Number starts = words.written('C');
  if (decided("HNC-G82-06"_clause, "C", starts) < 0) {
    block.alarm(AlarmClass::value_sign, "HNC-G82-06"_clause, 'C',
                with_values("The number of starts, {}, is negative.", {starts}));
  }
  if (starts != starts.floor()) {
    block.alarm(AlarmClass::not_an_integer, "HNC-G82-06"_clause, 'C',
                fmt::format("{} is no whole number of starts.", text_of(*words.word('C'))));
  }
}

// HNC-G82-02: the run-out, signed true lengths.
struct RunOut {
  Number along_x;
  Number along_z;
  bool any() const { return along_x.sign() != 0 || along_z.sign() != 0; }
};

// HNC-G82-02: E is a radius value, or a diameter as a reading says.
RunOut run_out_of(const BlockContext& block) {
  const CommandWords& command = block.machine.command;
  RunOut run_out;
  if (command.r) run_out.along_z = command.r->value;
  if (command.e) run_out.along_x = command.e->value;
  if (command.r && run_out.along_x.sign() != 0 && command.e->diameter &&
      block.readings.is("hnc.g82.e-scale=diameter"_reading)) {
    run_out.along_x = run_out.along_x / 2;
  }
  return run_out;
}

// HNC-G82-03: both or neither; one that is zero is as good as none.
void check_pair(BlockContext& block, const RunOut& run_out) {
  const CommandWords& command = block.machine.command;
  if (!run_out.any() || command.r.has_value() == command.e.has_value()) return;
  block.alarm(AlarmClass::retract_pair, "HNC-G82-03"_clause, command.r ? 'R' : 'E',
              "A run-out needs both R and E.");
}

// HNC-G82-12: a word whose partner is in force from an earlier block, or one of zero without a
// partner.
void note_lone_words(const BlockContext& block) {
  const BlockWords& words = block.words;
  const CommandWords& command = block.machine.command;
  const bool has_both = command.r && command.e;
  const bool has_one = !has_both && (command.r || command.e);
  const bool is_run_out = has_one || (has_both && words.has('R') != words.has('E'));
  const bool counts = command.c.value_or(0) > Number(1) && words.has('C') && !words.has('P');
  if (is_run_out || (counts && command.p)) block.out.accept("HNC-G82-12"_clause);
}

// HNC-G82-13: whether the other axis is the long one of some travels, to C from A or from B, X as a
// radius or as a diameter.
bool is_long_otherwise(const BlockContext& block, const Number& travel_z, const EndPoint& c,
                       bool long_z) {
  const Number from_b = abs(block.machine.command.i.value_or(0));
  const Number from_a = abs(c.x - block.machine.position[Axis::x]);
  if (!long_z) return min(from_a, from_b) <= travel_z;
  return max(from_a, from_b) * (block.words.modes().diameter ? 2 : 1) >= travel_z;
}

// HNC-G82-04, HNC-G82-13: short axis over long axis, at most 20. The long axis is that of the
// longer travel from B to C; of equal travels it is Z.
void check_ratio(BlockContext& block, const RunOut& run_out, const EndPoint& c) {
  const CommandWords& command = block.machine.command;
  if (!command.r || !command.e) return;
  const Number travel_x = abs(command.i.value_or(0));
  const Number travel_z = abs(c.z - block.machine.position[Axis::z]);
  const Number x = abs(run_out.along_x);
  const Number z = abs(run_out.along_z);
  const bool long_z =
      decided("HNC-G82-13"_clause, "abs(travel Z) - abs(travel X)", travel_z, travel_x) >= 0;
  const Number& across = long_z ? x : z;
  const Number& along = long_z ? z : x;
  if (decided("HNC-G82-04"_clause, "short - 20 long", across, along * 20) <= 0) {
    const bool is_disputed = along > across * 20 && is_long_otherwise(block, travel_z, c, long_z);
    if (is_disputed) block.out.accept("HNC-G82-13"_clause);
    return;
  }
  block.alarm(
      AlarmClass::retract_ratio, "HNC-G82-04"_clause, block.words.has('E') ? 'E' : 'R',
      with_values(long_z
                      ? "The run-out of {} mm along X is more than 20 times that of {} mm along Z."
                      : "The run-out of {} mm along Z is more than 20 times that of {} mm along X.",
                  {across, along}));
}

// HNC-G82-06: how many passes, at least 1; several need P (HNC-G82-11).
Number passes_of(BlockContext& block) {
  const CommandWords& command = block.machine.command;
  const Number starts = command.c.value_or(0);
  if (decided("HNC-G82-06"_clause, "C - 1", starts, 1) <= 0 || starts != starts.floor()) return 1;
  if (!command.p) {
    block.missing("HNC-G82-11"_clause, 'P');
    return 1;
  }
  return block.readings.is("hnc.g82.starts=all"_reading) ? starts : Number(1);
}

// HNC-G82-06, HNC-G82-09: the angle of pass k, in [0, 360). A thread with a single start begins at
// P, one with several at 0.
Number start_angle(const CommandWords& command, const Number& k) {
  const bool several = command.c.value_or(0) > Number(1);
  const Number angle = command.p.value_or(0) * (several ? k : Number(1));
  return angle - (angle / 360).floor() * 360;
}

struct ThreadPath {
  CycleMotions motions;
  CommandWords command;
  Number a_x, a_z;
  EndPoint c;
  RunOut run_out;
  Number passes;
  Number lead;
  bool exits_as_thread = false;
  bool last_first = false;  // hnc.g82.order = falling

  Record thread(ClauseId clause, const Number& x, const Number& z, const Number& start) const {
    Record record;
    record.kind = RecordKind::thread;
    record.block = motions.block;
    record.clause = clause;
    record.axes = {Axis::x, Axis::z};
    record.to[Axis::x] = x;
    record.to[Axis::z] = z;
    record.lead = lead;
    record.start = start;
    return record;
  }
};

// HNC-G82-01
Generator<Item> cut_thread(ThreadPath path) {
  const ClauseId clause = "HNC-G82-01"_clause;
  const EndPoint& c = path.c;
  const Number i = path.command.i.value_or(0);
  const Number out_x = c.x + path.run_out.along_x;
  const Number out_z = c.z + path.run_out.along_z;
  for (Number k = 0; k < path.passes; k += 1) {
    const Number start = start_angle(path.command, path.last_first ? path.passes - 1 - k : k);
    co_yield path.motions.rapid(clause, Axis::x, c.x + i);
    co_yield path.thread(clause, c.x, c.z, start);
    if (path.run_out.any()) co_yield path.thread("HNC-G82-02"_clause, out_x, out_z, start);
    if (path.exits_as_thread) {
      co_yield path.thread(clause, path.a_x, out_z, start);
    } else {
      co_yield path.motions.rapid(clause, Axis::x, path.a_x);
    }
    co_yield path.motions.rapid(clause, Axis::z, path.a_z);
  }
}

}  // namespace

void run_g82(BlockContext& block) {
  check_thread_words(block);
  if (does_nothing(block, kAxisAddresses)) return;
  const std::optional<EndPoint> c = cycle_end_point(block);
  const CommandWords& command = block.machine.command;
  if (!command.lead) {
    block.alarm(AlarmClass::lead_missing, "HNC-G82-07"_clause, 'F',
                "The block cuts a thread, but no lead is in force.");
  }
  const RunOut run_out = run_out_of(block);
  check_pair(block, run_out);
  note_lone_words(block);
  if (c) check_ratio(block, run_out, *c);
  const Number passes = passes_of(block);
  if (!block.out.alarms.empty()) return;

  const Position& a = block.machine.position;
  block.name_corners(Axis::x, Axis::z, command.i.value_or(0), c->over(a));
  const bool falls = passes > Number(1) && block.readings.is("hnc.g82.order=falling"_reading);
  block.out.cycle = cut_thread({.motions = CycleMotions(block),
                                .command = command,
                                .a_x = a[Axis::x],
                                .a_z = a[Axis::z],
                                .c = *c,
                                .run_out = run_out,
                                .passes = passes,
                                .lead = block.lead(),
                                .exits_as_thread = block.readings.is("hnc.g82.exit=feed"_reading),
                                .last_first = falls});
}

}  // namespace gonogo::reference::hnc21t
