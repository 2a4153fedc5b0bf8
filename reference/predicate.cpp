// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/predicate.hpp"

#include <utility>

namespace gonogo::reference {
namespace {

thread_local SignWatch* innermost = nullptr;

int told(ClauseId clause, std::string_view what, int sign) {
  if (innermost != nullptr) innermost->note(clause, what, sign);
  return sign;
}

}  // namespace

SignWatch::SignWatch() : before_(std::exchange(innermost, this)) {}
SignWatch::~SignWatch() {
  innermost = before_;
}

int decided(ClauseId clause, std::string_view what, const Number& value) {
  return told(clause, what, value.sign());
}

int decided(ClauseId clause, std::string_view what, const Number& a, const Number& b) {
  const std::strong_ordering order = a <=> b;
  return told(clause, what, order < 0 ? -1 : order > 0 ? 1 : 0);
}

}  // namespace gonogo::reference
