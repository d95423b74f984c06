// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of nearness between stretches, and each filter against its exact stage.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "kernel/stretch.h"
#include "tests/support/geometry_generators.h"

namespace dgt {
namespace {

/// A place of the element: rational, or where another element crosses it.
Point place_on(const Element& e) {
  const Element other =
      std::visit([](const auto& x) { return Element(test::circle_crossing(x)); }, e);
  const Meeting meeting = meet(e, other);
  const auto* two = std::get_if<TwoPoints>(&meeting);
  RC_PRE(two != nullptr);
  return two->at(*rc::gen::element(Which::Entry, Which::Exit));
}

Stretch stretch_on(const Element& e) {
  Stretch s{place_on(e), place_on(e), carrier(e)};
  RC_PRE(!(s.from == s.to));
  return s;
}

struct Pair {
  Stretch a, b;
};
Pair any_pair() {
  const Element a = test::any_element();
  return {stretch_on(a), stretch_on(test::element_beside(a))};
}

Stretch reversed(const Stretch& s) {
  return {s.to, s.from, carrier(reversed(s.carrier.element()))};
}

Rational some_distance() { return abs(test::nonzero_decimal(100)); }

RC_GTEST_PROP(StretchNearness, AgreesWithTheMeasureWhereThatIsClear, ()) {
  const auto [a, b] = any_pair();
  const Rational t = some_distance();
  const Piece pa = piece_of(a);
  const Piece pb = piece_of(b);
  const double measured = nearest(pa, pb).distance;
  const Bounds box = box_of(pa).united(box_of(pb));
  const double size = std::max({std::fabs(box.min_x), std::fabs(box.max_x), std::fabs(box.min_y),
                                std::fabs(box.max_y), std::fabs(pa.radius), std::fabs(pb.radius)});
  const double limit = nearest_double(t);
  RC_PRE(std::fabs(measured - limit) > 1e-6 * size);
  RC_CLASSIFY(measured < limit, "nearer");
  RC_ASSERT(comes_nearer(a, b, t) == (measured < limit));
}

RC_GTEST_PROP(StretchNearness, IsSymmetricAndKnowsNoDirection, ()) {
  const auto [a, b] = any_pair();
  const Rational t = some_distance();
  const bool nearer = comes_nearer(a, b, t);
  RC_ASSERT(comes_nearer(b, a, t) == nearer);
  RC_ASSERT(comes_nearer(reversed(a), b, t) == nearer);
  RC_ASSERT(comes_nearer(a, reversed(b), t) == nearer);
}

RC_GTEST_PROP(StretchNearness, GrowsWithTheDistance, ()) {
  const auto [a, b] = any_pair();
  const Rational t = some_distance();
  if (comes_nearer(a, b, t)) RC_ASSERT(comes_nearer(a, b, t + some_distance()));
}

RC_GTEST_PROP(StretchNearness, OfAnElementAndItsEquidistantIsTheOffsetExactly, ()) {
  const Element e = test::any_element();
  const Rational w = some_distance();
  if (const auto* circle = std::get_if<Circle>(&e)) RC_PRE(circle->survives_offset(w));
  const Stretch on = stretch_on(e);
  const Stretch beside = stretch_on(offset(e, w));
  RC_ASSERT(!comes_nearer(on, beside, w));
}

RC_GTEST_PROP(StretchNearnessConsistency, TheFilterNeverContradictsTheExactStage, ()) {
  const auto [a, b] = any_pair();
  const Rational t = some_distance();
  const auto quick = stages::filtered_nearer(balls_of(a), balls_of(b), Ball(t));
  RC_CLASSIFY(quick.has_value(), "settled by the filter");
  if (quick) RC_ASSERT(*quick == comes_nearer(a, b, t));
}

RC_GTEST_PROP(StretchNearnessCoverage, AnExactDistanceIsLeftToTheExactStage, ()) {
  const Element e = test::any_element();
  const Rational w = some_distance();
  if (const auto* circle = std::get_if<Circle>(&e)) RC_PRE(circle->survives_offset(w));
  const Stretch on = stretch_on(e);
  const Stretch moved = stretch_on(offset(e, w));
  RC_ASSERT(stages::filtered_nearer(balls_of(on), balls_of(moved), Ball(w)) != true);
}

RC_GTEST_PROP(StretchCrossings, LieOnBothAndMakeThemMeet, ()) {
  const auto [a, b] = any_pair();
  for (const Point& p : common_places(a, b)) {
    RC_ASSERT(covers(a, p));
    RC_ASSERT(covers(b, p));
    RC_ASSERT(comes_nearer(a, b, Rational(1, 1000000)));
  }
}

RC_GTEST_PROP(PlaceOrderConsistency, TheFilterNeverContradictsTheExactStage, ()) {
  const Point p = place_on(test::any_element());
  const Point q = *rc::gen::inRange(0, 4) == 0 ? p : place_on(test::any_element());
  const RationalPoint c = test::any_point();
  RC_ASSERT(turn_about(c, p, q) == stages::exact_turn_about(c, p.exact(), q.exact()));
  const Rational t = test::any_decimal();
  RC_ASSERT(compare_distance(p, q, t * t) ==
            stages::exact_compare_distance(p.exact(), q.exact(), t * t));
}

}  // namespace
}  // namespace dgt
