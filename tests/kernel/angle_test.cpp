// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/angle.h"

#include <gmock/gmock.h>

namespace dgt {
namespace {

UnitVector unit(int x, int y) { return UnitVector({x, y}); }

TEST(DirectionOfDegrees, MultiplesOf90AreExact) {
  const UnitVector expected[] = {unit(1, 0), unit(0, 1), unit(-1, 0), unit(0, -1)};
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const Direction d = direction_of(Rational(90 * quarter));
    EXPECT_EQ(d.unit, expected[((quarter % 4) + 4) % 4]) << 90 * quarter;
    EXPECT_EQ(d.bound, 0);
  }
}

TEST(DirectionOfDegrees, AtOddMultiplesOf45TheQuarterTurnsAreKept) {
  // A unit vector with |x| = |y| is irrational, so not both symmetries can hold here.
  for (int odd = -9; odd <= 9; odd += 2) {
    const UnitVector u = direction_of(Rational(45 * odd)).unit;
    EXPECT_EQ(direction_of(Rational(45 * odd + 90)).unit, turned_left(u)) << 45 * odd;
    EXPECT_EQ(direction_of(Rational(45 * odd + 360)).unit, u) << 45 * odd;
    EXPECT_EQ(direction_of(Rational(45 * odd - 360)).unit, u) << 45 * odd;
  }
}

TEST(DirectionOfVector, OnTheDiagonalsTheQuarterTurnsAreKept) {
  Vector v{1, 1};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(direction_of(turned_left(v)).unit, turned_left(direction_of(v).unit));
    EXPECT_EQ(direction_of(-v).unit, -direction_of(v).unit);
    v = turned_left(v);
  }
}

TEST(DirectionOfVector, AlongTheAxesIsExact) {
  EXPECT_EQ(direction_of(Vector{Rational(1, 3), 0}).unit, unit(1, 0));
  EXPECT_EQ(direction_of(Vector{0, -7}).unit, unit(0, -1));
  EXPECT_EQ(direction_of(Vector{0, -7}).bound, 0);
}

TEST(DirectionOfVector, OfTheZeroVectorThereIsNone) {
  EXPECT_THROW(static_cast<void>(direction_of(Vector{0, 0})), InternalError);
}

TEST(DirectionOfVector, IsTheSameOnEveryMachine) {
  // The half tangents: ⌊tan(45°/2)·2¹⁸⌋ / 2¹⁸, and tan(30°/2) to the nearest multiple of 2⁻¹⁷.
  const Direction d = direction_of(Vector{1, 1}, 16);
  EXPECT_EQ(d.unit, UnitVector::from_half_tangent(Rational(108583, 262144)));
  EXPECT_EQ(d.bound, 0x1p-16);
  EXPECT_EQ(direction_of(Rational(30), 16).unit,
            UnitVector::from_half_tangent(Rational(35121, 131072)));
}

TEST(UnitVector, AVectorOfAnotherLengthIsRefused) {
  EXPECT_THROW(UnitVector({1, 1}), InternalError);
}

}  // namespace
}  // namespace dgt
