// SPDX-License-Identifier: GPL-3.0-or-later
// The named cases of meet(), the order of entry and exit, and the stage that decides each.
#include "kernel/meet.h"

#include <gmock/gmock.h>

#include "kernel/construct.h"

namespace dgt {
namespace {

using stages::Verdict;

const Line kXAxis = horizontal_line(0);  // towards +X

void expect_at(const Point& p, double x, double y) {
  EXPECT_EQ(p.x(), x);
  EXPECT_EQ(p.y(), y);
}

template <class Case>
Case expect(const Meeting& m) {
  EXPECT_TRUE(std::holds_alternative<Case>(m)) << "case " << m.index();
  return std::holds_alternative<Case>(m) ? std::get<Case>(m) : Case();
}

// --- lines ------------------------------------------------------------------------------------

TEST(MeetLines, ThatCrossMeetInOneRationalPoint) {
  const auto one = expect<OnePoint>(meet(Element(kXAxis), Element(vertical_line(Rational(1, 3)))));
  EXPECT_FALSE(one.contact);
  expect_at(one.at, 1.0 / 3, 0);
  EXPECT_TRUE(one.at.exact().is_rational());
}

TEST(MeetLines, ThatAreParallelStayTheirDistanceApart) {
  for (const Line& other : {horizontal_line(7), horizontal_line(7).reversed()}) {
    const auto apart = expect<Apart>(meet(Element(horizontal_line(4)), Element(other)));
    EXPECT_EQ(compare(apart.gap, Rational(3)), 0);
    EXPECT_TRUE(apart.anywhere);
    EXPECT_EQ(side_of(horizontal_line(4), apart.on_a), 0);
    EXPECT_EQ(side_of(other, apart.on_b), 0);
  }
}

TEST(MeetLines, ThatAreOneLineAreCoincidentInEitherDirection) {
  const Line line = line_at_angle(known_point(RationalPoint{1, 2}), 30).value;
  expect<Coincident>(meet(Element(line), Element(line)));
  expect<Coincident>(meet(Element(line), Element(line.reversed())));
  expect<Coincident>(meet(Element(line), Element(line.offset(power_of_two(-71)))));
  expect<Apart>(meet(Element(line), Element(line.offset(power_of_two(-69)))));
}

TEST(MeetLines, ThatAreNearlyParallelStillMeetExactly) {
  const Line tilted =
      Line::through({0, 1}, UnitVector::from_half_tangent(power_of_two(-60)))  // normal near +X
          .reversed();
  const Line across(UnitVector({1, 0}), 0);
  const auto one = expect<OnePoint>(meet(Element(across), Element(tilted)));
  EXPECT_EQ(side_of(across, one.at.exact()), 0);
  EXPECT_EQ(side_of(tilted, one.at.exact()), 0);
  // Below the resolution of directions they are parallel.
  const Line hair = Line::through({0, 1}, UnitVector::from_half_tangent(power_of_two(-72)));
  expect<Coincident>(meet(Element(Line::through({0, 1}, UnitVector({1, 0}))), Element(hair)));
}

// --- line and circle --------------------------------------------------------------------------

TEST(MeetLineAndCircle, EntryComesBeforeExitAlongTheLine) {
  const Circle circle({10, 0}, 5);
  for (const Circle& c : {circle, circle.reversed()}) {
    const auto two = expect<TwoPoints>(meet(Element(kXAxis), Element(c)));
    expect_at(two.at(Which::Entry), 5, 0);
    expect_at(two.at(Which::Exit), 15, 0);
    const auto swapped = expect<TwoPoints>(meet(Element(c), Element(kXAxis)));
    expect_at(swapped.at(Which::Entry), 5, 0);
    const auto back = expect<TwoPoints>(meet(Element(kXAxis.reversed()), Element(c)));
    expect_at(back.at(Which::Entry), 15, 0);
  }
}

TEST(MeetLineAndCircle, AVerticalLineIsEnteredFromAboveWhenItRunsDown) {
  const auto two = expect<TwoPoints>(meet(Element(vertical_line(0)), Element(Circle({0, 0}, 2))));
  expect_at(two.at(Which::Entry), 0, 2);
  expect_at(two.at(Which::Exit), 0, -2);
}

TEST(MeetLineAndCircle, TangentIsOneContactPointOnBoth) {
  for (const Rational& y : {Rational(5), Rational(-5)}) {
    const auto one =
        expect<OnePoint>(meet(Element(horizontal_line(y)), Element(Circle({3, 0}, 5))));
    EXPECT_TRUE(one.contact);
    expect_at(one.at, 3, y.get_d());
  }
}

TEST(MeetLineAndCircle, WithinTheContactResolutionOnEitherSideIsAContact) {
  const Circle circle({3, 0}, 5);
  for (const int sense : {-1, 1}) {
    const Line line = horizontal_line(5 + sense * power_of_two(kContactExponent));
    const auto one = expect<OnePoint>(meet(Element(line), Element(circle)));
    EXPECT_TRUE(one.contact);
    EXPECT_EQ(side_of(circle, one.at.exact()), 0);
  }
  const Rational more = power_of_two(kContactExponent) + power_of_two(-200);
  expect<Apart>(meet(Element(horizontal_line(5 + more)), Element(circle)));
  expect<TwoPoints>(meet(Element(horizontal_line(5 - more)), Element(circle)));
}

TEST(MeetLineAndCircle, ApartSaysWhereTheyComeNearest) {
  const auto apart = expect<Apart>(meet(Element(Circle({3, 9}, -2)), Element(kXAxis)));
  EXPECT_EQ(compare(apart.gap, Rational(7)), 0);
  EXPECT_TRUE(same_place(apart.on_a, ExactPoint(RationalPoint{3, 7})));
  EXPECT_TRUE(same_place(apart.on_b, ExactPoint(RationalPoint{3, 0})));
}

// --- circles ----------------------------------------------------------------------------------

TEST(MeetCircles, ThatCrossAreEnteredWhereTheMotionOfTheFirstLeadsIn) {
  const Circle left({0, 0}, 5);
  const Circle right({6, 0}, 5);
  const auto two = expect<TwoPoints>(meet(Element(left), Element(right)));
  expect_at(two.at(Which::Entry), 3, -4);
  expect_at(two.at(Which::Exit), 3, 4);
  const auto clockwise = expect<TwoPoints>(meet(Element(left.reversed()), Element(right)));
  expect_at(clockwise.at(Which::Entry), 3, 4);
  const auto swapped = expect<TwoPoints>(meet(Element(right), Element(left)));
  expect_at(swapped.at(Which::Entry), 3, 4);
  // A second circle of the other sense changes nothing: only the motion of the first counts.
  const auto second = expect<TwoPoints>(meet(Element(left), Element(right.reversed())));
  expect_at(second.at(Which::Entry), 3, -4);
}

TEST(MeetCircles, TangentFromOutsideAndFromInsideIsOneContactPoint) {
  const Circle big({0, 0}, 5);
  for (const int sense : {-1, 1}) {
    const auto outside = expect<OnePoint>(meet(Element(big), Element(Circle({8, 0}, sense * 3))));
    EXPECT_TRUE(outside.contact);
    expect_at(outside.at, 5, 0);
    const auto inside = expect<OnePoint>(meet(Element(big), Element(Circle({2, 0}, sense * 3))));
    expect_at(inside.at, 5, 0);
    const auto around = expect<OnePoint>(meet(Element(Circle({2, 0}, sense * 3)), Element(big)));
    expect_at(around.at, 5, 0);
  }
}

TEST(MeetCircles, WithinTheContactResolutionIsAContactWhateverTheDirection) {
  // Centres √2 apart along the diagonal: the contact is irrational and never exact.
  const Rational root = sqrt_within(2, -200);
  const auto one =
      expect<OnePoint>(meet(Element(Circle({0, 0}, root / 2)), Element(Circle({1, 1}, root / 2))));
  EXPECT_TRUE(one.contact);
  expect_at(one.at, 0.5, 0.5);
}

TEST(MeetCircles, ConcentricOnesStayTheDifferenceOfTheirRadiiApart) {
  const auto apart = expect<Apart>(meet(Element(Circle({1, 1}, 5)), Element(Circle({1, 1}, -3))));
  EXPECT_EQ(compare(apart.gap, Rational(2)), 0);
  EXPECT_TRUE(apart.anywhere);
}

TEST(MeetCircles, CoincidentOnesAreThatInEitherDirection) {
  const Circle c({1, 1}, 5);
  expect<Coincident>(meet(Element(c), Element(c)));
  expect<Coincident>(meet(Element(c), Element(c.reversed())));
  expect<Coincident>(meet(Element(c), Element(c.offset(power_of_two(-71)))));
}

TEST(MeetCircles, OneInsideTheOtherSaysTheLeastGapAndWhere) {
  const auto apart = expect<Apart>(meet(Element(Circle({0, 0}, 10)), Element(Circle({3, 0}, 2))));
  EXPECT_EQ(compare(apart.gap, Rational(5)), 0);
  EXPECT_TRUE(same_place(apart.on_a, ExactPoint(RationalPoint{10, 0})));
  EXPECT_TRUE(same_place(apart.on_b, ExactPoint(RationalPoint{5, 0})));
  const auto swapped = expect<Apart>(meet(Element(Circle({3, 0}, 2)), Element(Circle({0, 0}, 10))));
  EXPECT_TRUE(same_place(swapped.on_a, ExactPoint(RationalPoint{5, 0})));
}

TEST(MeetCircles, OfHugeAndMinuteSizeAreDecided) {
  const Rational huge = 1000000000;
  const Rational minute = Rational(1) / 1000000000;
  const Circle big({-huge, 0}, huge);  // through the origin
  expect<TwoPoints>(meet(Element(big), Element(Circle({0, 0}, minute))));
  EXPECT_TRUE(expect<OnePoint>(meet(Element(big), Element(Circle({minute, 0}, minute)))).contact);
  expect<Apart>(meet(Element(big), Element(Circle({2 * minute, 0}, minute))));
}

// --- coverage of the stages ---------------------------------------------------------------------

TEST(MeetCoverage, TheFilterSettlesWhatIsClear) {
  const Carrier circle = carrier(Circle({0, 0}, 5));
  EXPECT_EQ(stages::filtered(carrier(kXAxis), circle), Verdict::Crossing);
  EXPECT_EQ(stages::filtered(carrier(horizontal_line(6)), circle), Verdict::Apart);
  EXPECT_EQ(stages::filtered(carrier(Circle({6, 0}, 5)), circle), Verdict::Crossing);
  EXPECT_EQ(stages::filtered(carrier(Circle({11, 0}, 5)), circle), Verdict::Apart);
  EXPECT_EQ(stages::filtered(carrier(Circle({1, 0}, 2)), circle), Verdict::Apart);
  EXPECT_EQ(stages::filtered(carrier(kXAxis), carrier(vertical_line(0))), Verdict::Crossing);
}

TEST(MeetCoverage, TheExactStageSettlesContactsAndHairbreadths) {
  const Circle circle({0, 0}, 5);
  const auto decide = [&](const Element& e, Verdict expected) {
    EXPECT_EQ(stages::filtered(carrier(e), carrier(circle)), Verdict::Unknown);
    EXPECT_EQ(stages::exact(e, circle), expected);
  };
  const Rational hair = 3 * power_of_two(-71);
  decide(horizontal_line(5), Verdict::Contact);
  decide(horizontal_line(5 - hair), Verdict::Crossing);
  decide(horizontal_line(5 + hair), Verdict::Apart);
  decide(Circle({8, 0}, 3), Verdict::Contact);
  decide(Circle({8 - hair, 0}, 3), Verdict::Crossing);
  decide(Circle({8 + hair, 0}, 3), Verdict::Apart);
  decide(Circle({0, 0}, 3), Verdict::Apart);
  decide(Circle({0, 0}, -5), Verdict::Contact);
}

}  // namespace
}  // namespace dgt
