// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/complaints.hpp"
#include "expanders/common/flow.hpp"
#include "expanders/common/tracer.hpp"
#include "expanders/hnc/alarms.hpp"
#include "expanders/hnc/block.hpp"
#include "expanders/hnc/faults.hpp"
#include "expanders/hnc/state.hpp"

namespace gonogo::expanders::hnc {

/// What every code works on.
class Machine : public Complaints<AlarmKind> {
 public:
  Machine(const Configuration& machine_configuration, const gonogo_sink_v1& sink, Fault planted)
      : configuration(machine_configuration),
        state(machine_configuration),
        tracer(sink, state.position, state.line),
        fault_(planted) {}
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const Configuration& configuration;
  State state;
  Tracer tracer;

  bool has(Fault planted) const { return fault_ == planted; }

  using Complaints::complain;
  void complain(AlarmKind kind, char word, const Block& block) {
    complain(kind, word, block.position(word));
  }
  Flow verdict() const { return in_alarm() ? Flow::kAlarm : Flow::kContinue; }

 private:
  Fault fault_;
};

inline constexpr AddressSet kAxisAddresses{"XZUW"};

/// The word of X or Z in a block.
struct AxisWord {
  bool present = false;
  bool incremental = false;
  char address = 0;
  Fixed value = 0;  ///< true length in mm
};

/// `axis`: GONOGO_X or GONOGO_Z.
AxisWord axis_word(const Machine& machine, const Block& block, std::size_t axis);

/// Place that the block commands along `axis`, in the base frame; the position without a word.
/// Complains when it is out of reach.
Fixed target(Machine& machine, const Block& block, std::size_t axis);

/// The length of `address` in mm; the word must be there.
Fixed length_of(const Machine& machine, const Block& block, char address);

/// Stores the length, or the bare number, of `address` when the block has it.
void take_length(const Machine& machine, const Block& block, char address, Retained& store);
void take_number(const Block& block, char address, Retained& store);

/// Whether the block has `address` with a number that is not whole.
bool has_fraction(const Block& block, char address);

/// Rules that hold for the words of every block (HNC-COM-01).
void check_words(Machine& machine, const Block& block);

}  // namespace gonogo::expanders::hnc
