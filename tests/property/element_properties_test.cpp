// SPDX-License-Identifier: GPL-3.0-or-later
// What offsetting, reversing and frames keep exactly.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/support/geometry_generators.h"

namespace dgt {
namespace {

using namespace test;  // NOLINT: generators

struct InContact {
  Element a;
  Circle b;
};

InContact any_contact() {
  const Element a = any_element();
  const Rational r = any_radius();
  if (const auto* line = std::get_if<Line>(&a)) {
    return {a, Circle((line->p() + r) * line->normal().vector() +
                          any_decimal() * line->direction().vector(),
                      r)};
  }
  const auto& first = std::get<Circle>(a);
  const Rational other = r == first.radius() ? Rational(r + 1 + abs(r)) : r;
  return {a, Circle(first.centre() + (other - first.radius()) * any_unit().vector(), other)};
}

Rational contact_error(const Element& a, const Circle& b) {
  if (const auto* line = std::get_if<Line>(&a))
    return line->distance_to_left(b.centre()) - b.radius();
  const auto& first = std::get<Circle>(a);
  const Rational difference = first.radius() - b.radius();
  return squared_length(first.centre() - b.centre()) - difference * difference;
}

Frame any_frame() { return {any_point(), any_unit()}; }

ExactPoint crossing_of(const Element& a) {
  const Element b = std::visit([](const auto& x) { return Element(circle_crossing(x)); }, a);
  return stages::exact_crossing(a, b, Which::Entry);
}

RC_GTEST_PROP(Offset, KeepsOrientedContact, ()) {
  const auto [a, b] = any_contact();
  const Rational w = any_decimal(20);
  RC_ASSERT(contact_error(a, b) == 0);
  const auto* first = std::get_if<Circle>(&a);
  if (b.radius() == w || (first && first->radius() == w)) return;  // eaten
  RC_ASSERT(contact_error(offset(a, w), b.offset(w)) == 0);
  // The point of contact moves sideways by w: along the common normal.
  const RationalPoint at = contact(b, a);
  const RationalPoint moved = contact(b.offset(w), offset(a, w));
  RC_ASSERT(squared_length(moved - at) == w * w);
}

RC_GTEST_PROP(Offset, ThereAndBackIsTheIdentity, ()) {
  const Element e = any_element();
  const Rational w = any_decimal(20);
  if (const auto* c = std::get_if<Circle>(&e); c && c->radius() == w) return;
  RC_ASSERT(offset(offset(e, w), -w) == e);
  RC_ASSERT(reversed(offset(reversed(e), -w)) == offset(e, w));
}

RC_GTEST_PROP(Reversed, ExchangesTheSidesAndIsItsOwnInverse, ()) {
  const Element e = any_element();
  const ExactPoint q(any_point());
  RC_ASSERT(reversed(reversed(e)) == e);
  RC_ASSERT(side_of(reversed(e), q) == -side_of(e, q));
  RC_ASSERT(distance_to(reversed(e), q) == distance_to(e, q));
}

RC_GTEST_PROP(SideOf, APointAheadOfTheOffsetIsOnTheOffsetElement, ()) {
  const Element e = any_element();
  const ExactPoint on = crossing_of(e);
  RC_ASSERT(side_of(e, on) == 0);
  const Rational w = abs(nonzero_decimal(20));
  if (const auto* c = std::get_if<Circle>(&e); c && abs(c->radius()) <= w) return;
  RC_ASSERT(side_of(offset(e, w), on) == -1);
  RC_ASSERT(side_of(offset(e, -w), on) == 1);
  const double distance = distance_to(offset(e, w), on);
  RC_ASSERT(std::fabs(distance - w.get_d()) <= 1e-13 * w.get_d());
}

RC_GTEST_PROP(Contact, LiesOnBothExactly, ()) {
  const auto [a, b] = any_contact();
  for (const RationalPoint& at : {contact(a, Element(b)), contact(Element(b), a)}) {
    RC_ASSERT(side_of(a, ExactPoint(at)) == 0);
    RC_ASSERT(side_of(b, ExactPoint(at)) == 0);
  }
}

RC_GTEST_PROP(Placed, KeepsIncidencesExactly, ()) {
  const auto [a, b] = any_contact();
  const Frame frame = any_frame();
  const Element placed_a = placed(a, frame);
  const auto placed_b = std::get<Circle>(placed(Element(b), frame));
  RC_ASSERT(contact_error(placed_a, placed_b) == 0);
  RC_ASSERT(placed_b.radius() == b.radius());
  RC_ASSERT(contact(placed_a, placed_b) == placed(contact(a, b), frame));
}

RC_GTEST_PROP(Placed, APointMovesWithTheElementsItLiesOn, ()) {
  const Element e = any_element();
  const Frame frame = any_frame();
  const ExactPoint on = crossing_of(e);
  RC_ASSERT(side_of(placed(e, frame), placed(on, frame)) == 0);
  const RationalPoint beside = any_point();
  RC_ASSERT(side_of(placed(e, frame), placed(ExactPoint(beside), frame)) ==
            side_of(e, ExactPoint(beside)));
  RC_ASSERT(same_place(placed(ExactPoint(beside), frame), ExactPoint(placed(beside, frame))));
}

RC_GTEST_PROP(Placed, TurningByAnAngleAndBackIsTheIdentity, ()) {
  Rational a = any_angle();
  if (Rational(a / 45).get_den() == 1) a += 1;  // odd multiples of 45°: see direction_of
  const Frame there{{0, 0}, direction_of(a).unit};
  const Frame back{{0, 0}, direction_of(-a).unit};
  const Element e = any_element();
  RC_ASSERT(placed(placed(e, there), back) == e);
  const RationalPoint p = any_point();
  RC_ASSERT(placed(placed(p, there), back) == p);
}

RC_GTEST_PROP(Placed, CommutesWithOffsetAndReversal, ()) {
  const Element e = any_element();
  const Frame frame = any_frame();
  const Rational w = any_decimal(20);
  if (const auto* c = std::get_if<Circle>(&e); c && c->radius() == w) return;
  RC_ASSERT(placed(offset(e, w), frame) == offset(placed(e, frame), w));
  RC_ASSERT(placed(reversed(e), frame) == reversed(placed(e, frame)));
}

TEST(Placed, ByTheIdentityNothingMoves) {
  const Frame identity;
  EXPECT_TRUE(identity.is_identity());
  EXPECT_EQ(placed(Element(Circle({1, 2}, 3)), identity), Element(Circle({1, 2}, 3)));
  EXPECT_EQ(placed(Element(horizontal_line(7)), identity), Element(horizontal_line(7)));
  EXPECT_FALSE((Frame{{0, 0}, direction_of(90).unit}).is_identity());
}

TEST(Placed, AQuarterTurnAboutAnOriginGoesCounterClockwise) {
  const Frame frame{{10, 20}, direction_of(90).unit};
  EXPECT_EQ(placed(RationalPoint{1, 0}, frame), (RationalPoint{10, 21}));
  EXPECT_EQ(placed(Element(horizontal_line(0)), frame), Element(vertical_line(10).reversed()));
}

}  // namespace
}  // namespace dgt
