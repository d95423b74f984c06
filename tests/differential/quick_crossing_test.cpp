// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of the cascade against each other. Consistency: what plain doubles decide,
// double-doubles decide alike. Coverage: each kind of pair comes to each outcome.
#include "kernel/quick_crossing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/differential/contours.h"

namespace dgt {
namespace {

using differential::Family;

std::string kind_of(const RawStrand& a, const RawStrand& b) {
  return std::string(a.is_line ? "line" : "arc") + "-" + (b.is_line ? "line" : "arc");
}

struct Outcomes {
  std::map<std::string, std::map<std::string, int>> seen;
  int apart_at_once = 0;

  int open_in_double_doubles() {
    int count = 0;
    for (auto& [kind, found] : seen) count += found["open in double-doubles"];
    return count;
  }

  void take(const OffsetSource& source) {
    const RawCurve curve(source);
    for (std::size_t loop = 0; loop < source.loops(); ++loop) {
      for (std::uint32_t a = curve.begin(loop); a < curve.end(loop); ++a) {
        for (std::uint32_t b = a + 1; b < curve.end(loop); ++b)
          if (!curve.adjacent(a, b) && curve.box(a).overlaps(curve.box(b)))
            compare(source, curve, a, b);
      }
    }
  }

 private:
  void compare(const OffsetSource& source, const RawCurve& curve, std::uint32_t a,
               std::uint32_t b) {
    std::vector<quick::Passing> quick;
    const bool decided = quick::cross(curve, a, b, quick);
    const Crossings<DoubleDouble> fine =
        cross(source.decisive_strand(curve[a].key), source.decisive_strand(curve[b].key));
    const std::string kind = kind_of(curve[a], curve[b]);
    ++seen[kind][decided ? std::to_string(quick.size()) : "open"];
    if (!fine.decided) ++seen[kind]["open in double-doubles"];
    if (curve.surely_apart(a, b)) {
      ++apart_at_once;
      EXPECT_TRUE(!fine.decided || fine.count == 0);
      EXPECT_TRUE(!decided || quick.empty());
    }
    EXPECT_TRUE(decided || quick.empty());
    if (!decided || !fine.decided) return;
    ASSERT_EQ(static_cast<int>(quick.size()), fine.count) << kind;
    for (std::size_t i = 0; i < quick.size(); ++i) {
      EXPECT_EQ(quick[i].turn, fine.found[i].turn);
      for (const std::size_t side : {0U, 1U}) {
        const Enclosed<DoubleDouble>& position = fine.found[i].position[side];
        EXPECT_LE(std::fabs((position.mid - DoubleDouble(quick[i].along[side])).hi),
                  double{quick[i].along_rad[side]} + position.rad);
      }
    }
  }
};

constexpr std::array kMade = {Family::Star, Family::Grid, Family::Rounded, Family::Slots,
                              Family::Touching};

OffsetSource source_of(Family family, std::uint32_t seed) {
  const differential::Case c = differential::make(family, seed);
  return OffsetSource(c.chains(), abs(c.distance), sgn(c.distance) < 0);
}

TEST(QuickCrossing, DecidesAsDoubleDoublesDoAndComesToEachOutcome) {
  Outcomes outcomes;
  for (const Family family : kMade)
    for (std::uint32_t seed = 1; seed <= 60; ++seed) outcomes.take(source_of(family, seed));
  for (const char* kind : {"line-line", "line-arc", "arc-line", "arc-arc"}) {
    auto& seen = outcomes.seen[kind];
    for (const char* outcome : {"0", "1", "open"}) EXPECT_GT(seen[outcome], 0) << kind;
  }
  EXPECT_GT(outcomes.seen["arc-arc"]["2"], 0);
  EXPECT_GT(outcomes.apart_at_once, 0);
}

TEST(QuickCrossing, DoublesHoldForMovedVerticesToo) {
  Outcomes outcomes;
  for (const Family family : kMade)
    for (std::uint32_t seed = 1; seed <= 60; ++seed)
      outcomes.take(source_of(family, seed).parted());
  EXPECT_EQ(outcomes.open_in_double_doubles(), 0);
}

/// Lines are moved square to themselves and arcs about their own centres: as nearly as stand-ins of
/// normals do, far below what vertices are moved by.
TEST(QuickCrossing, EdgesMoveWithTheirVertices) {
  constexpr double kLastBits = 0x1p-92;
  int lines = 0;
  int arcs = 0;
  for (const Family family : kMade) {
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
      const OffsetSource source = source_of(family, seed).parted();
      const RawCurve curve(source);
      for (std::uint32_t i = 0; i + 1 < curve.size(); ++i) {
        // An edge between two corners: tangent joints shift its ends along it.
        const RawKey key = curve[i].key;
        if (curve[i].first || curve[i].last || key.part() != 0) continue;
        if (curve[i - 1].key.part() == 0 || curve[i + 1].key.part() == 0) continue;
        const Strand<DoubleDouble> edge = source.decisive_strand(key);
        const Strand<DoubleDouble> corner = source.decisive_strand(curve[i + 1].key);
        const auto way = corner.from - corner.centre;
        const auto off = edge.is_line ? dot(way, edge.to - edge.from)
                                      : dot(edge.to - edge.centre, edge.to - edge.centre) -
                                            edge.radius * edge.radius;
        const double size = 1 + edge.from.size() + edge.to.size() + edge.centre.size();
        EXPECT_LT(off.size() + off.rad, kLastBits * size * size);
        ++(edge.is_line ? lines : arcs);
      }
    }
  }
  EXPECT_GT(lines, 1000);
  EXPECT_GT(arcs, 100);
}

TEST(QuickCrossing, FamiliesMadeToBeDegenerateAreDecidedByDoubleDoubles) {
  for (const Family family : {Family::Grid, Family::Slots}) {
    Outcomes outcomes;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) outcomes.take(source_of(family, seed));
    EXPECT_EQ(outcomes.open_in_double_doubles(), 0);
  }
}

}  // namespace
}  // namespace dgt
