// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dispatch of exact::Number: rational with rational, root with root, else an enclosure.
#include "reference/exact/number.hpp"

#include <stdexcept>
#include <utility>

#include "reference/exact/enclosure.hpp"
#include "reference/exact/rational.hpp"
#include "reference/exact/root.hpp"

namespace gonogo::exact {
namespace {

using Form = Number::Form;

Form joint_form(const Number& a, const Number& b) {
  return std::max(a.form(), b.form());
}

template <typename RationalOperation, typename RootOperation>
Number combine(const Number& a, const Number& b, Operation fallback, RationalOperation of_rationals,
               RootOperation of_roots) {
  const Form form = joint_form(a, b);
  if (form == Form::rational) {
    mpq_class scratch_a;
    mpq_class scratch_b;
    return number_of(mpq_class(of_rationals(rational_of(a, scratch_a), rational_of(b, scratch_b))));
  }
  if (form == Form::root) {
    if (std::optional<Root> result = of_roots(root_of(a), root_of(b))) {
      return number_of(*std::move(result));
    }
  }
  return enclosure(fallback, a, b);
}

// a / b of small forms where the quotient is small again.
std::optional<Number> small_quotient(const Number& a, const Number& b) {
  if (NumberAccess::node(a) != nullptr || NumberAccess::node(b) != nullptr) return std::nullopt;
  const std::int64_t divisor = NumberAccess::millionths(b);
  // By a small whole number, nearly always 2: 128 bits take ten times as long.
  const std::int64_t whole = divisor / detail::kUnit;
  const std::int64_t count_a = NumberAccess::millionths(a);
  if (whole > 0 && whole * detail::kUnit == divisor && count_a % whole == 0) {
    return Number::millionths(count_a / whole);
  }
  const detail::Wide dividend = static_cast<detail::Wide>(count_a) * detail::kUnit;
  const detail::Wide quotient = dividend / divisor;
  const auto count = static_cast<std::int64_t>(quotient);
  if (count != quotient || quotient * divisor != dividend) return std::nullopt;
  return Number::millionths(count);
}

}  // namespace

void NumberAccess::release(Node* node) noexcept {
  if (node->count.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
  switch (node->form) {
    case Form::rational:
      delete static_cast<RationalNode*>(node);
      break;
    case Form::root:
      delete static_cast<RootNode*>(node);
      break;
    case Form::enclosure:
      destroy_enclosure(node);
      break;
  }
}

Number NumberAccess::large_integer(std::int64_t value) noexcept {
  return number_of(integer_of(value));
}

Number NumberAccess::add(const Number& a, const Number& b) {
  return combine(
      a, b, Operation::add, [](const mpq_class& x, const mpq_class& y) { return mpq_class(x + y); },
      [](const Root& x, const Root& y) { return exact::add(x, y); });
}

Number NumberAccess::subtract(const Number& a, const Number& b) {
  return combine(
      a, b, Operation::subtract,
      [](const mpq_class& x, const mpq_class& y) { return mpq_class(x - y); },
      [](const Root& x, const Root& y) { return exact::add(x, exact::negate(y)); });
}

Number NumberAccess::multiply(const Number& a, const Number& b) {
  return combine(
      a, b, Operation::multiply,
      [](const mpq_class& x, const mpq_class& y) { return mpq_class(x * y); },
      [](const Root& x, const Root& y) { return exact::multiply(x, y); });
}

Number NumberAccess::divide(const Number& a, const Number& b) {
  if (b.sign() == 0) throw std::domain_error("exact: division by zero");
  if (auto small = small_quotient(a, b)) return *std::move(small);
  return combine(
      a, b, Operation::divide,
      [](const mpq_class& x, const mpq_class& y) { return mpq_class(x / y); },
      [](const Root& x, const Root& y) { return exact::multiply(x, inverse(y)); });
}

Number NumberAccess::negate(const Number& a) {
  switch (a.form()) {
    case Form::rational:
      return number_of(mpq_class(-rational_of(a)));
    case Form::root:
      return number_of(exact::negate(root_of(a)));
    case Form::enclosure:
      break;
  }
  return enclosure(Operation::negate, a);
}

int NumberAccess::sign(const Number& a) {
  switch (a.form()) {
    case Form::rational:
      return sgn(rational_of(a));
    case Form::root:
      return sign_of(root_of(a));
    case Form::enclosure:
      break;
  }
  return sign_of_enclosure(a);
}

int NumberAccess::compare(const Number& a, const Number& b) {
  switch (joint_form(a, b)) {
    case Form::rational: {
      mpq_class scratch_a;
      mpq_class scratch_b;
      const int order = cmp(rational_of(a, scratch_a), rational_of(b, scratch_b));
      return (order > 0) - (order < 0);
    }
    case Form::root:
      return exact::compare(root_of(a), root_of(b));
    case Form::enclosure:
      break;
  }
  return compare_enclosures(a, b);
}

Number Number::root(const Number& a, const Number& b, const Number& c) {
  if (c.sign() < 0) throw std::domain_error("exact: the square root of a negative number");
  const mpq_class radicand = require_rational(c);
  mpq_class factor = require_rational(b);
  if (const auto square_root = exact_sqrt(radicand)) {
    return number_of(mpq_class(require_rational(a) + factor * *square_root));
  }
  return number_of(make_root(require_rational(a), std::move(factor), radicand));
}

std::array<Number, 2> Number::roots(const std::array<Number, 2>& a, const std::array<Number, 2>& b,
                                    const Number& c, const Number& d) {
  if (auto small = small_roots(a, b, c, d)) return *std::move(small);
  const Number square_root = sqrt(c / d);
  return {a[0] + b[0] * square_root, a[1] + b[1] * square_root};
}

Number Number::between(const Number& low, const Number& high) {
  if (!low.is_rational() || !high.is_rational() || high < low) {
    throw std::invalid_argument("exact: between takes two rationals in order");
  }
  if (low == high) return low;
  return enclosure(Operation::between, low, high);
}

Number Number::floor() const {
  switch (form()) {
    case Form::rational:
      return number_of(floor_of(rational_of(*this)));
    case Form::root:
      return number_of(floor_of(root_of(*this)));
    case Form::enclosure:
      break;
  }
  return floor_of_enclosure(*this);
}

Number Number::ceil() const {
  return -(-*this).floor();
}

std::optional<std::int64_t> Number::to_int64() const {
  if (node_ == nullptr) {
    if (millionths_ % detail::kUnit != 0) return std::nullopt;
    return millionths_ / detail::kUnit;
  }
  if (form() == Form::enclosure) (void)floor();  // no whole number where this does not throw
  if (form() != Form::rational) return std::nullopt;
  mpq_class scratch;
  const mpq_class& value = rational_of(*this, scratch);
  if (value.get_den() != 1) return std::nullopt;
  return int64_of(value.get_num());
}

std::array<Number, 2> Number::bounds(int bits) const {
  if (form() == Form::rational) return {*this, *this};
  if (form() == Form::enclosure) return bounds_of_enclosure(*this, bits);
  const Number step = binary(1, -std::max(bits, 0));
  const Number low = (*this / step).floor() * step;
  return {low, low + step};
}

std::array<std::string, 2> Number::fraction() const {
  const mpq_class value = require_rational(*this);
  return {value.get_num().get_str(), value.get_den().get_str()};
}

std::array<Number, 3> Number::root_parts() const {
  if (form() != Form::root) throw std::invalid_argument("exact: root_parts takes a root");
  const Root root = root_of(*this);
  return {number_of(root.a), number_of(root.b), number_of(root.c)};
}

std::optional<int> Number::try_sign() const {
  return form() == Form::enclosure ? try_sign_of_enclosure(*this) : sign();
}

// What may be zero is as large as its width at most.
Number NumberAccess::abs(const Number& value) {
  const std::optional<int> sign = value.try_sign();
  if (!sign) return sqrt(value * value);
  return *sign < 0 ? -value : value;
}

namespace {

bool is_surely_below(const Number& a, const Number& b) {
  try {
    return a < b;
  } catch (const Undecided&) {
    return false;
  }
}

}  // namespace

// Takes the first of two enclosures that the last refinement does not tell apart: they differ by
// less than any question that it decides.
const Number& min(const Number& a, const Number& b) {
  return is_surely_below(b, a) ? b : a;
}
const Number& max(const Number& a, const Number& b) {
  return is_surely_below(a, b) ? b : a;
}

Number sqrt(const Number& value) {
  const EnclosureNode* const node = enclosure_node(value);
  // An enclosure may reach below zero by its width alone; what cannot be zero or more is an error.
  const int sign = node != nullptr ? node->base.sign() : value.sign();
  if (sign < 0) throw std::domain_error("exact: the square root of a negative number");
  if (node == nullptr) {
    if (auto root = sqrt_of(root_of(value))) return number_of(*std::move(root));
  }
  return enclosure(Operation::sqrt, value);
}

}  // namespace gonogo::exact
