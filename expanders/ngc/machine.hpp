// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/complaints.hpp"
#include "expanders/common/flow.hpp"
#include "expanders/common/tracer.hpp"
#include "expanders/ngc/alarms.hpp"
#include "expanders/ngc/block.hpp"
#include "expanders/ngc/faults.hpp"
#include "expanders/ngc/state.hpp"

namespace gonogo::expanders::ngc {

/// What every code works on.
class Machine : public Complaints<AlarmKind> {
 public:
  Machine(const Configuration& machine_configuration, const gonogo_sink_v1& sink, Fault planted)
      : configuration(machine_configuration),
        state(machine_configuration),
        tracer(sink, state.position, state.line),
        whole(machine_configuration.whole),
        fault_(planted) {
    whole.limit_refused = has(Fault::kWholeLimitRefused);
    whole.cut = has(Fault::kNearWholeCut);
    if (has(Fault::kCodeLimitUnscaled)) whole.code = whole.function;
  }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const Configuration& configuration;
  State state;
  Tracer tracer;
  WholeRule whole;

  bool has(Fault planted) const { return fault_ == planted; }

  using Complaints::complain;
  void complain(AlarmKind kind, char word, const Block& block) {
    complain(kind, word, block.position(word));
  }

 private:
  Fault fault_;
};

/// In the order of gonogo_axis.
inline constexpr char kAxisAddress[] = "XYZAC";
inline constexpr Axes kLinearAxes = axis_bit(GONOGO_X) | axis_bit(GONOGO_Y) | axis_bit(GONOGO_Z);

/// Point that the axis words of the block command, by G90 or G91; `axes` are those with a word.
/// Complains when it is out of reach.
Point commanded_point(Machine& machine, const Block& block, Axes& axes);

/// The length of `address` in mm, by the units in force; the word must be there.
Fixed length_of(const Machine& machine, const Block& block, char address);

/// Complains about numbers that are too large to reckon with.
void check_sizes(Machine& machine, const Block& block);

}  // namespace gonogo::expanders::ngc
