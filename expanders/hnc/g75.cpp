// SPDX-License-Identifier: GPL-3.0-or-later
// G75: grooving along X, at one place or at several along Z.
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {
namespace {

struct Groove {
  Pecks pecks;
  Fixed width = 0;  ///< signed
  Fixed steps = 0;  ///< the count; 0: a single groove
};

// HNC-G75-04: I (reading hnc.g75.i: P) is a positive whole number.
void take_count(Machine& machine, const Block& block, char address) {
  if (!block.has(address)) return;
  Retained& steps = machine.state.store.steps;
  take_number(block, address, steps);
  if (machine.has("groove-count-unchecked"_fault) && steps.value >= kOne) {
    steps.value -= steps.value % kOne;
  } else if (steps.value <= 0 || block.has_fraction(address)) {
    machine.complain(AlarmKind::kNotAnInteger, address, block);
  }
}

// HNC-G75-04, HNC-G75-05: an inherited count rests in a block without a width.
void prepare_width(Machine& machine, const Block& block, char address, const CycleEnd& end,
                   Groove& groove) {
  const bool wide = block.has('Z') || block.has('W');
  const Retained& steps = machine.state.store.steps;
  if (!wide && block.has(address)) machine.complain(AlarmKind::kMissingWord, 'Z', kNowhere);
  if (!wide) return;
  if (!steps.present) return machine.complain(AlarmKind::kMissingWord, address, kNowhere);
  groove.steps = steps.value / kOne;
  groove.width = end.z - machine.state.position[GONOGO_Z];
}

// HNC-G75-04: A_Z + n W / I, each place rounded once from the exact quotient.
class Places {
 public:
  Places(const Machine& machine, const Groove& groove, Fixed start)
      : groove_(groove),
        start_(start),
        intervals_(groove.steps),
        last_(groove.steps),
        summed_(machine.has("groove-running-sum"_fault)) {
    if (groove.steps == 0) return;
    if (machine.follows("hnc.g75.steps=i"_reading)) {
      --last_;
      intervals_ = last_;
    }
    if (machine.has("groove-step-short"_fault) && last_ > 0) --last_;
    if (groove.width == 0 && machine.follows("hnc.g75.zero-width=once"_reading)) last_ = 0;
  }

  /// Number of the last place; the first is 0.
  Fixed last() const { return last_; }

  Fixed at(Fixed n) const {
    // Reading hnc.g75.steps = i, a count of 1: the one plunge is at the end of the width.
    if (intervals_ == 0) return start_ + groove_.width;
    if (summed_) {
      constexpr Fixed kIncrement = kOne / 1000;
      return start_ +
             n * kIncrement * static_cast<Fixed>(scaled(groove_.width, 1, intervals_ * kIncrement));
    }
    return start_ + static_cast<Fixed>(scaled(groove_.width, n, intervals_));
  }

 private:
  const Groove& groove_;
  Fixed start_;
  Fixed intervals_;
  Fixed last_;
  bool summed_;
};

// Down, and straight out to where it began.
bool plunge(Machine& machine, const Groove& groove) {
  const Fixed out = machine.state.position[GONOGO_X];
  return perform_pecks(machine, groove.pecks) && machine.tracer.rapid_axis(GONOGO_X, out);
}

bool perform(Machine& machine, const Groove& groove) {
  const Fixed start = machine.state.position[GONOGO_Z];
  if (groove.steps == 0) return plunge(machine, groove);
  const Places places(machine, groove, start);
  for (Fixed n = 0; n <= places.last(); ++n) {
    if (!machine.tracer.rapid_axis(GONOGO_Z, places.at(n))) return false;
    if (!plunge(machine, groove)) return false;
  }
  const bool stays = machine.follows("hnc.g75.end=last"_reading);
  return stays || machine.tracer.rapid_axis(GONOGO_Z, start);
}

}  // namespace

void prepare_groove(Machine& machine, const Block& block, Plan& plan) {
  const bool by_reading =
      machine.follows("hnc.g75.depth-scale=diameter"_reading) && machine.state.diameter;
  const char count = machine.follows("hnc.g75.i=P"_reading) ? 'P' : 'I';
  take_pecks(machine, block, by_reading != machine.has("groove-depth-diameter"_fault));
  take_count(machine, block, count);
  if (is_idle(machine, block, true, false)) return;
  const bool wide = block.has('Z') || block.has('W');
  const CycleEnd end = cycle_end(machine, block, true, wide);
  Groove groove;
  groove.pecks.axis = GONOGO_X;
  groove.pecks.bottom = end.x;
  prepare_width(machine, block, count, end, groove);
  prepare_pecks(machine, block, groove.pecks);
  if (machine.in_alarm()) return;
  prepare_approach(machine, wide && machine.follows("hnc.g75.mode3=on"_reading), groove.pecks);
  if (machine.in_alarm()) return;
  keep_end(machine, end);
  plan = [&machine, groove] { return perform(machine, groove); };
}

}  // namespace gonogo::expanders::hnc
