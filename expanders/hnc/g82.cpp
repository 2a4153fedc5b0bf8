// SPDX-License-Identifier: GPL-3.0-or-later
// G82: threads with one or several starts, with and without run-out.
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {
namespace {

struct ThreadCycle {
  Fixed b = 0;
  CycleEnd end;
  Fixed lead = 0;
  Fixed run_out_x = 0;  ///< from C
  Fixed run_out_z = 0;
  Fixed passes = 1;
  Fixed first = 0;    ///< spindle angle of the first pass, degrees
  Fixed between = 0;  ///< from one pass to the next
};

constexpr int kHighestRatio = 20;

// To 0 .. 360 degrees.
Fixed within_circle(Wide angle) {
  const Wide rest = angle % kFullTurn;
  return static_cast<Fixed>(rest < 0 ? rest + kFullTurn : rest);
}

void take_words(Machine& machine, const Block& block) {
  CycleStore& store = machine.state.store;
  take_length(machine, block, 'I', store.taper);
  take_length(machine, block, 'R', store.run_out_z);
  take_length(machine, block, 'E', store.run_out_x);
  const bool by_reading =
      machine.follows("hnc.g82.e-scale=diameter"_reading) && machine.state.diameter;
  if (block.has('E') && by_reading != machine.has("run-out-diameter"_fault)) {
    store.run_out_x.value = static_cast<Fixed>(scaled(store.run_out_x.value, 1, 2));
  }
  take_number(block, 'C', store.starts);
  take_number(block, 'P', store.angle);
  // HNC-COM-01
  if (block.has('C') && store.starts.value < 0) machine.complain(AlarmKind::kValueSign, 'C', block);
  if (block.has_fraction('C')) machine.complain(AlarmKind::kNotAnInteger, 'C', block);
  if (!block.has('Q')) return;
  // HNC-G82-05; reading hnc.g82.q: a control before 7.11 lacks the word.
  if (machine.follows("hnc.g82.q=alarm"_reading)) {
    machine.complain(AlarmKind::kUndefinedCode, 'Q', block);
  } else if (block.number('Q').value < 0) {
    machine.complain(AlarmKind::kValueSign, 'Q', block);
  }
}

bool too_steep(const Machine& machine, Fixed across, Fixed along) {
  const Wide limit = static_cast<Wide>(magnitude(along)) * kHighestRatio;
  if (machine.has("ratio-equality-refused"_fault) && along != 0) return magnitude(across) >= limit;
  return magnitude(across) > limit;
}

// HNC-G82-03, HNC-G82-04.
void check_run_out(Machine& machine, const Block& block, Fixed travel_z) {
  const CycleStore& store = machine.state.store;
  const Retained& r = store.run_out_z;
  const Retained& e = store.run_out_x;
  if (r.present != e.present) {
    const Retained& alone = r.present ? r : e;
    if (alone.value != 0 && !machine.has("pair-unchecked"_fault)) {
      machine.complain(AlarmKind::kRetractPair, r.present ? 'R' : 'E', block);
    }
    return;
  }
  if (machine.has("ratio-unchecked"_fault)) return;
  // The long axis has the longer travel from B to C; Z when they are equal.
  const bool along_x = magnitude(store.taper.value) > magnitude(travel_z);
  const bool steep =
      along_x ? too_steep(machine, r.value, e.value) : too_steep(machine, e.value, r.value);
  if (!steep) return;
  const char word = along_x ? 'R' : 'E';
  machine.complain(AlarmKind::kRetractRatio, word, block);
  if (machine.has("late-alarm"_fault)) {
    machine.tracer.rapid_axis(GONOGO_X, target(machine, block, GONOGO_X) + store.taper.value);
  }
}

// HNC-G82-06, HNC-G82-09.
void prepare_starts(Machine& machine, ThreadCycle& cycle) {
  const CycleStore& store = machine.state.store;
  const Fixed starts = store.starts.value / kOne;
  if (starts <= 1) {
    cycle.first = within_circle(store.angle.value);
    return;
  }
  if (!store.angle.present) return machine.complain(AlarmKind::kMissingWord, 'P', kNowhere);
  if (machine.follows("hnc.g82.starts=one"_reading)) return;
  cycle.passes = machine.has("start-short"_fault) ? starts - 1 : starts;
  cycle.between = within_circle(store.angle.value);
  if (machine.has("starts-from-circle"_fault)) cycle.between = kFullTurn / starts;
  if (machine.has("starts-at-zero"_fault)) cycle.between = 0;
}

Fixed lead_in_force(const Machine& machine) {
  const State& state = machine.state;
  if (state.store.lead == 0 && machine.has("feed-serves-as-lead"_fault)) return state.feed;
  return state.store.lead;
}

// Thread from B to C and the run-out beyond it.
bool cut(Machine& machine, const ThreadCycle& cycle, Fixed start) {
  Fixed x = cycle.end.x;
  Fixed z = cycle.end.z;
  if (machine.has("run-out-before-end"_fault)) z -= cycle.run_out_z;
  Point to = machine.state.position;
  to[GONOGO_X] = x;
  to[GONOGO_Z] = z;
  if (!machine.tracer.thread(to, kBothAxes, cycle.lead, start)) return false;
  // HNC-G82-02; without a run-out there is no way to go.
  to[GONOGO_X] = x + cycle.run_out_x;
  to[GONOGO_Z] = z + (machine.has("run-out-sign"_fault) ? -cycle.run_out_z : cycle.run_out_z);
  return machine.tracer.thread(to, kBothAxes, cycle.lead, start);
}

// HNC-G82-01: from A and back to it.
bool pass(Machine& machine, const ThreadCycle& cycle, Fixed start) {
  Tracer& tracer = machine.tracer;
  const Point from = machine.state.position;
  if (!tracer.rapid_axis(GONOGO_X, cycle.b)) return false;
  if (!cut(machine, cycle, start)) return false;
  const bool threads =
      machine.follows("hnc.g82.exit=feed"_reading) != machine.has("threads-out"_fault);
  const bool out = threads ? tracer.thread_axis(GONOGO_X, from[GONOGO_X], cycle.lead, start)
                           : tracer.rapid_axis(GONOGO_X, from[GONOGO_X]);
  return out && tracer.rapid_axis(GONOGO_Z, from[GONOGO_Z]);
}

bool perform(Machine& machine, const ThreadCycle& cycle) {
  const bool falls = machine.follows("hnc.g82.order=falling"_reading);
  for (Fixed pass_number = 0; pass_number < cycle.passes; ++pass_number) {
    const Fixed k = falls ? cycle.passes - 1 - pass_number : pass_number;
    const Wide start = cycle.first + static_cast<Wide>(k) * cycle.between;
    if (!pass(machine, cycle, within_circle(start))) return false;
  }
  return true;
}

}  // namespace

void prepare_thread_cycle(Machine& machine, const Block& block, Plan& plan) {
  take_words(machine, block);
  if (is_idle(machine, block, true, true)) return;
  const CycleStore& store = machine.state.store;
  const CycleEnd end = cycle_end(machine, block, true, true);
  ThreadCycle cycle;
  cycle.b = moved(machine, end.x, store.taper.value);
  cycle.end = end;
  cycle.lead = lead_in_force(machine);
  // HNC-G82-07
  if (cycle.lead == 0) machine.complain(AlarmKind::kLeadMissing);
  prepare_starts(machine, cycle);
  cycle.run_out_x = store.run_out_x.value;
  cycle.run_out_z = store.run_out_z.value;
  if (machine.in_alarm()) return;
  check_run_out(machine, block, end.z - machine.state.position[GONOGO_Z]);
  moved(machine, end.x, cycle.run_out_x);
  moved(machine, end.z, cycle.run_out_z);
  if (machine.in_alarm()) return;
  keep_end(machine, end);
  plan = [&machine, cycle] { return perform(machine, cycle); };
}

}  // namespace gonogo::expanders::hnc
