// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/construct_bounds.h"

#include <cmath>
#include <limits>

namespace dgt {
namespace {

/// Grid of rounded coordinates: far below the stand-ins' own 2⁻⁹⁶.
constexpr int kGridExponent = -192;

const Rational& contact_resolution() {
  static const Rational value = power_of_two(kContactExponent);
  return value;
}

bool too_high(const Rational& value) { return height(value) > kMaxHeight; }

/// Rounds `value` when it is too long; the mm by which it moved at most.
double cap(Rational& value) {
  if (!too_high(value)) return 0;
  value = on_dyadic_grid(value, kGridExponent);
  return std::ldexp(1.0, kGridExponent);
}

/// A unit vector within 2⁻¹⁹⁰ of `u`, by the half tangent of its angle to the nearer of ±X.
UnitVector shortened(const UnitVector& u) {
  if (sgn(u.x()) < 0) return -shortened(-u);
  const Rational t = on_dyadic_grid(u.y() / (1 + u.x()), kGridExponent);
  return UnitVector::from_half_tangent(t);
}

/// |x − s| ≤ resolution for x = √square.
bool root_is(const Rational& square, const Rational& s) {
  const Rational high = s + contact_resolution();
  if (square > high * high) return false;
  const Rational low = s - contact_resolution();
  return sgn(low) <= 0 || square >= low * low;
}

}  // namespace

double length(const Vector& v) { return std::sqrt(nearest_double(squared_length(v))); }

double upper_bound(const Rational& value) {
  return std::nextafter(std::fabs(nearest_double(value)), std::numeric_limits<double>::infinity());
}

bool is_contact(const Rational& value) { return abs(value) <= contact_resolution(); }

bool within_contact(const Vector& v) { return is_contact(v.x) && is_contact(v.y); }

bool on_circle(const Circle& circle, const KnownPoint& point) {
  if (side_of(circle, point.exact) == 0) return true;
  return root_is(squared_length(point.stand_in - circle.centre()), abs(circle.radius()));
}

bool in_oriented_contact(const Circle& a, const Circle& b) {
  return root_is(squared_length(b.centre() - a.centre()), abs(b.radius() - a.radius()));
}

void cap_height(Constructed<Line>& line, const RationalPoint& anchor) {
  const Line& old = line.value;
  const bool turn = too_high(old.normal().x()) || too_high(old.normal().y());
  if (!turn && !too_high(old.p())) return;
  UnitVector normal = turn ? shortened(old.normal()) : old.normal();
  if (turn) line.turn += std::ldexp(1.0, kGridExponent + 2);
  Rational p = turn ? dot(normal.vector(), anchor) : old.p();
  line.bound += cap(p);
  line.value = Line(std::move(normal), std::move(p));
}

void cap_height(Constructed<Circle>& circle) {
  RationalPoint centre = circle.value.centre();
  Rational radius = circle.value.radius();
  const double moved = cap(centre.x) + cap(centre.y) + cap(radius);
  if (moved == 0) return;
  if (sgn(radius) == 0) radius = sgn(circle.value.radius()) * power_of_two(kGridExponent);
  circle.bound += moved;
  circle.value = Circle(std::move(centre), std::move(radius));
}

void cap_height(KnownPoint& point) {
  const double moved = cap(point.stand_in.x) + cap(point.stand_in.y);
  if (moved == 0) return;
  point.bound += moved;
  if (point.exact.is_rational()) point.exact = ExactPoint(point.stand_in);
}

}  // namespace dgt
