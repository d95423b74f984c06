// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of the kernel's numbers, against exact rationals and against MPFR at 4000 bits.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/number.h"
#include "tests/support/geometry_generators.h"
#include "tests/support/mpfr_interval.h"

namespace dgt {
namespace {

using test::any_decimal;
using test::Real;

constexpr mpfr_prec_t kOracleBits = 4000;

/// a + b√c in MPFR: 4000 bits decide every rounding that these operands can ask for.
Real oracle(const OneRoot& x) {
  Real root(kOracleBits);
  Real sum(kOracleBits);
  mpfr_set_q(root, x.c.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(root, root, MPFR_RNDN);
  mpfr_mul_q(root, root, x.b.get_mpq_t(), MPFR_RNDN);
  mpfr_set_q(sum, x.a.get_mpq_t(), MPFR_RNDN);
  mpfr_add(sum, sum, root, MPFR_RNDN);
  return sum;
}

Rational any_rational() {
  Rational value(*rc::gen::inRange(-1000000, 1000001), *rc::gen::inRange(1, 1000));
  value.canonicalize();
  return value;
}

OneRoot any_one_root() { return {any_rational(), any_rational(), abs(any_rational())}; }

/// A number at, or a hair beside, the midpoint of two neighbouring doubles.
Rational halfway_adjacent(double* low, int* side) {
  *low = std::ldexp(1.0 + *rc::gen::inRange(0, 1 << 30) * 0x1p-30, *rc::gen::inRange(-40, 40));
  const double high = std::nextafter(*low, std::numeric_limits<double>::infinity());
  *side = *rc::gen::inRange(-1, 2);
  const int fineness = *rc::gen::element(-120, -300, -900);
  return (Rational(*low) + Rational(high)) / 2 + *side * power_of_two(fineness);
}

double expected_beside_halfway(double low, int side) {
  const double high = std::nextafter(low, std::numeric_limits<double>::infinity());
  if (side != 0) return side < 0 ? low : high;
  const auto mantissa = static_cast<long long>(std::scalbn(low, 52 - std::ilogb(low)));
  return mantissa % 2 == 0 ? low : high;  // ties to even
}

RC_GTEST_PROP(Decimals, PrintingAndParsingIsTheIdentity, ()) {
  const Rational value = any_decimal(100000);
  RC_ASSERT(parse_decimal(to_decimal(value, 4)) == value);
  RC_ASSERT(parse_decimal(to_short_decimal(value)) == value);
  RC_ASSERT(to_short_decimal(value).size() <= to_decimal(value, 4).size());
}

RC_GTEST_PROP(Decimals, PrintingIsOffByAtMostHalfAUnit, ()) {
  const Rational value = any_rational();
  const auto printed = parse_decimal(to_decimal(value, 3));
  RC_ASSERT(printed.has_value());
  RC_ASSERT(abs(*printed - value) <= Rational(1, 2000));
}

RC_GTEST_PROP(NearestDouble, OfARationalAgreesWithMpfr, ()) {
  const Rational value = any_rational() / (1 + abs(any_rational()));
  RC_ASSERT(nearest_double(value) == mpfr_get_d(oracle(OneRoot(value)), MPFR_RNDN));
}

RC_GTEST_PROP(NearestDouble, BesideTheMidpointOfTwoDoublesIsDecidedExactly, ()) {
  double low = 0;
  int side = 0;
  const Rational value = halfway_adjacent(&low, &side);
  RC_ASSERT(nearest_double(value) == expected_beside_halfway(low, side));
  RC_ASSERT(nearest_double(OneRoot(value)) == expected_beside_halfway(low, side));
  RC_ASSERT(nearest_double(-OneRoot(value)) == -expected_beside_halfway(low, side));
}

RC_GTEST_PROP(NearestDouble, OfARootBesideTheMidpointOfTwoDoublesIsDecidedExactly, ()) {
  // a + √(b² ± ε) with a + b a midpoint: the root is off b by about ε / 2b, and the sum irrational.
  double low = 0;
  int side = 0;
  const Rational middle = halfway_adjacent(&low, &side);
  const Rational b(*rc::gen::inRange(1, 1000));
  const int sense = *rc::gen::element(-1, 1);
  const int fineness = *rc::gen::element(-150, -700);
  const OneRoot x(middle - side * power_of_two(-120) - b, 1,
                  b * b + sense * power_of_two(fineness));
  RC_ASSERT(nearest_double(x) == mpfr_get_d(oracle(x), MPFR_RNDN));
}

RC_GTEST_PROP(NearestDouble, OfAOneRootAgreesWithMpfr, ()) {
  const OneRoot x = any_one_root();
  const Real expected = oracle(x);
  if (expected.sign() == 0 || mpfr_get_exp(expected) < kZeroExponent) return;
  RC_ASSERT(nearest_double(x) == mpfr_get_d(expected, MPFR_RNDN));
}

RC_GTEST_PROP(NearestDouble, HeavyCancellationLosesNothing, ()) {
  // (√c rounded to 2^-k) − √c: what is left is far below the operands.
  const Rational c = Rational(*rc::gen::inRange(2, 100000));
  const int k = *rc::gen::inRange(1, 63);
  const OneRoot x(-sqrt_within(c, -k), 1, c);
  const double expected = mpfr_get_d(oracle(x), MPFR_RNDN);
  RC_ASSERT(nearest_double(x) == (std::fabs(expected) <= 0x1p-64 ? 0 : expected));
}

RC_GTEST_PROP(OneRootOrder, OverDifferentRootsAgreesWithMpfr, ()) {
  const OneRoot x = any_one_root();
  const OneRoot y = any_one_root();
  const Real ox = oracle(x);
  const Real oy = oracle(y);
  const int order = mpfr_cmp(ox, oy);
  RC_ASSERT(compare(x, y) == (order > 0) - (order < 0));
  RC_ASSERT(compare(y, x) == -compare(x, y));
  RC_ASSERT(sign(x) == ox.sign());
}

RC_GTEST_PROP(OneRootOrder, EqualNumbersOverDifferentFormsOfTheRootAreEqual, ()) {
  const OneRoot x = any_one_root();
  const Rational k = 1 + abs(any_rational());
  const OneRoot same(x.a, x.b / k, x.c * k * k);
  RC_ASSERT(compare(x, same) == 0);
  RC_ASSERT(compare(x, same + power_of_two(-2000)) == -1);
  RC_ASSERT(compare(x, same - power_of_two(-2000)) == 1);
}

RC_GTEST_PROP(OneRootOrder, NearlyEqualNumbersOverDifferentRootsAreTold, ()) {
  // √c against the best rational multiple of √d of 200 bits
  const Rational c(*rc::gen::inRange(2, 1000));
  const Rational d(*rc::gen::inRange(2, 1000));
  const OneRoot x(0, 1, c);
  const OneRoot y(0, sqrt_within(c / d, -200), d);
  const Real ox = oracle(x);
  const Real oy = oracle(y);
  const bool equal = y.b * y.b * d == c;
  const int order = mpfr_cmp(ox, oy);
  RC_ASSERT(compare(x, y) == (equal ? 0 : (order > 0) - (order < 0)));
}

RC_GTEST_PROP(NearestInteger, IsWithinAHalfAndTiesGoAwayFromZero, ()) {
  const Rational value = *rc::gen::arbitrary<bool>()
                             ? any_rational()
                             : Rational(*rc::gen::inRange(-2000, 2000)) + Rational(1, 2);
  const Integer rounded = nearest_integer(value);
  const Rational off = abs(value - Rational(rounded));
  RC_ASSERT(off <= Rational(1, 2));
  if (off == Rational(1, 2)) RC_ASSERT(abs(Rational(rounded)) > abs(value));
  RC_ASSERT(nearest_integer(Rational(-value)) == -rounded);
  // the same number written with a root
  RC_ASSERT(nearest_integer(OneRoot(value - 3, Rational(3, 2), 4)) == rounded);
}

RC_GTEST_PROP(NearestInteger, OfAnIrrationalAgreesWithMpfr, ()) {
  const OneRoot x = any_one_root();
  Real rounded = oracle(x);
  mpfr_round(rounded, rounded);
  Integer expected;
  mpfr_get_z(expected.get_mpz_t(), rounded, MPFR_RNDN);
  RC_ASSERT(nearest_integer(x) == expected);
}

RC_GTEST_PROP(SqrtWithin, IsWithinThePowerOfTwoAskedFor, ()) {
  const Rational value = abs(any_rational()) / (1 + abs(any_rational()));
  const int exponent = *rc::gen::inRange(-400, 3);
  const Rational root = sqrt_within(value, exponent);
  const Rational slack = power_of_two(exponent);
  RC_ASSERT(sgn(root) >= 0);
  RC_ASSERT((root + slack) * (root + slack) >= value);
  if (root > slack) RC_ASSERT((root - slack) * (root - slack) <= value);
}

RC_GTEST_PROP(ExactSqrt, FindsTheRootOfEverySquareAndOfNothingElse, ()) {
  const Rational value = abs(any_rational());
  RC_ASSERT(exact_sqrt(value * value) == value);
  if (sgn(value) != 0) RC_ASSERT(!exact_sqrt(2 * value * value));
}

RC_GTEST_PROP(RationalWithin, IsWithinThePowerOfTwoAskedFor, ()) {
  const OneRoot x = any_one_root();
  const int exponent = *rc::gen::inRange(-300, 3);
  const Rational r = rational_within(x, exponent);
  RC_ASSERT(compare(x, r + power_of_two(exponent)) <= 0);
  RC_ASSERT(compare(x, r - power_of_two(exponent)) >= 0);
}

RC_GTEST_PROP(DyadicGrid, TheNearestMultipleIsTaken, ()) {
  const Rational value = any_rational();
  const int exponent = *rc::gen::inRange(-80, 8);
  const Rational r = on_dyadic_grid(value, exponent);
  RC_ASSERT(Rational(r / power_of_two(exponent)).get_den() == 1);
  RC_ASSERT(2 * abs(r - value) <= power_of_two(exponent));
}

RC_GTEST_PROP(Combine, IsTheLinearCombination, ()) {
  const Rational c = abs(any_rational());
  const OneRoot x(any_rational(), *rc::gen::arbitrary<bool>() ? any_rational() : Rational(0), c);
  OneRoot y(any_rational(), any_rational(), c);
  if (*rc::gen::arbitrary<bool>()) y.c = 0;  // rational, whatever stands before the root
  const OneRoot sum = combine(2, x, -3, y, 7);
  Real expected = oracle(x);
  Real other = oracle(y);
  mpfr_mul_si(expected, expected, 2, MPFR_RNDN);
  mpfr_mul_si(other, other, 3, MPFR_RNDN);
  mpfr_sub(expected, expected, other, MPFR_RNDN);
  mpfr_add_si(expected, expected, 7, MPFR_RNDN);
  mpfr_sub(expected, expected, oracle(sum), MPFR_RNDN);
  RC_ASSERT(expected.sign() == 0 || mpfr_get_exp(expected) < -3000);
}

}  // namespace
}  // namespace dgt
