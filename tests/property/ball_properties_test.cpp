// SPDX-License-Identifier: GPL-3.0-or-later
// The filter in front of the exact types must never say anything false: random expressions are
// evaluated side by side in balls and in exact rationals.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/number.h"
#include "tests/support/geometry_generators.h"

namespace dgt {
namespace {

/// One value, known twice.
struct Pair {
  Ball ball;
  Rational exact;
};

/// Any long double is a rational.
Rational exactly(long double value) {
  int exponent = 0;
  const long double mantissa = std::frexp(value, &exponent);
  const auto high = static_cast<double>(mantissa);
  const auto low = static_cast<double>(mantissa - high);
  return (Rational(high) + Rational(low)) * power_of_two(exponent);
}

bool holds(const Ball& ball, const Rational& value) {
  if (!std::isfinite(ball.mid) || !std::isfinite(ball.rad)) return true;
  return abs(value - exactly(ball.mid)) <= exactly(ball.rad);
}

Rational any_leaf() {
  switch (*rc::gen::inRange(0, 6)) {
    case 0:  // does not fit into a long double
      return Rational(*rc::gen::arbitrary<std::int64_t>(), 1) / 3;
    case 1:  // more than 128 bits
      return Rational(*rc::gen::arbitrary<std::int64_t>()) * power_of_two(130) + 1;
    case 2:  // nearly cancelling partners
      return 1 + *rc::gen::inRange(-2, 3) * power_of_two(-*rc::gen::inRange(50, 80));
    case 3:
      return any_leaf() / (3 * power_of_two(150));
    default:
      return test::any_decimal();
  }
}

Pair any_expression(int depth) {
  if (depth == 0 || *rc::gen::inRange(0, 5) == 0) {
    const Rational value = any_leaf();
    return {Ball(value), value};
  }
  const Pair a = any_expression(depth - 1);
  const Pair b = any_expression(depth - 1);
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      return {a.ball + b.ball, a.exact + b.exact};
    case 1:
      return {a.ball - b.ball, a.exact - b.exact};
    case 2:
      return {-a.ball, -a.exact};
    case 3:
      if (const auto quotient = divide(a.ball, b.ball)) return {*quotient, a.exact / b.exact};
      return a;
    case 4:  // a root that stays rational
      if (const auto root = sqrt(b.ball * b.ball)) return {*root, abs(b.exact)};
      return b;
    default:
      return {a.ball * b.ball, a.exact * b.exact};
  }
}

RC_GTEST_PROP(Ball, TheTrueValueIsAlwaysInside, ()) {
  const Pair x = any_expression(6);
  RC_ASSERT(holds(x.ball, x.exact));
}

RC_GTEST_PROP(Ball, TheSignIsTheExactOneOrNone, ()) {
  Pair x = any_expression(5);
  if (*rc::gen::arbitrary<bool>()) {  // as near to zero as the midpoint comes
    const Rational shift = exactly(x.ball.mid);
    if (std::isfinite(x.ball.mid)) x = {x.ball - Ball(shift), x.exact - shift};
  }
  if (const auto sign = x.ball.sign()) RC_ASSERT(*sign == sgn(x.exact));
}

RC_GTEST_PROP(Ball, TheNearestDoubleIsTheExactOneOrNone, ()) {
  const Pair x = any_expression(4);
  if (const auto rounded = x.ball.nearest_double())
    RC_ASSERT(*rounded == nearest_double(OneRoot(x.exact)));
}

RC_GTEST_PROP(Ball, BesideTheMidpointOfTwoDoublesItDoesNotGuess, ()) {
  const double low = 1.0 + *rc::gen::inRange(0, 1 << 30) * 0x1p-30;
  const double high = std::nextafter(low, std::numeric_limits<double>::infinity());
  const Rational middle = (Rational(low) + Rational(high)) / 2;
  const Rational third(1, 3);
  const Rational x = middle + *rc::gen::inRange(-3, 4) * power_of_two(-64) * third;
  if (const auto rounded = Ball(x).nearest_double()) RC_ASSERT(*rounded == nearest_double(x));
}

RC_GTEST_PROP(Ball, ARoundedBallRoundsToThatDoubleAtBothEnds, ()) {
  const long double mid = 1 + *rc::gen::inRange(0, 1 << 14) * 0x1p-62L;
  const Ball ball(mid, std::ldexp(1.0L, -*rc::gen::inRange(50, 64)));
  const auto rounded = ball.nearest_double();
  if (!rounded) return;
  RC_ASSERT(*rounded == nearest_double(Rational(exactly(mid) - exactly(ball.rad))));
  RC_ASSERT(*rounded == nearest_double(Rational(exactly(mid) + exactly(ball.rad))));
}

RC_GTEST_PROP(Ball, TheZeroRuleIsTheExactOneOrNone, ()) {
  const Rational x = power_of_two(kZeroExponent) *
                     (1 + *rc::gen::inRange(-8, 9) * power_of_two(-*rc::gen::inRange(2, 70)));
  if (const auto rounded = Ball(x).nearest_double())
    RC_ASSERT(*rounded == nearest_double(OneRoot(x)));
}

RC_GTEST_PROP(Ball, ARootHoldsTheExactRoot, ()) {
  const Pair x = any_expression(4);
  const auto root = sqrt(x.ball);
  if (!root || !std::isfinite(root->mid)) return;
  RC_ASSERT(sgn(x.exact) >= 0);
  const Rational low = exactly(root->mid) - exactly(root->rad);
  const Rational high = exactly(root->mid) + exactly(root->rad);
  RC_ASSERT(high * high >= x.exact);
  if (sgn(low) > 0) RC_ASSERT(low * low <= x.exact);
}

RC_GTEST_PROP(Ball, OfAOneRootAgreesWithTheExactOrder, ()) {
  const OneRoot x(any_leaf(), any_leaf(), abs(any_leaf()));
  const Ball ball = enclosure(x);
  if (!std::isfinite(ball.mid) || !std::isfinite(ball.rad)) return;
  RC_ASSERT(compare(x, exactly(ball.mid) + exactly(ball.rad)) <= 0);
  RC_ASSERT(compare(x, exactly(ball.mid) - exactly(ball.rad)) >= 0);
}

TEST(Ball, IsTightEnoughToDecideWhatAPartAsksFor) {
  // A filter that never answers would pass every test above.
  const Ball third(Rational(1, 3));
  EXPECT_EQ((third * Ball(Rational(3)) - Ball(Rational(999999, 1000000))).sign(), 1);
  EXPECT_EQ(third.nearest_double(), 1.0 / 3.0);
  EXPECT_LE(third.rad, 1e-18L);
  const auto root = sqrt(Ball(Rational(2)));
  ASSERT_TRUE(root.has_value());
  EXPECT_EQ(root->nearest_double(), std::sqrt(2.0));
}

TEST(Ball, WideBallsKeepTheCornersOfTheirProducts) {
  const Ball wide(1, 0.5L);
  EXPECT_TRUE(holds(wide * wide, Rational(9, 4)));
  EXPECT_TRUE(holds(wide * wide, Rational(1, 4)));
  EXPECT_TRUE(holds(wide + wide, Rational(3)));
  EXPECT_TRUE(holds(wide - wide, Rational(-1)));
  EXPECT_TRUE(holds(*divide(wide, wide), Rational(3)));
  EXPECT_TRUE(holds(*sqrt(Ball(5, 4)), Rational(1)));
  EXPECT_TRUE(holds(*sqrt(Ball(5, 4)), Rational(3)));
}

TEST(Ball, OnlyTheExactZeroHasTheSignZero) {
  EXPECT_EQ(Ball(Rational(0)).sign(), 0);
  EXPECT_EQ((Ball(Rational(1, 3)) - Ball(Rational(1, 3))).sign(), std::nullopt);
}

TEST(Ball, ADivisorThatMayBeZeroGivesNothing) {
  const Ball doubtful = Ball(Rational(1, 3)) - Ball(Rational(1, 3));
  EXPECT_FALSE(divide(Ball(Rational(1)), doubtful).has_value());
  EXPECT_FALSE(divide(Ball(Rational(1)), Ball()).has_value());
  EXPECT_FALSE(sqrt(doubtful).has_value());
  EXPECT_FALSE(sqrt(Ball(Rational(-1))).has_value());
  EXPECT_TRUE(sqrt(Ball()).has_value());
}

TEST(Ball, NumbersBeyondTheRangeOfLongDoubleLeaveEverythingOpen) {
  for (const int exponent : {40000, -40000}) {
    const Rational huge = power_of_two(exponent);
    EXPECT_EQ(Ball(huge).sign(), std::nullopt);
    EXPECT_EQ(compare(OneRoot(0, 1, huge), OneRoot(0, 2, huge)), -1);
    EXPECT_EQ(sign(OneRoot(-1, 1, huge)), exponent > 0 ? 1 : -1);
    EXPECT_EQ((Ball(huge) * Ball(Rational(0))).sign(), std::nullopt);
  }
}

}  // namespace
}  // namespace dgt
