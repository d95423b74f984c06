// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/deviation.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/post/paths.h"

namespace dgt {
namespace {

using replay::Spot;
using replay::Step;

BallPoint point(double x, double y) { return {Ball(x, 0), Ball(y, 0)}; }

/// An arc given by angles in radians, and the same for the measuring side.
struct Sample {
  ArcBalls balls;
  Step step;
};

Sample arc(double cx, double cy, double r, double begin, double sweep, bool ccw) {
  const double sense = ccw ? 1 : -1;
  const double end = begin + sense * sweep;
  Sample s;
  s.step.kind = Step::Kind::Arc;
  s.step.from = {cx + r * std::cos(begin), cy + r * std::sin(begin)};
  s.step.to = {cx + r * std::cos(end), cy + r * std::sin(end)};
  s.step.centre = {cx, cy};
  s.step.radius = r;
  s.step.ccw = ccw;
  s.step.sweep = sweep;
  s.balls = {point(cx, cy),
             Ball(r, 0),
             point(s.step.from.x, s.step.from.y),
             point(s.step.to.x, s.step.to.y),
             ccw,
             sweep > std::acos(-1.0)};
  return s;
}

TEST(DeviationOfArc, OfEqualArcsIsNothing) {
  for (const double sweep : {0.3, 1.5, 3.0, 3.2, 5.0, 6.2}) {
    const Sample s = arc(3, 4, 50, 1, sweep, true);
    EXPECT_LT(deviation_of_arc(s.balls, 0, s.balls), 1e-12) << sweep;
    const Sample t = arc(3, 4, 50, 1, sweep, false);
    EXPECT_LT(deviation_of_arc(t.balls, 0, t.balls), 1e-12) << sweep;
  }
}

TEST(DeviationOfArc, OfALargerRadiusAboutTheSameCentreIsTheDifference) {
  const Sample a = arc(0, 0, 50, 0.4, 2, true);
  const Sample b = arc(0, 0, 50.5, 0.4, 2, true);
  const double d = deviation_of_arc(b.balls, 0, a.balls);
  EXPECT_GE(d, 0.5);
  EXPECT_LT(d, 0.51);
}

TEST(DeviationOfArc, TheComplementIsFar) {
  const double pi = std::acos(-1.0);
  const Sample small = arc(0, 0, 50, -1, 2, true);
  const Sample large = arc(100 * std::cos(1.0), 0, 50, pi + 1, 2 * pi - 2, true);
  EXPECT_GT(deviation_of_arc(large.balls, 0, small.balls), 50);
}

TEST(DeviationOfArc, TheBandIsAdded) {
  const Sample a = arc(0, 0, 50, 0.4, 2, true);
  EXPECT_GE(deviation_of_arc(a.balls, 0.25, a.balls), 0.25);
}

TEST(DeviationOfLine, IsTheLargerOfTheEnds) {
  EXPECT_NEAR(deviation_of_line({0, 0}, {10, 0}, point(0, 0.25), point(10, -0.5)), 0.5, 1e-12);
  EXPECT_GE(deviation_of_line({0, 0}, {10, 0}, point(0, 0.25), point(10, -0.5)), 0.5);
}

TEST(DeviationOfLine, ZeroLengthStandsForAMoveNotWritten) {
  EXPECT_NEAR(deviation_of_line({0, 0}, {0, 0}, point(-0.25, 0), point(0.5, 0)), 0.5, 1e-12);
}

TEST(DeviationOfChord, IsAtLeastTheSagitta) {
  const Sample a = arc(0, 0, 50, 0, 0.2, true);
  const double sagitta = 50 * (1 - std::cos(0.1));
  EXPECT_GE(sagitta_bound(a.balls), sagitta);
  EXPECT_LT(sagitta_bound(a.balls), sagitta * 1.0001);
}

/// Arcs that differ a little in everything: the bound is never below what dense samples measure,
/// and not idle. Degenerate cases among them: tiny arcs, half turns, nearly full turns, huge radii.
TEST(DeviationOfArc, IsNeverBelowTheMeasuredDistance) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int tight = 0;
  constexpr int kCases = 20000;
  for (int i = 0; i < kCases; ++i) {
    const double r = std::exp(uniform(0, 9));
    const double sweep = i % 4 == 0 ? uniform(2.9, 3.3) : uniform(0.02, 6.2);
    const double begin = uniform(-3, 3);
    const double size = std::exp(uniform(-5, 0));
    const bool ccw = i % 2 == 0;
    const Sample exact = arc(uniform(-9, 9), 2, r, begin, sweep, ccw);
    const Sample written = arc(exact.step.centre.x + uniform(-size, size), 2 + uniform(-size, size),
                               r + uniform(-size, size), begin + uniform(-size, size) / r,
                               std::max(1e-3, sweep + uniform(-size, size) / r), ccw);
    const double bound = deviation_of_arc(written.balls, 0, exact.balls);
    const double measured = testing::measured_distance({written.step}, {exact.step}, 60);
    ASSERT_GE(bound * (1 + 1e-9) + 1e-9, measured) << i << " r " << r << " sweep " << sweep;
    if (bound < 2.5 * measured + 1e-9) ++tight;
  }
  EXPECT_GT(tight, kCases * 9 / 10);
}

}  // namespace
}  // namespace dgt
