// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "expanders/common/alarms.hpp"
#include "expanders/common/letter_block.hpp"
#include "expanders/common/machine_profile.hpp"
#include "expanders/common/planted.hpp"
#include "expanders/common/tracer.hpp"

namespace gonogo::expanders {

/// What the codes of every maker work on.
class Machine : public Complaints<AlarmKind> {
 public:
  /// `position` is that of the tool, in the coordinates that are put out.
  Machine(const MachineProfile& machine_profile, const gonogo_sink_v1& sink, Point& position,
          Planted<Fault> planted)
      : profile(machine_profile), tracer(sink, position, line), planted_(planted) {}
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const MachineProfile& profile;
  std::uint64_t line = 0;  ///< of the block at work
  Tracer tracer;
  /// What the expander would need for the block and has not; "": nothing.
  std::string lacking;

  /// Whether the fault is the planted one; its line is reached.
  bool has(Fault fault) const { return planted_.has(fault); }
  /// Whether the machine follows this alternative.
  bool follows(Reading reading) const { return profile.readings.follows(reading); }

  using Complaints::complain;
  void complain(AlarmKind kind, char address, const LetterBlock& block) {
    complain(kind, address, block.position(address));
  }

 private:
  Planted<Fault> planted_;
};

}  // namespace gonogo::expanders
