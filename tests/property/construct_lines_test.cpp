// SPDX-License-Identifier: GPL-3.0-or-later
// Every line of the catalogue against its ideal: direction and side as the language says them, the
// incidence that is promised exactly, the rest within the bound claimed.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "tests/property/ideal.h"
#include "tests/support/geometry_generators.h"

namespace dgt {
namespace {

using namespace test;  // NOLINT: the witness's operators

template <class T>
Constructed<T> made(const Construction<T>& c) {
  RC_ASSERT(std::holds_alternative<Constructed<T>>(c));
  return std::get<Constructed<T>>(c);
}

/// Runs the ideal's way, at most the claimed angle off; the claim itself is 2⁻⁹⁶ at most.
void expect_direction(const Constructed<Line>& line, const IdealLine& expected) {
  const IdealPoint along = ideal(line.value.direction().vector());
  RC_ASSERT(dot(along, expected.along).certainly_positive());
  RC_ASSERT(abs(dot(along, left_of(expected.along))).at_most(line.turn));
  RC_ASSERT(line.turn <= 0x1p-96);
}

/// Passes `q` at the distance that the claims allow for a point `reach` away from the anchor.
void expect_near(const Constructed<Line>& line, const IdealPoint& q, const Interval& reach) {
  const Interval off = abs(dot(ideal(line.value.normal().vector()), q) - Interval(line.value.p()));
  RC_ASSERT((off - Interval(Rational(line.turn)) * abs(reach)).at_most(line.bound));
}

bool touches(const Line& line, const Circle& circle) {
  return line.distance_to_left(circle.centre()) == circle.radius();
}

struct PointAndCircle {
  RationalPoint point;
  Circle circle;
};
/// A point outside a circle: anywhere, at a Pythagorean distance, or 10⁻⁹ mm from it.
PointAndCircle outside_point() {
  const Circle c = any_circle();
  const Rational r = abs(c.radius());
  const UnitVector u = pythagorean_unit();
  switch (*rc::gen::inRange(0, 4)) {
    case 0:  // the tangent's length is rational: (r, r·4/3, r·5/3)
      return {c.centre() + Rational(5, 3) * r * u.vector(), c};
    case 1:
      return {c.centre() + (r + Rational(1) / 1000000000) * u.vector(), c};
    case 2:
      return {c.centre() + r * 1000000 * any_unit().vector(), c};
    default:
      return {c.centre() + (r + abs(nonzero_decimal())) * any_unit().vector(), c};
  }
}

/// Two circles with a common tangent: disjoint in general, sometimes nearly in contact, in ratios
/// up to 10¹⁰, or with a rational solution.
std::pair<Circle, Circle> tangent_circles() {
  const Circle a = any_circle();
  const Rational r = any_radius();
  const Rational difference = abs(r - a.radius());
  const int kind = *rc::gen::inRange(0, 4);
  Rational distance = difference;
  if (kind == 0) distance = sgn(difference) == 0 ? Rational(1) : Rational(5, 3) * difference;
  if (kind == 1) distance += Rational(1) / 1000000000;
  if (kind >= 2) distance += abs(nonzero_decimal());
  return {a,
          Circle(a.centre() + distance * (kind < 2 ? pythagorean_unit() : any_unit()).vector(), r)};
}

RC_GTEST_PROP(LineThroughTwoPoints, RunsFromTheFirstExactlyToTheSecondWithinTheBound, ()) {
  const RationalPoint p = any_point();
  RationalPoint q = p + near_miss() * pythagorean_unit().vector();
  if (q == p) q = any_point();
  if (q == p) return;
  const auto line = made(line_through(known_point(p), known_point(q)));
  RC_ASSERT(line.value.distance_to_left(p) == 0);
  RC_ASSERT(line.bound == 0);
  expect_direction(line, ideal_through(p, q));
  expect_near(line, ideal(q), length(ideal(q) - ideal(p)));
  if (exact_sqrt(squared_length(q - p))) RC_ASSERT(line.value.distance_to_left(q) == 0);
}

RC_GTEST_PROP(ParallelLines, AreExactAndRunAsTheGivenLine, ()) {
  const Line given = any_line();
  const RationalPoint p = any_point();
  const auto through = parallel_through(known_point(p), given);
  RC_ASSERT(through.value.distance_to_left(p) == 0);
  RC_ASSERT(through.value.direction() == given.direction());
  RC_ASSERT(through.bound == 0 && through.turn == 0);
  const Rational d = any_decimal();
  const auto shifted = parallel_at(given, d);
  RC_ASSERT(shifted.value.direction() == given.direction());
  // D > 0 shifts to the left
  RC_ASSERT(given.distance_to_left(shifted.value.p() * shifted.value.normal().vector()) == d);
  RC_ASSERT(shifted.bound == 0 && shifted.turn == 0);
}

RC_GTEST_PROP(LineAtAngle, PassesThePointExactlyAtTheAngle, ()) {
  const RationalPoint p = any_point();
  const Rational degrees = any_angle();
  const auto line = line_at_angle(known_point(p), degrees);
  RC_ASSERT(line.value.distance_to_left(p) == 0);
  expect_direction(line, {ideal(p), direction_at(degrees)});
}

RC_GTEST_PROP(LineTurned, PassesThePointExactlyAtTheAngleToTheGivenLine, ()) {
  const RationalPoint p = any_point();
  const Line given = any_line();
  const Rational degrees = any_angle();
  const auto line = line_turned(given, degrees, known_point(p));
  RC_ASSERT(line.value.distance_to_left(p) == 0);
  const IdealPoint base = ideal(given.direction().vector());
  const IdealPoint turn = direction_at(degrees);
  expect_direction(line, {ideal(p), turn.x * base + turn.y * left_of(base)});
}

RC_GTEST_PROP(TangentAtAngle, TouchesExactlyAndRunsAtTheAngle, ()) {
  const Circle circle = any_circle();
  const Rational degrees = any_angle();
  const auto line = tangent_at_angle(circle, degrees);
  RC_ASSERT(touches(line.value, circle));
  expect_direction(line, ideal_tangent(circle, direction_at(degrees)));
}

RC_GTEST_PROP(TangentFromPoint, TouchesExactlyAndLeavesThePointForTheContact, ()) {
  const auto [p, circle] = outside_point();
  const auto line = made(tangent_from(known_point(p), circle));
  RC_ASSERT(touches(line.value, circle));
  RC_ASSERT(line.bound == 0);
  const IdealLine expected = ideal_tangent_from(p, circle);
  expect_direction(line, expected);
  expect_near(line, ideal(p), length(ideal(p) - ideal(circle.centre())));
  const RationalPoint at = contact(line.value, circle);
  RC_ASSERT(sgn(dot(at - p, line.value.direction().vector())) > 0);
}

RC_GTEST_PROP(TangentFromPoint, OnTheCircleRunsInTheCirclesDirection, ()) {
  const Circle circle = any_circle();
  const UnitVector u = pythagorean_unit();
  const RationalPoint p = circle.centre() + abs(circle.radius()) * u.vector();
  const auto line = made(tangent_from(known_point(p), circle));
  RC_ASSERT(touches(line.value, circle));
  RC_ASSERT(line.value.distance_to_left(p) == 0);
  const UnitVector forward = circle.counter_clockwise() ? turned_left(u) : turned_right(u);
  RC_ASSERT(line.value.direction() == forward);
}

RC_GTEST_PROP(TangentFromPoint, AnIrrationalPointOfTheCircleIsKnownToLieOnIt, ()) {
  const Line line = any_line();
  const Circle circle = circle_crossing(line);
  const auto point = made(meeting_point(line, circle, Selector::I2));
  const auto tangent = made(tangent_from(point.value, circle));
  RC_ASSERT(touches(tangent.value, circle));
  const Rational off = abs(tangent.value.distance_to_left(point.value.stand_in));
  RC_ASSERT(off <= power_of_two(-95) * (1 + abs(circle.radius())));
}

RC_GTEST_PROP(CommonTangent, TouchesTheFirstExactlyAndTheSecondWithinTheBound, ()) {
  const auto [a, b] = tangent_circles();
  const auto line = made(common_tangent(a, b));
  RC_ASSERT(touches(line.value, a));
  RC_ASSERT(line.bound == 0);
  expect_direction(line, ideal_common_tangent(a, b));
  const Interval gap = abs(Interval(line.value.distance_to_left(b.centre())) - b.radius());
  const Interval reach = length(ideal(b.centre()) - ideal(a.centre()));
  RC_ASSERT((gap - Interval(Rational(line.turn)) * reach).at_most(0));
  // From the contact on the first to that on the second.
  const Vector way = contact(line.value, b) - contact(line.value, a);
  RC_ASSERT(sgn(dot(way, line.value.direction().vector())) > 0);
}

RC_GTEST_PROP(CommonTangent, OfCirclesOfOneSenseIsOuterAndOfTwoSensesInner, ()) {
  const Rational ra = abs(any_radius());
  const Rational rb = abs(any_radius());
  const Circle a({0, 0}, ra);
  const RationalPoint centre = (ra + rb + 1) * any_unit().vector();
  const auto side = [&](const Line& line, const RationalPoint& c) {
    return sgn(line.distance_to_left(c));
  };
  const Line outer = made(common_tangent(a, Circle(centre, rb))).value;
  RC_ASSERT(side(outer, a.centre()) == 1 && side(outer, centre) == 1);
  const Line inner = made(common_tangent(a, Circle(centre, -rb))).value;
  RC_ASSERT(side(inner, a.centre()) == 1 && side(inner, centre) == -1);
}

RC_GTEST_PROP(CommonTangent, OfCirclesInContactIsTheTangentThere, ()) {
  const Circle a = any_circle();
  Rational r = any_radius();
  if (r == a.radius()) r += 1;
  const UnitVector n = pythagorean_unit();
  const Circle b(a.centre() + (r - a.radius()) * n.vector(), r);
  const auto line = made(common_tangent(a, b));
  RC_ASSERT(line.value.normal() == n);
  RC_ASSERT(touches(line.value, a) && touches(line.value, b));
}

RC_GTEST_PROP(CommonTangent, ThatIsRationalIsExactAtBoth, ()) {
  const Circle a = any_circle();
  const UnitVector n = pythagorean_unit();
  const Rational r = any_radius();
  const Rational ahead = abs(nonzero_decimal());
  const Circle b(a.centre() + (r - a.radius()) * n.vector() + ahead * turned_right(n).vector(), r);
  const auto line = made(common_tangent(a, b));
  RC_ASSERT(line.turn == 0 && line.bound == 0);
  RC_ASSERT(touches(line.value, a) && touches(line.value, b));
}

}  // namespace
}  // namespace dgt
