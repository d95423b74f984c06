// SPDX-License-Identifier: GPL-3.0-or-later
//
// The library proves its bound; here it is measured, at places of the curve and of the arcs.
#include "kernel/curve_fit.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace dgt {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

struct Place {
  double x = 0;
  double y = 0;
};

Place at(const RationalCurve& curve, double t) {
  std::vector<std::array<double, 3>> p;
  for (const BezierPoint& c : curve)
    p.push_back({nearest_double(c.x), nearest_double(c.y), nearest_double(c.w)});
  for (std::size_t n = p.size(); n > 1; --n) {
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t k = 0; k < 3; ++k) p[i][k] += t * (p[i + 1][k] - p[i][k]);
  }
  return {p[0][0] / p[0][2], p[0][1] / p[0][2]};
}

/// Places of an edge, from its beginning to its end.
std::vector<Place> places(const ChainEdge& edge, int count) {
  std::vector<Place> found;
  const double fx = nearest_double(edge.from.x);
  const double fy = nearest_double(edge.from.y);
  const double tx = nearest_double(edge.to.x);
  const double ty = nearest_double(edge.to.y);
  const double r = nearest_double(edge.radius);
  const RationalPoint c = edge.is_line() ? edge.from : edge.centre();
  const double cx = nearest_double(c.x);
  const double cy = nearest_double(c.y);
  const double begin = std::atan2(fy - cy, fx - cx);
  double sweep = std::atan2(ty - cy, tx - cx) - begin;
  if (r > 0 && sweep < 0) sweep += 2 * std::acos(-1.0);
  if (r < 0 && sweep > 0) sweep -= 2 * std::acos(-1.0);
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    if (edge.is_line()) {
      found.push_back({fx + t * (tx - fx), fy + t * (ty - fy)});
    } else {
      const double angle = begin + t * sweep;
      found.push_back({cx + std::fabs(r) * std::cos(angle), cy + std::fabs(r) * std::sin(angle)});
    }
  }
  return found;
}

/// The largest distance of a place of `a` from the polyline `b`.
double beside(const std::vector<Place>& a, const std::vector<Place>& b) {
  double most = 0;
  for (const Place& p : a) {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < b.size(); ++i) {
      const double dx = b[i + 1].x - b[i].x;
      const double dy = b[i + 1].y - b[i].y;
      const double square = dx * dx + dy * dy;
      const double t =
          square == 0 ? 0
                      : std::clamp(((p.x - b[i].x) * dx + (p.y - b[i].y) * dy) / square, 0.0, 1.0);
      least = std::min(least, std::hypot(b[i].x + t * dx - p.x, b[i].y + t * dy - p.y));
    }
    most = std::max(most, least);
  }
  return most;
}

