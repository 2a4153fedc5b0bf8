// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-EXP-01: what stands between brackets, and behind '#'.
#include "reference/rs274/expression.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/exact/size.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/logic_order.hpp"
#include "reference/rs274/machine.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {
namespace {

using grammar::TermKind;

// NGC-EXP-07: operations on a value that is only enclosed.
constexpr std::size_t kDeepest = 200;

}  // namespace

bool Calculator::fail(AlarmClass alarm_class, ClauseId clause, const grammar::Span& where,
                      std::string message) {
  alarm = Alarm{alarm_class, clause, {}, where, std::move(message)};
  return false;
}

bool Calculator::leave_out(std::string code, const grammar::Span& where, std::string message) {
  outside = NotCovered{0, std::move(code), std::move(message), where};
  return false;
}

// NGC-EXP-07
bool Calculator::is_kept(const grammar::Term& term) {
  const exact::Size size = exact::size_of(stack_.back().number);
  if (size.bits <= kLongest && size.depth <= kDeepest) return true;
  return leave_out("expression", term.where,
                   "The exact value has more digits than the gauge keeps.");
}

// NGC-PAR-01: the number of a parameter, or near enough to one.
std::optional<std::int64_t> Calculator::number_of_parameter(const Number& value,
                                                            const grammar::Span& where) {
  const ClauseId clause = "NGC-PAR-01"_clause;
  const NearWhole number(value);
  if (!number.counts_as_whole(Whole::repeats, readings_)) {
    fail(AlarmClass::not_an_integer, clause, where,
         with_values("The number of a parameter is whole, and not {}.", {value}));
    return std::nullopt;
  }
  const std::int64_t nearest = number.nearest().to_int64().value_or(0);
  if (nearest >= 1 && nearest <= kLastParameter) return nearest;
  fail(AlarmClass::value_out_of_range, clause, where,
       with_values("The number of a parameter is from 1 to {}, and not {}.",
                   {kLastParameter, nearest}));
  if (nearest <= 0) alarm->also.add(AlarmClass::value_sign);
  return std::nullopt;
}

// NGC-PAR-04
std::optional<Value> Calculator::of_machine(std::int64_t number) const {
  const WordModes& modes = machine_.modes;
  switch (number) {
    case 5220:
      return Value{static_cast<std::int64_t>(machine_.offsets.system) + 1};
    case 5420:
      return as_doubles_have(modes.number_of(machine_.position[Axis::x]));
    case 5421:
      return as_doubles_have(modes.number_of(machine_.position[Axis::y]));
    case 5422:
      return as_doubles_have(modes.number_of(machine_.position[Axis::z]));
    case 5423:
      return as_doubles_have(machine_.position[Axis::a]);
    case 5425:
      return as_doubles_have(machine_.position[Axis::c]);
    default:
      return std::nullopt;
  }
}

namespace {

// NGC-PAR-04: names that are 1 while something is in force, else 0.
struct Flag {
  std::string_view name;
  bool (*is_on)(const Machine& machine);
};
constexpr auto kFlags = std::to_array<Flag>({
    {"_absolute", [](const Machine& machine) { return !machine.modes.incremental; }},
    {"_flood", [](const Machine& machine) { return machine.has_flood; }},
    {"_ijk_absolute_mode", [](const Machine& machine) { return machine.modes.absolute_centre; }},
    {"_imperial", [](const Machine& machine) { return machine.modes.inch; }},
    {"_incremental", [](const Machine& machine) { return machine.modes.incremental; }},
    {"_inverse_time", [](const Machine& machine) { return machine.is_inverse_time; }},
    {"_metric", [](const Machine& machine) { return !machine.modes.inch; }},
    {"_mist", [](const Machine& machine) { return machine.has_mist; }},
    {"_spindle_css_mode", [](const Machine& machine) { return machine.has_surface_speed; }},
    {"_spindle_cw", [](const Machine& machine) { return machine.spindle == 3; }},
    {"_spindle_on", [](const Machine& machine) { return machine.spindle_turns(); }},
    {"_spindle_rpm_mode", [](const Machine& machine) { return !machine.has_surface_speed; }},
    {"_units_per_minute",
     [](const Machine& machine) {
       return !machine.is_inverse_time && machine.feed_mode == FeedMode::per_minute;
     }},
    {"_units_per_rev",
     [](const Machine& machine) {
       return !machine.is_inverse_time && machine.feed_mode == FeedMode::per_revolution;
     }},
});

// G54 is 540, G59.3 is 593.
std::int64_t tenths_of_system(std::size_t system) {
  constexpr std::size_t kG59 = 5;
  return static_cast<std::int64_t>(system <= kG59 ? 540 + 10 * system : 590 + system - kG59);
}

}  // namespace

