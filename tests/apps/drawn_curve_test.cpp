// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and arcs in doubles: nothing trembles, and chains keep to their arcs.
#include "apps/driver/drawn_curve.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/moves.h"

namespace dgt {
namespace {

using support::at;

constexpr double kPi = std::numbers::pi;
constexpr double kUlp = std::numeric_limits<double>::epsilon();

Box around(DrawnPlace p, double reach) {
  return {p.x - reach, p.y - reach, p.x + reach, p.y + reach};
}

TEST(DrawnCurve, TellsTheTwoArcsBetweenTwoPointsApart) {
  const DrawnCurve quarter = drawn(support::arc({0, 0}, 5, at(5, 0), at(0, 5)));
  const DrawnCurve rest = drawn(support::arc({0, 0}, -5, at(5, 0), at(0, 5)));
  const DrawnCurve half = drawn(support::arc({0, 0}, 5, at(5, 0), at(-5, 0)));
  const DrawnCurve whole = drawn(support::full_circle({0, 0}, -5, at(5, 0)));
  EXPECT_DOUBLE_EQ(quarter.sweep, kPi / 2);
  EXPECT_DOUBLE_EQ(rest.sweep, -3 * kPi / 2);
  EXPECT_DOUBLE_EQ(half.sweep, kPi);
  EXPECT_DOUBLE_EQ(whole.sweep, -2 * kPi);
  EXPECT_DOUBLE_EQ(whole.length(), 10 * kPi);
}

TEST(DrawnCurve, APlaceOnAnArcWhoseCentreIsFarAwayDoesNotTremble) {
  // A chord of 1 mm on a circle of a thousand kilometres; doubles there are 10⁻⁷ mm apart.
  const Rational far(1'000'000'000);
  const Rational rise = far - sqrt_within(far * far - Rational(1, 4), -120);
  const Move move = support::arc({Rational(1, 2), rise - far}, -far, at(0, 0), at(1, 0));
  const DrawnCurve arc = drawn(move);
  EXPECT_NEAR(arc.length(), 1, 1e-14);
  const DrawnPlace middle = place_at(arc, 0.5);
  EXPECT_NEAR(middle.x, 0.5, 1e-15);
  EXPECT_NEAR(middle.y, 1.25e-10, 1e-16) << "a 125 millionth of a micrometre above the chord";
  const DrawnPlace just_before = place_at(arc, std::nextafter(1.0, 0.0));
  EXPECT_NEAR(just_before.x, 1, 1e-14) << "it ends where the next move begins";
}

TEST(DrawnCurve, NearestPlacesAreFeetAndEnds) {
  const DrawnCurve line = drawn(support::line(at(0, 0), at(10, 0)));
  EXPECT_EQ(nearest_place(line, {3, 4}).at, (DrawnPlace{3, 0}));
  EXPECT_EQ(nearest_place(line, {-3, 4}).distance, 5);
  const DrawnCurve arc = drawn(support::arc({0, 0}, 5, at(5, 0), at(0, 5)));
  EXPECT_NEAR(nearest_place(arc, {6, 8}).distance, 5, 1e-14);
  EXPECT_EQ(nearest_place(arc, {-1, -9}).at, (DrawnPlace{5, 0}));
  EXPECT_EQ(nearest_place(arc, {-9, -1}).at, (DrawnPlace{0, 5}));
  const DrawnCurve point = drawn(support::line(at(1, 1), at(1, 1)));
  EXPECT_EQ(nearest_place(point, {4, 5}).distance, 5) << "a move of no length";
}

TEST(DrawnCurve, ABeginningEndsOnTheCurve) {
  const DrawnCurve arc = drawn(support::arc({0, 0}, 5, at(5, 0), at(-5, 0)));
  const DrawnCurve half = beginning_of(arc, 0.5);
  EXPECT_NEAR(half.to.y, 5, 1e-14);
  EXPECT_DOUBLE_EQ(half.sweep, kPi / 2);
  EXPECT_EQ(beginning_of(arc, 1).to, arc.to);
}

TEST(Flatten, ALineIsOneStroke) {
  std::vector<DrawnPlace> corners;
  flatten(drawn(support::line(at(0, 0), at(7, 8))), around({0, 0}, 1), 0.1, corners);
  EXPECT_THAT(corners, testing::ElementsAre(DrawnPlace{7, 8}));
}

TEST(Flatten, AMillionFoldZoomTakesFewStrokes) {
  const DrawnCurve circle = drawn(support::full_circle({0, 0}, 50, at(50, 0)));
  const double pixel = 1e-7;
  std::vector<DrawnPlace> corners;
  flatten(circle, around({0, 50}, 500 * pixel), pixel / 4, corners);
  EXPECT_LE(corners.size(), 120U);
}

double any(double low, double high) {
  const int steps = *rc::gen::inRange(0, 1'000'001);
  return low + (high - low) * steps / 1e6;
}
/// 10^low … 10^high
double any_size(double low, double high) { return std::pow(10, any(low, high)); }

DrawnCurve any_arc() {
  DrawnCurve arc;
  arc.radius = any_size(-3, 9);
  const double begin = any(-kPi, kPi);
  arc.sweep = any(-2 * kPi, 2 * kPi);
  arc.from = {any(-1000, 1000), any(-1000, 1000)};
  arc.centre = arc.from - arc.radius * DrawnPlace{std::cos(begin), std::sin(begin)};
  const double end = begin + arc.sweep;
  arc.to = arc.centre + arc.radius * DrawnPlace{std::cos(end), std::sin(end)};
  return arc;
}

/// How far an arc of at most half a turn bulges beyond its chord; exact but for rounding.
double rise(double chord, double radius) {
  const double half = chord / 2;
  const double inner = std::sqrt(std::max(0.0, (radius - half) * (radius + half)));
  return half * half / (radius + inner);
}

// Each stroke joins two places of the circle. Between them the arc is nowhere further from the
// stroke than it rises above it, which is either within the tolerance, or it lies, as the arc does,
// in a box around both that misses the window.
RC_GTEST_PROP(Flatten, KeepsWithinTheToleranceWhereTheWindowShowsIt, ()) {
  const DrawnCurve arc = any_arc();
  const double size = any_size(-6, 4);
  const DrawnPlace middle = place_at(arc, any(0, 1));
  const Box window = around({middle.x + any(-size, size), middle.y + any(-size, size)}, size);
  const double tolerance = size / any_size(1, 3.5);
  std::vector<DrawnPlace> corners;
  flatten(arc, window, tolerance, corners);
  RC_ASSERT(corners.back() == arc.to);
  // Ends and centre of this arc are themselves rounded, by some ulps of the largest of them.
  const double noise =
      32 * kUlp * (arc.radius + std::max(std::fabs(arc.centre.x), std::fabs(arc.centre.y)) + 2000);
  DrawnPlace from = arc.from;
  for (const DrawnPlace& to : corners) {
    RC_ASSERT(std::fabs(distance(to, arc.centre) - arc.radius) <= noise);
    const double chord = distance(from, to);
    RC_ASSERT(chord <= 2 * arc.radius + noise);
    const double up = rise(std::min(chord, 2 * arc.radius), arc.radius);
    Box box = around(from, up + noise);
    box.add(to.x - up - noise, to.y - up - noise);
    box.add(to.x + up + noise, to.y + up + noise);
    const Box outside{window.left + 2 * noise, window.bottom + 2 * noise, window.right - 2 * noise,
                      window.top - 2 * noise};
    const bool is_seen =
        outside.left < outside.right && outside.bottom < outside.top && overlap(box, outside);
    if (is_seen) RC_ASSERT(up <= tolerance + noise);
    from = to;
  }
  RC_CLASSIFY(corners.size() > 4, "several strokes");
}

RC_GTEST_PROP(NearestPlace, IsNoFurtherThanTheEnds, ()) {
  const DrawnCurve arc = any_arc();
  const DrawnPlace pointer{any(-2000, 2000), any(-2000, 2000)};
  const NearestPlace nearest = nearest_place(arc, pointer);
  const double far = std::min(distance(arc.from, pointer), distance(arc.to, pointer));
  RC_ASSERT(nearest.part >= 0);
  RC_ASSERT(nearest.part <= 1);
  RC_ASSERT(nearest.distance <= far + 32 * kUlp * (far + arc.radius));
}

RC_GTEST_PROP(BoxAround, HoldsTheCurve, ()) {
  const DrawnCurve arc = any_arc();
  const Box box = box_around(arc);
  const DrawnPlace p = place_at(arc, any(0, 1));
  const double noise = 32 * kUlp * (arc.radius + 4000);
  RC_ASSERT(p.x >= box.left - noise);
  RC_ASSERT(p.x <= box.right + noise);
  RC_ASSERT(p.y >= box.bottom - noise);
  RC_ASSERT(p.y <= box.top + noise);
}

}  // namespace
}  // namespace dgt
