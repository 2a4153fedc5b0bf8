// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sinumerik/cycle.hpp"

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>

namespace gonogo::reference::sinumerik {
namespace {

// Whether R`number` of a cycle is a length.
bool is_length(std::uint64_t number) {
  return (number >= 101 && number <= 104) || (number >= 116 && number <= 121) || number == 124 ||
         number == 125;
}

// R122 and R123 of LCYC75.
bool is_feed(std::uint64_t number) {
  return number == 122 || number == 123;
}

}  // namespace

bool CycleCall::counts_inches(std::uint64_t number) const {
  if (!block.machine.modes.inch || calculator.parameter(number).sign() == 0) return false;
  const ReadingsInUse& readings = block.readings;
  if (is_feed(number)) return readings.is("sie.lcyc.unit=inch-with-feeds"_reading);
  return is_length(number) && !readings.is("sie.lcyc.unit=mm"_reading);
}

Number CycleCall::parameter(std::uint64_t number) const {
  const Number& written = calculator.parameter(number);
  return counts_inches(number) ? inches(written) : written;
}

grammar::Span CycleCall::where() const {
  grammar::Span where;
  for (const grammar::NamedWord& name : block.words.block().named) {
    if (cycle_of(name) != Cycle::none) where = name.where;
  }
  return where;
}

void CycleCall::alarm(AlarmClass alarm, ClauseId clause, WordName word, std::string message) const {
  block.out.alarms.push_back({alarm, clause, word, where(), std::move(message)});
}

void CycleCall::parameter_alarm(AlarmClass alarm, ClauseId clause, std::uint64_t number,
                                std::string message) const {
  this->alarm(alarm, clause, WordName(fmt::format("R{}", number)), std::move(message));
}

void check_planes(const CycleCall& call) {
  const ClauseId clause = "SIE-LC82-02"_clause;
  // Messages have the numbers of the program, which may count inches (sie.lcyc.unit).
  const auto as_written = [&](std::uint64_t number) { return call.calculator.parameter(number); };
  if (decided(clause, "R101 - R103 - R102", call.retract(), call.clearance()) < 0) {
    const bool is_above_reference =
        decided("SIE-LC82-04"_clause, "R101 - R103", call.retract(), call.parameter(103)) >= 0;
    call.parameter_alarm(
        AlarmClass::reference_plane, is_above_reference ? "SIE-LC82-04"_clause : clause, 101,
        with_values("The retract plane R101 = {} lies below the clearance R103 + R102 = {}.",
                    {as_written(101), as_written(103) + as_written(102)}));
  }
  if (decided("SIE-LC82-04"_clause, "R102", call.parameter(102)) < 0) {
    call.parameter_alarm(
        AlarmClass::value_sign, "SIE-LC82-04"_clause, 102,
        with_values("The safety clearance R102 = {} is below zero.", {as_written(102)}));
  }
  if (decided(clause, "R104 - R103", call.parameter(104), call.parameter(103)) >= 0) {
    call.parameter_alarm(
        AlarmClass::reference_plane, clause, 104,
        with_values("The depth R104 = {} is not below the reference plane R103 = {}.",
                    {as_written(104), as_written(103)}));
  }
}

void name_planes(const CycleCall& call) {
  BlockOutput& out = call.block.out;
  if (!out.notes_places) return;
  const Machine& machine = call.block.machine;
  const Axis d = call.block.plane_axes().d;
  const auto base = [&](const Number& level) {
    Position at = machine.position;
    at[d] = level;
    return machine.frame.to_base(at)[d];
  };
  out.name_plane("R101", d, base(call.retract()));
  out.name_plane("R103 + R102", d, base(call.clearance()));
  out.name_plane("R104", d, base(call.parameter(104)));
}

void put_cycle_motion(const CycleCall& call, RecordKind kind, ClauseId clause,
                      std::initializer_list<AxisValue> to, const Number& feed) {
  Machine& machine = call.block.machine;
  Record record = call.block.motion(kind, clause, to);
  if (kind != RecordKind::rapid) record.feed = feed;
  put_in_base(call.block, std::move(record), machine.position);
}

void end_cycle(BlockContext& block) {
  const PlaneAxes axes = block.plane_axes();
  LastMotion last;
  last.direction[axes.d] = 1;
  block.machine.last = std::move(last);
  // What is known of the place in the plane stays known where only the depth axis has moved.
  std::optional<PlaceMark>& mark = block.machine.mark;
  if (mark && mark->plane != block.machine.plane) mark.reset();
}

void order_by_parameter(std::vector<Alarm>& alarms) {
  const auto goes_before = [](const Alarm& a, const Alarm& b) {
    const bool a_is_parameter = a.word.text().starts_with('R');
    const bool b_is_parameter = b.word.text().starts_with('R');
    // Their numbers have three digits.
    return a_is_parameter && (!b_is_parameter || a.word.text() < b.word.text());
  };
  for (std::size_t i = 1; i < alarms.size(); ++i) {
    for (std::size_t k = i; k > 0 && goes_before(alarms[k], alarms[k - 1]); --k) {
      std::swap(alarms[k], alarms[k - 1]);
    }
  }
}

}  // namespace gonogo::reference::sinumerik
