// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "kernel/construct.h"
#include "tests/support/mpfr_interval.h"

/// The ideal elements of the language's definitions, recomputed in interval arithmetic from what
/// the forms mean: directions and contacts as a draughtsman says them, not as the kernel computes
/// them.
namespace dgt::test {

struct IdealPoint {
  Interval x, y;
};
inline IdealPoint ideal(const RationalPoint& p) { return {p.x, p.y}; }
inline IdealPoint operator+(const IdealPoint& a, const IdealPoint& b) {
  return {a.x + b.x, a.y + b.y};
}
inline IdealPoint operator-(const IdealPoint& a, const IdealPoint& b) {
  return {a.x - b.x, a.y - b.y};
}
inline IdealPoint operator*(const Interval& k, const IdealPoint& a) { return {k * a.x, k * a.y}; }
inline Interval dot(const IdealPoint& a, const IdealPoint& b) { return a.x * b.x + a.y * b.y; }
inline Interval square(const Interval& x) { return abs(x) * abs(x); }
inline Interval length(const IdealPoint& a) { return sqrt(square(a.x) + square(a.y)); }
inline IdealPoint left_of(const IdealPoint& a) { return {-a.y, a.x}; }

/// A line by a point on it and its direction of travel, of length 1.
struct IdealLine {
  IdealPoint at, along;
};
struct IdealCircle {
  IdealPoint centre;
  Interval radius;
};

inline IdealPoint direction_at(const Rational& degrees) {
  return {cos(radians(degrees)), sin(radians(degrees))};
}

inline IdealLine ideal_through(const RationalPoint& from, const RationalPoint& to) {
  const IdealPoint v = ideal(to) - ideal(from);
  return {ideal(from), 1 / length(v) * v};
}

/// The line that runs along `along` with the circle on the side that its sense asks for: the centre
/// lies `radius` to the left.
inline IdealLine ideal_tangent(const Circle& circle, const IdealPoint& along) {
  return {ideal(circle.centre()) - Interval(circle.radius()) * left_of(along), along};
}

/// A direction that advances by `ahead` along v and keeps `left` to the left of it: of a triangle
/// with the hypotenuse v, ahead² + left² = v².
inline IdealPoint leaning(const IdealPoint& v, const Interval& ahead, const Interval& left) {
  return 1 / (square(v.x) + square(v.y)) * (ahead * v - left * left_of(v));
}

/// From the point to the contact: the tangent's length and the radius are the legs of a right
/// triangle over the way to the centre.
inline IdealLine ideal_tangent_from(const RationalPoint& p, const Circle& circle) {
  const IdealPoint v = ideal(circle.centre()) - ideal(p);
  const Interval r = circle.radius();
  const Interval tangent = sqrt(square(v.x) + square(v.y) - square(r));
  return {ideal(p), leaning(v, tangent, r)};
}

/// From the contact on `a` to that on `b`: seen from a's contact, b's centre lies as much further
/// to the left as its radius is greater.
inline IdealLine ideal_common_tangent(const Circle& a, const Circle& b) {
  const IdealPoint v = ideal(b.centre()) - ideal(a.centre());
  const Interval left = Interval(b.radius()) - Interval(a.radius());
  const Interval ahead = sqrt(square(v.x) + square(v.y) - square(left));
  return ideal_tangent(a, leaning(v, ahead, left));
}

/// The intersection of two perpendicular bisectors, by Cramer's rule.
inline IdealCircle ideal_through(const RationalPoint& p, const RationalPoint& q,
                                 const RationalPoint& r) {
  const auto squared = [](const RationalPoint& a) { return square(Interval(a.x)) + square(a.y); };
  const IdealPoint u = ideal(q) - ideal(p);
  const IdealPoint v = ideal(r) - ideal(p);
  const Interval k = (squared(q) - squared(p)) / 2;
  const Interval l = (squared(r) - squared(p)) / 2;
  const Interval det = u.x * v.y - u.y * v.x;
  const IdealPoint centre{(k * v.y - l * u.y) / det, (u.x * l - v.x * k) / det};
  return {centre, length(centre - ideal(p))};
}

/// The two points where a path enters and leaves: [0] where it enters.
using IdealPair = std::array<IdealPoint, 2>;

/// Where a line enters and leaves a circle of the radius `reach` (of any sign) about `centre`.
inline IdealPair ideal_crossings(const IdealLine& line, const IdealPoint& centre,
                                 const Interval& reach) {
  const IdealPoint to_centre = centre - line.at;
  const Interval ahead = dot(to_centre, line.along);
  const Interval beside = dot(to_centre, left_of(line.along));
  const Interval half_chord = sqrt(square(reach) - square(beside));
  return {line.at + (ahead - half_chord) * line.along, line.at + (ahead + half_chord) * line.along};
}

/// Where a circle of the radius ra about a, run counter-clockwise or not, enters and leaves the
/// disc of the radius rb about b.
inline IdealPair ideal_crossings(const IdealPoint& a, const Interval& ra, bool counter_clockwise,
                                 const IdealPoint& b, const Interval& rb) {
  const Interval distance = length(b - a);
  const IdealPoint e = 1 / distance * (b - a);
  const Interval ahead = (square(distance) + square(ra) - square(rb)) / (2 * distance);
  const Interval beside = sqrt(square(ra) - square(ahead));
  IdealPair pair = {a + ahead * e + beside * left_of(e), a + ahead * e - beside * left_of(e)};
  // Going in means coming nearer to b: the velocity looks its way.
  const IdealPoint arm = pair[0] - a;
  const IdealPoint velocity = counter_clockwise ? left_of(arm) : Interval(-1) * left_of(arm);
  if (!dot(velocity, b - pair[0]).certainly_positive()) std::swap(pair[0], pair[1]);
  return pair;
}

/// The candidate that a selector means; false when the witness cannot tell (equal coordinates).
inline bool select(const IdealPair& pair, Selector selector, IdealPoint* chosen) {
  const auto by = [&](const Interval& first_minus_second, bool greater) {
    if (first_minus_second.holds_zero()) return false;
    *chosen = pair[first_minus_second.certainly_positive() == greater ? 0 : 1];
    return true;
  };
  switch (selector) {
    case Selector::GreaterX:
      return by(pair[0].x - pair[1].x, true);
    case Selector::SmallerX:
      return by(pair[0].x - pair[1].x, false);
    case Selector::GreaterY:
      return by(pair[0].y - pair[1].y, true);
    case Selector::SmallerY:
      return by(pair[0].y - pair[1].y, false);
    case Selector::I2:
      *chosen = pair[1];
      return true;
    case Selector::Default:
    case Selector::I1:
      break;
  }
  *chosen = pair[0];
  return true;
}

}  // namespace dgt::test
