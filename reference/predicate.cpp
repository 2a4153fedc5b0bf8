// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/predicate.hpp"

#include <algorithm>
#include <utility>

namespace gonogo::reference {
namespace {

thread_local DecisionWatch* innermost = nullptr;

}  // namespace

DecisionWatch::DecisionWatch() : before_(std::exchange(innermost, this)) {}
DecisionWatch::~DecisionWatch() {
  innermost = before_;
}

int decided(ClauseId clause, std::string_view what, const Number& value) {
  const int sign = value.sign();
  if (innermost != nullptr) innermost->note({clause, what, sign, value});
  return sign;
}

int decided(ClauseId clause, std::string_view what, const Number& a, const Number& b) {
  const int sign = sign_of(a <=> b);
  if (innermost != nullptr) innermost->note({clause, what, sign, a - b});
  return sign;
}

bool decisions_are_watched() {
  return innermost != nullptr;
}

int decided_by_roots(std::string_view what, int sign, std::initializer_list<Decision::Root> roots) {
  if (innermost != nullptr) {
    Decision decision{kNoClause, what, sign, 0};
    std::ranges::copy(roots, decision.roots.begin());
    innermost->note(decision);
  }
  return sign;
}

}  // namespace gonogo::reference
