// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/angle.h"

#include <mpfr.h>

#include <algorithm>
#include <cmath>

#include "kernel/check.h"
#include "kernel/mpfr_float.h"

namespace dgt {
namespace {

/// tan(degrees/2) for 0 < degrees ≤ 45, rounded to the multiple of 2^−(bits+1) nearest to an
/// approximation good to 2^−(bits+30): off by less than 2^−(bits+1), so the angle 2·arctan(t) is
/// off by less than 2^−bits.
Rational half_tangent(const Rational& degrees, int bits) {
  MpfrFloat angle(bits + 40);
  MpfrFloat pi(bits + 40);
  mpfr_set_q(angle, degrees.get_mpq_t(), MPFR_RNDN);
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_mul(angle, angle, pi, MPFR_RNDN);
  mpfr_div_ui(angle, angle, 360, MPFR_RNDN);
  mpfr_tan(angle, angle, MPFR_RNDN);
  Integer scaled;
  mpfr_mul_2si(angle, angle, bits + 1, MPFR_RNDN);
  mpfr_get_z(scaled.get_mpz_t(), angle, MPFR_RNDN);
  return Rational(scaled) * power_of_two(-(bits + 1));
}

}  // namespace

Direction direction_of(const Rational& degrees, int bits) {
  // a = 90·quarter + rest with −45 ≤ rest < 45; the rest's sign and the quarter turns are applied
  // exactly, which is what makes the symmetries exact. Rounding the tie at 45 always upwards makes
  // the quarter periodic, where rounding away from zero would not.
  const Rational quarters = degrees / 90 + Rational(1, 2);
  Integer quarter;
  mpz_fdiv_q(quarter.get_mpz_t(), quarters.get_num_mpz_t(), quarters.get_den_mpz_t());
  const Rational rest = degrees - 90 * Rational(quarter);
  Direction result;
  if (sgn(rest) != 0) {
    Rational t = half_tangent(abs(rest), bits);
    if (sgn(rest) < 0) t = -t;
    result = {UnitVector::from_half_tangent(t), std::ldexp(1.0, -bits)};
  }
  const unsigned long turns = mpz_fdiv_ui(quarter.get_mpz_t(), 4);
  for (unsigned long i = 0; i < turns; ++i) result.unit = turned_left(result.unit);
  return result;
}

Direction direction_of(const Vector& v, int bits) {
  DGT_CHECK(sgn(v.x) != 0 || sgn(v.y) != 0);
  // Primitive whole-number direction: the same for all positive multiples of v.
  Integer x = v.x.get_num() * v.y.get_den();
  Integer y = v.y.get_num() * v.x.get_den();
  Integer g;
  mpz_gcd(g.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
  x /= g;
  y /= g;
  // Into the octant 0 ≤ y ≤ x, and back at the end: exact symmetries.
  const bool flip_x = sgn(x) < 0;
  const bool flip_y = sgn(y) < 0;
  if (flip_x) x = -x;
  if (flip_y) y = -y;
  // On the diagonals the swap follows the quadrant: they are quarter turns of one another.
  const bool swapped = y > x || (y == x && flip_x != flip_y);
  if (swapped) std::swap(x, y);

  Rational ux;
  Rational uy;
  double bound = 0;
  const Integer square = x * x + y * y;
  if (mpz_perfect_square_p(square.get_mpz_t())) {
    Integer length;
    mpz_sqrt(length.get_mpz_t(), square.get_mpz_t());
    ux = Rational(x, length);
    uy = Rational(y, length);
    ux.canonicalize();
    uy.canonicalize();
  } else {
    // t = y / (x + |v|) lies in (0, tan 22.5°]; scaled by 2^k and cut to a whole number.
    const auto k = static_cast<mp_bitcnt_t>(bits + 2);
    const Integer scaled_square = square << (2 * k);
    Integer length;
    mpz_sqrt(length.get_mpz_t(), scaled_square.get_mpz_t());
    Integer t = (y << (2 * k)) / ((x << k) + length);
    // The root is off by less than 1 in 2^k·|v|, the quotient by less than 1 more: |δt| < 2·2^−k.
    const UnitVector u = UnitVector::from_half_tangent(Rational(t) / Rational(Integer(1) << k));
    ux = u.x();
    uy = u.y();
    bound = std::ldexp(1.0, -bits);
  }
  if (swapped) std::swap(ux, uy);
  if (flip_x) ux = -ux;
  if (flip_y) uy = -uy;
  return {UnitVector({ux, uy}), bound};
}

Direction direction_of(const OneRoot& x, const OneRoot& y, int bits) {
  if (x.is_rational() && y.is_rational()) return direction_of(Vector{x.a, y.a}, bits);
  // Tighten until the stand-in vector is 2^-(bits+2) relative: its error over its size.
  for (int exponent = -(bits + 16);; exponent *= 2) {
    DGT_CHECK(exponent > -100000);  // only the zero vector gets here
    const Vector v{rational_within(x, exponent), rational_within(y, exponent)};
    const Rational size = abs(v.x) > abs(v.y) ? abs(v.x) : abs(v.y);
    if (size > power_of_two(exponent + bits + 4)) {
      Direction d = direction_of(v, bits + 1);
      d.bound = std::ldexp(1.0, -bits);
      return d;
    }
  }
}

}  // namespace dgt
