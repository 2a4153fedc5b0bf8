// SPDX-License-Identifier: GPL-3.0-or-later
// G32: one thread, straight or tapered.
#include "expanders/hnc/motion.hpp"

namespace gonogo::expanders::hnc {

void prepare_thread(Machine& machine, const Block& block, Plan& plan) {
  Thread thread;
  thread.to = commanded_point(machine, block, thread.axes);
  if (thread.axes == 0) return;
  thread.lead = machine.state.store.lead;
  if (thread.lead == 0) machine.complain(AlarmKind::kLeadMissing);  // HNC-MOD-04
  if (machine.has(Fault::kThreadLeadForgotten)) machine.state.store.lead = 0;
  plan = thread;
}

bool perform(Machine& machine, const Thread& thread) {
  return machine.tracer.thread(thread.to, thread.axes, thread.lead);
}

}  // namespace gonogo::expanders::hnc
