// SPDX-License-Identifier: GPL-3.0-or-later
//
// With the chord w and the centre c seen from the beginning, q = |w|² and d = |c|² − |c − w|² =
// 2 c·w − q, the foot of the centre on the bisector is c − w d/2q, and its squared distance from
// either end |c|² − d/2 − d²/4q. All of it is worked out in whole numbers over one denominator,
// since lowest terms would cost more than the rest.
#include "lang/nc/arc.h"

#include <cmath>

#include "kernel/check.h"
#include "lang/nc/grid_arc.h"

namespace dgt {
namespace {

constexpr mp_bitcnt_t kBits = kArcBits;

struct WholeVector {
  Integer x;
  Integer y;
};

Integer dot(const WholeVector& a, const WholeVector& b) { return a.x * b.x + a.y * b.y; }
Integer cross(const WholeVector& a, const WholeVector& b) { return a.x * b.y - a.y * b.x; }
Integer square(const WholeVector& a) { return dot(a, a); }

bool is_zero(const Spot& v) { return v.x.is_zero() && v.y.is_zero(); }

/// Two vectors in whole numbers of 1/unit mm.
struct WholePair {
  WholeVector a;
  WholeVector b;
  Integer unit = static_cast<long>(Point::kDecimalStepsPerMillimetre);

  WholePair(const Spot& a_, const Spot& b_) {
    if (a_.on_grid() && b_.on_grid()) {
      a = {a_.x.steps(), a_.y.steps()};
      b = {b_.x.steps(), b_.y.steps()};
      return;
    }
    const RationalPoint p = a_.exact();
    const RationalPoint q = b_.exact();
    for (const Rational* const value : {&p.x, &p.y, &q.x, &q.y})
      mpz_lcm(unit.get_mpz_t(), unit.get_mpz_t(), value->get_den_mpz_t());
    const auto whole = [this](const Rational& value) {
      return Integer(value.get_num() * (unit / value.get_den()));
    };
    a = {whole(p.x), whole(p.y)};
    b = {whole(q.x), whole(q.y)};
  }
};

/// numerator / denominator, rounded down to a multiple of 2^−kBits.
Rational dyadic(const Integer& numerator, const Integer& denominator) {
  Integer scaled = numerator << kBits;
  mpz_fdiv_q(scaled.get_mpz_t(), scaled.get_mpz_t(), denominator.get_mpz_t());
  Rational value(scaled);
  mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), kBits);
  return value;
}

/// √(numerator / denominator) likewise.
Rational dyadic_root(const Integer& numerator, const Integer& denominator) {
  Integer scaled = numerator << (2 * kBits);
  scaled /= denominator;
  mpz_sqrt(scaled.get_mpz_t(), scaled.get_mpz_t());
  Rational value(scaled);
  mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), kBits);
  return value;
}

Rational fraction(Integer numerator, Integer denominator) {
  Rational value(std::move(numerator), std::move(denominator));
  value.canonicalize();
  return value;
}

/// `from` + (x, y)/unit. On the grid, which is the rule, a sum of whole numbers.
RationalPoint exact_sum(const Spot& from, const WholeVector& v, const Integer& unit) {
  if (from.on_grid() && unit == Point::kDecimalStepsPerMillimetre)
    return {fraction(v.x + from.x.steps(), unit), fraction(v.y + from.y.steps(), unit)};
  const RationalPoint origin = from.exact();
  return {origin.x + fraction(v.x, unit), origin.y + fraction(v.y, unit)};
}

/// The same rounded down to 2^−kBits, which spares every later user the long denominator.
RationalPoint dyadic_sum(const Spot& from, const WholeVector& v, const Integer& unit,
                         const Integer& scale) {
  const Integer denominator = unit * scale;
  if (from.on_grid() && unit == Point::kDecimalStepsPerMillimetre) {
    return {dyadic(v.x + from.x.steps() * scale, denominator),
            dyadic(v.y + from.y.steps() * scale, denominator)};
  }
  const RationalPoint origin = from.exact();
  return {origin.x + dyadic(v.x, denominator), origin.y + dyadic(v.y, denominator)};
}

Rational signed_radius(Rational radius, bool counter_clockwise) {
  if (!counter_clockwise) mpq_neg(radius.get_mpq_t(), radius.get_mpq_t());
  return radius;
}

/// The root of a whole number over `unit`: exact where it is whole.
Rational root_over(const Integer& value, const Integer& unit) {
  Integer root;
  Integer rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), value.get_mpz_t());
  if (sgn(rest) == 0) return fraction(std::move(root), unit);
  return dyadic_root(value, unit * unit);
}

struct SquaredRadii {
  grid::Wide first;
  grid::Wide last;
};
SquaredRadii squared_radii(const Spot& chord, const Spot& centre) {
  const grid::Vector w = grid::steps_of(chord);
  const grid::Vector c = grid::steps_of(centre);
  const grid::Vector e{c.x - w.x, c.y - w.y};
  return {grid::dot(c, c), grid::dot(e, e)};
}

double in_millimetres(const Integer& squared, const Integer& unit) {
  return std::sqrt(mpz_get_d(squared.get_mpz_t())) / mpz_get_d(unit.get_mpz_t());
}

}  // namespace

