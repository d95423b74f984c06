// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/chain.h"

#include <gtest/gtest.h>

namespace dgt {
namespace {

TEST(BulgeOf, IsExactWhereTheChordIsRational) {
  const Circle circle({0, 0}, 5);
  EXPECT_EQ(bulge_of(circle, {-5, 0}, {5, 0}), 1);               // half a turn
  EXPECT_EQ(bulge_of(circle, {4, -3}, {4, 3}), Rational(1, 3));  // less
  EXPECT_EQ(bulge_of(circle, {4, 3}, {4, -3}), 3);               // more
  EXPECT_EQ(bulge_of(circle.reversed(), {4, -3}, {4, 3}), -3);   // clockwise
  EXPECT_EQ(bulge_of(circle.reversed(), {4, 3}, {4, -3}), Rational(-1, 3));
}

TEST(BulgeOf, IsWithinItsBoundWhereTheChordIsIrrational) {
  // A quarter turn: √2 − 1, the root of b² + 2b − 1.
  const Rational b = bulge_of(Circle({0, 0}, 1), {1, 0}, {0, 1});
  EXPECT_LE(abs(b * b + 2 * b - 1), power_of_two(-94));
}

TEST(BulgeOf, GivesTheArcBack) {
  const Circle circle({Rational(7, 3), Rational(-1, 9)}, Rational(-25, 4));
  const RationalPoint from =
      circle.centre() + Rational(25, 4) * Vector{Rational(3, 5), Rational(4, 5)};
  const RationalPoint to =
      circle.centre() + Rational(25, 4) * Vector{Rational(12, 13), Rational(-5, 13)};
  const ChainEdge edge = arc(from, to, bulge_of(circle, from, to));
  EXPECT_LE(abs(edge.radius - circle.radius()), power_of_two(-80));
  EXPECT_LE(squared_length(edge.centre() - circle.centre()), power_of_two(-160));
}

TEST(ChainOf, BulgesTooSmallForARadiusAreSegments) {
  const Rational tiny = power_of_two(kStraightBulgeExponent - 1);
  const Rational small = power_of_two(kStraightBulgeExponent);
  const auto chain = chain_of({{{0, 0}, tiny}, {{1, 0}, -small}, {{1, 1}, -tiny}}, true);
  ASSERT_TRUE(chain.has_value());
  EXPECT_TRUE(chain->edges[0].is_line());
  EXPECT_FALSE(chain->edges[1].is_line());
  EXPECT_LT(chain->edges[1].radius, 0);
  EXPECT_TRUE(chain->edges[2].is_line());
}

}  // namespace
}  // namespace dgt
