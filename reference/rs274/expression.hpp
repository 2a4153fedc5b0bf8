// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of words, settings and conditions. All of it exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

// NGC-EXP-08: whether a double can be this number.
bool is_double(const Number& number);
inline Value as_doubles_have(Number number) {
  const bool is_rounded = !is_double(number);
  return {std::move(number), is_rounded};
}

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
  // The same, and whether it is rounded.
  std::optional<Value> calculated(const grammar::Block& block, const grammar::TermRange& range);
  // NGC-EXP-02: whether the value is true; nothing as above.
  std::optional<bool> is_true(const grammar::Block& block, const grammar::TermRange& range);
  // NGC-PAR-02: the settings of the block, which take effect together. False after a problem.
  bool assign(const grammar::Block& block);

  std::optional<Alarm> alarm;
  std::optional<NotCovered> outside;  // without its block

 private:
  bool apply(const grammar::Block& block, const grammar::Term& term);
  bool apply_one(const grammar::Term& term);
  bool take_root(const grammar::Term& term);
  bool apply_two(const grammar::Term& term);
  bool holds(grammar::TermKind kind, const Number& left, const Number& right) const;
  bool is_doubtful(grammar::TermKind kind, const Value& left, const Value& right) const;
  bool is_doubtful(grammar::TermKind kind, const Value& value) const;
  bool leave_to_doubles(const grammar::Span& where);
  bool apply_power(const grammar::Term& term, Number& left, const Number& right);
  bool push_numbered(const grammar::Term& term);
  bool push_named(const std::string& name, const grammar::Term& term);
  std::optional<std::int64_t> number_of_parameter(const Number& value, const grammar::Span& where);
  std::optional<Value> of_machine(std::int64_t number) const;
  std::optional<Value> of_machine(std::string_view name) const;
  bool are_equal(const Number& left, const Number& right) const;
  bool fail(AlarmClass alarm_class, ClauseId clause, const grammar::Span& where,
            std::string message);
  bool leave_out(std::string code, const grammar::Span& where, std::string message);
  bool is_kept(const grammar::Term& term);

  const Machine& machine_;
  Parameters& parameters_;
  const ReadingsInUse& readings_;
  std::vector<Value> stack_;
};

}  // namespace gonogo::reference::rs274
