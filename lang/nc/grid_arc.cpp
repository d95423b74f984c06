// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formulas stand in arc.cpp. A million arcs are read a second, so what passes a machine word
// goes through a few numbers that are kept from arc to arc.
#include "lang/nc/grid_arc.h"

#include <array>
#include <cmath>
#include <numeric>

namespace dgt::grid {
namespace {

constexpr long kUnit = Point::kDecimalStepsPerMillimetre;

void set(mpz_ptr out, Wide value) {
  const bool negative = value < 0;
  __extension__ typedef unsigned __int128 Unsigned;
  const auto magnitude = negative ? -static_cast<Unsigned>(value) : static_cast<Unsigned>(value);
  const std::array<std::uint64_t, 2> limbs = {static_cast<std::uint64_t>(magnitude),
                                              static_cast<std::uint64_t>(magnitude >> 64)};
  mpz_import(out, limbs.size(), -1, sizeof(std::uint64_t), 0, 0, limbs.data());
  if (negative) mpz_neg(out, out);
}

/// Whole steps as mm.
Rational millimetres(std::int64_t steps) {
  const std::int64_t common = std::gcd(steps, std::int64_t{kUnit});
  Rational value;
  mpq_set_si(value.get_mpq_t(), steps / common, static_cast<unsigned long>(kUnit / common));
  return value;
}

/// n / 2^bits in lowest terms.
Rational dyadic(mpz_srcptr n, int bits) {
  Rational value;
  mpz_set(value.get_num_mpz_t(), n);
  mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(bits));
  return value;
}

Rational with_sense(Rational radius, bool counter_clockwise) {
  if (!counter_clockwise) mpq_neg(radius.get_mpq_t(), radius.get_mpq_t());
  return radius;
}

/// The root of a square, when it is one.
std::optional<std::int64_t> whole_root(Wide square) {
  const auto root = static_cast<std::int64_t>(std::sqrt(static_cast<long double>(square)));
  for (const std::int64_t candidate : {root, root + 1})
    if (static_cast<Wide>(candidate) * candidate == square) return candidate;
  return std::nullopt;
}

/// Numbers that keep their memory between arcs.
struct Scratch {
  mpz_class a, b, c, d;
  mpz_class unit = kUnit;
  mpz_class unit_squared = mpz_class(kUnit) * kUnit;
};
Scratch& scratch() {
  thread_local Scratch numbers;
  return numbers;
}

/// √(value in steps²) mm, rounded down to 2^−bits.
Rational radius_of(Wide square, int bits) {
  if (const auto root = whole_root(square)) return millimetres(*root);
  Scratch& s = scratch();
  set(s.a.get_mpz_t(), square);
  s.a <<= static_cast<mp_bitcnt_t>(2 * bits);
  s.a /= s.unit_squared;
  mpz_sqrt(s.a.get_mpz_t(), s.a.get_mpz_t());
  return dyadic(s.a.get_mpz_t(), bits);
}

}  // namespace

double root_in_millimetres(Wide squared) {
  return static_cast<double>(std::sqrt(static_cast<long double>(squared)) / kUnit);
}

std::optional<bool> roots_differ(Wide a, Wide b, const Rational& tolerance) {
  // |√a − √b| = |a − b| / (√a + √b), off by a few units in the last place; mpq_get_d by one of a
  // double.
  constexpr long double kDoubt = 1e-14L;
  const long double sum =
      std::sqrt(static_cast<long double>(a)) + std::sqrt(static_cast<long double>(b));
  const long double difference = static_cast<long double>(a > b ? a - b : b - a) / sum / kUnit;
  const auto limit = static_cast<long double>(tolerance.get_d());
  if (difference > limit * (1 + kDoubt)) return true;
  if (difference < limit * (1 - kDoubt)) return false;
  return std::nullopt;
}

