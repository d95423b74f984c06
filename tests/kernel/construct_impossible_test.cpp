// SPDX-License-Identifier: GPL-3.0-or-later
// Every case in which a construction has no result, by name and with its measure, and the
// degenerate operands that still have one.
#include <gmock/gmock.h>

#include <cmath>

#include "kernel/construct.h"

namespace dgt {
namespace {

using Why = Impossible::Why;

KnownPoint at(Rational x, Rational y) {
  return known_point(RationalPoint{std::move(x), std::move(y)});
}

template <class T>
void expect_impossible(const Construction<T>& c, Why why, double measure) {
  const auto* no = std::get_if<Impossible>(&c);
  ASSERT_NE(no, nullptr) << "it has a result";
  EXPECT_EQ(static_cast<int>(no->why), static_cast<int>(why));
  EXPECT_DOUBLE_EQ(no->measure, measure);
}

template <class T>
Constructed<T> expect_made(const Construction<T>& c) {
  if (const auto* no = std::get_if<Impossible>(&c)) {
    ADD_FAILURE() << "impossible, case " << static_cast<int>(no->why);
    throw std::runtime_error("no result");
  }
  return std::get<Constructed<T>>(c);
}

const Rational kHalfResolution = power_of_two(kContactExponent - 1);

TEST(Impossible, CoincidentPointsSayTheirDistance) {
  expect_impossible(line_through(at(1, 2), at(1, 2)), Why::CoincidentPoints, 0);
  expect_impossible(line_through(at(1, 2), at(1 + kHalfResolution, 2)), Why::CoincidentPoints,
                    0x1p-71);
  expect_impossible(circle_through(at(0, 0), at(0, 0), at(1, 0)), Why::CoincidentPoints, 0);
  expect_impossible(circle_through(at(0, 0), at(1, 0), at(0, kHalfResolution)),
                    Why::CoincidentPoints, 0x1p-71);
  expect_impossible(circle_through(at(1, 0), at(0, 0), at(0, 0)), Why::CoincidentPoints, 0);
}

TEST(Impossible, CollinearPointsSayHowFarTheMiddleOneLiesOff) {
  expect_impossible(circle_through(at(0, 0), at(1, 1), at(3, 3)), Why::CollinearPoints, 0);
  expect_impossible(circle_through(at(0, 0), at(4, 0), at(1, kHalfResolution)),
                    Why::CollinearPoints, 0x1p-71);
  expect_impossible(circle_through(at(4, 0), at(1, kHalfResolution), at(0, 0)),
                    Why::CollinearPoints, 0x1p-71);
  // Beyond the resolution it is a circle, however flat.
  const auto flat =
      expect_made(circle_through(at(0, 0), at(4, 0), at(1, Rational(1) / 1000000000)));
  EXPECT_GT(flat.value.radius(), 1000000000);
}

TEST(Impossible, PointsOfOneLineThatAreIrrationalAreCollinear) {
  const Line line = line_at_angle(at(1, 2), 30).value;
  const auto on_line = [&](int radius, Selector s) {
    return expect_made(meeting_point(line, Circle({3, 4}, radius), s)).value;
  };
  const auto result =
      circle_through(on_line(5, Selector::I1), on_line(7, Selector::I2), on_line(9, Selector::I1));
  ASSERT_TRUE(std::holds_alternative<Impossible>(result));
  EXPECT_EQ(std::get<Impossible>(result).why, Why::CollinearPoints);
}

TEST(Impossible, ParallelLinesSayTheirDistance) {
  const Line a = horizontal_line(1);
  expect_impossible(meeting_point(a, horizontal_line(4), Selector::Default), Why::ParallelLines, 3);
  expect_impossible(touching(a, horizontal_line(4), 2), Why::ParallelLines, 3);
  // Of opposite directions the loci of the centre count: y = 3 and y = 2.
  expect_impossible(touching(a, horizontal_line(4).reversed(), 2), Why::ParallelLines, 1);
}

TEST(Impossible, APointInsideSaysItsDepth) {
  expect_impossible(tangent_from(at(3, 0), Circle({0, 0}, -5)), Why::PointInside, 2);
  expect_impossible(tangent_from(at(0, 0), Circle({0, 0}, 5)), Why::PointInside, 5);
}

TEST(Impossible, ConcentricCirclesSayTheDifferenceOfTheirRadii) {
  const Circle a({1, 1}, 5);
  expect_impossible(common_tangent(a, Circle({1, 1}, 3)), Why::ConcentricCircles, 2);
  expect_impossible(touching(a, Circle({1, 1}, -3), 2, Selector::Default), Why::ConcentricCircles,
                    2);
}

TEST(Impossible, ACircleInsideTheOtherSaysItsDepth) {
  // 1 apart, while the radii differ by 3: 2 too deep.
  expect_impossible(common_tangent(Circle({0, 0}, 5), Circle({1, 0}, 2)), Why::CircleInside, 2);
  // Circles that cross have no inner tangent: 6 apart, where 5 − (−4) = 9 are needed.
  expect_impossible(common_tangent(Circle({0, 0}, 5), Circle({6, 0}, -4)), Why::CircleInside, 3);
}

TEST(Impossible, NoTouchingCircleSaysTheGapOfTheLoci) {
  // line y = 0, circle of radius 1 about (0, 10): centres on y = 2 and within 1 of (0, 10)
  expect_impossible(touching(horizontal_line(0), Circle({0, 10}, 1), 2, Selector::I1),
                    Why::NoTouchingCircle, 7);
  expect_impossible(touching(Circle({0, 0}, 1), Circle({20, 0}, 1), 3, Selector::I1),
                    Why::NoTouchingCircle, 16);
  // one locus inside the other: radii 9 and 1, centres 3 apart
  expect_impossible(touching(Circle({0, 0}, 10), Circle({3, 0}, 2), 1, Selector::I1),
                    Why::NoTouchingCircle, 5);
}

TEST(Impossible, InAChannelOrRingAsWideAsTheCircleItTouchesEverywhere) {
  expect_impossible(touching(horizontal_line(0), horizontal_line(4).reversed(), 2),
                    Why::AlwaysTouching, 0);
  // ring from 3 to 5, outside counter-clockwise, inside clockwise
  expect_impossible(touching(Circle({0, 0}, 5), Circle({0, 0}, -3), 1, Selector::I1),
                    Why::AlwaysTouching, 0);
}

TEST(Impossible, ARadiusOfZeroIsNone) {
  expect_impossible(circle_about(at(0, 0), 0), Why::ZeroRadius, 0);
  expect_impossible(circle_polar(at(0, 0), 5, 30, 0), Why::ZeroRadius, 0);
  expect_impossible(touching(horizontal_line(0), vertical_line(0), 0), Why::ZeroRadius, 0);
  expect_impossible(touching(horizontal_line(0), Circle({0, 5}, 1), 0, Selector::I1),
                    Why::ZeroRadius, 0);
  expect_impossible(touching(Circle({0, 0}, 1), Circle({0, 5}, 1), 0, Selector::I1),
                    Why::ZeroRadius, 0);
}

TEST(Impossible, NoMeetingSaysTheGap) {
  expect_impossible(meeting_point(horizontal_line(7), Circle({0, 0}, 5), Selector::I1),
                    Why::NoMeeting, 2);
  expect_impossible(meeting_point(Circle({3, 4}, 1), Circle({0, 0}, 2), Selector::I1),
                    Why::NoMeeting, 2);
}

TEST(Impossible, TheSameElementTwiceIsNamed) {
  const Circle c({1, 2}, 3);
  expect_impossible(meeting_point(c, c.reversed(), Selector::I1), Why::SameElement, 0);
  expect_impossible(meeting_point(horizontal_line(1), horizontal_line(1), Selector::Default),
                    Why::SameElement, 0);
  expect_impossible(touching(c, Circle({9, 9}, 4), 3, Selector::I1), Why::SameElement, 0);
}

TEST(Impossible, WhereThereIsOnePointASelectorHasNoChoice) {
  expect_impossible(meeting_point(horizontal_line(1), vertical_line(1), Selector::I2),
                    Why::NoChoice, 0);
  expect_impossible(
      touching(Element(horizontal_line(1)), Element(vertical_line(1)), 2, Selector::GreaterX),
      Why::NoChoice, 0);
}

TEST(Impossible, CandidatesWithEqualCoordinatesAreNotChosenBetween) {
  const Circle c({0, 0}, 5);
  for (const Selector s : {Selector::GreaterX, Selector::SmallerX}) {
    expect_impossible(meeting_point(vertical_line(1), c, s), Why::EqualCandidates, 0);
    expect_impossible(touching(vertical_line(4).reversed(), c, 2, s), Why::EqualCandidates, 0);
    expect_impossible(touching(c, Circle({8, 0}, 5), -2, s), Why::EqualCandidates, 0);
  }
  for (const Selector s : {Selector::GreaterY, Selector::SmallerY})
    expect_impossible(meeting_point(horizontal_line(1), c, s), Why::EqualCandidates, 0);
}

// --- degenerate operands that have a result -----------------------------------------------------

TEST(Degenerate, LociInContactGiveTheOneCircleBetweenThem) {
  const auto made = expect_made(touching(Circle({0, 0}, 1), Circle({10, 0}, 1), -4, Selector::I2));
  EXPECT_EQ(made.value, Circle({5, 0}, -4));
  EXPECT_EQ(made.bound, 0);
  const auto by_line =
      expect_made(touching(horizontal_line(0), Circle({7, 10}, -2), 4, Selector::GreaterX));
  EXPECT_EQ(by_line.value, Circle({7, 4}, 4));
  EXPECT_EQ(by_line.bound, 0);
}

TEST(Degenerate, LociInContactWithinTheResolutionSayHowFarTheResultIsOff) {
  const Rational gap = power_of_two(kContactExponent - 2);
  const auto made =
      expect_made(touching(Circle({0, 0}, 1), Circle({10 + gap, 0}, 1), -4, Selector::I1));
  EXPECT_GE(Rational(made.bound), gap / 2);
  EXPECT_LE(made.bound, 0x1p-67);
}

TEST(Degenerate, CirclesInContactWithinTheResolutionSayHowFarALargeResultIsOff) {
  // The radii differ by 1/1000, the result is 10⁶ times as large: so is what it is off.
  const Rational gap = power_of_two(kContactExponent - 1);
  const Circle a({0, 0}, 1);
  const Circle b({Rational(1, 1000) + gap, 0}, Rational(999, 1000));
  const auto made = expect_made(touching(a, b, 1000, Selector::I1));
  const double from_a = std::sqrt(squared_length(made.value.centre()).get_d());
  EXPECT_NEAR(from_a, 999, 1e-9);
  const Rational reach = 999;
  const Rational stretch = squared_length(made.value.centre()) - reach * reach;  // 2·reach·off
  EXPECT_LE(abs(stretch) / (2 * reach), Rational(made.bound));
  EXPECT_LE(made.bound, 0x1p-46);
}

TEST(Degenerate, ATangentFromAPointWithinTheResolutionOfTheCircleIsTheTangentThere) {
  for (const int sense : {-1, 1}) {
    const auto line =
        expect_made(tangent_from(at(5 + sense * kHalfResolution, 0), Circle({0, 0}, 5)));
    EXPECT_EQ(line.value, vertical_line(5).reversed());
  }
}

TEST(Degenerate, SelectorsPickTheSideTheyName) {
  const Line line = horizontal_line(0);
  const Circle circle({0, 3}, -3);  // clockwise, on top of the line
  const auto left = expect_made(touching(line, circle, 2, Selector::SmallerX)).value;
  const auto right = expect_made(touching(line, circle, 2, Selector::GreaterX)).value;
  EXPECT_LT(left.centre().x, 0);
  EXPECT_GT(right.centre().x, 0);
  EXPECT_EQ(left, expect_made(touching(line, circle, 2, Selector::I1)).value);
  EXPECT_EQ(right, expect_made(touching(line, circle, 2, Selector::I2)).value);
}

}  // namespace
}  // namespace dgt
