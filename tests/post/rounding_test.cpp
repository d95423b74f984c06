// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/rounding.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/post/paths.h"

namespace dgt {
namespace {

using testing::q;

Rational ratio(std::int64_t numerator, std::int64_t denominator) {
  Rational r(static_cast<long>(numerator), static_cast<long>(denominator));
  r.canonicalize();
  return r;
}

Grid tenths(RationalPoint origin = {}) { return {Rational(1, 10), std::move(origin)}; }

GridPoint nearest(const Grid& grid, const char* x, const char* y) {
  return grid.nearest(Point(RationalPoint{q(x), q(y)})).value();
}

TEST(GridNearest, HalfWayGoesAwayFromTheOrigin) {
  EXPECT_EQ(nearest(tenths(), "0.05", "-0.05"), (GridPoint{1, -1}));
  EXPECT_EQ(nearest(tenths(), "0.15", "-0.25"), (GridPoint{2, -3}));
  EXPECT_EQ(nearest(tenths({q("1"), q("1")}), "0.95", "1.05"), (GridPoint{-1, 1}));
}

TEST(GridNearest, JustBesideHalfWayIsDecidedExactly) {
  EXPECT_EQ(nearest(tenths(), "0.0499999999999999999999999", "0.0500000000000000000000001"),
            (GridPoint{0, 1}));
}

TEST(GridNearest, HalfWayBetweenForAnIrrationalPoint) {
  // The circle of radius √… is cut where x = 0.05 exactly; y is irrational.
  const Carrier circle = carrier(Circle({0, 0}, 7));
  const Carrier line = carrier(Line(UnitVector(Vector{1, 0}), q("0.05")));
  const auto meeting = meet(line, circle);
  const Point p = std::get<TwoPoints>(meeting).at(Which::Entry);
  const GridPoint k = tenths().nearest(p).value();
  EXPECT_EQ(k.x, 1);
  EXPECT_EQ(std::abs(k.y), 70);
}

TEST(GridNearest, BeyondTheLimitIsNothing) {
  EXPECT_FALSE(tenths().nearest(Point(RationalPoint{q("100000000000.1"), 0})));
  EXPECT_TRUE(tenths().nearest(Point(RationalPoint{q("100000000000"), 0})));
  EXPECT_FALSE(tenths().nearest(Point(RationalPoint{0, q("-1000000000000000000000000000000")})));
}

RC_GTEST_PROP(GridNearest, LiesWithinHalfAUnitOnEachAxis, (std::int64_t n, std::int64_t m)) {
  const Rational unit = ratio(*rc::gen::inRange(1, 2000), 10000);
  const Rational origin = ratio(n % 1000003, 997);
  const Rational x = ratio(n % 100000007, 1 + std::abs(m % 10007));
  const Rational y = origin + unit * (m % 100003) + unit / 2;  // half-way
  const Grid grid(unit, {origin, origin});
  const GridPoint k = grid.nearest(Point(RationalPoint{x, y})).value();
  RC_ASSERT(abs(Rational(origin + unit * static_cast<long>(k.x) - x)) <= unit / 2);
  const Rational off = origin + unit * static_cast<long>(k.y) - y;
  RC_ASSERT(abs(off) == unit / 2);
  RC_ASSERT(sgn(off) == (k.y > 0 ? 1 : -1));
}

RC_GTEST_PROP(GridNearest, IncrementsOfAClosedPathSumToZero, (std::vector<std::int16_t> steps)) {
  const Grid grid = tenths({Rational(1, 3), Rational(1, 7)});
  Rational x(1, 3);
  GridPoint last;
  std::int64_t sum = 0;
  const auto go = [&] {
    const GridPoint next = grid.nearest(Point(RationalPoint{x, Rational(1, 7)})).value();
    sum += next.x - last.x;
    last = next;
  };
  for (const std::int16_t s : steps) {
    x += ratio(s, 300);
    go();
  }
  x = Rational(1, 3);
  go();
  RC_ASSERT(sum == 0);
}

}  // namespace
}  // namespace dgt