Circle circle_by_centre(const Vector& from, const Vector& chord, const Vector& centre,
                        bool counter_clockwise, int bits) {
  const Wide q = dot(chord, chord);
  const Wide s = dot(centre, centre);
  const Wide d = 2 * dot(centre, chord) - q;
  if (d == 0 || q == 0) {
    return {{millimetres(from.x + centre.x), millimetres(from.y + centre.y)},
            with_sense(radius_of(s, bits), counter_clockwise)};
  }
  Scratch& n = scratch();
  mpz_class& scale = n.a;
  mpz_class& offset = n.b;
  mpz_class& t = n.c;
  mpz_class& denominator = n.d;
  set(scale.get_mpz_t(), 2 * q);
  set(offset.get_mpz_t(), d);
  denominator = scale * n.unit;
  const auto coordinate = [&](std::int64_t whole, std::int64_t way) {
    mpz_mul_si(t.get_mpz_t(), scale.get_mpz_t(), whole);
    if (way >= 0)
      mpz_submul_ui(t.get_mpz_t(), offset.get_mpz_t(), static_cast<unsigned long>(way));
    else
      mpz_addmul_ui(t.get_mpz_t(), offset.get_mpz_t(), static_cast<unsigned long>(-way));
    t <<= static_cast<mp_bitcnt_t>(bits);
    mpz_fdiv_q(t.get_mpz_t(), t.get_mpz_t(), denominator.get_mpz_t());
    return dyadic(t.get_mpz_t(), bits);
  };
  RationalPoint foot{coordinate(from.x + centre.x, chord.x),
                     coordinate(from.y + centre.y, chord.y)};
  // (2·scale·s − d (scale + d)) / (2·scale·unit²)
  set(t.get_mpz_t(), s);
  t *= scale;
  t *= 2;
  denominator = scale + offset;
  mpz_submul(t.get_mpz_t(), offset.get_mpz_t(), denominator.get_mpz_t());
  t <<= static_cast<mp_bitcnt_t>(2 * bits);
  denominator = scale * n.unit_squared;
  denominator *= 2;
  mpz_tdiv_q(t.get_mpz_t(), t.get_mpz_t(), denominator.get_mpz_t());
  mpz_sqrt(t.get_mpz_t(), t.get_mpz_t());
  return {std::move(foot), with_sense(dyadic(t.get_mpz_t(), bits), counter_clockwise)};
}

Circle circle_by_radius(const Vector& from, const Vector& chord, std::int64_t radius, bool major,
                        bool counter_clockwise, int bits) {
  const Wide q = dot(chord, chord);
  const Wide rest = 4 * static_cast<Wide>(radius) * radius - q;
  Scratch& n = scratch();
  mpz_class& aside = n.a;
  mpz_class& divisor = n.b;
  mpz_class& t = n.c;
  set(aside.get_mpz_t(), rest);
  aside <<= static_cast<mp_bitcnt_t>(2 * bits);
  set(divisor.get_mpz_t(), 4 * q);
  mpz_tdiv_q(aside.get_mpz_t(), aside.get_mpz_t(), divisor.get_mpz_t());
  mpz_sqrt(aside.get_mpz_t(), aside.get_mpz_t());
  if (major == counter_clockwise) aside = -aside;
  // (2 from + chord) / 2 ± aside·chord turned left, over the unit.
  const auto coordinate = [&](std::int64_t whole, std::int64_t half, std::int64_t way) {
    t = whole;
    t *= 2;
    t += half;
    t <<= static_cast<mp_bitcnt_t>(bits - 1);
    if (way >= 0)
      mpz_addmul_ui(t.get_mpz_t(), aside.get_mpz_t(), static_cast<unsigned long>(way));
    else
      mpz_submul_ui(t.get_mpz_t(), aside.get_mpz_t(), static_cast<unsigned long>(-way));
    mpz_fdiv_q(t.get_mpz_t(), t.get_mpz_t(), n.unit.get_mpz_t());
    return dyadic(t.get_mpz_t(), bits);
  };
  RationalPoint centre{coordinate(from.x, chord.x, -chord.y), coordinate(from.y, chord.y, chord.x)};
  return {std::move(centre), with_sense(millimetres(radius), counter_clockwise)};
}

}  // namespace dgt::grid
