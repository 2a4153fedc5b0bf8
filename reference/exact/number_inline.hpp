// SPDX-License-Identifier: GPL-3.0-or-later
//
// The small path of exact::Number: 64-bit integers of 1e-6 with overflow checks, inline. What
// does not fit goes to NumberAccess, out of line. Included at the end of number.hpp only.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <utility>

#include "reference/exact/number.hpp"  // IWYU pragma: keep

namespace gonogo::exact {

// The head of every heap representation. Numbers may be read by several threads at once, so the
// count is atomic; everything else in a node is fixed when it is made.
struct Node {
  explicit Node(Number::Form its_form) noexcept : form(its_form) {}
  std::atomic<std::uint32_t> count{1};
  const Number::Form form;
};

struct NumberAccess {
  static Number adopt(Node* node) noexcept { return Number(node); }
  static Node* node(const Number& value) noexcept { return value.node_; }
  static std::int64_t millionths(const Number& value) noexcept { return value.millionths_; }
  static Node* steal(Number& value) noexcept { return std::exchange(value.node_, nullptr); }

  // Frees the node where nobody else has it.
  static void release(Node* node) noexcept;
  static Number large_integer(std::int64_t value) noexcept;
  static Number add(const Number& a, const Number& b);
  static Number subtract(const Number& a, const Number& b);
  static Number multiply(const Number& a, const Number& b);
  static Number divide(const Number& a, const Number& b);
  static Number negate(const Number& a);
  static Number abs(const Number& a);
  static int sign(const Number& a);
  static int compare(const Number& a, const Number& b);
};

namespace detail {

inline constexpr std::int64_t kUnit = 1'000'000;  // millionths in one
__extension__ using Wide = __int128;

// a * b / 10^6 in `product` when it is exact and fits. Most products stay within 64 bits, where
// the division by a constant is a multiplication.
inline bool small_product(std::int64_t a, std::int64_t b, std::int64_t& product) noexcept {
  std::int64_t narrow = 0;
  if (!__builtin_mul_overflow(a, b, &narrow)) {
    product = narrow / kUnit;
    return product * kUnit == narrow;
  }
  if (a % kUnit == 0) return !__builtin_mul_overflow(a / kUnit, b, &product);
  if (b % kUnit == 0) return !__builtin_mul_overflow(a, b / kUnit, &product);
  const Wide wide = static_cast<Wide>(a) * b;
  const Wide quotient = wide / kUnit;
  if (quotient * kUnit != wide) return false;
  product = static_cast<std::int64_t>(quotient);
  return product == quotient;
}

}  // namespace detail

inline Number::Number(std::int64_t value) noexcept {
  if (__builtin_mul_overflow(value, detail::kUnit, &millionths_)) {
    millionths_ = 0;
    *this = NumberAccess::large_integer(value);
  }
}

// In units of many files g++ calls even what is smaller than a call, unless it has to inline it.
[[gnu::always_inline]] inline Number::Number(const Number& other) noexcept
    : millionths_(other.millionths_), node_(other.node_) {
  if (node_ != nullptr) node_->count.fetch_add(1, std::memory_order_relaxed);
}

[[gnu::always_inline]] inline Number::Number(Number&& other) noexcept
    : millionths_(std::exchange(other.millionths_, 0)),
      node_(std::exchange(other.node_, nullptr)) {}

[[gnu::always_inline]] inline Number::~Number() {
  if (node_ != nullptr) NumberAccess::release(node_);
}

[[gnu::always_inline]] inline Number& Number::operator=(Number&& other) noexcept {
  std::swap(millionths_, other.millionths_);
  std::swap(node_, other.node_);
  return *this;
}

[[gnu::always_inline]] inline Number& Number::operator=(const Number& other) noexcept {
  return *this = Number(other);
}

inline Number Number::millionths(std::int64_t count) noexcept {
  Number value;
  value.millionths_ = count;
  return value;
}

inline Number::Form Number::form() const noexcept {
  return node_ == nullptr ? Form::rational : node_->form;
}

[[gnu::always_inline]] inline int Number::sign() const {
  if (node_ != nullptr) return NumberAccess::sign(*this);
  return (millionths_ > 0) - (millionths_ < 0);
}

[[gnu::always_inline]] inline Number operator+(const Number& a, const Number& b) {
  std::int64_t sum = 0;
  if (a.node_ == nullptr && b.node_ == nullptr &&
      !__builtin_add_overflow(a.millionths_, b.millionths_, &sum)) {
    return Number::millionths(sum);
  }
  return NumberAccess::add(a, b);
}

[[gnu::always_inline]] inline Number operator-(const Number& a, const Number& b) {
  std::int64_t difference = 0;
  if (a.node_ == nullptr && b.node_ == nullptr &&
      !__builtin_sub_overflow(a.millionths_, b.millionths_, &difference)) {
    return Number::millionths(difference);
  }
  return NumberAccess::subtract(a, b);
}

inline Number operator*(const Number& a, const Number& b) {
  std::int64_t product = 0;
  if (a.node_ == nullptr && b.node_ == nullptr &&
      detail::small_product(a.millionths_, b.millionths_, product)) {
    return Number::millionths(product);
  }
  return NumberAccess::multiply(a, b);
}

inline Number operator/(const Number& a, const Number& b) {
  return NumberAccess::divide(a, b);
}

inline Number Number::operator-() const {
  if (node_ == nullptr && millionths_ != std::numeric_limits<std::int64_t>::min()) {
    return millionths(-millionths_);
  }
  return NumberAccess::negate(*this);
}

inline Number abs(const Number& value) {
  if (NumberAccess::node(value) != nullptr) return NumberAccess::abs(value);
  return NumberAccess::millionths(value) < 0 ? -value : value;
}

[[gnu::always_inline]] inline int Number::compare(const Number& a, const Number& b) {
  if (a.node_ == nullptr && b.node_ == nullptr) {
    return (a.millionths_ > b.millionths_) - (a.millionths_ < b.millionths_);
  }
  return NumberAccess::compare(a, b);
}

}  // namespace gonogo::exact
