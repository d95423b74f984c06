// SPDX-License-Identifier: GPL-3.0-or-later
// Every circle and point of the catalogue against its ideal: which of two solutions a selector
// means, the contacts that are promised exactly, the rest within the bound claimed.
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

/// The claim covers the way of the centre and the change of the radius, and is itself 2⁻⁹⁶ of
/// `size` at most.
void expect_circle(const Constructed<Circle>& circle, const IdealCircle& expected,
                   const Rational& size) {
  const IdealPoint moved = ideal(circle.value.centre()) - expected.centre;
  const Interval off = length(moved) + abs(Interval(circle.value.radius()) - expected.radius);
  RC_ASSERT(off.at_most(circle.bound));
  RC_ASSERT(Rational(circle.bound) <= power_of_two(-kStandInBits) * size);
}

void expect_point(const Constructed<KnownPoint>& point, const IdealPoint& expected) {
  RC_ASSERT(length(ideal(point.value.stand_in) - expected).at_most(point.bound));
}

bool touches(const Line& line, const Circle& circle) {
  return line.distance_to_left(circle.centre()) == circle.radius();
}
bool touches(const Circle& a, const Circle& b) {
  const Rational difference = a.radius() - b.radius();
  return squared_length(a.centre() - b.centre()) == difference * difference;
}

Selector any_selector() { return static_cast<Selector>(*rc::gen::inRange(0, 7)); }

bool is(const Construction<Circle>& c, Impossible::Why why) {
  const auto* no = std::get_if<Impossible>(&c);
  return no != nullptr && no->why == why;
}

/// Somewhere in [0, limit]: anywhere, or 10⁻⁹ mm from the ends, or where a half chord is rational.
Rational share_of(const Rational& limit) {
  static const Rational kHair = Rational(1) / 1000000000;
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return limit > kHair ? Rational(limit - kHair) : Rational(limit / 2);
    case 1:
      return 0;
    case 2:
      return Rational(3, 5) * limit;
    default:
      return limit * Rational(*rc::gen::inRange(1, 64)) / 64;
  }
}

RC_GTEST_PROP(CircleThroughThreePoints, PassesTheFirstExactlyAndTheOthersWithinTheBound, ()) {
  const RationalPoint p = any_point();
  const RationalPoint q = any_point();
  RationalPoint r = any_point();
  if (*rc::gen::inRange(0, 3) == 0)  // nearly collinear
    r = p + Rational(1, 3) * (q - p) + Rational(1) / 1000000000 * turned_left(q - p);
  if (sgn(cross(q - p, r - p)) == 0) return;
  const auto circle = made(circle_through(known_point(p), known_point(q), known_point(r)));
  const Rational& radius = circle.value.radius();
  RC_ASSERT(sgn(radius) > 0);  // counter-clockwise
  RC_ASSERT(squared_length(circle.value.centre() - p) == radius * radius);
  expect_circle(circle, ideal_through(p, q, r), 1 + radius);
}

RC_GTEST_PROP(CircleThroughThreePoints, OfARationalRadiusIsExact, ()) {
  const Circle expected = {any_point(), abs(any_radius())};
  const auto at = [&] {
    return known_point(expected.centre() + expected.radius() * pythagorean_unit().vector());
  };
  const KnownPoint p = at();
  const KnownPoint q = at();
  const KnownPoint r = at();
  if (p.stand_in == q.stand_in || q.stand_in == r.stand_in || p.stand_in == r.stand_in) return;
  const auto circle = made(circle_through(p, q, r));
  RC_ASSERT(circle.value == expected);
  RC_ASSERT(circle.bound == 0);
}

RC_GTEST_PROP(CircleTouchingTwoLines, TouchesBothExactly, ()) {
  const Line a = any_line();
  const Line b = any_line();
  const Rational radius = any_radius();
  const auto result = touching(a, b, radius);
  if (std::holds_alternative<Impossible>(result)) {
    RC_ASSERT(sgn(cross(a.normal().vector(), b.normal().vector())) == 0);
    return;
  }
  const auto circle = made(result);
  RC_ASSERT(touches(a, circle.value) && touches(b, circle.value));
  RC_ASSERT(circle.value.radius() == radius);
  RC_ASSERT(circle.bound == 0);
}

