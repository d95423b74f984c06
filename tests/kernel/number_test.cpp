// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/number.h"

#include <gmock/gmock.h>

#include <cmath>

namespace dgt {
namespace {

TEST(ParseDecimal, TakesEverySpellingOfTheLanguage) {
  EXPECT_EQ(parse_decimal("5"), Rational(5));
  EXPECT_EQ(parse_decimal("5."), Rational(5));
  EXPECT_EQ(parse_decimal(".5"), Rational(1, 2));
  EXPECT_EQ(parse_decimal("-0"), Rational(0));
  EXPECT_EQ(parse_decimal("+5"), Rational(5));
  EXPECT_EQ(parse_decimal("-0.25"), Rational(-1, 4));
  EXPECT_EQ(parse_decimal("007.10"), Rational(71, 10));
}

TEST(ParseDecimal, IsExactWhereBinaryIsNot) {
  EXPECT_EQ(Rational(*parse_decimal("0.1") + *parse_decimal("0.2")), *parse_decimal("0.3"));
}

TEST(ParseDecimal, RefusesWhatIsNoDecimal) {
  for (const char* text : {"", "+", "-", ".", "-.", "1e5", "1,5", "1.2.3", " 1", "1 ", "--1", "x"})
    EXPECT_FALSE(parse_decimal(text).has_value()) << '"' << text << '"';
}

TEST(ToDecimal, RoundsTiesAwayFromZero) {
  EXPECT_EQ(to_decimal(Rational(1, 2), 0), "1");
  EXPECT_EQ(to_decimal(Rational(-1, 2), 0), "-1");
  EXPECT_EQ(to_decimal(Rational(5, 1000), 2), "0.01");
  EXPECT_EQ(to_decimal(Rational(-5, 1000), 2), "-0.01");
  EXPECT_EQ(to_decimal(Rational(4999, 1000000), 2), "0.00");
}

TEST(ToDecimal, NeverPrintsANegativeZero) {
  EXPECT_EQ(to_decimal(Rational(-1, 1000), 2), "0.00");
  EXPECT_EQ(to_decimal(Rational(-1, 1000), 0), "0");
  EXPECT_EQ(to_short_decimal(Rational(-1, 1000), 2), "0");
}

TEST(ToDecimal, CarriesThroughNines) {
  EXPECT_EQ(to_decimal(Rational(99999, 100000), 3), "1.000");
  EXPECT_EQ(to_decimal(Rational(-99999, 10000), 2), "-10.00");
}

TEST(ToShortDecimal, PrintsTheShortestExactForm) {
  EXPECT_EQ(to_short_decimal(Rational(3, 2)), "1.5");
  EXPECT_EQ(to_short_decimal(Rational(1200)), "1200");
  EXPECT_EQ(to_short_decimal(Rational(1, 3)), "0.333333333");
  EXPECT_EQ(to_short_decimal(Rational(5, 2), 0), "3");
}

TEST(NearestDouble, WithinTwoToTheMinus64IsZeroAndBeyondItIsNot) {
  const Rational limit = power_of_two(kZeroExponent);
  const Rational hair = power_of_two(-2000);
  EXPECT_EQ(nearest_double(OneRoot(limit)), 0.0);
  EXPECT_EQ(nearest_double(OneRoot(-limit)), 0.0);
  EXPECT_EQ(nearest_double(OneRoot(limit + hair)), 0x1p-64);
  EXPECT_EQ(nearest_double(OneRoot(-limit - hair)), -0x1p-64);
  EXPECT_FALSE(std::signbit(nearest_double(OneRoot(-limit))));
  // √2 − (√2 rounded downwards to 2⁻⁶⁶), irrational
  EXPECT_EQ(nearest_double(OneRoot(-sqrt_within(2, -66), 1, 2)), 0.0);
}

TEST(NearestDouble, TiesGoToTheEvenNeighbour) {
  EXPECT_EQ(nearest_double(Rational(1 + power_of_two(-53))), 1.0);
  EXPECT_EQ(nearest_double(Rational(1 + 3 * power_of_two(-53))), 1 + 0x1p-51);
  // 1 + 2⁻⁵³ as a number with a (perfect) root
  EXPECT_EQ(
      nearest_double(OneRoot(-1, 1, Rational((2 + power_of_two(-53)) * (2 + power_of_two(-53))))),
      1.0);
}

TEST(NearestInteger, TiesGoAwayFromZero) {
  EXPECT_EQ(nearest_integer(Rational(1, 2)), 1);
  EXPECT_EQ(nearest_integer(Rational(-1, 2)), -1);
  EXPECT_EQ(nearest_integer(Rational(5, 2)), 3);
  EXPECT_EQ(nearest_integer(Rational(-5, 2)), -3);
  EXPECT_EQ(nearest_integer(OneRoot(Rational(-1, 2), 1, 4)), 2);   // −1/2 + √4
  EXPECT_EQ(nearest_integer(OneRoot(Rational(1, 2), -1, 4)), -2);  // 1/2 − √4
  EXPECT_EQ(nearest_integer(OneRoot(Rational(-3, 2), 1, 4)), 1);   // −3/2 + √4
  EXPECT_EQ(nearest_integer(OneRoot(Rational(3, 2), -1, 4)), -1);  // 3/2 − √4
}

TEST(NearestInteger, TiesAreSeenThroughARootThatIsRationalButNotDyadic) {
  EXPECT_EQ(nearest_integer(OneRoot(Rational(1, 2), -3, Rational(1, 9))), -1);  // 1/2 − 3·√(1/9)
  EXPECT_EQ(nearest_integer(OneRoot(Rational(-1, 2), 3, Rational(1, 9))), 1);
  EXPECT_EQ(nearest_integer(OneRoot(Rational(5, 2), -3, Rational(1, 9))), 2);  // 3/2
  EXPECT_EQ(nearest_integer(OneRoot(Rational(-5, 2), 3, Rational(1, 9))), -2);
}

TEST(OneRoot, ARootOfZeroCountsForNothing) {
  const OneRoot x(3, 5, 0);
  EXPECT_TRUE(x.is_rational());
  EXPECT_EQ(compare(combine(2, x, 1, OneRoot(1, 1, 2), 0), OneRoot(7, 1, 2)), 0);
  EXPECT_EQ(compare(combine(1, OneRoot(1, 1, 2), 2, x, 0), OneRoot(7, 1, 2)), 0);
}

TEST(ExactSqrt, OfANegativeNumberThereIsNone) {
  EXPECT_FALSE(exact_sqrt(Rational(-4)).has_value());
  EXPECT_EQ(exact_sqrt(Rational(0)), Rational(0));
  EXPECT_EQ(exact_sqrt(Rational(9, 4)), Rational(3, 2));
}

TEST(Height, IsTheBitsOfTheLongerPart) {
  EXPECT_EQ(height(Rational(0)), 1U);
  EXPECT_EQ(height(Rational(255)), 8U);
  EXPECT_EQ(height(Rational(1, 256)), 9U);
}

}  // namespace
}  // namespace dgt
