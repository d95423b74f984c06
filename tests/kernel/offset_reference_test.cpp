// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "kernel/offset.h"

namespace dgt {
namespace {

constexpr double kPi = std::numbers::pi;

/// Vertices `x y bulge`, separated by semicolons.
Chain polygon(const std::string& text) {
  std::vector<BulgeVertex> vertices;
  std::istringstream all(text);
  for (std::string vertex; std::getline(all, vertex, ';');) {
    std::istringstream words(vertex);
    std::string x, y, bulge = "0";
    words >> x >> y >> bulge;
    vertices.push_back({{*parse_decimal(x), *parse_decimal(y)}, *parse_decimal(bulge)});
  }
  return chain_of(vertices, true).value();
}

Chain rectangle(int x0, int y0, int x1, int y1) {
  return chain_of({{{x0, y0}, 0}, {{x1, y0}, 0}, {{x1, y1}, 0}, {{x0, y1}, 0}}, true).value();
}

struct Shape {
  std::size_t loops = 0;
  double area = 0;
  double length = 0;
};
Shape shape_of(const std::vector<Chain>& loops, const Rational& distance) {
  Shape shape;
  for (const OffsetLoop& loop : reference_offset(loops, distance)) {
    ++shape.loops;
    shape.area += area(loop);
    shape.length += length(loop);
  }
  return shape;
}

TEST(ReferenceOffset, SquareShrinksWithSharpCorners) {
  const Shape s = shape_of({rectangle(0, 0, 10, 10)}, 1);
  EXPECT_EQ(s.loops, 1U);
  EXPECT_DOUBLE_EQ(s.area, 64);
  EXPECT_DOUBLE_EQ(s.length, 32);
}

TEST(ReferenceOffset, SquareGrowsWithRoundCorners) {
  const Shape s = shape_of({rectangle(0, 0, 10, 10)}, -1);
  EXPECT_EQ(s.loops, 1U);
  EXPECT_NEAR(s.area, 100 + 40 + kPi, 1e-12);
  EXPECT_NEAR(s.length, 40 + 2 * kPi, 1e-12);
}

TEST(ReferenceOffset, NothingIsLeftAtHalfTheWidthAndBeyond) {
  EXPECT_EQ(shape_of({rectangle(0, 0, 10, 10)}, 5).loops, 0U);
  EXPECT_EQ(shape_of({rectangle(0, 0, 10, 10)}, 6).loops, 0U);
  EXPECT_EQ(shape_of({rectangle(0, 0, 10, 10)}, 1000).loops, 0U);
}

TEST(ReferenceOffset, CircleOfTwoHalves) {
  const Chain circle = polygon("-5 0 1; 5 0 1");
  EXPECT_NEAR(shape_of({circle}, 2).area, 9 * kPi, 1e-12);
  EXPECT_NEAR(shape_of({circle}, -2).area, 49 * kPi, 1e-12);
  EXPECT_EQ(shape_of({circle}, 5).loops, 0U);
  EXPECT_EQ(shape_of({circle}, 7).loops, 0U);  // a void loop: the disc swallows the circle
}

TEST(ReferenceOffset, SlotExactlyTwiceTheDistanceIsCutThere) {
  // A dumb-bell: two 10×10 squares joined by a neck 4 wide.
  const Chain bell = polygon("0 0;10 0;10 3;20 3;20 0;30 0;30 10;20 10;20 7;10 7;10 10;0 10");
  EXPECT_EQ(shape_of({bell}, Rational(19, 10)).loops, 1U);
  EXPECT_EQ(shape_of({bell}, 2).loops, 2U);
  EXPECT_EQ(shape_of({bell}, Rational(2000001, 1000000)).loops, 2U);
  const Rational hair = Rational(1) / 1000000000;
  EXPECT_EQ(shape_of({bell}, 2 - hair).loops, 1U);
  EXPECT_EQ(shape_of({bell}, 2 + hair).loops, 2U);
}

TEST(ReferenceOffset, HoleIsAnIsland) {
  const Chain hole = reversed(rectangle(40, 40, 60, 60));
  const Shape s = shape_of({rectangle(0, 0, 100, 100), hole}, 10);
  EXPECT_EQ(s.loops, 2U);
  EXPECT_NEAR(s.area, 80 * 80 - (20 * 20 + 4 * 20 * 10 + 100 * kPi), 1e-9);
}

TEST(ReferenceOffset, PublishedFailuresComeOutRight) {
  // A contour reported to come out empty when inset by exactly 36.
  const Chain stair = polygon("36 504;540 504;576 360;756 360;864 144;864 36;36 36");
  EXPECT_GE(shape_of({reversed(stair)}, 36).loops, 1U);
  EXPECT_GT(shape_of({reversed(stair)}, 36).area, 0);
  // Islands exactly as far apart as twice the distance.
  const Shape islands = shape_of({rectangle(0, 0, 100, 100), reversed(rectangle(20, 20, 40, 40)),
                                  reversed(rectangle(60, 30, 80, 80))},
                                 10);
  EXPECT_GT(islands.area, 0);
  const Shape narrow =
      shape_of({rectangle(0, 0, 20, 20), reversed(rectangle(15, 10, 17, 12))}, Rational(1, 2));
  EXPECT_EQ(narrow.loops, 2U);
  EXPECT_NEAR(narrow.area, 19 * 19 - (4 + 4 + kPi / 4), 1e-12);
}

TEST(ReferenceOffset, TangentChainKeepsOneLoop) {
  // A stadium: its offset is a stadium, without slivers at the tangent joints.
  const Chain stadium = polygon("0 0;10 0 1;10 6;0 6 1");
  for (const int d : {-3, -1, 1, 2}) {
    const auto loops = reference_offset({stadium}, d);
    ASSERT_EQ(loops.size(), 1U) << d;
    EXPECT_EQ(loops[0].pieces.size(), 4U) << d;
    EXPECT_NEAR(area(loops[0]), (3 - d) * (3 - d) * kPi + 20 * (3 - d), 1e-9);
  }
}

TEST(ReferenceOffset, ReversedLoopsAreTheOtherSide) {
  const Chain square = rectangle(0, 0, 10, 10);
  const auto hole = reference_offset({reversed(square)}, 1);
  ASSERT_EQ(hole.size(), 1U);
  EXPECT_NEAR(area(hole[0]), -(100 + 40 + kPi), 1e-12);
}

TEST(ReferenceOffset, LoopsThatTouchAtAPointAreParted) {
  // Two squares joined by a neck that the offset closes to a point.
  const Chain hourglass = polygon("0 0;10 0;6 5;10 10;0 10;4 5");
  const auto loops = reference_offset({hourglass}, 1);
  EXPECT_EQ(loops.size(), 2U);
}

}  // namespace
}  // namespace dgt
