// SPDX-License-Identifier: GPL-3.0-or-later
// G85, G86 and G89.
#include "expanders/ngc/cycle.hpp"

namespace gonogo::expanders::ngc {
namespace {

// NGC-G85-01
bool out_of_g85(const Hole& hole) {
  const Machine& machine = hole.machine;
  if (machine.adds("g85-rapid-out"_fault)) return hole.rapid(hole.cycle.clear);
  if (!machine.follows("ngc.g85.out=clear"_reading) && !hole.feed(hole.cycle.r)) return false;
  return machine.follows("ngc.g85.out=clear"_reading) ? hole.feed(hole.cycle.clear)
                                                      : hole.rapid(hole.cycle.clear);
}

// NGC-G86-02
bool out_of_g86(const Hole& hole) {
  const Machine& machine = hole.machine;
  const Cycle& cycle = hole.cycle;
  if (machine.spares("g86-without-dwell"_fault, cycle.dwell != 0) && !hole.dwell()) return false;
  const bool late = machine.adds("g86-late-stop"_fault);
  if (late && !hole.rapid(cycle.clear)) return false;
  if (!hole.turn(5) || !hole.rapid(cycle.clear)) return false;
  return machine.adds("g86-without-restart"_fault) || hole.turn(cycle.spindle);
}

// NGC-G89-01
bool out_of_g89(const Hole& hole) {
  const Cycle& cycle = hole.cycle;
  const Fixed end = hole.machine.alters("g89-out-to-r"_fault, cycle.clear, cycle.r);
  return hole.dwell() && hole.feed(end) && hole.rapid(cycle.clear);
}

}  // namespace

bool bore(const Hole& hole) {
  if (!hole.feed(hole.cycle.bottom)) return false;
  switch (hole.cycle.code) {
    case Motion::kG85:
      return out_of_g85(hole);
    case Motion::kG86:
      return out_of_g86(hole);
    default:
      return out_of_g89(hole);
  }
}

}  // namespace gonogo::expanders::ngc
