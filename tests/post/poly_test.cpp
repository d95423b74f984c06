// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/poly.h"

#include <gmock/gmock.h>

#include <memory>

namespace dgt {
namespace {

Move line(const RationalPoint& from, const RationalPoint& to) {
  Move move;
  move.from = Point(from);
  move.to = Point(to);
  return move;
}

Move arc(const RationalPoint& from, const RationalPoint& to, const Circle& circle) {
  Move move = line(from, to);
  move.kind = MoveKind::Arc;
  move.carrier.base = ElementPtr(circle);
  return move;
}

std::string written(const std::vector<Move>& moves) {
  std::string out;
  append_poly(out, moves);
  return out;
}

TEST(PolyWriter, AClosedRunLeavesItsLastPointOut) {
  EXPECT_EQ(written({line({0, 0}, {4, 0}), line({4, 0}, {0, 3}), line({0, 3}, {0, 0})}),
            "0 0 0\n4 0 0\n0 3 0\n");
}

TEST(PolyWriter, AnOpenRunSaysSo) {
  EXPECT_EQ(written({line({0, 0}, {4, 0}), line({4, 0}, {0, 3})}), "open\n0 0 0\n4 0 0\n0 3 0\n");
}

TEST(PolyWriter, BulgesAreExactWhereTheyAreRational) {
  // Half a turn; twice atan(3/4), of which a quarter has the tangent 1/3, and the rest of its
  // circle.
  EXPECT_EQ(written({arc({-5, 0}, {5, 0}, Circle({0, 0}, 5)), line({5, 0}, {-5, 0})}),
            "-5 0 1\n5 0 0\n");
  EXPECT_EQ(written({arc({4, -3}, {4, 3}, Circle({0, 0}, 5)), line({4, 3}, {4, -3})}),
            "4 -3 0.3333333333333333\n4 3 0\n");
  EXPECT_EQ(written({arc({4, 3}, {4, -3}, Circle({0, 0}, 5)), line({4, -3}, {4, 3})}),
            "4 3 3\n4 -3 0\n");
  EXPECT_EQ(written({arc({4, 3}, {4, -3}, Circle({0, 0}, -5)), line({4, -3}, {4, 3})}),
            "4 3 -0.3333333333333333\n4 -3 0\n");
}

TEST(PolyWriter, AQuarterTurnIsTheNearestDoubleToItsBulge) {
  // tan(22.5°) = √2 − 1 = 0.414213562373095048…
  EXPECT_EQ(written({arc({1, 0}, {0, 1}, Circle({0, 0}, 1)), line({0, 1}, {1, 0})}),
            "1 0 0.41421356237309503\n0 1 0\n");
}

TEST(PolyWriter, AFullCircleIsTwoHalves) {
  Move circle = arc({2, -5}, {2, -5}, Circle({2, 0}, -5));
  circle.full_circle = true;
  EXPECT_EQ(written({circle}), "2 -5 -1\n2 5 -1\n");
}

TEST(PolyWriter, NumbersHaveNoExponent) {
  const Rational tiny = Rational(1) / 100000000;
  EXPECT_EQ(written({line({0, 0}, {tiny, 0}), line({tiny, 0}, {0, 100000000}),
                     line({0, 100000000}, {0, 0})}),
            "0 0 0\n0.00000001 0 0\n0 100000000 0\n");
}

TEST(PolyWriter, ABlankLinePartsLoops) {
  const std::vector<Move> there_and_back = {line({0, 0}, {1, 0}), line({1, 0}, {0, 0})};
  std::string out;
  append_poly(out, there_and_back);
  append_poly(out, there_and_back);
  EXPECT_EQ(out, "0 0 0\n1 0 0\n\n0 0 0\n1 0 0\n");
}

}  // namespace
}  // namespace dgt
