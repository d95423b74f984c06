// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/three_b.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "tests/post/paths.h"

namespace dgt {
namespace {

using testing::PathBuilder;

const Dialect& three_b() { return *find_dialect("3b"); }
std::string text(const PathBuilder& p) { return write(p.path(), three_b()).text; }

WrittenArc arc(GridPoint from, GridPoint to, bool ccw) {
  WrittenArc a;
  a.from = from;
  a.to = to;
  a.ccw = ccw;
  return a;
}
std::string shown(const std::optional<CountedArc>& a) {
  if (!a) return "none";
  return std::to_string(a->x) + " " + std::to_string(a->y) + " " + std::to_string(a->count) +
         (a->axis == CountedAxis::X ? " X " : " Y ") + std::to_string(a->quadrant);
}

TEST(ThreeBText, LinesInEveryDirection) {
  PathBuilder p;
  p.line("17", "5");                                                    // the line of the textbooks
  p.line("27", "5").line("27", "15").line("17", "15").line("17", "5");  // along the axes
  p.line("14", "12").line("12", "9").line("15", "2");
  EXPECT_EQ(text(p),
            "B17000B5000B17000GXL1\n"
            "B10000B0B10000GXL1\nB0B10000B10000GYL2\nB10000B0B10000GXL3\nB0B10000B10000GYL4\n"
            "B3000B7000B7000GYL2\nB2000B3000B3000GYL3\nB3000B7000B7000GYL4\nDD\n");
}

TEST(ThreeBText, LinesAtHalfARightAngle) {
  PathBuilder p;
  p.line("1", "1").line("0", "2").line("-1", "1").line("0", "0");
  EXPECT_EQ(text(p),
            "B1000B1000B1000GYL1\nB1000B1000B1000GXL2\nB1000B1000B1000GYL3\nB1000B1000B1000GXL4\n"
            "DD\n");
}

TEST(ThreeBText, QuarterTurnsBeginInTheQuadrantTheyRunInto) {
  PathBuilder left;
  left.arc({-5, 5}, {-5, 0}, true).arc({-10, 0}, {-5, 0}, true);
  left.arc({-5, -5}, {-5, 0}, true).arc({0, 0}, {-5, 0}, true);
  EXPECT_EQ(text(left),
            "B5000B0B5000GXNR1\nB0B5000B5000GYNR2\nB5000B0B5000GXNR3\nB0B5000B5000GYNR4\nDD\n");
  PathBuilder right;
  right.arc({-5, -5}, {-5, 0}, false).arc({-10, 0}, {-5, 0}, false);
  right.arc({-5, 5}, {-5, 0}, false).arc({0, 0}, {-5, 0}, false);
  EXPECT_EQ(text(right),
            "B5000B0B5000GXSR4\nB0B5000B5000GYSR3\nB5000B0B5000GXSR2\nB0B5000B5000GYSR1\nDD\n");
}

TEST(ThreeBText, ACircleIsTwoHalfTurnsThatCountBothWays) {
  PathBuilder p;
  p.arc({0, 0}, {-5, 0}, true);
  EXPECT_EQ(text(p), "B5000B0B10000GYNR1\nB5000B0B10000GYNR3\nDD\n");
}

TEST(ThreeBText, RapidsTakeTheWireOut) {
  PathBuilder p;
  p.line("1", "0").rapid("1", "2").rapid("3", "2").code("M0").line("4", "2");
  EXPECT_EQ(text(p),
            "B1000B0B1000GXL1\nD\nB0B2000B2000GYL2\nB2000B0B2000GXL1\nD\nD\nD\nB1000B0B1000GXL1\n"
            "DD\n");
}

TEST(CountedArcs, OfTheTextbooks) {
  EXPECT_EQ(shown(counted_arc(arc({-2000, 9000}, {9000, -2000}, true))), "2000 9000 25440 Y 2");
  EXPECT_EQ(shown(counted_arc(arc({9000, -2000}, {-2000, 9000}, false))), "9000 2000 25440 X 4");
}

TEST(CountedArcs, EndsAtHalfARightAngle) {
  // √50 rounds to 7 and ⌈√49⌉ is 7.
  EXPECT_EQ(shown(counted_arc(arc({7, 1}, {5, 5}, true))), "7 1 2 X 1");
  EXPECT_EQ(shown(counted_arc(arc({-1, 7}, {-5, 5}, true))), "1 7 2 Y 2");
}

TEST(CountedArcs, AreNoneWhereControlsTurnAtDifferentSteps) {
  // √(100² + 15²) = 101.12: some turn at 101, some at 102. X is not counted at the other end.
  EXPECT_FALSE(counted_arc(arc({100, -15}, {15, 100}, true)));
  EXPECT_TRUE(counted_arc(arc({100, 15}, {15, 100}, true)));
}

TEST(CountedArcs, AreNoneWhereTheCircleMissesTheEnd) {
  EXPECT_TRUE(counted_arc(arc({100, 0}, {0, 100}, true)));
  EXPECT_FALSE(counted_arc(arc({100, 0}, {0, 101}, true)));
}

/// A control as they were built first: step by step, by the sign of x² + y² − r².
GridPoint stepped(const CountedArc& a, bool ccw) {
  int q = a.quadrant;
  std::int64_t x = a.x;
  std::int64_t y = a.y;  // in the quadrant, both positive
  std::int64_t f = 0;
  for (std::int64_t left = a.count; left > 0;) {
    // Which of the two falls towards its axis in this quadrant.
    const bool x_falls = (q % 2 == 1) == ccw;
    std::int64_t& falling = x_falls ? x : y;
    std::int64_t& rising = x_falls ? y : x;
    if (falling == 0) {
      q = ccw ? q % 4 + 1 : (q + 2) % 4 + 1;
      continue;
    }
    const bool falls = f >= 0;
    if (falls) {
      f += 1 - 2 * falling;
      --falling;
    } else {
      f += 1 + 2 * rising;
      ++rising;
    }
    if ((falls == x_falls) == (a.axis == CountedAxis::X)) --left;
  }
  return {q == 1 || q == 4 ? x : -x, q <= 2 ? y : -y};
}

TEST(CountedArcs, EndWhereAControlThatStepsEnds) {
  std::mt19937 random(7);
  int counted = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto whole = [&](int least, int most) {
      return std::int64_t{std::uniform_int_distribution<int>(least, most)(random)};
    };
    const int size = i % 3 == 0 ? 40 : 900;
    const GridPoint from{whole(-size, size), whole(-size, size)};
    // Of a few steps a circle is no circle; Dialect::least_radius keeps them away.
    const double r = std::hypot(static_cast<double>(from.x), static_cast<double>(from.y));
    if (r < 10) continue;
    const double angle = std::uniform_real_distribution<double>(0, 6.3)(random);
    const GridPoint to{std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))};
    const bool ccw = i % 2 == 0;
    const auto a = counted_arc(arc(from, to, ccw));
    if (!a) continue;
    ++counted;
    const GridPoint end = stepped(*a, ccw);
    const bool along_x = a->axis == CountedAxis::X;
    EXPECT_EQ(along_x ? end.x : end.y, along_x ? to.x : to.y)
        << from.x << " " << from.y << " " << to.x << " " << to.y << " " << ccw;
    EXPECT_LE(std::llabs(along_x ? end.y - to.y : end.x - to.x), 1);
  }
  EXPECT_GT(counted, 60000);
}

TEST(ThreeB, WhatItCannotSayIsRefusedAtItsMove) {
  PathBuilder p;
  p.line("1", "0").dwell("2").line("2000", "0").height("1");
  const WriteResult r = write(p.path(), three_b());
  ASSERT_EQ(r.faults.size(), 2u);
  EXPECT_EQ(r.faults[0].kind, WriteFault::Kind::DwellImpossible);
  EXPECT_EQ(r.faults[1].kind, WriteFault::Kind::HeightImpossible);
  EXPECT_TRUE(r.text.empty());
  const WriteResult far = write(PathBuilder().line("1", "0").line("1001", "0").path(), three_b());
  ASSERT_EQ(far.faults.size(), 1u);
  EXPECT_EQ(far.faults[0].kind, WriteFault::Kind::BeyondLargest);
  EXPECT_EQ(far.faults[0].move, 1u);
  EXPECT_EQ(far.faults[0].place.line, 2u);
}

}  // namespace
}  // namespace dgt
