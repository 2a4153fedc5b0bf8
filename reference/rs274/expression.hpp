// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of words, settings and conditions. All of it exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/outcome.hpp"
#include "reference/reading.hpp"
#include "reference/rs274/parameters.hpp"

namespace gonogo::reference::rs274 {

struct Machine;

// NGC-EXP-07: bits of a number that is still kept, for programs that calculate can make it grow
// without end.
inline constexpr std::size_t kLongest = 16'384;

// NGC-EXP-02
inline Number truth(bool holds) {
  return holds ? 1 : 0;
}

class Calculator {
 public:
  Calculator(const Machine& machine, Parameters& parameters, const ReadingsInUse& readings)
      : machine_(machine), parameters_(parameters), readings_(readings) {}

  // The value. Nothing once a rule was broken, or where something is not read: alarm or outside
  // says which.
  std::optional<Number> value(const grammar::Block& block, const grammar::TermRange& range);
  // NGC-PAR-02: the settings of the block, which take effect together. False after a problem.
  bool assign(const grammar::Block& block);

  std::optional<Alarm> alarm;
  std::optional<NotCovered> outside;  // without its block

 private:
  bool apply(const grammar::Block& block, const grammar::Term& term);
  bool apply_one(const grammar::Term& term);
  bool apply_two(const grammar::Term& term);
  bool holds(grammar::TermKind kind, const Number& left, const Number& right) const;
  bool apply_power(const grammar::Term& term, Number& left, const Number& right);
  bool push_numbered(const grammar::Term& term);
  bool push_named(const std::string& name, const grammar::Term& term);
  std::optional<std::int64_t> number_of_parameter(const Number& value, const grammar::Span& where);
  std::optional<Number> of_machine(std::int64_t number) const;
  std::optional<Number> of_machine(std::string_view name) const;
  bool are_equal(const Number& left, const Number& right) const;
  bool fail(AlarmClass alarm_class, ClauseId clause, const grammar::Span& where,
            std::string message);
  bool leave_out(std::string code, const grammar::Span& where, std::string message);
  bool is_kept(const grammar::Term& term);

  const Machine& machine_;
  Parameters& parameters_;
  const ReadingsInUse& readings_;
  std::vector<Number> stack_;
};

}  // namespace gonogo::reference::rs274