Circle circle_by_centre(const Spot& from, const Spot& chord, const Spot& centre,
                        bool counter_clockwise) {
  if (from.on_grid() && chord.on_grid() && centre.on_grid()) {
    return grid::circle_by_centre(grid::steps_of(from), grid::steps_of(chord),
                                  grid::steps_of(centre), counter_clockwise, kArcBits);
  }
  const WholePair whole(chord, centre);
  const WholeVector& w = whole.a;
  const WholeVector& c = whole.b;
  const Integer q = square(w);
  const Integer s = square(c);
  const Integer d = 2 * dot(c, w) - q;
  if (sgn(d) == 0 || sgn(q) == 0) {
    return {exact_sum(from, c, whole.unit),
            signed_radius(root_over(s, whole.unit), counter_clockwise)};
  }
  const Integer scale = 2 * q;
  const WholeVector foot{c.x * scale - w.x * d, c.y * scale - w.y * d};
  const Rational radius =
      dyadic_root(2 * scale * s - d * (scale + d), 2 * scale * whole.unit * whole.unit);
  return {dyadic_sum(from, foot, whole.unit, scale), signed_radius(radius, counter_clockwise)};
}

EndRadii end_radii(const Spot& chord, const Spot& centre) {
  if (chord.on_grid() && centre.on_grid()) {
    const auto [first, last] = squared_radii(chord, centre);
    return {grid::root_in_millimetres(first), grid::root_in_millimetres(last), first == last};
  }
  const WholePair whole(chord, centre);
  const Integer first = square(whole.b);
  const Integer last = square({whole.b.x - whole.a.x, whole.b.y - whole.a.y});
  return {in_millimetres(first, whole.unit), in_millimetres(last, whole.unit), first == last};
}

bool radii_differ(const Spot& chord, const Spot& centre, const Rational& tolerance) {
  if (chord.on_grid() && centre.on_grid()) {
    const auto [first, last] = squared_radii(chord, centre);
    if (const auto certain = grid::roots_differ(first, last, tolerance)) return *certain;
  }
  const WholePair whole(chord, centre);
  // |√a − √b| > t: a + b − t² > 2√(ab).
  const Rational squared = tolerance * tolerance * whole.unit * whole.unit;
  const Integer a = square(whole.b);
  const Integer b = square({whole.b.x - whole.a.x, whole.b.y - whole.a.y});
  const Rational left = a + b - squared;
  return sgn(left) > 0 && left * left > 4 * a * b;
}

int half_turns(const Spot& chord, const Spot& centre, bool counter_clockwise) {
  if (is_zero(chord)) return 1;
  if (chord.on_grid() && centre.on_grid()) {
    const grid::Wide turn = grid::cross(grid::steps_of(chord), grid::steps_of(centre));
    if (turn != 0) return (turn > 0) == counter_clockwise ? -1 : 1;
  }
  const WholePair whole(chord, centre);
  const int turn = sgn(cross(whole.a, whole.b));  // positive: the centre is on the left
  if (turn != 0) return (turn > 0) == counter_clockwise ? -1 : 1;
  const WholeVector& c = whole.b;
  const WholeVector last{c.x - whole.a.x, c.y - whole.a.y};
  return sgn(dot(c, last)) < 0 ? 0 : 1;
}

Circle circle_by_radius(const Spot& from, const Spot& chord, const Length& radius, bool major,
                        bool counter_clockwise) {
  if (chord_against_diameter(chord, radius) == 0) return half_turn(from, chord, counter_clockwise);
  if (from.on_grid() && chord.on_grid() && radius.on_grid()) {
    return grid::circle_by_radius(grid::steps_of(from), grid::steps_of(chord), radius.steps(),
                                  major, counter_clockwise, kArcBits);
  }
  const WholePair whole(chord, {radius, Length()});
  const WholeVector& w = whole.a;
  const Integer& r = whole.b.x;
  const Integer q = square(w);
  const Integer rest = 4 * r * r - q;
  DGT_CHECK(sgn(q) > 0 && sgn(rest) >= 0);
  // The centre lies √(rest/4q) chords beside the middle of the chord, on the left of a
  // counter-clockwise minor arc.
  Integer aside = rest << (2 * kBits);
  aside /= 4 * q;
  mpz_sqrt(aside.get_mpz_t(), aside.get_mpz_t());
  if (major == counter_clockwise) aside = -aside;
  const Integer one = Integer(1) << kBits;
  const WholeVector centre{w.x * one - 2 * aside * w.y, w.y * one + 2 * aside * w.x};
  const Rational exact_radius = signed_radius(radius.millimetres(), counter_clockwise);
  return {dyadic_sum(from, centre, whole.unit, 2 * one), exact_radius};
}

Circle half_turn(const Spot& from, const Spot& chord, bool counter_clockwise) {
  const WholePair whole(chord, chord);
  const Integer diameter_unit = 2 * whole.unit;
  return {exact_sum(from, whole.a, diameter_unit),
          signed_radius(root_over(square(whole.a), diameter_unit), counter_clockwise)};
}

int chord_against_diameter(const Spot& chord, const Length& radius) {
  if (chord.on_grid() && radius.on_grid()) {
    const grid::Vector w = grid::steps_of(chord);
    const grid::Wide diameter = 2 * static_cast<grid::Wide>(radius.steps());
    const grid::Wide excess = grid::dot(w, w) - diameter * diameter;
    return excess < 0 ? -1 : excess > 0 ? 1 : 0;
  }
  const WholePair whole(chord, {radius, Length()});
  return sgn(Integer(square(whole.a) - 4 * whole.b.x * whole.b.x));
}

double length_of(const Spot& chord) {
  if (chord.on_grid())
    return grid::root_in_millimetres(grid::dot(grid::steps_of(chord), grid::steps_of(chord)));
  const WholePair whole(chord, chord);
  return in_millimetres(square(whole.a), whole.unit);
}

}  // namespace dgt
