// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/figures.h"

#include <gmock/gmock.h>

#include <ostream>

#include "tests/support/moves.h"

namespace dgt {

bool operator==(const Box& a, const Box& b) {
  return a.left == b.left && a.bottom == b.bottom && a.right == b.right && a.top == b.top;
}
void PrintTo(const Box& box, std::ostream* out) {
  *out << "[" << box.left << " " << box.bottom << " " << box.right << " " << box.top << "]";
}

namespace {

using support::arc;
using support::at;
using support::full_circle;

const RationalPoint kOrigin{0, 0};

Box box_of_one(const Move& move) { return box_of(std::span(&move, 1)); }

// Points of the circle of radius 5, one in each quadrant and on each axis.
const Point kFirst = at(4, 3);
const Point kFirstLater = at(3, 4);
const Point kSecond = at(-3, 4);
const Point kThird = at(-3, -4);
const Point kFourth = at(4, -3);
const Point kRight = at(5, 0);
const Point kTop = at(0, 5);
const Point kLeft = at(-5, 0);

TEST(BoxOfMoves, OfNothingIsEmpty) {
  EXPECT_TRUE(box_of({}).empty());
  Move code;
  code.kind = MoveKind::Code;
  EXPECT_TRUE(box_of_one(code).empty());
}

TEST(BoxOfMoves, OfAnArcInsideOneQuadrantIsThatOfItsEnds) {
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kFirst, kFirstLater)), (Box{3, 3, 4, 4}));
  EXPECT_EQ(box_of_one(arc(kOrigin, -5, kFirstLater, kFirst)), (Box{3, 3, 4, 4}));
}

TEST(BoxOfMoves, OfAnArcRoundToTheQuadrantItBeganInHasAllSides) {
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kFirstLater, kFirst)), (Box{-5, -5, 5, 5}));
  EXPECT_EQ(box_of_one(arc(kOrigin, -5, kFirst, kFirstLater)), (Box{-5, -5, 5, 5}));
}

TEST(BoxOfMoves, OfAnArcHasTheExtremesItRunsOver) {
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kFirst, kSecond)), (Box{-3, 3, 4, 5}));
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kFirst, kThird)), (Box{-5, -4, 4, 5}));
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kFourth, kFirst)), (Box{4, -3, 5, 3}));
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kSecond, kFirst)), (Box{-5, -5, 5, 4}));
  EXPECT_EQ(box_of_one(arc(kOrigin, -5, kFirst, kSecond)), (Box{-5, -5, 5, 4}));
}

TEST(BoxOfMoves, OfAnArcThatEndsAtAnExtremeStopsThere) {
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kRight, kTop)), (Box{0, 0, 5, 5}));
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kTop, kRight)), (Box{-5, -5, 5, 5}));
  EXPECT_EQ(box_of_one(arc(kOrigin, 5, kRight, kLeft)), (Box{-5, 0, 5, 5}));
  EXPECT_EQ(box_of_one(arc(kOrigin, -5, kRight, kLeft)), (Box{-5, -5, 5, 0}));
}

TEST(BoxOfMoves, OfAFullCircleIsTheSquareAboutIt) {
  EXPECT_EQ(box_of_one(full_circle({1, 2}, -5, at(6, 2))), (Box{-4, -3, 6, 7}));
  EXPECT_EQ(box_of_one(full_circle({1, 2}, 5, at(4, 6))), (Box{-4, -3, 6, 7}));
}

TEST(BoxOfMoves, RapidsAreTravelledToo) {
  EXPECT_EQ(box_of_one(support::rapid(at(1, 2), at(-3, 5))), (Box{-3, 2, 1, 5}));
}

TEST(FiguresOfAnArc, HaveAPositiveRadiusAndTheSense) {
  const ArcFigures figures_of = figures(arc({1, 2}, Rational(-5, 2), at(1, 2), at(1, 2)));
  EXPECT_EQ(figures_of.centre_x, 1);
  EXPECT_EQ(figures_of.centre_y, 2);
  EXPECT_EQ(figures_of.radius, 2.5);
  EXPECT_FALSE(figures_of.counter_clockwise);
}

TEST(CoordinateInDoubles, IsZeroWithinTheResolutionOfZero) {
  EXPECT_EQ(coordinate(power_of_two(kZeroExponent)), 0);
  EXPECT_GT(coordinate(power_of_two(kZeroExponent + 1)), 0);
  EXPECT_EQ(coordinate(Rational(1, 3)), 1.0 / 3.0);
}

TEST(AppendNumber, WritesTheShortestFormThatReadsBack) {
  const auto text = [](double value) {
    std::string out;
    append_number(out, value);
    return out;
  };
  EXPECT_EQ(text(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(text(0.2), "0.2");
  EXPECT_EQ(text(14), "14");
  EXPECT_EQ(text(-0.0), "0");
}

}  // namespace
}  // namespace dgt
