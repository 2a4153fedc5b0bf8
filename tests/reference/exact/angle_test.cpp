// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference/exact/number.hpp"
#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::exact {
namespace {

using testing::enclosed;
using testing::num;
using Form = Number::Form;

struct KnownAngle {
  int degrees;
  Number cosine;
  Number sine;
};

// Every multiple of 30 and 45 degrees, read off the triangles (1, 1, sqrt 2) and (1, sqrt 3, 2).
std::vector<KnownAngle> known_angles() {
  const Number half = num("0.5");
  const Number root2 = sqrt(Number(2)) * half;
  const Number root3 = sqrt(Number(3)) * half;
  return {{0, 1, 0},    {30, root3, half},    {45, root2, root2},    {60, half, root3},
          {90, 0, 1},   {120, -half, root3},  {135, -root2, root2},  {150, -root3, half},
          {180, -1, 0}, {210, -root3, -half}, {225, -root2, -root2}, {240, -half, -root3},
          {270, 0, -1}, {300, half, -root3},  {315, root2, -root2},  {330, root3, -half}};
}

TEST(CosSin, AreExactAtTheKnownAnglesInEveryTurn) {
  for (const KnownAngle& known : known_angles()) {
    for (const std::int64_t turns : {-1'000'000'000, -1, 0, 1, 7}) {
      const auto [cosine, sine] = cos_sin_degrees(Number(known.degrees + 360 * turns));
      EXPECT_NE(cosine.form(), Form::enclosure);
      EXPECT_EQ(cosine, known.cosine) << known.degrees;
      EXPECT_EQ(sine, known.sine) << known.degrees;
    }
  }
}

// cos 36 = (1 + sqrt 5)/4, sin 18 = (sqrt 5 - 1)/4, from the regular pentagon.
TEST(CosSin, EncloseTheValuesOfThePentagon) {
  const Number golden = Number::root(num("0.25"), num("0.25"), 5);
  const Number smaller = Number::root(num("-0.25"), num("0.25"), 5);
  EXPECT_TRUE(enclosed(cos_sin_degrees(36)[0], golden, 400));
  EXPECT_TRUE(enclosed(cos_sin_degrees(18)[1], smaller, 400));
  EXPECT_TRUE(enclosed(cos_sin_degrees(-36)[0], golden, 400));
  EXPECT_TRUE(enclosed(cos_sin_degrees(144)[0], -golden, 400));
  EXPECT_TRUE(enclosed(cos_sin_degrees(198)[1], -smaller, 400));
}

// cos 15 = (sqrt 6 + sqrt 2)/4, so 4 cos^2 15 = 2 + sqrt 3.
TEST(CosSin, EncloseTheValuesAt15Degrees) {
  const Number cosine = cos_sin_degrees(15)[0];
  EXPECT_TRUE(enclosed(Number(4) * cosine * cosine, Number::root(2, 1, 3), 400));
}

TEST(CosSin, SquaresAddUpToOne) {
  for (const char* degrees : {"0.001", "1/7", "20", "44.999999", "45.000001", "100", "-77.7",
                              "359.999", "123456789.25", "1e300"}) {
    const auto [cosine, sine] = cos_sin_degrees(num(degrees));
    EXPECT_TRUE(enclosed(cosine * cosine + sine * sine, Number(1), 200)) << degrees;
  }
}

// sin(x + 360 k) = sin x = cos(90 - x) is seen as one expression, so equality is decided.
TEST(CosSin, EqualAnglesAreEqualNumbers) {
  const auto [cosine, sine] = cos_sin_degrees(20);
  EXPECT_EQ(cos_sin_degrees(380)[1], sine);
  EXPECT_EQ(cos_sin_degrees(70)[0], sine);
  EXPECT_EQ(cos_sin_degrees(110)[0], -sine);
  EXPECT_EQ(cos_sin_degrees(-20)[0], cosine);
}

// sin x < x and cos x > 1 - x^2/2 for x > 0, pi < 3.1416.
TEST(CosSin, KeepTheirSignNearTheAxes) {
  const Number tiny = num("1e-100");
  EXPECT_GT(cos_sin_degrees(tiny)[1], Number(0));
  EXPECT_LT(cos_sin_degrees(tiny)[1], tiny);
  EXPECT_LT(cos_sin_degrees(tiny)[0], Number(1));
  EXPECT_LT(cos_sin_degrees(Number(90) + tiny)[0], Number(0));
  EXPECT_LT(cos_sin_degrees(-tiny)[1], Number(0));
}

TEST(CosSin, OfARootOrAnEnclosureAreEnclosures) {
  const auto [cosine, sine] = cos_sin_degrees(sqrt(Number(2)));
  EXPECT_TRUE(enclosed(cosine * cosine + sine * sine, Number(1), 200));
  const auto [wide_cosine, wide_sine] = cos_sin_degrees(Number::between(0, 90));
  EXPECT_LE(wide_cosine.bounds(10)[0], Number(0));
  EXPECT_EQ(wide_cosine.bounds(10)[1], Number(1));
  EXPECT_LE(wide_sine.bounds(10)[0], Number(0));
  EXPECT_EQ(wide_sine.bounds(10)[1], Number(1));
}

TEST(Angle, IsExactAtTheKnownAngles) {
  for (const KnownAngle& known : known_angles()) {
    const Number length = num("7/3");
    const Number angle = angle_degrees(known.cosine * length, known.sine * length);
    EXPECT_TRUE(angle.is_rational()) << known.degrees;
    EXPECT_EQ(angle, Number(known.degrees));
  }
}

TEST(Angle, OfRootsWithTwoRadicandsIsExactToo) {
  EXPECT_EQ(angle_degrees(sqrt(Number(2)), sqrt(Number(6))), Number(60));
  EXPECT_EQ(angle_degrees(Number::root(1, 1, 2), Number::root(-1, -1, 2)), Number(315));
}

// The vector (3, 4) has cosine 3/5 and sine 4/5; likewise in the other quadrants.
TEST(Angle, HasTheCosineAndSineOfItsVector) {
  for (const int x : {3, -3}) {
    for (const int y : {4, -4}) {
      const Number angle = angle_degrees(x, y);
      EXPECT_EQ(angle.form(), Form::enclosure);
      EXPECT_GE(angle, Number(0));
      EXPECT_LT(angle, Number(360));
      const auto [cosine, sine] = cos_sin_degrees(angle);
      EXPECT_TRUE(enclosed(cosine, Number(x) / Number(5), 200));
      EXPECT_TRUE(enclosed(sine, Number(y) / Number(5), 200));
    }
  }
}

TEST(Angle, OfCosineAndSineIsTheAngle) {
  for (const int degrees : {1, 20, 89, 91, 179, 181, 269, 271, 359}) {
    const auto [cosine, sine] = cos_sin_degrees(degrees);
    EXPECT_TRUE(enclosed(angle_degrees(cosine, sine), Number(degrees), 200)) << degrees;
  }
}

// In every quadrant, at the angles that are exact and at others.
TEST(Angle, CosineAndSineAreThoseOfThePair) {
  for (int degrees = -375; degrees <= 375; degrees += 5) {
    const auto [cosine, sine] = cos_sin_degrees(degrees);
    EXPECT_EQ(cos_degrees(degrees), cosine) << degrees;
    EXPECT_EQ(sin_degrees(degrees), sine) << degrees;
  }
  const auto [cosine, sine] = cos_sin_degrees(sqrt(Number(2)));
  EXPECT_EQ(cos_degrees(sqrt(Number(2))), cosine);
  EXPECT_EQ(sin_degrees(sqrt(Number(2))), sine);
}

// atan(1e-40) lies below 1e-38 degrees.
TEST(Angle, JustBelowTheAxisIsJustBelow360) {
  const Number angle = angle_degrees(1, num("-1e-40"));
  EXPECT_LT(angle, Number(360));
  EXPECT_GT(angle, Number(360) - num("1e-38"));
}

TEST(Angle, NearTheXAxisIsUndecidedOnlyOnItsPositiveHalf) {
  const Number near_zero = Number::between(num("-1e-20"), num("1e-20"));
  EXPECT_THROW(angle_degrees(1, near_zero), Undecided);
  const auto [low, high] = angle_degrees(-1, near_zero).bounds(40);
  EXPECT_LE(low, Number(180));
  EXPECT_GE(high, Number(180));
  EXPECT_LT(high - low, num("1e-17"));
}

TEST(Angle, OfNoVectorIsADomainError) {
  EXPECT_THROW(angle_degrees(0, 0), std::domain_error);
}

}  // namespace
}  // namespace gonogo::exact
