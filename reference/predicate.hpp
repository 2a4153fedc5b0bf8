// SPDX-License-Identifier: GPL-3.0-or-later
//
// A comparison on which a clause depends. It has three outcomes, of which two are often one
// decision (below and at a limit). An observer can learn which of them programs have met; the
// reference does not depend on it.
#pragma once

#include <array>
#include <compare>
#include <initializer_list>
#include <string_view>

#include "reference/axis.hpp"
#include "reference/clause.hpp"

namespace gonogo::reference {

// What was decided, for the observer. Both hold until `note` returns.
struct Decision {
  // `what` is an expression with the letters of the words, "L - 2 D". kNoClause: the decision is
  // one of the geometry on which several clauses stand.
  ClauseId clause = kNoClause;
  std::string_view what;
  int sign = 0;  // of the expression: -1, 0 or 1
  Number value;  // of the expression; of roots it is 0
  // Lengths whose squares alone are known, um^2, each with its factor. The expression is the size
  // of the sum of the first two, plus the third.
  struct Root {
    int factor = 0;
    Number square;
  };
  std::array<Root, 3> roots{};
};

// Takes the reference's decisions in its own thread, while it lives. Several live as on a stack:
// the one that was made last takes the decisions.
class DecisionWatch {
 public:
  DecisionWatch();
  DecisionWatch(const DecisionWatch&) = delete;
  DecisionWatch& operator=(const DecisionWatch&) = delete;
  virtual ~DecisionWatch();
  virtual void note(const Decision& decision) = 0;

 private:
  DecisionWatch* before_;
};

constexpr int sign_of(std::strong_ordering order) {
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

// The sign of `value`, or of a - b, as the clause has it decided. Throws exact::Undecided as the
// comparison does.
int decided(ClauseId clause, std::string_view what, const Number& value);
int decided(ClauseId clause, std::string_view what, const Number& a, const Number& b);

// Whether this thread has an observer: then no decision may be omitted.
bool decisions_are_watched();

// The sign of an expression of roots, as their squares say it.
int decided_by_roots(std::string_view what, int sign, std::initializer_list<Decision::Root> roots);

}  // namespace gonogo::reference
