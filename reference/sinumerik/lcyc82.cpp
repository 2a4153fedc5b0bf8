// SPDX-License-Identifier: GPL-3.0-or-later
//
// LCYC82: drilling and counterboring with a dwell, where the tool stands.
#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/sinumerik/cycle.hpp"

namespace gonogo::reference::sinumerik {

void run_lcyc82(const CycleCall& call) {
  BlockContext& block = call.block;
  const ClauseId clause = "SIE-LC82-01"_clause;
  check_planes(call);
  // SIE-LC82-03
  const Number dwell = call.parameter(105);
  if (decided("SIE-LC82-04"_clause, "R105", dwell) < 0) {
    call.parameter_alarm(AlarmClass::value_sign, "SIE-LC82-04"_clause, 105,
                         with_values("The dwell R105, {} s, is below zero.", {dwell}));
  }
  drop_feed_of_before(block);
  if (block.machine.feed_is_zero) block.out.accept("SIE-COM-06"_clause);
  if (decided("SIE-LC82-03"_clause, "F", block.machine.feed) == 0) {
    call.alarm(AlarmClass::feed_missing, "SIE-LC82-03"_clause, 'F', "No feed is in force.");
  }
  need_spindle(block);
  if (!block.out.alarms.empty()) return;
  name_planes(call);
  const Axis d = block.plane_axes().d;
  put_cycle_motion(call, RecordKind::rapid, clause, {{d, call.clearance()}});
  put_cycle_motion(call, RecordKind::feed, clause, {{d, call.parameter(104)}}, linear_feed(block));
  if (dwell.sign() > 0) {
    Record record;
    record.kind = RecordKind::dwell;
    record.block = block.line;
    record.clause = clause;
    record.seconds = dwell;
    block.put(std::move(record));
  }
  put_cycle_motion(call, RecordKind::rapid, clause, {{d, call.retract()}});
  end_cycle(block);
}

}  // namespace gonogo::reference::sinumerik
