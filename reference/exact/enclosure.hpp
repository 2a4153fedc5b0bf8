// SPDX-License-Identifier: GPL-3.0-or-later
//
// Enclosures: values that are known as an expression over rationals and roots and can be enclosed
// as tightly as wanted. Evaluation walks the expression with a stack of its own, release with a
// list through its nodes, so a long chain costs time and memory, never the program's stack; closed
// forms keep it short.
#pragma once

#include <optional>

#include "reference/exact/interval.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::exact {

enum class Operation : std::uint8_t {
  between,  // a value in [left, right] of which no more is known
  negate,
  add,
  subtract,
  multiply,
  divide,
  sqrt,
  root,  // of the degree `right`, a whole number
  cos_degrees,
  sin_degrees,
  atan_degrees,  // the angle in (-90, 90) whose tangent is `left`
  radians,       // of degrees
};

struct EnclosureNode final : Node {
  EnclosureNode(Operation its_operation, Number its_left, Number its_right);
  const Operation operation;
  const bool refinable;       // no `between` in it
  const std::uint32_t depth;  // of the tree of operations: 1 + that of the deeper operand
  Number left;                // given up only by destroy_enclosure
  Number right;
  const std::uint64_t hash;       // of the structure
  const Interval base;            // at kBaseBits
  EnclosureNode* next = nullptr;  // of those that destroy_enclosure still has to free
};

inline constexpr mpfr_prec_t kBaseBits = 128;
inline constexpr mpfr_prec_t kLastBits = 4096;  // of sign and comparison
// Where a `between` is in it, more digits add nothing but the rounding of its ends.
inline constexpr mpfr_prec_t kLastBitsOfBetween = 256;

// Simplifies what needs no evaluation (x + 0, x - x, x * 0, 2x + 3x, ...).
Number enclosure(Operation operation, const Number& left, const Number& right = Number());
// Without that.
Number plain_enclosure(Operation operation, const Number& left, const Number& right = Number());
// In simplify.cpp. x op y as another number, where that holds for every value of the operands.
// Products come in one form, k * (x * y) with a rational k first, so that equal ones show.
std::optional<Number> simplified(Operation operation, const Number& x, const Number& y);
// REQUIRES: x is an enclosure. Frees it and what only it holds, and needs no memory for that.
void destroy_enclosure(Node* node) noexcept;

Interval interval_of(const Number& value, mpfr_prec_t bits);
// The bounds of the expression.
std::uint64_t hash_of(const Number& value);
// Whether two numbers are one by construction; false says nothing.
bool same_expression(const Number& x, const Number& y);

// The interval of x at rising precision until `decided(interval)` is true: the last of them, or
// nothing when `last_bits` are not enough.
template <typename Decided>
std::optional<Interval> refine(const Number& x, mpfr_prec_t last_bits, Decided decided);

// Nothing when kLastBits do not decide.
std::optional<int> try_sign_of_enclosure(const Number& x);
// At least one is an enclosure. Throw Undecided.
int sign_of_enclosure(const Number& x);
int compare_enclosures(const Number& x, const Number& y);
Number floor_of_enclosure(const Number& x);
std::array<Number, 2> bounds_of_enclosure(const Number& x, int bits);

inline const EnclosureNode* enclosure_node(const Number& value) {
  if (value.form() != Number::Form::enclosure) return nullptr;
  return static_cast<const EnclosureNode*>(NumberAccess::node(value));
}

inline bool is_refinable(const Number& value) {
  const EnclosureNode* node = enclosure_node(value);
  return node == nullptr || node->refinable;
}

template <typename Decided>
std::optional<Interval> refine(const Number& x, mpfr_prec_t last_bits, Decided decided) {
  const mpfr_prec_t last = is_refinable(x) ? last_bits : kLastBitsOfBetween;
  for (mpfr_prec_t bits = kBaseBits; bits <= last; bits *= 2) {
    Interval interval = interval_of(x, bits);
    if (decided(interval)) return interval;
  }
  return std::nullopt;
}

}  // namespace gonogo::exact