RC_GTEST_PROP(CircleTouchingLineAndCircle, TouchesBothExactlyWhereTheSelectorSays, ()) {
  const Line line = any_line();
  const Rational radius = any_radius();
  Rational r = any_radius();
  if (r == radius) r += 1;
  const Rational reach = abs(r - radius);
  const Rational aside = *rc::gen::element(-1, 1) * share_of(reach);
  const Line locus = line.offset(radius);
  const Circle circle(
      (locus.p() + aside) * locus.normal().vector() + any_decimal() * locus.direction().vector(),
      r);
  const Selector selector = any_selector();
  const auto result = touching(Element(circle), Element(line), radius, selector);
  RC_ASSERT(result.index() == touching(line, circle, radius, selector).index());

  const IdealLine path{ideal(locus.foot(circle.centre())), ideal(line.direction().vector())};
  IdealPoint centre;
  if (!select(ideal_crossings(path, ideal(circle.centre()), reach), selector, &centre)) {
    RC_ASSERT(is(result, Impossible::Why::EqualCandidates));
    return;
  }
  const auto touch = made(result);
  RC_ASSERT(touch.value == made(touching(line, circle, radius, selector)).value);
  RC_ASSERT(touches(line, touch.value) && touches(circle, touch.value));
  RC_ASSERT(abs(touch.value.radius() - radius) <= power_of_two(-kStandInBits) * abs(radius));
  expect_circle(touch, {centre, radius}, 1);
  if (exact_sqrt(reach * reach - aside * aside)) RC_ASSERT(touch.bound == 0);
}

RC_GTEST_PROP(CircleTouchingTwoCircles, TouchesBothExactlyWhereTheSelectorSays, ()) {
  const Circle a = any_circle();
  const Rational radius = any_radius();
  Rational r = any_radius();
  if (r == radius) r += 1;
  const Rational reach_a = abs(a.radius() - radius);
  const Rational reach_b = abs(r - radius);
  if (sgn(reach_a) == 0) return;
  const Rational least = abs(reach_a - reach_b);
  Rational distance = least + share_of(reach_a + reach_b - least);
  if (distance == least) distance = (least + reach_a + reach_b) / 2;
  const Circle b(a.centre() + distance * any_unit().vector(), r);
  const Selector selector = any_selector();
  const auto result = touching(a, b, radius, selector);

  IdealPoint centre;
  if (!select(ideal_crossings(ideal(a.centre()), reach_a, a.counter_clockwise(), ideal(b.centre()),
                              reach_b),
              selector, &centre)) {
    RC_ASSERT(is(result, Impossible::Why::EqualCandidates));
    return;
  }
  const auto touch = made(result);
  RC_ASSERT(touches(a, touch.value) && touches(b, touch.value));
  RC_ASSERT(abs(touch.value.radius() - radius) <= power_of_two(-kStandInBits) * abs(radius));
  expect_circle(touch, {centre, radius}, 1 + reach_a);
}

RC_GTEST_PROP(CircleTouchingTwoCircles, ThatIsRationalIsExact, ()) {
  const Circle expected = any_circle();
  const auto neighbour = [&](const UnitVector& u) {
    Rational r = any_radius();
    if (r == expected.radius()) r += 1;
    return Circle(expected.centre() + (r - expected.radius()) * u.vector(), r);
  };
  const UnitVector u = pythagorean_unit();
  const UnitVector v = pythagorean_unit();
  if (u == v || u == -v) return;  // then the two are in contact, or the solutions fall together
  const Circle a = neighbour(u);
  const Circle b = neighbour(v);
  const auto first = made(touching(a, b, expected.radius(), Selector::I1));
  const auto second = made(touching(a, b, expected.radius(), Selector::I2));
  RC_ASSERT(first.bound == 0 && second.bound == 0);
  RC_ASSERT(first.value == expected || second.value == expected);
  RC_ASSERT(!(first.value == second.value));
}

