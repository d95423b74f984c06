// SPDX-License-Identifier: GPL-3.0-or-later
// Tool paths as they are shown: steps, layers, the tool on its way.
#include "apps/driver/drawn_path.h"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/moves.h"

namespace dgt {
namespace {

using support::at;
using testing::ElementsAre;

constexpr double kPi = std::numbers::pi;

DrawnPath drawn_path(const Toolpath& path) { return DrawnPath::of(path, {}).value(); }

Move asked_for(Move move, std::uint32_t line) {
  move.source = {0, line, 1};
  return move;
}

Move code(const char* word) {
  Move move;
  move.kind = MoveKind::Code;
  move.code = word;
  return move;
}

/// A rapid of 10 mm, a code, a line of 20 mm, half a circle of radius 1.
Toolpath sample() {
  Toolpath path;
  path.files = {"part.bgt"};
  path.moves.push_back(asked_for(support::rapid(at(0, 0), at(10, 0)), 3));
  path.moves.push_back(code("M7"));
  path.moves.push_back(asked_for(support::line(at(10, 0), at(30, 0)), 4));
  path.moves.push_back(asked_for(support::arc({30, 1}, 1, at(30, 0), at(30, 2)), 4));
  Contour contour;
  contour.offset = Rational(-1, 4);
  contour.first = 2;
  contour.last = 4;
  contour.programmed = std::vector{asked_for(support::line(at(10, 1), at(30, 1)), 4)};
  path.contours.push_back(contour);
  return path;
}

TEST(DrawnPath, StepsAreTheMovesThatTravel) {
  const DrawnPath path = drawn_path(sample());
  EXPECT_EQ(path.steps(), 3U);
  EXPECT_TRUE(path.is_rapid(0));
  EXPECT_EQ(path.move(1), 2U);
  EXPECT_EQ(path.source(2).line, 4U);
  EXPECT_EQ(path.step_of(2), 1U);
  EXPECT_EQ(path.step_of(1), 1U) << "a code: the next move that travels";
}

TEST(DrawnPath, TheToolRunsAlongTheArcAtTheSpeedOfTheLine) {
  const DrawnPath path = drawn_path(sample());
  EXPECT_DOUBLE_EQ(path.travel(), 30 + kPi);
  const ToolPlace on_line = path.tool_after(15);
  EXPECT_EQ(on_line, (ToolPlace{1, 0.25}));
  EXPECT_EQ(path.place(on_line), (DrawnPlace{15, 0}));
  const DrawnPlace on_arc = path.place(path.tool_after(30 + kPi / 2));
  EXPECT_NEAR(on_arc.x, 31, 1e-14);
  EXPECT_NEAR(on_arc.y, 1, 1e-14);
  EXPECT_EQ(path.tool_after(1e9), (ToolPlace{3, 0}));
  EXPECT_EQ(path.place({3, 0}), (DrawnPlace{30, 2}));
  for (const double way : {0.0, 3.5, 10.0, 29.0, 31.0}) {
    EXPECT_NEAR(path.travelled(path.tool_after(way)), way, 1e-12);
  }
}

TEST(DrawnPath, TheKerfIsThatOfTheContourInHandOrBefore) {
  Toolpath path = sample();
  path.moves.push_back(support::rapid(at(30, 2), at(50, 2)));
  const DrawnPath drawn = drawn_path(path);
  EXPECT_EQ(drawn.kerf_radius(std::uint32_t{0}), 0.25);
  EXPECT_EQ(drawn.kerf_radius(ToolPlace{2, 0.5}), 0.25);
  EXPECT_EQ(drawn.kerf_radius(ToolPlace{4, 0}), 0.25);
  EXPECT_EQ(drawn_path(Toolpath{}).kerf_radius(ToolPlace{}), 0);
}

TEST(DrawnPath, MovesAreFoundByTheirLine) {
  const DrawnPath path = drawn_path(sample());
  EXPECT_THAT(path.cuts().of_line(0, 4), ElementsAre(0, 1));
  EXPECT_THAT(path.rapids().of_line(0, 3), ElementsAre(0));
  EXPECT_THAT(path.programmed().of_line(0, 4), ElementsAre(0));
  EXPECT_THAT(path.cuts().of_line(1, 4), ElementsAre());
}

TEST(DrawnPath, ThePartIsTheProgrammedContourAndElseTheCuts) {
  const Box part = drawn_path(sample()).part_box();
  EXPECT_EQ(part.width(), 20);
  EXPECT_EQ(part.height(), 0);
  Toolpath bare = sample();
  bare.contours.clear();
  EXPECT_EQ(drawn_path(bare).part_box().width(), 21) << "the bulge of the arc counts";
}

TEST(DrawnPath, APathWithoutMovesHasATool) {
  Toolpath path;
  path.start = {Rational(3), Rational(4)};
  const DrawnPath drawn = drawn_path(path);
  EXPECT_EQ(drawn.place({}), (DrawnPlace{3, 4}));
  EXPECT_EQ(drawn.tool_after(1), ToolPlace{});
  EXPECT_EQ(drawn.travel(), 0);
  EXPECT_TRUE(drawn.part_box().empty());
}

TEST(DrawnPath, IsGivenUpWhenNobodyWantsIt) {
  Toolpath path;
  const Move line = support::line(at(0, 0), at(1, 0));
  path.moves.assign(10000, line);
  EXPECT_FALSE(DrawnPath::of(path, [] { return true; }));
}

DrawnLayer staircase(int steps) {
  DrawnLayer layer;
  for (int i = 0; i < steps; ++i)
    layer.add(support::line(at(i, i), at(i + 1, i + 1)), static_cast<std::uint32_t>(i));
  layer.index();
  return layer;
}

TEST(DrawnLayer, VisitsAllThatComesIntoTheWindowAndLittleElse) {
  const DrawnLayer layer = staircase(10000);
  std::vector<std::size_t> seen;
  layer.visit({5000.5, 5000.5, 5002.5, 5002.5}, [&](std::size_t i) { seen.push_back(i); });
  EXPECT_THAT(seen, testing::IsSupersetOf({5000U, 5001U, 5002U}));
  EXPECT_LE(seen.size(), 16U);
  EXPECT_TRUE(std::ranges::is_sorted(seen));
}

TEST(DrawnLayer, WhatIsTooSmallToBeToldApartIsPassedInOne) {
  const DrawnLayer layer = staircase(10000);
  std::size_t curves = 0;
  std::size_t next = 0;
  layer.visit(
      layer.box(), 100, [&](std::size_t) { ++curves; },
      [&](std::size_t first, std::size_t last) {
        EXPECT_EQ(first, next) << "nothing is left out";
        next = last;
        EXPECT_LE(layer.end_of(last - 1).x - layer.begin_of(first).x, 100);
      });
  EXPECT_EQ(curves, 0U);
  EXPECT_EQ(next, layer.size());
}

TEST(DrawnLayer, AnEmptyOneIsVisitedInVain) {
  DrawnLayer layer;
  layer.index();
  layer.visit({-1, -1, 1, 1}, [](std::size_t) { FAIL(); });
  EXPECT_TRUE(layer.box().empty());
}

}  // namespace
}  // namespace dgt
