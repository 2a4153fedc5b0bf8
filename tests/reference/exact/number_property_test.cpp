// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rational numbers against a model of plain mpq_class arithmetic.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <tuple>

#include "reference/exact/number.hpp"
#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::exact {
namespace {

using testing::is_small;
using testing::json;
using testing::model_of;

// A rational as a model, written "p/q" so that RapidCheck can show it. The kinds meet every
// border of the forms: counts of 1e-6, counts about 2^63, short fractions, long fractions.
mpq_class model_from(int kind, std::int64_t x, std::int64_t y) {
  const mpz_class two_to_63 = mpz_class(1) << 63;
  const mpz_class three_to_40("12157665459056928801");
  mpq_class model;
  switch (kind) {
    case 0:
      model = mpq_class(mpz_class(x), 1'000'000);
      break;
    case 1:
      model =
          mpq_class(mpz_class(y % 2 == 0 ? two_to_63 : mpz_class(-two_to_63)) + x % 4, 1'000'000);
      break;
    case 2:
      model = mpq_class(mpz_class(x), mpz_class(y % 1000 == 0 ? 1 : std::abs(y % 1000)));
      break;
    case 3:
      model = mpq_class((mpz_class(x) << 70) + y, three_to_40);
      break;
    default:
      model = mpq_class(mpz_class(x));
      break;
  }
  model.canonicalize();
  return model;
}

rc::Gen<std::string> rational_text() {
  return rc::gen::map(rc::gen::tuple(rc::gen::inRange(0, 5), rc::gen::arbitrary<std::int64_t>(),
                                     rc::gen::arbitrary<std::int64_t>()),
                      [](const std::tuple<int, std::int64_t, std::int64_t>& t) {
                        return model_from(std::get<0>(t), std::get<1>(t), std::get<2>(t)).get_str();
                      });
}

struct RationalWithModel {
  mpq_class model;
  Number number;
};

// The number by way of its decimal digits and a division, not of parse.
RationalWithModel any_rational() {
  const mpq_class model(*rational_text());
  const auto whole = [](const mpz_class& z) {
    return Number::decimal(sgn(z) < 0, mpz_class(abs(z)).get_str(), 0);
  };
  return {model, whole(model.get_num()) / whole(model.get_den())};
}

// Small exactly when the value is a 64-bit count of 1e-6: one form for each value.
bool is_canonical(const Number& number) {
  const mpq_class count = model_of(number) * 1'000'000;
  const bool fits = count.get_den() == 1 && count.get_num().fits_slong_p();
  return is_small(number) == fits;
}

void expect_is(const Number& number, const mpq_class& model) {
  RC_ASSERT(model_of(number) == model);
  RC_ASSERT(is_canonical(number));
}

RC_GTEST_PROP(NumberProperty, ArithmeticIsThatOfTheModel, ()) {
  const RationalWithModel a = any_rational();
  const RationalWithModel b = any_rational();
  expect_is(a.number, a.model);
  expect_is(a.number + b.number, mpq_class(a.model + b.model));
  expect_is(a.number - b.number, mpq_class(a.model - b.model));
  expect_is(a.number * b.number, mpq_class(a.model * b.model));
  expect_is(-a.number, mpq_class(-a.model));
  expect_is(abs(a.number), mpq_class(abs(a.model)));
  if (sgn(b.model) != 0) expect_is(a.number / b.number, mpq_class(a.model / b.model));
}

// Counts that overflow in every way: two arbitrary 64-bit counts.
RC_GTEST_PROP(NumberProperty, CountsOfAllSizesAreThoseOfTheModel, ()) {
  const auto x = *rc::gen::resize(1000, rc::gen::arbitrary<std::int64_t>());
  const auto shift = *rc::gen::inRange(0, 63);
  const auto y = *rc::gen::resize(1000, rc::gen::arbitrary<std::int64_t>()) >> shift;
  const Number a = Number::millionths(x);
  const Number b = Number::millionths(y);
  const mpq_class unit(1, 1'000'000);
  const mpq_class model_a = x * unit;
  const mpq_class model_b = y * unit;
  expect_is(a + b, mpq_class(model_a + model_b));
  expect_is(a - b, mpq_class(model_a - model_b));
  expect_is(a * b, mpq_class(model_a * model_b));
  if (y != 0) expect_is(a / b, mpq_class(model_a / model_b));
  RC_ASSERT(Number::compare(a, b) == (x > y) - (x < y));
}

RC_GTEST_PROP(NumberProperty, OrderIsThatOfTheModel, ()) {
  const RationalWithModel a = any_rational();
  const RationalWithModel b = any_rational();
  const int order = cmp(a.model, b.model);
  RC_ASSERT(Number::compare(a.number, b.number) == (order > 0) - (order < 0));
  RC_ASSERT((a.number == b.number) == (order == 0));
  RC_ASSERT((a.number < b.number) == (order < 0));
  RC_ASSERT(min(a.number, b.number) <= max(a.number, b.number));
  RC_ASSERT(a.number.sign() == sgn(a.model));
}

RC_GTEST_PROP(NumberProperty, FieldAxiomsHold, ()) {
  const Number a = any_rational().number;
  const Number b = any_rational().number;
  const Number c = any_rational().number;
  RC_ASSERT((a + b) + c == a + (b + c));
  RC_ASSERT((a * b) * c == a * (b * c));
  RC_ASSERT(a * (b + c) == a * b + a * c);
  RC_ASSERT(a + b == b + a);
  RC_ASSERT(a - b == -(b - a));
  if (b.sign() != 0) RC_ASSERT(a / b * b == a);
}

RC_GTEST_PROP(NumberProperty, FloorAndCeilSurroundTheNumber, ()) {
  const Number a = any_rational().number;
  RC_ASSERT(model_of(a.floor()).get_den() == 1);
  RC_ASSERT(a.floor() <= a);
  RC_ASSERT(a < a.floor() + Number(1));
  RC_ASSERT(a.ceil() == -(-a).floor());
  const auto whole = a.to_int64();
  RC_ASSERT(whole.has_value() == (a.floor() == a && model_of(a).get_num().fits_slong_p()));
  if (whole) RC_ASSERT(Number(*whole) == a);
}

RC_GTEST_PROP(NumberProperty, ParseReadsWhatIsWritten, ()) {
  const RationalWithModel a = any_rational();
  RC_ASSERT(Number::parse(a.number.text()) == a.number);
  RC_ASSERT(Number::parse(a.model.get_str()) == a.number);
  RC_ASSERT(json(a.number) == '"' + a.number.text() + '"');
}

RC_GTEST_PROP(NumberProperty, ParseReadsDecimalsOfAllShapes, ()) {
  const auto digits = rc::gen::container<std::string>(rc::gen::inRange<char>('0', '9' + 1));
  const std::string whole = *digits;
  const std::string fraction = *digits;
  RC_PRE(!whole.empty() || !fraction.empty());
  const auto exponent = *rc::gen::inRange(-30, 30);
  mpz_class ten;
  mpz_ui_pow_ui(ten.get_mpz_t(), 10, fraction.size() + 30);
  mpz_class shift;
  mpz_ui_pow_ui(shift.get_mpz_t(), 10, static_cast<unsigned long>(exponent) + 30);
  mpq_class model(-mpz_class(whole + fraction, 10) * shift, ten);
  model.canonicalize();
  const auto number = Number::parse("-" + whole + "." + fraction + "e" + std::to_string(exponent));
  RC_ASSERT(number.has_value());
  expect_is(*number, model);
}

RC_GTEST_PROP(NumberProperty, DecimalTextIsWithinHalfAUnit, ()) {
  const Number a = any_rational().number;
  const auto decimals = *rc::gen::inRange(0, 9);
  const Number written = Number::parse(a.decimal_text(decimals)).value();
  const Number unit = Number::decimal(false, 1, static_cast<std::uint32_t>(decimals));
  RC_ASSERT(abs(written - a) * Number(2) <= unit);
  RC_ASSERT((written / unit).to_int64().has_value() || abs(a) > Number(1'000'000'000));
}

RC_GTEST_PROP(NumberProperty, AnyTextIsReadOrRefusedWithoutHarm, ()) {
  const auto text = *rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("0123456789abcdefpxXeE+-./ ")));
  const auto number = Number::parse(text);
  if (number) RC_ASSERT(is_canonical(*number));
}

}  // namespace
}  // namespace gonogo::exact