RC_GTEST_PROP(CircleTouching, ElementsAlreadyInContactTouchesBothAtTheirContact, ()) {
  const Rational radius = any_radius();
  const Element a = any_element();
  const auto in_contact = [](const auto& e) {
    const UnitVector u = pythagorean_unit();
    const Rational r = any_radius();
    if constexpr (std::is_same_v<std::decay_t<decltype(e)>, Line>)
      return Circle((e.p() + r) * e.normal().vector() + r * e.direction().vector(), r);
    else
      return Circle(e.centre() + (r - e.radius()) * u.vector(), r);
  };
  const Circle b = std::visit(in_contact, a);
  const auto* first = std::get_if<Circle>(&a);
  if (first && (first->radius() == b.radius() || first->radius() == radius)) return;
  if (b.radius() == radius) return;
  const auto touch = made(touching(a, Element(b), radius, any_selector()));
  RC_ASSERT(touch.bound == 0);
  RC_ASSERT(touch.value.radius() == radius);
  RC_ASSERT(touches(b, touch.value));
  RC_ASSERT(std::visit([&](const auto& e) { return touches(e, touch.value); }, a));
  RC_ASSERT(contact(Element(b), Element(touch.value)) == contact(Element(b), a));
}

RC_GTEST_PROP(PolarForms, LieAtTheDistanceAndTheAngle, ()) {
  const RationalPoint p = any_point();
  const Rational distance = any_decimal();
  const Rational degrees = any_angle();
  const Rational radius = any_radius();
  const IdealPoint expected = ideal(p) + Interval(distance) * direction_at(degrees);
  const auto point = point_polar(known_point(p), distance, degrees);
  expect_point(point, expected);
  RC_ASSERT(squared_length(point.value.stand_in - p) == distance * distance);
  RC_ASSERT(point.bound <= 0x1p-95 * std::abs(distance.get_d()));
  const auto circle = made(circle_polar(known_point(p), distance, degrees, radius));
  RC_ASSERT(circle.value.radius() == radius);
  expect_circle(circle, {expected, radius}, 2 * abs(distance));
}

RC_GTEST_PROP(MeetingPoint, IsWhereTheSelectorSays, ()) {
  const Line line = any_line();
  const Circle circle = circle_crossing(line);
  const Selector selector = any_selector();
  const auto result = meeting_point(line, circle, selector);
  const IdealLine path{ideal(line.p() * line.normal().vector()), ideal(line.direction().vector())};
  IdealPoint expected;
  const Interval radius = abs(Interval(circle.radius()));
  if (!select(ideal_crossings(path, ideal(circle.centre()), radius), selector, &expected)) {
    RC_ASSERT(std::get<Impossible>(result).why == Impossible::Why::EqualCandidates);
    return;
  }
  expect_point(made(result), expected);
  RC_ASSERT(made(result).bound <= 0x1p-120);
  // Both orders of a line and a circle mean the line entering the circle.
  const auto swapped = made(meeting_point(circle, line, selector));
  RC_ASSERT(swapped.value.stand_in == made(result).value.stand_in);
  RC_ASSERT(side_of(line, swapped.value.exact) == 0 && side_of(circle, swapped.value.exact) == 0);
}

RC_GTEST_PROP(MeetingPoint, OfTwoCirclesIsWhereTheFirstEntersTheSecond, ()) {
  const Circle a = any_circle();
  const Circle b = circle_crossing(a);
  const Selector selector = any_selector();
  const auto result = meeting_point(a, b, selector);
  const auto pair =
      ideal_crossings(ideal(a.centre()), abs(Interval(a.radius())), a.counter_clockwise(),
                      ideal(b.centre()), abs(Interval(b.radius())));
  IdealPoint expected;
  if (!select(pair, selector, &expected)) {
    RC_ASSERT(std::get<Impossible>(result).why == Impossible::Why::EqualCandidates);
    return;
  }
  expect_point(made(result), expected);
}

}  // namespace
}  // namespace dgt
