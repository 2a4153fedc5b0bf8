// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/flow.hpp"
#include "expanders/gsk/block.hpp"
#include "expanders/gsk/faults.hpp"
#include "expanders/gsk/state.hpp"
#include "expanders/gsk/trace.hpp"

namespace gonogo::expanders::gsk {

/// What every code works on.
struct Machine {
  Machine(const Configuration& machine_configuration, const gonogo_sink_v1& sink, Fault planted)
      : configuration(machine_configuration),
        state(machine_configuration),
        trace(sink, state),
        fault(planted) {}
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const Configuration& configuration;
  State state;
  Trace trace;
  Fault fault;
  Alarm alarm;

  bool has(Fault planted) const { return fault == planted; }
  Flow raise(AlarmKind kind, char word) {
    alarm = {kind, word};
    return Flow::kAlarm;
  }
};

/// The word or words of one axis in a block.
struct AxisWord {
  bool present = false;
  bool incremental = false;
  char address = 0;
  Fixed value = 0;  ///< true length in mm, or degrees
};

inline constexpr AddressSet kAxisAddresses{"XYZUVWCH"};

/// The word of `axis` (X, Y, Z or C). `as_diameter`: an X word is halved where the machine
/// programs diameters.
AxisWord axis_word(const Machine& machine, const Block& block, std::size_t axis,
                   bool as_diameter = true);

/// The length of `address` in mm; the word must be there.
Fixed length_of(const Machine& machine, const Block& block, char address);

/// The degrees of `address`; the word must be there.
Fixed angle_of(const Machine& machine, const Block& block, char address);

/// Stores the length of `address` when the block has it; true then.
bool take(const Machine& machine, const Block& block, char address, Retained& store);

/// Coordinate that `word` commands when it is counted from `from`.
inline Fixed target_of(const AxisWord& word, Fixed from) {
  if (!word.present) return from;
  return word.incremental ? from + word.value : word.value;
}

/// The commanded point of the block, counted from the position; `axes` are those commanded.
Flow commanded_point(Machine& machine, const Block& block, Point& to, Axes& axes);

/// Rules that hold for the words of every block (GSK-COM-01, GSK-COM-03).
Flow check_words(Machine& machine, const Block& block);

/// The ranges of the words of the cycle in force, in the unit in which they are written
/// (GSK-COM-06).
Flow check_ranges(Machine& machine, const Block& block);

}  // namespace gonogo::expanders::gsk
