// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 64-bit form of a number is a filter before GMP, which is the definition: all that is worked
// out in it is the very number, in the very form, that rationals of GMP come to. GONOGO_TRIALS says
// how many pairs are tried.
#include <gtest/gtest.h>

#include <limits>

#include "reference/exact/rational.hpp"
#include "tests/trials.hpp"

namespace gonogo::exact {
namespace {

// Millionths of every size: those of programs, whole millimetres, the borders of 64 bits.
std::int64_t any_count(Chance& chance) {
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  const auto bits = static_cast<std::int64_t>(chance.bits());
  switch (chance.below(6)) {
    case 0:
      return bits >> (chance.below(63));
    case 1:
      return (bits >> 44) * detail::kUnit;
    case 2:
      return (bits >> 40) * 1000;
    case 3:
      return static_cast<std::int64_t>(chance.below(20)) - 10;
    case 4:
      return kMost - static_cast<std::int64_t>(chance.below(3));
    default:
      return kLeast + static_cast<std::int64_t>(chance.below(3));
  }
}

// The same number in the same form.
bool identical(const Number& a, const Number& b) {
  const bool small = NumberAccess::node(a) == nullptr;
  return small == (NumberAccess::node(b) == nullptr) && NumberAccess::compare(a, b) == 0;
}

TEST(SmallForm, ComesToWhatRationalsComeTo) {
  each_trial(100'000, [](Chance& chance) {
    const Number a = Number::millionths(any_count(chance));
    const Number b = Number::millionths(any_count(chance));
    const mpq_class x = rational_of(a);
    const mpq_class y = rational_of(b);
    const std::string what = a.text() + " and " + b.text();
    ASSERT_TRUE(identical(a + b, number_of(mpq_class(x + y)))) << what;
    ASSERT_TRUE(identical(a - b, number_of(mpq_class(x - y)))) << what;
    ASSERT_TRUE(identical(a * b, number_of(mpq_class(x * y)))) << what;
    ASSERT_TRUE(identical(-a, number_of(mpq_class(-x)))) << what;
    ASSERT_EQ(a.sign(), sgn(x)) << what;
    ASSERT_EQ(a < b, x < y) << what;
    ASSERT_EQ(a == b, x == y) << what;
    ASSERT_TRUE(identical(a.floor(), number_of(floor_of(x)))) << what;
    if (b.sign() != 0) {
      ASSERT_TRUE(identical(a / b, number_of(mpq_class(x / y)))) << what;
    }
    ASSERT_TRUE(identical(*Number::parse(a.text()), a)) << what;
  });
}

// a + b sqrt(c/d), as the centre of an arc by its radius: quotients of squares, near them, any.
TEST(SmallForm, RootsAreThoseOfRationals) {
  each_trial(50'000, [](Chance& chance) {
    const auto root = static_cast<std::int64_t>(chance.below(3000)) + 1;
    const auto part = static_cast<std::int64_t>(chance.below(60)) + 1;
    const auto off = chance.once_in(2) ? 0 : static_cast<std::int64_t>(chance.below(3));
    const auto factor = static_cast<std::int64_t>(chance.below(9)) + 1;
    const Number c = Number::millionths((root * root + off) * factor);
    const Number d = Number::millionths(part * part * factor);
    const std::array<Number, 2> a = {Number::millionths(any_count(chance)), Number(root)};
    const std::array<Number, 2> b = {Number::millionths(any_count(chance)), Number(-part)};
    const std::array<Number, 2> both = Number::roots(a, b, c, d);
    for (std::size_t k : {0U, 1U}) {
      const Number want = Number::root(a[k], b[k], c / d);
      ASSERT_EQ(both[k].text(), want.text());
      ASSERT_EQ(both[k].form(), want.form());
    }
  });
}

}  // namespace
}  // namespace gonogo::exact
