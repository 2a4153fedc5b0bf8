// SPDX-License-Identifier: GPL-3.0-or-later
//
// What LCYC82 and LCYC75 have in common: parameters in R, planes, alarms that name a parameter.
#pragma once

#include <string>

#include "reference/sinumerik/expression.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {

// One call of a cycle.
struct CycleCall {
  BlockContext& block;
  const Calculator& calculator;
  OpenPaths open_paths;

  // R101 and so on; mm, mm/min or mm/rev. Under G70 a reading has lengths, or these and feeds, in
  // inches (sie.lcyc.unit).
  Number parameter(std::uint64_t number) const;
  // Whether the program's number counts inches.
  bool counts_inches(std::uint64_t number) const;
  // A rule about a parameter that is broken; its place is the name of the cycle.
  void parameter_alarm(AlarmClass alarm, ClauseId clause, std::uint64_t number,
                       std::string message) const;
  void alarm(AlarmClass alarm, ClauseId clause, WordName word, std::string message) const;
  // For the name of the cycle.
  grammar::Span where() const;
  // In workpiece coordinates.
  Number retract() const { return parameter(101); }
  Number clearance() const { return parameter(103) + parameter(102); }
};

// Several broken rules of a cycle: the first by the number of its parameter comes first.
void order_by_parameter(std::vector<Alarm>& alarms);
// SIE-LC82-02: the planes lie in order.
void check_planes(const CycleCall& call);
// A motion of the cycle, without the words of the block. The feed is of this motion.
// The planes that the parameters give, in base coordinates.
void name_planes(const CycleCall& call);
void put_cycle_motion(const CycleCall& call, RecordKind kind, ClauseId clause,
                      std::initializer_list<AxisValue> to, const Number& feed = 0);
// SIE-CT-02: a cycle ends with a traverse along the depth axis.
void end_cycle(BlockContext& block);

void run_lcyc82(const CycleCall& call);
void run_lcyc75(const CycleCall& call);

}  // namespace gonogo::reference::sinumerik
