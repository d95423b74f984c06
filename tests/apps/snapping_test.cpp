// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring: what a person means when pointing near it.
#include "apps/driver/snapping.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/moves.h"

namespace dgt {
namespace {

using support::at;

/// A line of 10 mm along X and a circle of radius 3 about (20, 0), from its rightmost point.
class Snapping : public testing::Test {
 protected:
  Snapping() {
    layer_.add(support::line(at(0, 0), at(10, 0)), 0);
    layer_.add(support::full_circle({20, 0}, 3, at(23, 0)), 1);
    layer_.index();
  }
  Snap point(DrawnPlace pointer, std::optional<DrawnPlace> from = {}) const {
    return snap({&layer_}, pointer, 0.5, from);
  }

  DrawnLayer layer_;
};

TEST_F(Snapping, FindsEndsMiddlesAndCentres) {
  EXPECT_EQ(point({0.1, 0.2}).kind, SnapKind::End);
  EXPECT_EQ(point({0.1, 0.2}).at, (DrawnPlace{0, 0}));
  EXPECT_EQ(point({5.2, -0.1}).kind, SnapKind::Middle);
  EXPECT_EQ(point({5.2, -0.1}).at, (DrawnPlace{5, 0}));
  const Snap centre = point({20.3, 0.2});
  EXPECT_EQ(centre.kind, SnapKind::Centre) << "far from the circle itself";
  EXPECT_EQ(centre.at, (DrawnPlace{20, 0}));
  EXPECT_EQ(centre.curve->radius, 3);
}

TEST_F(Snapping, FindsTheNearestPlaceWhereThereIsNothingBetter) {
  const Snap on_line = point({7, 0.3});
  EXPECT_EQ(on_line.kind, SnapKind::OnMove);
  EXPECT_EQ(on_line.at, (DrawnPlace{7, 0}));
  const Snap free = point({7, 3});
  EXPECT_EQ(free.kind, SnapKind::Free);
  EXPECT_EQ(free.at, (DrawnPlace{7, 3}));
  EXPECT_FALSE(free.curve);
}

TEST_F(Snapping, TangentsTouchTheCircle) {
  // From (15, 0), 5 mm from the centre: the right triangle 3-4-5.
  const DrawnPlace from{15, 0};
  const DrawnPlace touch{20 - 9.0 / 5, 12.0 / 5};
  const Snap tangent = point({touch.x + 0.1, touch.y}, from);
  EXPECT_EQ(tangent.kind, SnapKind::Tangent);
  EXPECT_NEAR(tangent.at.x, touch.x, 1e-14);
  EXPECT_NEAR(tangent.at.y, touch.y, 1e-14);
  EXPECT_NEAR(measured(from, tangent.at).distance, 4, 1e-14);
  EXPECT_TRUE(tangent_places(layer_[1], {21, 0}).empty()) << "from inside";
}

TEST_F(Snapping, TangentsOfAnArcLieOnIt) {
  const DrawnCurve quarter = drawn(support::arc({0, 0}, 3, at(3, 0), at(0, 3)));
  EXPECT_EQ(tangent_places(quarter, {5, 0}).size(), 1U);
  EXPECT_TRUE(tangent_places(quarter, {-5, -1}).empty());
}

TEST_F(Snapping, PerpendicularsMeetLinesAndCirclesAtRightAngles) {
  const Snap foot = point({3.1, 0.2}, DrawnPlace{3, 8});
  EXPECT_EQ(foot.kind, SnapKind::Perpendicular);
  EXPECT_EQ(foot.at, (DrawnPlace{3, 0}));
  const auto feet = perpendicular_places(layer_[1], {20, 8});
  ASSERT_EQ(feet.size(), 2U);
  EXPECT_NEAR(feet[0].y, 3, 1e-14);
  EXPECT_NEAR(feet[1].y, -3, 1e-14) << "the far side";
}

TEST(Measured, TellsDistanceWaysAndAngle) {
  const Measurement m = measured({1, 1}, {4, 5});
  EXPECT_EQ(m.distance, 5);
  EXPECT_EQ(m.dx, 3);
  EXPECT_EQ(m.dy, 4);
  EXPECT_NEAR(m.degrees, 53.13010235415598, 1e-12);
  EXPECT_EQ(measured({0, 0}, {-1, -0.0}).degrees, 180);
  EXPECT_EQ(measured({0, 0}, {0, 0}).degrees, 0) << "the same place twice";
}

}  // namespace
}  // namespace dgt
