// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "kernel/offset.h"
#include "tests/kernel/offset_families.h"

namespace dgt {
namespace {

struct Measure {
  double area = 0;
  double length = 0;
  std::size_t pieces = 0;
};

std::vector<Measure> measured(const std::vector<OffsetLoop>& loops) {
  std::vector<Measure> all;
  for (const OffsetLoop& loop : loops)
    all.push_back({area(loop), length(loop), loop.pieces.size()});
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.area < b.area; });
  return all;
}

/// Production and reference agree loop by loop.
testing::AssertionResult same_loops(const std::vector<Chain>& loops, const Rational& distance,
                                    OffsetCounts* counts = nullptr) {
  const auto fast = measured(production_offset(loops, distance, {}, counts));
  const auto slow = measured(reference_offset(loops, distance));
  if (fast.size() != slow.size())
    return testing::AssertionFailure() << fast.size() << " loops instead of " << slow.size();
  for (std::size_t i = 0; i < fast.size(); ++i) {
    const double scale = std::max(1.0, std::fabs(slow[i].area));
    if (std::fabs(fast[i].area - slow[i].area) > 1e-9 * scale ||
        std::fabs(fast[i].length - slow[i].length) > 1e-9 * std::max(1.0, slow[i].length))
      return testing::AssertionFailure()
             << "loop " << i << ": area " << fast[i].area << " length " << fast[i].length
             << " instead of " << slow[i].area << " " << slow[i].length;
  }
  return testing::AssertionSuccess();
}

TEST(ProductionOffset, RandomRingsGiveTheLoopsOfTheReference) {
  std::size_t by_reference = 0;
  std::size_t all = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const unsigned n = 10 + seed * 3;
    const auto ring = families::random_ring(n, seed);
    for (const char* d : {"0.05", "0.3", "1", "2.5", "-0.3", "-1", "-5", "20"}) {
      OffsetCounts counts;
      EXPECT_TRUE(same_loops(ring, *parse_decimal(d), &counts))
          << "n " << n << " seed " << seed << " distance " << d;
      by_reference += counts.exact > 0 ? 1 : 0;
      ++all;
    }
  }
  // Ordinary parts are settled by balls.
  EXPECT_EQ(by_reference, 0) << "of " << all;
}

TEST(ProductionOffset, SlotsGiveTheLoopsOfTheReference) {
  for (const char* d : {"0.9", "0.5", "-0.5", "-0.99", "1", "-1", "1.2", "-1.2"})
    EXPECT_TRUE(same_loops(families::slots(12), *parse_decimal(d))) << d;
}

TEST(ProductionOffset, GridPocketsExactlyAsWideAsTheToolGiveTheLoopsOfTheReference) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    for (const char* d : {"0.5", "1", "1.5", "0.499999999", "0.500000001", "-0.5", "-1", "-1.5"})
      EXPECT_TRUE(same_loops(families::grid_pocket(12, seed), *parse_decimal(d)))
          << "seed " << seed << " distance " << d;
  }
}

TEST(ProductionOffset, WavyPolylinesGiveTheLoopsOfTheReference) {
  for (const char* d : {"0.2", "1", "2", "-2", "-0.7"})
    EXPECT_TRUE(same_loops(families::wavy(300), *parse_decimal(d))) << d;
}

TEST(ProductionOffset, IslandsGiveTheLoopsOfTheReference) {
  std::vector<Chain> loops = families::random_ring(120, 7);
  for (const Chain& hole : families::random_ring(40, 3)) loops.push_back(reversed(hole));
  for (const char* d : {"0.5", "2", "5", "6.4", "-1", "-3", "-8"})
    EXPECT_TRUE(same_loops(loops, *parse_decimal(d))) << d;
}

/// Squares of a chessboard: each corner inside is one of two loops.
std::vector<Chain> chessboard(int side) {
  std::vector<Chain> loops;
  for (int x = 0; x < side; ++x) {
    for (int y = x % 2; y < side; y += 2) {
      std::vector<BulgeVertex> square;
      for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
        square.push_back({{Rational(4 * (x + dx)), Rational(4 * (y + dy))}, 0});
      loops.push_back(chain_of(square, true).value());
    }
  }
  return loops;
}

TEST(ProductionOffset, LoopsThatTouchInVerticesAreNoMatterForTheReference) {
  std::size_t fine = 0;
  for (const OffsetCorner corner :
       {OffsetCorner::Round, OffsetCorner::Sharp, OffsetCorner::Chamfer}) {
    for (const char* d : {"-2", "-1", "-0.3", "0.5", "2"}) {
      SCOPED_TRACE(d);
      OffsetCounts counts;
      const auto fast =
          measured(production_offset(chessboard(5), *parse_decimal(d), {corner}, &counts));
      EXPECT_EQ(counts.exact, 0);
      fine += counts.fine;
      const auto slow = measured(reference_offset(chessboard(5), *parse_decimal(d), {corner}));
      ASSERT_EQ(fast.size(), slow.size());
      for (std::size_t i = 0; i < fast.size(); ++i) {
        EXPECT_NEAR(fast[i].area, slow[i].area, 1e-12 * (1 + std::fabs(slow[i].area)));
        EXPECT_EQ(fast[i].pieces, slow[i].pieces);
      }
    }
  }
  EXPECT_GT(fine, 0);
}

TEST(ProductionOffset, PointsAreThoseOfTheReferenceToTheLastBit) {
  const auto ring = families::random_ring(60, 11);
  for (const OffsetLoop& loop : production_offset(ring, 1)) {
    for (const OffsetPiece& piece : loop.pieces) {
      const ExactPoint exact = piece.from.exact();
      EXPECT_EQ(piece.from.x(), nearest_double(exact.x));
      EXPECT_EQ(piece.from.y(), nearest_double(exact.y));
    }
  }
}

}  // namespace
}  // namespace dgt
