// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an operation on enclosures comes to without evaluation. Multiples of one expression are
// added up, and products have one form: points on one ray, r1 * cos(a) and r2 * cos(a), are then
// seen to be on it, which no interval could show.
#include <utility>

#include "reference/exact/enclosure.hpp"

namespace gonogo::exact {
namespace {

bool is(const Number& value, int wanted) {
  return value.is_rational() && value == Number(wanted);
}

// value = offset + factor * core, with rational offset and factor.
struct Linear {
  Number offset = 0;
  Number factor = 1;
  Number core;
};

Linear multiple(const Number& value) {
  const EnclosureNode* node = enclosure_node(value);
  if (node == nullptr) return {0, 1, value};
  if (node->operation == Operation::negate) return {0, -1, node->left};
  if (node->operation == Operation::multiply && node->left.is_rational()) {
    return {0, node->left, node->right};
  }
  return {0, 1, value};
}

Linear linear(const Number& value) {
  const EnclosureNode* node = enclosure_node(value);
  const bool has_offset =
      node != nullptr && node->operation == Operation::add && node->left.is_rational();
  if (!has_offset) return multiple(value);
  Linear result = multiple(node->right);
  result.offset = node->left;
  return result;
}

// k * core in the one form.
Number scaled(const Number& k, const Number& core) {
  if (core.form() != Number::Form::enclosure) return k * core;
  if (k.sign() == 0) return 0;
  if (is(k, 1)) return core;
  if (is(k, -1)) return plain_enclosure(Operation::negate, core);
  return plain_enclosure(Operation::multiply, k, core);
}

// offset + rest in the one form. REQUIRES: `rest` is no sum with a rational number.
Number with_offset(const Number& offset, const Number& rest) {
  if (rest.form() != Number::Form::enclosure) return offset + rest;
  return is(offset, 0) ? rest : plain_enclosure(Operation::add, offset, rest);
}

Number times(const Number& k, const Number& value) {
  const Linear term = linear(value);
  return with_offset(k * term.offset, scaled(k * term.factor, term.core));
}

Number product(const Number& x, const Number& y) {
  if (x.is_rational()) return times(x, y);
  if (y.is_rational()) return times(y, x);
  const Linear a = multiple(x);
  const Linear b = multiple(y);
  const Number factor = a.factor * b.factor;
  const EnclosureNode* node = enclosure_node(a.core);
  const bool is_square = node != nullptr && same_expression(a.core, b.core);
  if (is_square && node->operation == Operation::sqrt) return factor * node->left;
  const bool in_order = hash_of(a.core) <= hash_of(b.core);
  return scaled(factor, plain_enclosure(Operation::multiply, in_order ? a.core : b.core,
                                        in_order ? b.core : a.core));
}

// What is left of a sum or difference when a term of it cancels out: (a + b) - a, x - (x + b), ...
std::optional<Number> cancelled(Operation operation, const Number& x, const Number& y) {
  const bool adds = operation == Operation::add;
  const EnclosureNode* const left = enclosure_node(x);
  const EnclosureNode* const right = enclosure_node(y);
  if (left != nullptr && left->operation == Operation::add && !adds) {
    if (same_expression(left->left, y)) return left->right;
    if (same_expression(left->right, y)) return left->left;
  }
  if (left != nullptr && left->operation == Operation::subtract) {
    if (adds && same_expression(left->right, y)) return left->left;
    if (!adds && same_expression(left->left, y)) return -left->right;
  }
  if (right != nullptr && right->operation == Operation::add && !adds) {
    if (same_expression(right->left, x)) return -right->right;
    if (same_expression(right->right, x)) return -right->left;
  }
  if (right != nullptr && right->operation == Operation::subtract) {
    if (adds && same_expression(right->right, x)) return right->left;
    if (!adds && same_expression(right->left, x)) return right->right;
  }
  return std::nullopt;
}

// x + y or x - y.
Number sum(Operation operation, const Number& x, const Number& y) {
  const bool adds = operation == Operation::add;
  const auto plus = [adds](const Number& a, const Number& b) { return adds ? a + b : a - b; };
  if (x.is_rational()) {
    const Linear term = linear(y);
    return with_offset(plus(x, term.offset), scaled(adds ? term.factor : -term.factor, term.core));
  }
  if (y.is_rational()) {
    const Linear term = linear(x);
    return with_offset(plus(term.offset, y), scaled(term.factor, term.core));
  }
  const Linear a = linear(x);
  const Linear b = linear(y);
  const Number offset = plus(a.offset, b.offset);
  if (same_expression(a.core, b.core)) {
    return with_offset(offset, scaled(plus(a.factor, b.factor), a.core));
  }
  const Number first = scaled(a.factor, a.core);
  const Number second = scaled(b.factor, b.core);
  if (const auto left = cancelled(operation, first, second)) return offset + *left;
  return with_offset(offset, plain_enclosure(operation, first, second));
}

}  // namespace

std::optional<Number> simplified(Operation operation, const Number& x, const Number& y) {
  switch (operation) {
    case Operation::negate:
      return times(-1, x);
    case Operation::add:
    case Operation::subtract:
      return sum(operation, x, y);
    case Operation::multiply:
      return product(x, y);
    case Operation::divide:
      if (is(x, 0)) return Number(0);
      if (is(y, 1)) return x;
      if (same_expression(x, y)) return Number(1);
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace gonogo::exact