std::vector<ChainEdge> fitted(const std::vector<RationalCurve>& pieces, const Rational& tolerance) {
  auto edges = arcs_along(pieces, tolerance, 10'000);
  EXPECT_TRUE(edges.has_value());
  return edges ? *std::move(edges) : std::vector<ChainEdge>();
}

/// How far the two are apart, either way, but for the chords that stand for them here.
double distance_between(const RationalCurve& curve, const std::vector<ChainEdge>& edges) {
  std::vector<Place> on_curve;
  constexpr int kPlaces = 2000;
  for (int i = 0; i <= kPlaces; ++i)
    on_curve.push_back(at(curve, static_cast<double>(i) / kPlaces));
  std::vector<Place> on_edges;
  for (const ChainEdge& edge : edges) {
    const std::vector<Place> more = places(edge, 30);
    on_edges.insert(on_edges.end(), more.begin(), more.end());
  }
  return std::max(beside(on_curve, on_edges), beside(on_edges, on_curve));
}

RationalCurve random_curve(unsigned seed, std::size_t points, bool weighted) {
  std::mt19937 random(seed);
  RationalCurve curve;
  for (std::size_t i = 0; i < points; ++i) {
    const Rational w = weighted ? Rational(static_cast<long>(random() % 40 + 4), 10) : Rational(1);
    const Rational x(static_cast<long>(random() % 100'000), 1000);
    const Rational y(static_cast<long>(random() % 100'000), 1000);
    curve.push_back({x * w, y * w, w});
    for (Rational* value : {&curve.back().x, &curve.back().y, &curve.back().w})
      value->canonicalize();
  }
  return curve;
}

TEST(CurveFit, EveryPlaceOfEitherLiesWithinTheToleranceOfTheOther) {
  constexpr double kTolerance = 0.02;  // far above what the chords here leave
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const RationalCurve curve = random_curve(seed, 3 + seed % 4, seed % 2 == 0);
    const auto edges = fitted({curve}, Rational(1, 50));
    EXPECT_LE(distance_between(curve, edges), kTolerance) << "seed " << seed;
  }
}

TEST(CurveFit, EdgesFollowEachOtherWithOneTangentExactly) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const RationalCurve curve = random_curve(seed, 4, false);
    const auto edges = fitted({curve}, Rational(1, 1000));
    ASSERT_FALSE(edges.empty());
    EXPECT_EQ(edges.front().from, (RationalPoint{curve.front().x, curve.front().y}));
    EXPECT_EQ(edges.back().to, (RationalPoint{curve.back().x, curve.back().y}));
    std::size_t smooth = 0;
    for (std::size_t i = 1; i < edges.size(); ++i) {
      EXPECT_EQ(edges[i - 1].to, edges[i].from);
      if (!edges[i - 1].is_line() && !edges[i].is_line()) {
        EXPECT_EQ(edges[i - 1].end, edges[i].start) << "seed " << seed << ", joint " << i;
        ++smooth;
      }
    }
    EXPECT_GT(smooth, 0U);
  }
}

TEST(CurveFit, ArcsKeepTheirEquations) {
  for (const ChainEdge& edge : fitted({random_curve(7, 5, true)}, Rational(1, 1000))) {
    if (edge.is_line()) continue;
    EXPECT_EQ(edge.centre(), edge.to + edge.radius * edge.end.vector());
  }
}

TEST(CurveFit, ACurveOfNoSizeHasNoEdges) {
  EXPECT_THAT(fitted({{{1, 2, 1}, {1, 2, 1}, {2, 4, 2}}}, Rational(1, 1000)), IsEmpty());
}

TEST(CurveFit, AStraightCurveIsOneSegmentHoweverItIsParametrized) {
  const auto edges = fitted({{{0, 0, 1}, {1, 1, 1}, {1, 1, 1}, {9, 9, 1}}}, Rational(1, 1000));
  ASSERT_THAT(edges, SizeIs(1));
  EXPECT_TRUE(edges[0].is_line());
}

TEST(CurveFit, ACurveThatComesBackToItsBeginningIsALoop) {
  const RationalCurve loop{{0, 0, 1}, {30, 0, 1}, {0, 30, 1}, {0, 0, 1}};
  const auto edges = fitted({loop}, Rational(1, 100));
  EXPECT_GT(edges.size(), 2U);
  EXPECT_EQ(edges.front().from, edges.back().to);
  EXPECT_LE(distance_between(loop, edges), 0.011);
}

TEST(CurveFit, ControlPointsThatCoincideAtAnEndAreNoHindrance) {
  const RationalCurve curve{{0, 0, 1}, {0, 0, 1}, {20, 0, 1}, {20, 20, 1}};
  EXPECT_LE(distance_between(curve, fitted({curve}, Rational(1, 100))), 0.01);
}

TEST(CurveFit, MoreEdgesThanAreWantedAreNone) {
  EXPECT_FALSE(arcs_along({random_curve(3, 6, false)}, Rational(1, 1'000'000), 5).has_value());
}

TEST(CurveFit, AFinerToleranceTakesAsManyArcsAsTheOrderOfBiarcsSays) {
  const RationalCurve curve{{0, 0, 1}, {40, 0, 1}, {60, 30, 1}};
  const auto coarse = fitted({curve}, Rational(1, 1000)).size();
  const auto fine = fitted({curve}, Rational(1, 1'000'000)).size();
  EXPECT_GT(fine, 4 * coarse);   // third order: ten times as many
  EXPECT_LT(fine, 24 * coarse);  // halving may double it
}

}  // namespace
}  // namespace dgt
