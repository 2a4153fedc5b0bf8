// SPDX-License-Identifier: GPL-3.0-or-later
//
// Roots and enclosures against integer square roots of 600 bits.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tuple>

#include "reference/exact/number.hpp"
#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::exact {
namespace {

using testing::model_of;

constexpr unsigned long kModelBits = 600;

// [low, high] / 2^kModelBits holds the value.
struct Model {
  mpz_class low;
  mpz_class high;
};

struct RootWithModel {
  Model model;
  Number number;
};

mpz_class scaled_floor(const mpq_class& value) {
  mpz_class floor;
  const mpz_class scaled = value.get_num() << kModelBits;
  mpz_fdiv_q(floor.get_mpz_t(), scaled.get_mpz_t(), value.get_den_mpz_t());
  return floor;
}

// a + b*sqrt(c), the root from b*sqrt(c) = +-sqrt(b^2 c).
Model model_of_root(const mpq_class& a, const mpq_class& b, const mpq_class& c) {
  const mpq_class square = b * b * c;
  mpz_class scaled = (square.get_num() << (2 * kModelBits)) / square.get_den();
  const mpz_class root = sqrt(scaled);  // at most 2 below the true one
  const mpz_class whole = scaled_floor(a);
  if (sgn(b) >= 0) return {whole + root, whole + root + 3};
  return {whole - root - 2, whole - root + 1};
}

mpq_class any_fraction() {
  const auto numerator = *rc::gen::inRange(-2'000, 2'000);
  const auto denominator = *rc::gen::inRange(1, 50);
  mpq_class value(numerator, denominator);
  value.canonicalize();
  return value;
}

Number number_from(const mpq_class& value) {
  return Number::parse(value.get_str()).value();
}

RootWithModel any_root(const mpq_class& c) {
  const mpq_class a = any_fraction();
  const mpq_class b = any_fraction();
  return {model_of_root(a, b, c), Number::root(number_from(a), number_from(b), number_from(c))};
}

mpq_class any_radicand() {
  return abs(any_fraction());
}

// The order of the models, or 0 where they overlap.
int order_of(const Model& x, const Model& y) {
  if (x.high < y.low) return -1;
  return x.low > y.high ? 1 : 0;
}

// The fractions above are so short that numbers 2^-500 apart are equal.
RC_GTEST_PROP(RootProperty, OrderIsThatOfTheModelForAnyRadicands, ()) {
  const RootWithModel x = any_root(any_radicand());
  const RootWithModel y = any_root(any_radicand());
  RC_ASSERT(Number::compare(x.number, y.number) == order_of(x.model, y.model));
  RC_ASSERT(Number::compare(y.number, x.number) == order_of(y.model, x.model));
  RC_ASSERT(x.number.sign() == order_of(x.model, Model{0, 0}));
}

RC_GTEST_PROP(RootProperty, NumbersCloseToEachOtherAreOrdered, ()) {
  const RootWithModel x = any_root(any_radicand());
  const auto [low, high] = x.number.bounds(300);
  if (x.number.is_rational()) {
    RC_ASSERT(low == high);
  } else {
    RC_ASSERT(low < x.number);
    RC_ASSERT(x.number < high);
  }
}

RC_GTEST_PROP(RootProperty, FieldAxiomsHoldForOneRadicand, ()) {
  const mpq_class c = any_radicand();
  const Number x = any_root(c).number;
  const Number y = any_root(c * 4).number;  // the same field in another writing
  const Number z = any_root(c).number;
  RC_ASSERT((x + y).form() != Number::Form::enclosure);
  RC_ASSERT((x * y).form() != Number::Form::enclosure);
  RC_ASSERT((x + y) + z == x + (y + z));
  RC_ASSERT((x * y) * z == x * (y * z));
  RC_ASSERT(x * (y + z) == x * y + x * z);
  RC_ASSERT(x - y == -(y - x));
  if (y.sign() != 0) RC_ASSERT(x / y * y == x);
}

RC_GTEST_PROP(RootProperty, SquaredTheyGiveTheRadicandBack, ()) {
  const Number value = number_from(any_radicand());
  const Number root = sqrt(value);
  RC_ASSERT(root.sign() >= 0);
  RC_ASSERT(root * root == value);
}

RC_GTEST_PROP(RootProperty, RootsOfSquaresAreTheAbsoluteValue, ()) {
  const Number x = any_root(any_radicand()).number;
  RC_ASSERT(sqrt(x * x) == abs(x));
}

RC_GTEST_PROP(RootProperty, FloorIsTheIntegerBelow, ()) {
  const RootWithModel x = any_root(any_radicand());
  const Number floor = x.number.floor();
  RC_ASSERT(floor <= x.number);
  RC_ASSERT(x.number < floor + Number(1));
  RC_ASSERT(floor.to_int64().has_value());
}

RC_GTEST_PROP(RootProperty, TwoRadicandsEncloseTheModel, ()) {
  const RootWithModel x = any_root(any_radicand());
  const RootWithModel y = any_root(any_radicand());
  const auto [low, high] = (x.number + y.number).bounds(200);
  const mpz_class unit = mpz_class(1) << kModelBits;
  RC_ASSERT(model_of(low) * unit <= x.model.high + y.model.high);
  RC_ASSERT(model_of(high) * unit >= x.model.low + y.model.low);
  RC_ASSERT(high - low <= Number::binary(1, -200));
}

// The sum of angles: cos(x + y) = cos x cos y - sin x sin y.
RC_GTEST_PROP(AngleProperty, CosineOfASumIsInTheEnclosure, ()) {
  const Number x = number_from(any_fraction());
  const Number y = number_from(any_fraction());
  const auto [cos_x, sin_x] = cos_sin_degrees(x);
  const auto [cos_y, sin_y] = cos_sin_degrees(y);
  const auto expanded = (cos_x * cos_y - sin_x * sin_y).bounds(200);
  const auto direct = cos_sin_degrees(x + y)[0].bounds(200);
  RC_ASSERT(expanded[0] <= direct[1]);
  RC_ASSERT(direct[0] <= expanded[1]);
}

RC_GTEST_PROP(AngleProperty, AngleOfAVectorPointsAlongIt, ()) {
  const Number x = number_from(any_fraction());
  const Number y = number_from(any_fraction());
  RC_PRE(x.sign() != 0 || y.sign() != 0);
  const Number angle = angle_degrees(x, y);
  RC_ASSERT(angle >= Number(0));
  RC_ASSERT(angle < Number(360));
  const auto [cosine, sine] = cos_sin_degrees(angle);
  const auto across = (cosine * y - sine * x).bounds(100);  // zero
  RC_ASSERT(across[0] <= Number(0));
  RC_ASSERT(across[1] >= Number(0));
  RC_ASSERT((cosine * x + sine * y).sign() == 1);
}

}  // namespace
}  // namespace gonogo::exact
