// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of equidistants, on the families of the differential runs. Loops are compared vertex by
// vertex and bit by bit: the engine knows no preferred place, direction or size.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <random>

#include "kernel/offset.h"
#include "tests/differential/contours.h"

namespace dgt::differential {
namespace {

struct Corner {
  double x, y, radius;
  auto operator<=>(const Corner&) const = default;
};
using Loops = std::vector<std::vector<Corner>>;

Loops in_order(Loops loops) {
  for (auto& loop : loops) std::ranges::rotate(loop, std::ranges::min_element(loop));
  std::ranges::sort(loops);
  return loops;
}

Loops corners(const std::vector<OffsetLoop>& found) {
  Loops loops;
  for (const OffsetLoop& loop : found) {
    auto& corners = loops.emplace_back();
    for (const OffsetPiece& p : loop.pieces)
      corners.push_back({p.from.x(), p.from.y(), p.is_line ? 0 : nearest_double(p.radius)});
  }
  return in_order(std::move(loops));
}

Loops offset(const std::vector<std::vector<BulgeVertex>>& loops, const Rational& distance) {
  std::vector<Chain> chains;
  for (const auto& loop : loops) chains.push_back(chain_of(loop, true).value());
  return corners(production_offset(chains, distance));
}

constexpr std::array kFamilies = {Family::Star, Family::Grid, Family::Slots, Family::Islands};
constexpr std::uint32_t kSeeds = 40;

using Families = std::vector<Family>;

void for_cases(const std::function<void(const Case&)>& check,
               const Families& families = {kFamilies.begin(), kFamilies.end()}) {
  for (const Family family : families) {
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      const Case c = make(family, seed);
      SCOPED_TRACE(c.to_text());
      check(c);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(OffsetLaws, WhereALoopBeginsChangesNothing) {
  for_cases([](const Case& c) {
    Case turned = c;
    for (auto& loop : turned.loops) std::ranges::rotate(loop, loop.begin() + 1 + loop.size() / 2);
    EXPECT_EQ(offset(c.loops, c.distance), offset(turned.loops, c.distance));
  });
}

TEST(OffsetLaws, AQuarterTurnTurnsTheResult) {
  for_cases([](const Case& c) {
    Case turned = c;
    for (auto& loop : turned.loops)
      for (BulgeVertex& v : loop) v.at = turned_left(v.at);
    Loops back = offset(turned.loops, c.distance);
    for (auto& loop : back)
      for (Corner& k : loop) k = {k.y, k.x == 0 ? 0 : -k.x, k.radius};
    EXPECT_EQ(offset(c.loops, c.distance), in_order(std::move(back)));
  });
}

/// But where there are contacts: what is in contact, and what is too small to keep, is told in
/// millimetres.
TEST(OffsetLaws, PowersOfTwoScaleTheResult) {
  const auto check = [](const Case& c) {
    for (const double scale : {8.0, 0.125, 1024.0}) {
      Case scaled = c;
      for (auto& loop : scaled.loops)
        for (BulgeVertex& v : loop) v.at = Rational(scale) * v.at;
      Loops back = offset(scaled.loops, c.distance * scale);
      for (auto& loop : back)
        for (Corner& k : loop) k = {k.x / scale, k.y / scale, k.radius / scale};
      EXPECT_EQ(offset(c.loops, c.distance), in_order(std::move(back))) << scale;
    }
  };
  for_cases(check, {Family::Star, Family::Islands});
}

/// Stand-ins of arcs begin at the other end then, and may differ in their last bits.
TEST(OffsetLaws, TheMirrorMirrorsTheResult) {
  for_cases([](const Case& c) {
    Case mirrored = c;
    for (std::size_t i = 0; i < c.loops.size(); ++i) {
      const auto& loop = c.loops[i];
      auto& image = mirrored.loops[i];
      image.clear();
      for (std::size_t k = loop.size(); k-- > 0;) {
        const RationalPoint& p = loop[(k + 1) % loop.size()].at;
        image.push_back({{Rational(-p.x), p.y}, loop[k].bulge});
      }
    }
    Loops there = offset(c.loops, c.distance);
    const Loops image = offset(mirrored.loops, c.distance);
    ASSERT_EQ(there.size(), image.size());
    // The vertices alone: a piece's radius stands at its other end.
    std::vector<std::pair<double, double>> one;
    std::vector<std::pair<double, double>> other;
    for (const auto& loop : there)
      for (const Corner& k : loop) one.emplace_back(k.x, k.y);
    for (const auto& loop : image)
      for (const Corner& k : loop) other.emplace_back(k.x == 0 ? 0 : -k.x, k.y);
    std::ranges::sort(one);
    std::ranges::sort(other);
    EXPECT_EQ(one, other);
  });
}

TEST(OffsetLaws, AreaFallsAsTheDistanceGrows) {
  for_cases([](const Case& c) {
    const std::vector<Chain> chains = c.chains();
    double before = std::numeric_limits<double>::infinity();
    for (const char* d : {"-3", "-1", "-0.25", "0.01", "0.3", "1", "1.7"}) {
      double sum = 0;
      for (const OffsetLoop& loop : production_offset(chains, *parse_decimal(d))) sum += area(loop);
      EXPECT_LE(sum, before) << d;
      before = sum;
    }
  });
}

/// Every vertex, exactly: where two pieces cross, a wrong choice shows first.
TEST(OffsetLaws, VerticesKeepTheDistance) {
  for_cases([](const Case& c) {
    const std::vector<Chain> chains = c.chains();
    const Rational least = abs(c.distance) - power_of_two(-60);
    for (const OffsetLoop& loop : production_offset(chains, c.distance)) {
      for (const OffsetPiece& p : loop.pieces) {
        const ExactPoint exact = p.from.exact();
        EXPECT_TRUE(keeps_distance(
            chains, {rational_within(exact.x, -100), rational_within(exact.y, -100)}, least));
      }
    }
  });
}

TEST(OffsetLaws, PolylinesInDoublesAreTheChainsTheyMean) {
  for_cases([](const Case& c) {
    std::vector<BulgePolyline> polylines;
    std::vector<Chain> chains;
    for (const auto& loop : c.loops) {
      BulgePolyline& polyline = polylines.emplace_back();
      std::vector<BulgeVertex> meant;
      for (const BulgeVertex& v : loop) {
        polyline.push_back({v.at.x.get_d(), v.at.y.get_d(), v.bulge.get_d()});
        const BulgePoint& p = polyline.back();
        meant.push_back({{Rational(p.x), Rational(p.y)}, Rational(p.bulge)});
      }
      chains.push_back(chain_of(meant, true).value());
    }
    EXPECT_EQ(corners(production_offset(polylines, c.distance).exact()),
              corners(production_offset(chains, c.distance)));
  });
}

/// Loops that cross themselves and each other, double back, repeat vertices: outside what the
/// engines promise anything of, but no reason to fall. Distances meet the radii of arcs exactly.
TEST(OffsetLaws, WhateverComesInLoopsComeOut) {
  std::mt19937 random(7);
  const auto below = [&random](int n) {
    return static_cast<int>(random() % static_cast<unsigned>(n));
  };
  const std::array bulges = {Rational(0),  Rational(0),      Rational(1),
                             Rational(-1), Rational(1, 2),   Rational(-1, 2),
                             Rational(3),  Rational(41, 99), power_of_two(-90)};
  const std::array distances = {Rational(0),    Rational(1), Rational(-1),
                                Rational(1, 2), Rational(3), power_of_two(-40)};
  for (int i = 0; i < 400; ++i) {
    std::vector<Chain> closed;
    for (int loop = below(3); loop >= 0; --loop) {
      std::vector<BulgeVertex> vertices;
      for (int n = 2 + below(7); n > 0; --n)
        vertices.push_back({{Rational(below(9) - 4), Rational(below(9) - 4)},
                            bulges[static_cast<std::size_t>(below(9))]});
      if (auto chain = chain_of(vertices, true)) closed.push_back(*std::move(chain));
    }
    const Rational& distance = distances[static_cast<std::size_t>(i) % distances.size()];
    for (const OffsetCorner corner :
         {OffsetCorner::Round, OffsetCorner::Sharp, OffsetCorner::Chamfer}) {
      for (const OffsetLoop& loop : production_offset(closed, distance, {corner})) {
        for (std::size_t k = 0; k < loop.pieces.size(); ++k)
          ASSERT_TRUE(loop.pieces[k].to == loop.pieces[(k + 1) % loop.pieces.size()].from) << i;
      }
    }
  }
}

}  // namespace
}  // namespace dgt::differential
