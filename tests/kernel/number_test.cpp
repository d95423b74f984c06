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

TEST(ParseDecimal, ShortAndLongNumbersAreInLowestTerms) {
  for (const char* text : {"0.000000000000000000", "123456789012345678", "0.125", "1.20", "0.00050",
                           "99999999.9999999999", "0.000000000000000005", "1234567890123456789.5",
                           "0.0000000000000000000000625"}) {
    Rational value = parse_decimal(text).value();
    const Rational as_read = value;
    value.canonicalize();
    EXPECT_EQ(as_read.get_num(), value.get_num()) << text;
    EXPECT_EQ(as_read.get_den(), value.get_den()) << text;
    // Digit by digit, another way.
    Rational sum = 0;
    Rational place = 1;
    bool after_point = false;
    for (const char* c = text; *c != '\0'; ++c) {
      if (*c == '.') {
        after_point = true;
      } else if (after_point) {
        place /= 10;
        sum += place * (*c - '0');
      } else {
        sum = 10 * sum + (*c - '0');
      }
    }
    EXPECT_EQ(value, sum) << text;
  }
}

TEST(ParseScientific, ReadsExponentsExactly) {
  EXPECT_EQ(parse_scientific("2e-5"), Rational(1, 50000));
  EXPECT_EQ(parse_scientific("-1.5E+3"), Rational(-1500));
  EXPECT_EQ(parse_scientific("7"), Rational(7));
  EXPECT_EQ(parse_scientific(".5e0"), Rational(1, 2));
  EXPECT_EQ(parse_scientific("0e400"), Rational(0));
  for (const char* text : {"", "e5", "1e", "1e+", "1e+-5", "1e5.0", "1e401", "1e-401", "1 e5",
                           "1e5 ", "inf", "0x1p3", "1e99999999999"}) {
    EXPECT_FALSE(parse_scientific(text).has_value()) << '"' << text << '"';
  }
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
