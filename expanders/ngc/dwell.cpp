// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {

// NGC-G4-01
void prepare_dwell(Machine& machine, const Block& block, Plan& plan) {
  if (!block.has('P')) return machine.complain(AlarmKind::kMissingWord, 'P', kNowhere);
  const Fixed seconds = block.number('P').value;
  if (seconds < 0) return machine.complain(AlarmKind::kValueSign, 'P', block);
  const auto parts = machine.alters<Fixed>("dwell-in-milliseconds"_fault, 1, 1000);
  plan.dwell = static_cast<Fixed>(scaled(seconds, 1, parts));
}

}  // namespace gonogo::expanders::ngc
