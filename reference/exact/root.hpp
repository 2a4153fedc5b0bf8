// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers a + b*sqrt(c): closed under + - * / for one radicand, ordered exactly for two.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>

#include "reference/exact/rational.hpp"

namespace gonogo::exact {

// A rational has b = 0 and c = 0; else c is an integer > 1 and not a square.
struct Root {
  mpq_class a;
  mpq_class b;
  mpz_class c;
};

struct RootNode final : Node {
  explicit RootNode(Root its_value) : Node(Number::Form::root), value(std::move(its_value)) {}
  RootNode(std::int64_t a_millionths, mpq_class b, mpz_class c)
      : Node(Number::Form::root),
        value{rational_of_millionths(a_millionths), std::move(b), std::move(c)} {}
  const Root value;  // b != 0
};

// REQUIRES: value is a rational or a root.
Root root_of(const Number& value);
Number number_of(Root value);
// a + b*sqrt(c) of any rational c >= 0, brought to the form above.
Root make_root(mpq_class a, mpq_class b, const mpq_class& c);

// Number::roots without GMP except for its result; nothing where 64 bits do not suffice for that,
// or where the result is rational.
std::optional<std::array<Number, 2>> small_roots(const std::array<Number, 2>& a,
                                                 const std::array<Number, 2>& b, const Number& c,
                                                 const Number& d);

// Nothing where the result is no single root.
std::optional<Root> add(const Root& x, const Root& y);
std::optional<Root> multiply(const Root& x, const Root& y);
// REQUIRES: x is not zero.
Root inverse(const Root& x);
Root negate(Root x);
// REQUIRES: x >= 0.
std::optional<Root> sqrt_of(const Root& x);

int sign_of(const Root& x);
int compare(const Root& x, const Root& y);
mpz_class floor_of(const Root& x);

}  // namespace gonogo::exact
