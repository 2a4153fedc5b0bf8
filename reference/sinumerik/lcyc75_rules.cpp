// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-LC75-03, SIE-LC75-08, SIE-LC75-09: what LCYC75 needs, in the order of its parameters.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"
#include "reference/sinumerik/lcyc75.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr ClauseId kRanges = "SIE-LC75-09"_clause;
constexpr ClauseId kUnsaid = "SIE-LC75-15"_clause;

bool roughs(const CycleCall& call) {
  return call.parameter(127) == Number(1);
}
bool finishes(const CycleCall& call) {
  return call.parameter(127) == Number(2);
}

// SIE-LC75-03: T0 and D0 are no tool.
bool has_tool(const CycleCall& call) {
  return call.block.machine.tool && call.block.machine.edge.sign() != 0;
}

// Whether T changes the tool or M6 does, the machine decides, and no text says: behind a T that no
// M6 has followed, where one has followed a T before, either may be in force.
bool is_tool_unsaid(const Machine& machine) {
  return machine.last_m6 && machine.last_m6->tool != machine.tool;
}

// As with_values takes it.
Number number_of(std::uint64_t parameter) {
  return static_cast<std::int64_t>(parameter);
}

// A number of the program, which may count inches (sie.lcyc.unit).
const Number& written(const CycleCall& call, std::uint64_t number) {
  return call.calculator.parameter(number);
}

// The profile gives the radius of the first edge of a tool.
bool is_edge_described(const CycleCall& call) {
  return call.block.machine.edge == Number(1);
}

// The radius of the tool in force; nothing where the profile does not say it.
std::optional<Number> tool_radius(const CycleCall& call) {
  if (!has_tool(call) || !is_edge_described(call)) return std::nullopt;
  const auto& tools = call.block.profile.tools;
  const auto found = tools.find(call.block.machine.tool->text());
  if (found == tools.end() || found->second.radius.sign() <= 0) return std::nullopt;
  return found->second.radius;
}

// The machine has a tool of which the profile says nothing. Where the block alarms in any case, it
// may as well be for the tool.
void lack_tool(const CycleCall& call) {
  const std::string number = call.block.machine.tool->text();
  const std::string edge = call.block.machine.edge.text();
  if (!call.block.out.alarms.empty()) {
    const std::string at_edge =
        is_edge_described(call) ? "" : fmt::format(" at its edge D{}", edge);
    call.alarm(AlarmClass::no_tool, "SIE-LC75-03"_clause, 'T',
               fmt::format("The profile does not describe the tool {}{}.", number, at_edge));
    return;
  }
  if (!is_edge_described(call)) {
    call.block.out.not_covered = NotCovered{
        call.block.line, "D",
        fmt::format("The edge D{} of the tool {} is in force, and the profile gives the radius of "
                    "the edge D1 only.",
                    edge, number),
        call.where()};
    return;
  }
  call.block.out.not_covered =
      lacking_in_profile(fmt::format("The radius of the tool {}", number),
                         fmt::format("tools = {{ \"{}\" = {{ radius = \"5\" }} }}", number),
                         call.where(), call.block.line);
}

void check_tool(const CycleCall& call) {
  const ClauseId clause = "SIE-LC75-03"_clause;
  if (!has_tool(call)) {
    call.alarm(AlarmClass::no_tool, clause, 'T', "No tool is in force.");
  }
  if (!spindle_turns(call.block)) {
    call.alarm(AlarmClass::spindle_stopped, clause, 'S', "The spindle does not turn.");
  }
}

// The sign of R`number`.
int sign_of(const CycleCall& call, ClauseId clause, std::uint64_t number) {
  return decided(clause, fmt::format("R{}", number), call.parameter(number));
}

void need_not_negative(const CycleCall& call, std::uint64_t number) {
  if (sign_of(call, kUnsaid, number) >= 0) return;
  call.parameter_alarm(
      AlarmClass::value_sign, kUnsaid, number,
      with_values("R{} = {} is below zero.", {number_of(number), written(call, number)}));
}

void check_sizes(const CycleCall& call) {
  for (const std::uint64_t number : {118U, 119U}) {
    if (sign_of(call, kRanges, number) > 0) continue;
    call.parameter_alarm(
        AlarmClass::pocket_size, kRanges, number,
        with_values("R{} = {} is not above zero.", {number_of(number), written(call, number)}));
  }
  need_not_negative(call, 120);
  const Number widest = min(call.parameter(118), call.parameter(119)) / 2;
  if (widest.sign() > 0 &&
      decided(kRanges, "R120 - half the pocket", call.parameter(120), widest) > 0 &&
      call.block.readings.is("sie.corner=reject"_reading)) {
    call.parameter_alarm(
        AlarmClass::pocket_size, kRanges, 120,
        with_values("The corner radius R120 = {} is larger than half the pocket, {}.",
                    {written(call, 120), min(written(call, 118), written(call, 119)) / 2}));
  }
  if (sign_of(call, kUnsaid, 121) <= 0) {
    call.parameter_alarm(
        AlarmClass::value_sign, kUnsaid, 121,
        with_values("The infeed R121 = {} is not above zero.", {written(call, 121)}));
  }
}

