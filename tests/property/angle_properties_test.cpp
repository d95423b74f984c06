// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of direction_of, its bounds held by MPFR intervals at 400 bits.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "kernel/angle.h"
#include "tests/support/geometry_generators.h"
#include "tests/support/mpfr_interval.h"

namespace dgt {
namespace {

using test::any_angle;
using test::any_decimal;
using test::Interval;

Vector any_vector() {
  const Vector v = test::any_point(1000);
  return sgn(v.x) == 0 && sgn(v.y) == 0 ? Vector{1, 2} : v;
}

/// |sin| of the angle from `u` to the ideal (x, y) of any length, which must lie ahead of u.
Interval sine_between(const UnitVector& u, const Interval& x, const Interval& y) {
  const Interval ux(u.x());
  const Interval uy(u.y());
  RC_ASSERT((ux * x + uy * y).certainly_positive());
  return abs(ux * y - uy * x) / sqrt(x * x + y * y);
}

Rational diagonal_free_angle() {
  const Rational a = any_angle();
  return Rational(a / 45).get_den() == 1 && mpz_odd_p(Rational(a / 45).get_num_mpz_t()) != 0 ? a + 1
                                                                                             : a;
}

RC_GTEST_PROP(DirectionOfDegrees, WholeTurnsChangeNothing, ()) {
  const Rational a = any_angle();
  RC_ASSERT(direction_of(a + 360 * *rc::gen::inRange(-5, 6)).unit == direction_of(a).unit);
}

RC_GTEST_PROP(DirectionOfDegrees, AddingAQuarterTurnsExactly, ()) {
  const Rational a = any_angle();
  RC_ASSERT(direction_of(a + 90).unit == turned_left(direction_of(a).unit));
  RC_ASSERT(direction_of(a + 180).unit == -direction_of(a).unit);
}

RC_GTEST_PROP(DirectionOfDegrees, TheNegativeAngleMirrorsExactly, ()) {
  const Rational a = diagonal_free_angle();
  const UnitVector u = direction_of(a).unit;
  RC_ASSERT(direction_of(-a).unit == UnitVector({u.x(), -u.y()}));
}

RC_GTEST_PROP(DirectionOfDegrees, TheAngleDiffersByAtMostTheBound, ()) {
  const Rational a = any_angle();
  const int bits = *rc::gen::element(8, 30, 96, 200);
  const Direction d = direction_of(a, bits);
  RC_ASSERT(d.bound <= std::ldexp(1.0, -bits));
  const Interval ideal = test::radians(a);
  RC_ASSERT(sine_between(d.unit, cos(ideal), sin(ideal)).at_most(d.bound));
}

RC_GTEST_PROP(DirectionOfDegrees, MinuteAnglesKeepTheBound, ()) {
  const Rational a = any_decimal() * power_of_two(-*rc::gen::inRange(0, 200));
  const Direction d = direction_of(a);
  const Interval ideal = test::radians(a);
  RC_ASSERT(sine_between(d.unit, cos(ideal), sin(ideal)).at_most(d.bound));
}

RC_GTEST_PROP(DirectionOfVector, ParallelVectorsGetTheSameUnitVector, ()) {
  const Vector v = any_vector();
  const Rational k = abs(test::nonzero_decimal());
  RC_ASSERT(direction_of(k * v).unit == direction_of(v).unit);
  RC_ASSERT(direction_of((1 / k) * v).unit == direction_of(v).unit);
}

RC_GTEST_PROP(DirectionOfVector, OppositeVectorsGetOppositeUnitVectors, ()) {
  const Vector v = any_vector();
  const Rational k = -abs(test::any_radius());
  RC_ASSERT(direction_of(k * v).unit == -direction_of(v).unit);
}

RC_GTEST_PROP(DirectionOfVector, AVectorOfRationalLengthIsExact, ()) {
  const UnitVector u = test::pythagorean_unit();
  const Direction d = direction_of(abs(test::nonzero_decimal()) * u.vector());
  RC_ASSERT(d.unit == u);
  RC_ASSERT(d.bound == 0);
}

RC_GTEST_PROP(DirectionOfVector, QuarterTurnsAndMirrorsCarryOver, ()) {
  const Vector v = any_vector();
  const UnitVector u = direction_of(v).unit;
  RC_ASSERT(direction_of(turned_left(v)).unit == turned_left(u));
  if (abs(v.x) == abs(v.y)) return;
  RC_ASSERT(direction_of(Vector{v.x, -v.y}).unit == UnitVector({u.x(), -u.y()}));
  RC_ASSERT(direction_of(Vector{v.y, v.x}).unit == UnitVector({u.y(), u.x()}));
}

RC_GTEST_PROP(DirectionOfVector, TheAngleDiffersByAtMostTheBound, ()) {
  Vector v = any_vector();
  if (*rc::gen::arbitrary<bool>()) v.y = v.y * power_of_two(-*rc::gen::inRange(1, 150));
  if (sgn(v.x) == 0 && sgn(v.y) == 0) v.x = 1;
  const int bits = *rc::gen::element(8, 30, 96, 200);
  const Direction d = direction_of(v, bits);
  RC_ASSERT(d.bound <= std::ldexp(1.0, -bits));
  RC_ASSERT(sine_between(d.unit, Interval(v.x), Interval(v.y)).at_most(d.bound));
}

RC_GTEST_PROP(DirectionOfOneRoots, TheAngleDiffersByAtMostTheBound, ()) {
  const Rational c = abs(any_decimal());
  const Rational tiny = power_of_two(-*rc::gen::inRange(0, 120));
  OneRoot x(any_decimal(), any_decimal(), c);
  OneRoot y(any_decimal(), any_decimal(), c);
  if (*rc::gen::arbitrary<bool>()) x = x * tiny;
  if (*rc::gen::arbitrary<bool>())  // both coordinates the leftovers of a cancellation
    x = OneRoot(-sqrt_within(c, -80), 1, c), y = OneRoot(-sqrt_within(c, -75), 1, c);
  if (sign(x) == 0 && sign(y) == 0) return;
  const Direction d = direction_of(x, y);
  const auto interval = [&](const OneRoot& z) {
    return Interval(z.a) + Interval(z.b) * sqrt(Interval(z.c));
  };
  RC_ASSERT(d.bound <= 0x1p-96);
  RC_ASSERT(sine_between(d.unit, interval(x), interval(y)).at_most(d.bound));
}

}  // namespace
}  // namespace dgt
