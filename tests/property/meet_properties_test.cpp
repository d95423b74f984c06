// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of meet(), each stage against the next, and all against CGAL's circular kernel.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "kernel/cgal/crossings.h"
#include "tests/support/geometry_generators.h"

namespace dgt {
namespace {

using stages::Verdict;

Carrier shifted(const Element& e) {
  Carrier c = carrier(e);
  if (*rc::gen::arbitrary<bool>()) return c;
  const Rational shift = test::any_decimal(3);
  if (const auto* circle = std::get_if<Circle>(&e); circle && !circle->survives_offset(shift))
    return c;
  c.shift = std::make_shared<const Rational>(shift);
  return c;
}

struct Operands {
  Element a;
  Element b;
};
Operands any_operands() {
  const Element a = test::any_element();
  return {a, test::element_beside(a)};
}
/// A line and a circle or two circles that cross, in either order.
Operands crossing_operands() {
  const Element a = test::any_element();
  const Element b = std::visit([](const auto& x) { return Element(test::circle_crossing(x)); }, a);
  return *rc::gen::arbitrary<bool>() ? Operands{a, b} : Operands{b, a};
}

std::optional<int> cgal_count(const Element& a, const Element& b) {
  const auto* line_a = std::get_if<Line>(&a);
  const auto* line_b = std::get_if<Line>(&b);
  if (line_a && line_b) return std::nullopt;
  if (line_a) return cgal::crossing_count(*line_a, std::get<Circle>(b));
  if (line_b) return cgal::crossing_count(*line_b, std::get<Circle>(a));
  return cgal::crossing_count(std::get<Circle>(a), std::get<Circle>(b));
}

bool on_both(const ExactPoint& p, const Element& a, const Element& b) {
  return side_of(a, p) == 0 && side_of(b, p) == 0;
}

RC_GTEST_PROP(MeetConsistency, TheFilterNeverContradictsTheExactStage, ()) {
  const auto [a, b] = any_operands();
  const Carrier ca = shifted(a);
  const Carrier cb = shifted(b);
  const Verdict quick = stages::filtered(ca, cb);
  RC_CLASSIFY(quick != Verdict::Unknown, "settled by the filter");
  if (quick == Verdict::Unknown) return;
  RC_ASSERT(quick == stages::exact(ca.element(), cb.element()));
}

RC_GTEST_PROP(MeetConsistency, AHairbreadthFromContactTheFilterNeverContradictsTheExactStage, ()) {
  const auto nearly_touching = [](const auto& a) {
    const Circle c = test::circle_touching(a);
    const Rational hair = *rc::gen::inRange(-8, 9) * power_of_two(-*rc::gen::inRange(40, 76));
    return c.survives_offset(hair) ? Element(c.offset(hair)) : Element(c);
  };
  const Element a = test::any_element();
  const Element b = std::visit(nearly_touching, a);
  const Verdict quick = stages::filtered(carrier(a), carrier(b));
  if (quick == Verdict::Unknown) return;
  RC_ASSERT(quick == stages::exact(a, b));
}

RC_GTEST_PROP(MeetConsistency, TheDoublesOfACrossingAreTheNearestOfTheExactOnes, ()) {
  const auto [a, b] = crossing_operands();
  const Which which = *rc::gen::element(Which::Entry, Which::Exit);
  const Point p = Point::crossing(carrier(a), carrier(b), which);
  const ExactPoint exact = stages::exact_crossing(a, b, which);
  RC_ASSERT(p.x() == nearest_double(exact.x));
  RC_ASSERT(p.y() == nearest_double(exact.y));
  RC_ASSERT(p == Point(exact));
  RC_ASSERT(same_place(p.exact(), exact));
}

RC_GTEST_PROP(MeetConsistency, TheDoublesOfACrossingOfLinesAreTheNearestOfTheExactOnes, ()) {
  const Line a = test::any_line();
  const Line b = test::any_line();
  const Meeting m = meet(Element(a), Element(b));
  if (!std::holds_alternative<OnePoint>(m)) return;
  const Point& p = std::get<OnePoint>(m).at;
  const ExactPoint exact = stages::exact_crossing(a, b, Which::Entry);
  RC_ASSERT(on_both(exact, a, b));
  RC_ASSERT(p.x() == nearest_double(exact.x));
  RC_ASSERT(p.y() == nearest_double(exact.y));
}

RC_GTEST_PROP(MeetConsistency, AnOffsetCarrierMeetsLikeTheOffsetElement, ()) {
  const auto [a, b] = any_operands();
  const Carrier ca = shifted(a);
  const Carrier cb = shifted(b);
  const Meeting by_carrier = meet(ca, cb);
  const Meeting by_element = meet(ca.element(), cb.element());
  RC_ASSERT(by_carrier.index() == by_element.index());
  if (const auto* two = std::get_if<TwoPoints>(&by_carrier)) {
    const auto& other = std::get<TwoPoints>(by_element);
    RC_ASSERT(two->at(Which::Entry) == other.at(Which::Entry));
    RC_ASSERT(two->at(Which::Exit) == other.at(Which::Exit));
  }
}

RC_GTEST_PROP(MeetLaws, EveryCrossingLiesOnBothExactly, ()) {
  const auto [a, b] = crossing_operands();
  const Meeting m = meet(a, b);
  RC_ASSERT(std::holds_alternative<TwoPoints>(m));
  const auto& two = std::get<TwoPoints>(m);
  RC_ASSERT(on_both(two.at(Which::Entry).exact(), a, b));
  RC_ASSERT(on_both(two.at(Which::Exit).exact(), a, b));
  RC_ASSERT(!(two.at(Which::Entry) == two.at(Which::Exit)));
}

RC_GTEST_PROP(MeetLaws, AnExactContactLiesOnBothExactly, ()) {
  const auto touching = [](const auto& a) { return test::circle_touching(a); };
  const Element a = test::any_element();
  const Element b = std::visit(touching, a);
  const Meeting m = meet(a, b);
  if (!std::holds_alternative<OnePoint>(m)) return;  // 10⁻⁹ off, or the same circle
  RC_ASSERT(std::get<OnePoint>(m).contact);
  RC_ASSERT(on_both(std::get<OnePoint>(m).at.exact(), a, b));
}

RC_GTEST_PROP(MeetLaws, TheSwappedOperandsMeetInTheSamePoints, ()) {
  const auto [a, b] = any_operands();
  const Meeting ab = meet(a, b);
  const Meeting ba = meet(b, a);
  RC_ASSERT(ab.index() == ba.index());
  if (const auto* one = std::get_if<OnePoint>(&ab)) {
    RC_ASSERT(one->at == std::get<OnePoint>(ba).at);
  } else if (const auto* apart = std::get_if<Apart>(&ab)) {
    RC_ASSERT(compare(apart->gap, std::get<Apart>(ba).gap) == 0);
  } else if (const auto* two = std::get_if<TwoPoints>(&ab)) {
    const auto& swapped = std::get<TwoPoints>(ba);
    const auto* ca = std::get_if<Circle>(&a);
    const auto* cb = std::get_if<Circle>(&b);
    const bool exchanged = ca && cb && ca->counter_clockwise() == cb->counter_clockwise();
    const Which same = exchanged ? Which::Exit : Which::Entry;
    RC_ASSERT(two->at(Which::Entry) == swapped.at(same));
    RC_ASSERT(two->at(Which::Exit) == swapped.at(other(same)));
  }
}

RC_GTEST_PROP(MeetLaws, ReversingTheElementWhoseMotionCountsExchangesEntryAndExit, ()) {
  const auto [a, b] = crossing_operands();
  const bool line_second = std::holds_alternative<Line>(b);
  const Element moved = reversed(line_second ? b : a);
  const Element still = reversed(line_second ? a : b);
  const auto at = [](const Element& x, const Element& y, Which w) {
    return std::get<TwoPoints>(meet(x, y)).at(w);
  };
  const auto moved_at = [&](Which w) { return line_second ? at(a, moved, w) : at(moved, b, w); };
  const auto still_at = [&](Which w) { return line_second ? at(still, b, w) : at(a, still, w); };
  RC_ASSERT(moved_at(Which::Entry) == at(a, b, Which::Exit));
  RC_ASSERT(moved_at(Which::Exit) == at(a, b, Which::Entry));
  RC_ASSERT(still_at(Which::Entry) == at(a, b, Which::Entry));
}

RC_GTEST_PROP(MeetLaws, EntryIsWhereTheMotionLeadsIntoTheDisc, ()) {
  const auto [a, b] = crossing_operands();
  if (std::holds_alternative<Line>(b)) return;
  const Circle disc = std::get<Circle>(b);
  const ExactPoint entry = std::get<TwoPoints>(meet(a, b)).at(Which::Entry).exact();
  // The derivative of |x − c|² along the motion, up to a positive factor, over one root.
  OneRoot heading_x;
  OneRoot heading_y;
  if (const auto* line = std::get_if<Line>(&a)) {
    heading_x = OneRoot(line->direction().x());
    heading_y = OneRoot(line->direction().y());
  } else {
    const auto& circle = std::get<Circle>(a);
    const Rational sense = circle.counter_clockwise() ? 1 : -1;
    heading_x = (entry.y - circle.centre().y) * (-sense);
    heading_y = (entry.x - circle.centre().x) * sense;
  }
  const auto product = [](const OneRoot& x, const OneRoot& y) {
    const Rational& c = x.is_rational() ? y.c : x.c;
    return OneRoot(x.a * y.a + x.b * y.b * c, x.a * y.b + x.b * y.a, c);
  };
  const OneRoot outwards_x = product(heading_x, entry.x - disc.centre().x);
  const OneRoot outwards_y = product(heading_y, entry.y - disc.centre().y);
  RC_ASSERT(sign(combine(1, outwards_x, 1, outwards_y, 0)) < 0);
}

RC_GTEST_PROP(MeetWitness, CgalCountsAsManyCrossings, ()) {
  const auto [a, b] = any_operands();
  const auto count = cgal_count(a, b);
  const Meeting m = meet(a, b);
  if (!count || std::holds_alternative<Coincident>(m)) return;
  const int ours = std::holds_alternative<TwoPoints>(m) ? 2 : std::holds_alternative<OnePoint>(m);
  RC_ASSERT(ours == *count);
}

RC_GTEST_PROP(MeetLaws, TheGapOfElementsApartIsTheDistanceOfTheirNearestPoints, ()) {
  const auto [a, b] = any_operands();
  const Meeting m = meet(a, b);
  const auto* apart = std::get_if<Apart>(&m);
  if (!apart) return;
  RC_ASSERT(side_of(a, apart->on_a) == 0);
  RC_ASSERT(side_of(b, apart->on_b) == 0);
  RC_ASSERT(sign(apart->gap) > 0);
  const double gap = nearest_double(apart->gap);
  RC_ASSERT(std::abs(distance_to(a, apart->on_b) - gap) <= 1e-12 * gap);
  RC_ASSERT(std::abs(distance_to(b, apart->on_a) - gap) <= 1e-12 * gap);
}

}  // namespace
}  // namespace dgt
