// SPDX-License-Identifier: GPL-3.0-or-later
// Frames and cycles of 802S. As in plan.hpp: preparing checks and complains, performing cannot
// fail.
#pragma once

#include "expanders/sinumerik/plan.hpp"

namespace gonogo::expanders::sinumerik {

/// A frame block: G158, G258, G259.
void take_frame(Machine& machine, const Block& block, int code);

void prepare_drilling(Machine& machine, const Block& block, Plan& plan);
void prepare_pocket(Machine& machine, const Block& block, Plan& plan);

/// The R parameters of a cycle in counts; what none can be is complained of.
class CycleParameters {
 public:
  explicit CycleParameters(Machine& machine) : machine_(machine) {}

  Fixed operator()(int number);
  /// Whether one that was read is no whole number of counts.
  bool rounded() const { return rounded_; }

  /// Complains of R`number`.
  void complain(AlarmKind kind, int number);
  /// SIE-LC82-02: the planes R101 to R104.
  void check_planes();
  /// Complains of R`number` below 0.
  void check_not_negative(int number);

 private:
  Machine& machine_;
  bool rounded_ = false;
};

/// Whether the cycle stands alone in its block; complains if not.
bool stands_alone(Machine& machine, const Block& block);

/// Way straight along the third axis, for what goes on from the cycle.
Heading heading_along_depth(const Plane& plane);

}  // namespace gonogo::expanders::sinumerik
