// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/stretch.h"

#include <gmock/gmock.h>

#include "tests/kernel/contour_notation.h"

namespace dgt::notation {
namespace {

/// Far below what any double could tell.
Rational hair() { return power_of_two(-300); }

void expect_exactly(const Stretch& a, const Stretch& b, const Rational& distance) {
  EXPECT_FALSE(comes_nearer(a, b, distance));
  EXPECT_TRUE(comes_nearer(a, b, distance + hair()));
  EXPECT_FALSE(comes_nearer(b, a, distance));
  EXPECT_TRUE(comes_nearer(b, a, distance + hair()));
}

Stretch on(const ElementPtr& e, const Point& from, const Point& to) { return {from, to, {e, {}}}; }

Point crossing(const ElementPtr& a, const ElementPtr& b, Which which) {
  return Point::crossing({a, {}}, {b, {}}, which);
}

TEST(StretchDistance, OfParallelSegmentsIsToldToTheLastBit) {
  expect_exactly(on(horizontal("0"), at("0", "0"), at("10", "0")),
                 on(horizontal("4.2"), at("2", "4.2"), at("20", "4.2")), number("4.2"));
}

TEST(StretchDistance, OfEndsOverDifferentRootsIsToldToTheLastBit) {
  const auto line = horizontal("0");
  const auto far = horizontal("1");  // ends: (√5/2, 0) and (−3/4, 1)
  const Stretch a = on(line, crossing(line, circle("0", "1", "1.5"), Which::Exit), at("50", "0"));
  const Stretch b = on(far, at("-50", "1"), crossing(far, circle("0", "0", "1.25"), Which::Entry));
  const Rational square = Rational(5, 4) + Rational(9, 16) + 1;
  const OneRoot gap_square{square, Rational(3, 4), 5};  // + 2·(√5/2)·(3/4)
  const Rational low = sqrt_within(rational_within(gap_square, -400), -200);
  EXPECT_FALSE(comes_nearer(a, b, low - power_of_two(-190)));
  EXPECT_TRUE(comes_nearer(a, b, low + power_of_two(-190)));
}

TEST(StretchDistance, OfALineAndAnArcOnTheNormalIsToldToTheLastBit) {
  expect_exactly(on(horizontal("0"), at("-9", "0"), at("9", "0")),
                 on(circle("1", "8", "5"), at("-4", "8"), at("6", "8")), Rational(3));
}

TEST(StretchDistance, OfTheFarSideOfAnArcIsThatOfItsEnds) {
  // The upper half of the same circle: the normal does not meet it.
  expect_exactly(on(horizontal("0"), at("-4", "0"), at("9", "0")),
                 on(circle("1", "8", "-5"), at("-4", "8"), at("6", "8")), Rational(8));
}

TEST(StretchDistance, OfArcsOnTheLineOfCentresIsToldToTheLastBit) {
  expect_exactly(on(circle("0", "0", "2"), at("0", "-2"), at("0", "2")),
                 on(circle("9", "0", "-3"), at("9", "-3"), at("9", "3")), Rational(4));
}

TEST(StretchDistance, OfConcentricArcsIsTheDifferenceOfTheirRadii) {
  expect_exactly(on(circle("0", "0", "2"), at("0", "-2"), at("0", "2")),
                 on(circle("0", "0", "5"), at("3", "-4"), at("3", "4")), Rational(3));
}

TEST(StretchDistance, OfAFullCircleAboutAPointIsItsRadius) {
  expect_exactly(on(circle("0", "0", "5"), at("5", "0"), at("5", "0")),
                 on(horizontal("0"), at("0", "0"), at("1", "0")), Rational(4));
}

TEST(StretchDistance, OfStretchesThatCrossIsNothing) {
  const Stretch a = on(horizontal("0"), at("-9", "0"), at("9", "0"));
  const Stretch b = on(vertical("0"), at("0", "9"), at("0", "-9"));
  EXPECT_TRUE(comes_nearer(a, b, hair()));
  EXPECT_FALSE(comes_nearer(a, b, 0));
  EXPECT_EQ(crossings_inside(a, b).size(), 1U);
}

TEST(StretchDistance, OfHalfACircleHoldsItsEndsAndNothingBeyond) {
  const Stretch half = on(circle("0", "0", "5"), at("5", "0"), at("-5", "0"));
  EXPECT_TRUE(covers(half, at("5", "0")));
  EXPECT_TRUE(covers(half, at("-5", "0")));
  EXPECT_TRUE(covers(half, at("0", "5")));
  EXPECT_FALSE(covers(half, at("0", "-5")));
}

TEST(CommonPlaces, OfCoincidentLinesAreTheEndsThatLieOnTheOther) {
  const Stretch a = on(horizontal("0"), at("0", "0"), at("10", "0"));
  const Stretch b = on(minus(horizontal("0")), at("15", "0"), at("5", "0"));
  EXPECT_THAT(common_places(a, b), testing::ElementsAre(at("10", "0"), at("5", "0")));
}

TEST(CommonPlaces, OfACrossingAtAnEndIsThatEnd) {
  const Stretch a = on(horizontal("0"), at("0", "0"), at("10", "0"));
  const Stretch b = on(vertical("10"), at("10", "5"), at("10", "0"));
  EXPECT_THAT(common_places(a, b), testing::ElementsAre(at("10", "0")));
  EXPECT_THAT(crossings_inside(a, b), testing::IsEmpty());
}

}  // namespace
}  // namespace dgt::notation
