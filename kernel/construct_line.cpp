// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "kernel/construct.h"
#include "kernel/construct_bounds.h"

namespace dgt {
namespace {

/// The line in oriented contact with `circle` whose left normal is `normal`: exact.
Line tangent_with_normal(const Circle& circle, UnitVector normal) {
  Rational p = dot(normal.vector(), circle.centre()) - circle.radius();
  return {std::move(normal), std::move(p)};
}

/// Result of a construction whose line is exact at `anchor` and off by at most `turn` in direction.
Constructed<Line> anchored(Line line, const RationalPoint& anchor, double turn) {
  Constructed<Line> result{std::move(line), 0, turn};
  cap_height(result, anchor);
  return result;
}

RationalPoint contact_with(const Circle& circle, const Line& line) {
  return circle.centre() - circle.radius() * line.normal().vector();
}

Constructed<Line> anchored_at_contact(const Circle& circle, const Direction& normal) {
  const Line line = tangent_with_normal(circle, normal.unit);
  return anchored(line, contact_with(circle, line), normal.bound);
}

/// The normal (δ v + √(v² − δ²) v⊥)/v² of the line that leaves a point or circle by v, with radii
/// that differ by δ, as a vector of any positive length. Its direction n satisfies n·v = δ, and of
/// the two solutions it is the one whose line runs along +v.
Direction leaving_normal(const Vector& v, const Rational& delta, const Rational& discriminant,
                         int bits) {
  if (const auto root = exact_sqrt(discriminant))
    return direction_of(delta * v + *root * turned_left(v), bits);
  return direction_of(OneRoot(delta * v.x, -v.y, discriminant),
                      OneRoot(delta * v.y, v.x, discriminant), bits);
}

}  // namespace

Line vertical_line(const Rational& x) { return {UnitVector({1, 0}), x}; }
Line horizontal_line(const Rational& y) { return {UnitVector({0, 1}), y}; }

Construction<Line> line_through(const KnownPoint& from, const KnownPoint& to, int bits) {
  const Vector v = to.stand_in - from.stand_in;
  if (within_contact(v)) return Impossible{Impossible::Why::CoincidentPoints, length(v)};
  const Direction along = direction_of(v, bits);
  return anchored(Line::through(from.stand_in, turned_left(along.unit)), from.stand_in,
                  along.bound);
}

Constructed<Line> parallel_through(const KnownPoint& point, const Line& line) {
  return anchored(Line::through(point.stand_in, line.normal()), point.stand_in, 0);
}

Constructed<Line> parallel_at(const Line& line, const Rational& distance) {
  const Line moved = line.offset(distance);
  return anchored(moved, moved.p() * moved.normal().vector(), 0);
}

Constructed<Line> line_at_angle(const KnownPoint& point, const Rational& degrees, int bits) {
  const Direction along = direction_of(degrees, bits);
  return anchored(Line::through(point.stand_in, turned_left(along.unit)), point.stand_in,
                  along.bound);
}

Constructed<Line> line_turned(const Line& line, const Rational& degrees, const KnownPoint& point,
                              int bits) {
  const Direction turn = direction_of(degrees, bits);
  return anchored(Line::through(point.stand_in, rotated(line.normal(), turn.unit)), point.stand_in,
                  turn.bound);
}

Constructed<Line> tangent_at_angle(const Circle& circle, const Rational& degrees, int bits) {
  Direction along = direction_of(degrees, bits);
  along.unit = turned_left(along.unit);
  return anchored_at_contact(circle, along);
}

Construction<Line> tangent_from(const KnownPoint& point, const Circle& circle, int bits) {
  const Vector v = circle.centre() - point.stand_in;
  if (on_circle(circle, point)) {
    // The left normal at a point of the circle points to the centre, or away when clockwise.
    const Vector inward = circle.counter_clockwise() ? v : -v;
    return anchored_at_contact(circle, direction_of(inward, bits));
  }
  const Rational discriminant = squared_length(v) - circle.radius() * circle.radius();
  if (sgn(discriminant) < 0)
    return Impossible{Impossible::Why::PointInside,
                      std::fabs(nearest_double(circle.radius())) - length(v)};
  return anchored_at_contact(circle, leaving_normal(v, circle.radius(), discriminant, bits));
}

Construction<Line> common_tangent(const Circle& a, const Circle& b, int bits) {
  const Vector v = b.centre() - a.centre();
  const Rational delta = b.radius() - a.radius();
  if (within_contact(v))
    return Impossible{Impossible::Why::ConcentricCircles, std::fabs(nearest_double(delta))};
  const Rational discriminant = squared_length(v) - delta * delta;
  if (in_oriented_contact(a, b)) {
    // The contacts fall together: the tangent there, which both circles follow.
    return anchored_at_contact(a, direction_of(sgn(delta) < 0 ? -v : v, bits));
  }
  if (sgn(discriminant) < 0)
    return Impossible{Impossible::Why::CircleInside, std::fabs(nearest_double(delta)) - length(v)};
  return anchored_at_contact(a, leaving_normal(v, delta, discriminant, bits));
}

}  // namespace dgt