// NGC-PAR-04
std::optional<Value> Calculator::of_machine(std::string_view name) const {
  const WordModes& modes = machine_.modes;
  const auto flag = std::ranges::find(kFlags, name, &Flag::name);
  if (flag != kFlags.end()) return Value{truth(flag->is_on(machine_))};
  if (name == "_x") return of_machine(5420);
  if (name == "_y") return of_machine(5421);
  if (name == "_z") return of_machine(5422);
  if (name == "_a") return of_machine(5423);
  if (name == "_c") return of_machine(5425);
  if (name == "_plane") return Value{10 * plane_code(machine_.plane)};
  if (name == "_coord_system") return Value{tenths_of_system(machine_.offsets.system)};
  // What F is worth once the units have changed no text says.
  const bool is_as_written = modes.length_of(machine_.rotary_feed) == machine_.feed;
  if (name == "_feed" && is_as_written) return as_doubles_have(machine_.rotary_feed);
  if (name == "_value") return parameters_.returned.value_or(Value{});
  if (name == "_value_returned") return Value{truth(parameters_.returned.has_value())};
  return std::nullopt;
}

bool Calculator::push_numbered(const grammar::Term& term) {
  const auto number = number_of_parameter(stack_.back().number, term.where);
  if (!number) return false;
  if (is_of_program(*number)) {
    Value value = parameters_.numbered(*number);
    // NGC-OWD-02
    if (parameters_.is_inherited(*number) && value.number.sign() != 0 &&
        readings_.is("ngc.call-parameters=zero"_reading)) {
      value = {};
    }
    stack_.back() = std::move(value);
    return true;
  }
  const std::optional<Value> of_it = of_machine(*number);
  if (!of_it) {
    return leave_out(fmt::format("#{}", *number), term.where,
                     "The gauge does not read this parameter of the machine.");
  }
  stack_.back() = *of_it;
  return true;
}

// NGC-PAR-03
bool Calculator::push_named(const std::string& name, const grammar::Term& term) {
  const bool asks = term.kind == TermKind::exists;
  std::optional<Value> value = is_predefined(name) ? of_machine(name) : parameters_.named(name);
  if (!value && is_predefined(name)) {
    return leave_out(fmt::format("#<{}>", name), term.where,
                     "The gauge does not read this parameter of the machine.");
  }
  if (!value && !asks) {
    return fail(AlarmClass::value_out_of_range, "NGC-PAR-03"_clause, term.where,
                fmt::format("The parameter #<{}> has no value.", name));
  }
  stack_.push_back(asks ? Value{truth(value.has_value())} : *value);
  return true;
}

bool Calculator::apply(const grammar::Block& block, const grammar::Term& term) {
  switch (term.kind) {
    case TermKind::number:
      stack_.push_back(as_doubles_have(to_number(term.number)));
      return true;
    case TermKind::numbered:
      return push_numbered(term);
    case TermKind::named:
    case TermKind::exists:
      return push_named(block.names[static_cast<std::size_t>(term.number.magnitude)], term);
    default:
      return (takes_two(term.kind) ? apply_two(term) : apply_one(term)) && is_kept(term);
  }
}

std::optional<Value> Calculator::calculated(const grammar::Block& block,
                                            const grammar::TermRange& range) {
  stack_.clear();
  // NGC-EXP-09
  if (has_logic_before_sum(block, range) && readings_.is("ngc.logic-order=among-sums"_reading)) {
    for (const std::uint32_t place : logic_among_sums(block, range)) {
      if (!apply(block, block.terms[place])) return std::nullopt;
    }
    return std::move(stack_.back());
  }
  for (std::uint32_t i = 0; i < range.count; ++i) {
    if (!apply(block, block.terms[range.first + i])) return std::nullopt;
  }
  return std::move(stack_.back());
}

std::optional<Number> Calculator::value(const grammar::Block& block,
                                        const grammar::TermRange& range) {
  std::optional<Value> found = calculated(block, range);
  if (!found) return std::nullopt;
  return std::move(found->number);
}

// NGC-PAR-02
bool Calculator::assign(const grammar::Block& block) {
  struct Setting {
    const grammar::Assignment* assignment;
    std::int64_t number;
    Value value;
  };
  std::vector<Setting> settings;
  for (const grammar::Assignment& assignment : block.assignments) {
    std::int64_t number = 0;
    if (assignment.name.empty()) {
      const std::optional<Number> index = value(block, assignment.index);
      const auto named = index ? number_of_parameter(*index, assignment.where) : std::nullopt;
      if (!named) return false;
      number = *named;
    }
    const bool is_of_machine =
        assignment.name.empty() ? !is_of_program(number) : is_predefined(assignment.name);
    if (is_of_machine) {  // NGC-PAR-04
      return leave_out(assignment.name.empty() ? fmt::format("#{}", number)
                                               : fmt::format("#<{}>", assignment.name),
                       assignment.where,
                       "The gauge does not read settings of parameters of the machine.");
    }
    std::optional<Value> to = calculated(block, assignment.value);
    if (!to) return false;
    settings.push_back({&assignment, number, *std::move(to)});
  }
  for (Setting& setting : settings) {
    if (setting.assignment->name.empty()) {
      parameters_.set(setting.number, std::move(setting.value));
    } else {
      parameters_.set(setting.assignment->name, std::move(setting.value));
    }
  }
  return true;
}

}  // namespace gonogo::reference::rs274
