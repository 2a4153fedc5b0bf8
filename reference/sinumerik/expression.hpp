// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of words, and the R parameters that they are calculated from. All of it exact.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/axis.hpp"

namespace gonogo::reference::sinumerik {

inline constexpr std::uint64_t kParameters = 1000;     // R0 to R999
inline constexpr std::uint64_t kParameters802s = 300;  // R0 to R299

// Why there is no value.
struct NoValue {
  grammar::Span where;
  std::string message;       // a sentence
  bool is_too_long = false;  // exact, but of more digits than the gauge keeps; else out of range
};

class Calculator {
 public:
  // Takes a control with R0 to R`count - 1`. REQUIRES: count <= kParameters.
  explicit Calculator(std::uint64_t count) : count_(count) {}
  std::uint64_t count() const { return count_; }
  // The value of a word that has one; nothing after `problem` was filled.
  std::optional<Number> value(const grammar::Block& block, const grammar::NamedWord& word,
                              NoValue& problem);
  // REQUIRES: number < count().
  const Number& parameter(std::uint64_t number) const {
    const auto place = static_cast<std::size_t>(number);
    return place < parameters_.size() ? parameters_[place] : never_assigned_;
  }
  void assign(std::uint64_t number, Number value) {
    const auto place = static_cast<std::size_t>(number);
    if (place >= parameters_.size()) parameters_.resize(place + 1);
    parameters_[place] = std::move(value);
  }

 private:
  bool apply(const grammar::Term& term, NoValue& problem);
  bool apply_function(const grammar::Term& term, NoValue& problem);
  bool push_parameter(const grammar::Term& term, NoValue& problem);

  std::uint64_t count_;
  std::vector<Number> parameters_;  // up to the last that was assigned
  Number never_assigned_;           // 0
  std::vector<Number> stack_;
};

}  // namespace gonogo::reference::sinumerik