void check_feeds(const CycleCall& call) {
  for (const std::uint64_t number : {122U, 123U}) {
    if (sign_of(call, kRanges, number) > 0) continue;
    call.parameter_alarm(AlarmClass::feed_missing, kRanges, number,
                         with_values("The feed R{} = {} is not above zero.",
                                     {number_of(number), written(call, number)}));
  }
}

// Whether the allowance is to be smaller than the tool. The text says so of R124, with roughing.
bool is_limited(const CycleCall& call, std::uint64_t number) {
  const ReadingsInUse& readings = call.block.readings;
  if (number == 125) return readings.is("sie.lc75.r125-limit=alarm"_reading);
  return !finishes(call) || readings.is("sie.lc75.finish-limit=alarm"_reading);
}

void check_below_tool(const CycleCall& call, std::uint64_t number,
                      const std::optional<Number>& radius) {
  if (!radius) return;
  const Number value = call.parameter(number);
  const Number diameter = *radius * 2;
  if (decided(kRanges, fmt::format("R{} - tool", number), value, diameter) < 0) return;
  if (!is_limited(call, number)) return;
  std::string message =
      call.counts_inches(number)
          ? with_values(
                "The allowance R{} = {} ({} mm) is not smaller than the tool's diameter {}.",
                {number_of(number), written(call, number), value, diameter})
          : with_values("The allowance R{} = {} is not smaller than the tool's diameter {}.",
                        {number_of(number), value, diameter});
  call.parameter_alarm(AlarmClass::allowance_too_large, kRanges, number, std::move(message));
}

void check_allowances(const CycleCall& call, const std::optional<Number>& radius) {
  need_not_negative(call, 124);
  check_below_tool(call, 124, radius);
  need_not_negative(call, 125);
  check_below_tool(call, 125, radius);
  const Number depth = call.parameter(103) - call.parameter(104);
  if (roughs(call) && depth.sign() > 0 &&
      decided(kUnsaid, "R125 - depth", call.parameter(125), depth) >= 0) {
    call.parameter_alarm(
        AlarmClass::allowance_too_large, kUnsaid, 125,
        with_values("The allowance R125 = {} leaves nothing of the depth {} to be roughed.",
                    {written(call, 125), written(call, 103) - written(call, 104)}));
  }
}

// SIE-LC75-08: the tool between the walls; equality passes.
void check_fit(const CycleCall& call, const std::optional<Number>& radius) {
  if (!radius || (!roughs(call) && !finishes(call))) return;
  const Number needs = roughs(call) ? *radius + call.parameter(124) : *radius;
  for (const std::uint64_t number : {118U, 119U}) {
    const Number size = call.parameter(number);
    if (size.sign() <= 0) continue;
    if (decided("SIE-LC75-08"_clause, "tool - pocket", needs * 2, size) <= 0) continue;
    std::string message =
        call.counts_inches(number)
            ? with_values(
                  "The tool, with the allowance {} wide, does not fit into R{} = {} ({} mm).",
                  {needs * 2, number_of(number), written(call, number), size})
            : with_values("The tool, with the allowance {} wide, does not fit into R{} = {}.",
                          {needs * 2, number_of(number), size});
    call.parameter_alarm(AlarmClass::tool_too_large, "SIE-LC75-08"_clause, number,
                         std::move(message));
  }
}

void check_direction(const CycleCall& call) {
  const Number direction = call.parameter(126);
  if (direction == Number(2) || direction == Number(3)) return;
  // The second example of the text has R126=0.
  const ReadingsInUse& readings = call.block.readings;
  const bool has_sense = direction.sign() == 0 && !readings.is("sie.lc75.no-sense=alarm"_reading);
  if (has_sense) return;
  call.parameter_alarm(AlarmClass::direction_parameter, kRanges, 126,
                       with_values("R126 = {} is neither 2 nor 3.", {direction}));
}

}  // namespace

std::optional<Number> check_pocket(const CycleCall& call) {
  if (is_tool_unsaid(call.block.machine)) {
    call.block.out.not_covered =
        NotCovered{call.block.line, "T",
                   "No text says whether T alone has changed the tool, or M6 will.", call.where()};
    return std::nullopt;
  }
  const std::optional<Number> radius = tool_radius(call);
  check_planes(call);
  check_sizes(call);
  check_fit(call, radius);
  check_feeds(call);
  check_allowances(call, radius);
  check_direction(call);
  if (!roughs(call) && !finishes(call)) {
    call.parameter_alarm(AlarmClass::machining_type, kRanges, 127,
                         with_values("R127 = {} is neither 1 nor 2.", {call.parameter(127)}));
  }
  check_tool(call);
  if (has_tool(call) && !radius) lack_tool(call);
  order_by_parameter(call.block.out.alarms);
  return call.block.out.alarms.empty() ? radius : std::nullopt;
}

Number corner_radius(const CycleCall& call) {
  return min(call.parameter(120), min(call.parameter(118), call.parameter(119)) / 2);
}

}  // namespace gonogo::reference::sinumerik
