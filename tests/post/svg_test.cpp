// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/svg.h"

#include <gmock/gmock.h>

#include <cstdio>

#include "tests/support/moves.h"

namespace dgt {
namespace {

using support::at;
using ::testing::HasSubstr;
using ::testing::Not;

/// A rapid to the part, a programmed square corner, and the same corner cut 1 mm outside.
Toolpath corner_path() {
  Toolpath path;
  path.start = {-5, 0};
  path.moves = {support::rapid(at(-5, 0), at(0, 1)), support::line(at(0, 1), at(9, 1)),
                support::line(at(9, 1), at(9, 10))};
  Contour contour;
  contour.id = 1;
  contour.first = 1;
  contour.last = 3;
  contour.programmed =
      std::vector{support::line(at(0, 0), at(10, 0)), support::line(at(10, 0), at(10, 10))};
  path.contours = {contour};
  return path;
}

Toolpath path_of(const Move& move) {
  Toolpath path;
  path.moves = {move};
  return path;
}

/// The part of a drawing that belongs to one class.
std::string group(const std::string& drawing, const std::string& name) {
  const auto begin = drawing.find("<g class=\"" + name + "\"");
  return drawing.substr(begin, drawing.find("</g>", begin) - begin);
}

TEST(DrawSvg, ProgrammedGreenEquidistantYellowRapidsDashed) {
  const std::string drawing = draw_svg(corner_path());
  const DrawingStyle style;
  EXPECT_THAT(group(drawing, "programmed"), HasSubstr(style.programmed));
  EXPECT_THAT(group(drawing, "programmed"), HasSubstr("d=\"M0 0 L10 0 L10 10\""));
  EXPECT_THAT(group(drawing, "equidistant"), HasSubstr(style.equidistant));
  EXPECT_THAT(group(drawing, "equidistant"), HasSubstr("d=\"M0 1 L9 1 L9 10\""));
  EXPECT_THAT(group(drawing, "rapid"), HasSubstr("stroke-dasharray"));
  EXPECT_THAT(group(drawing, "rapid"), HasSubstr("d=\"M-5 0 L0 1\""));
  EXPECT_THAT(group(drawing, "start"), HasSubstr("d=\"M-5 0 h0\""));
}

TEST(DrawSvg, TheSheetHoldsBothContoursTheStartAndAMarginWithYUp) {
  // 15 x 10 mm from (-5, 0) to (10, 10), a margin of 0.75 mm.
  EXPECT_THAT(draw_svg(corner_path()), HasSubstr("viewBox=\"-5.75 -10.75 16.5 11.5\""));
  EXPECT_THAT(draw_svg(corner_path()), HasSubstr("<g transform=\"scale(1,-1)\""));
}

TEST(DrawSvg, ArcsAreArcCommandsWithSizeAndSense) {
  const auto drawn = [](const Move& arc) { return draw_svg(path_of(arc)); };
  EXPECT_THAT(drawn(support::arc({0, 0}, 5, at(4, 3), at(-3, 4))),
              HasSubstr("M4 3 A5 5 0 0 1 -3 4\""));
  EXPECT_THAT(drawn(support::arc({0, 0}, 5, at(-3, 4), at(4, 3))),
              HasSubstr("M-3 4 A5 5 0 1 1 4 3\""));
  EXPECT_THAT(drawn(support::arc({0, 0}, -5, at(-3, 4), at(4, 3))),
              HasSubstr("M-3 4 A5 5 0 0 0 4 3\""));
  EXPECT_THAT(drawn(support::arc({0, 0}, -5, at(4, 3), at(-3, 4))),
              HasSubstr("M4 3 A5 5 0 1 0 -3 4\""));
}

TEST(DrawSvg, AFullCircleIsTwoHalves) {
  EXPECT_THAT(draw_svg(path_of(support::full_circle({1, 0}, 5, at(6, 0)))),
              HasSubstr("M6 0 A5 5 0 0 1 -4 0 A5 5 0 0 1 6 0\""));
}

TEST(DrawSvg, ARapidLiftsThePen) {
  Toolpath path;
  path.moves = {support::line(at(0, 0), at(1, 0)), support::rapid(at(1, 0), at(2, 0)),
                support::line(at(2, 0), at(3, 0))};
  EXPECT_THAT(group(draw_svg(path), "equidistant"), HasSubstr("M0 0 L1 0\nM2 0 L3 0\""));
}

TEST(DrawSvg, ADwellDoesNotLiftThePen) {
  Toolpath path;
  Move dwell;
  dwell.kind = MoveKind::Dwell;
  path.moves = {support::line(at(0, 0), at(1, 0)), dwell, support::line(at(1, 0), at(1, 1))};
  EXPECT_THAT(group(draw_svg(path), "equidistant"), HasSubstr("M0 0 L1 0 L1 1\""));
}

TEST(DrawSvg, APathThatGoesNowhereStillHasASheet) {
  const std::string drawing = draw_svg(Toolpath{});
  EXPECT_THAT(drawing, HasSubstr("viewBox=\"-0.05 -0.05 0.1 0.1\""));
  EXPECT_THAT(drawing, Not(HasSubstr("nan")));
  EXPECT_THAT(drawing, Not(HasSubstr("inf")));
}

TEST(DrawSvg, StrokesAreInPixelsOrElseInMillimetresOfTheSameWidth) {
  // 16.5 mm are 1000 pixels.
  const std::string drawing = draw_svg(corner_path());
  EXPECT_THAT(drawing, HasSubstr(".programmed { stroke-width: 3px; }"));
  EXPECT_THAT(group(drawing, "programmed"), HasSubstr("stroke-width=\"0.0495\""));
  EXPECT_THAT(drawing, HasSubstr(".rapid { stroke-width: 1px; stroke-dasharray: 5px; }"));
}

// --- named elements -----------------------------------------------------------------------------

std::vector<NamedShape> corner_names() {
  const Line level(UnitVector(Vector{0, 1}), 0);
  return {{"P1", NamedSpot{5, 5, true}},
          {"R2", NamedSpot{9, 5, false}},
          {"O1", NamedAxes{-4, 8, 0, 1}},
          {"C1", Circle({5, 5}, -3)},
          {"L1", level},
          {"L9", level.offset(100)}};
}
std::string named_corner() { return draw_svg(corner_path(), {}, corner_names()); }

TEST(DrawSvgNames, ElementsLieThinBeneathThePathAndAcrossTheSheet) {
  // 15 mm and a margin of 0.12 of it on each side.
  EXPECT_THAT(named_corner(), HasSubstr("viewBox=\"-6.8 -11.8 18.6 13.6\""));
  const std::string elements = group(named_corner(), "element");
  EXPECT_THAT(elements, HasSubstr("M8 5 A3 3 0 0 1 2 5 A3 3 0 0 1 8 5"));
  EXPECT_THAT(elements, HasSubstr("M-6.8"));
  EXPECT_LT(named_corner().find("class=\"element\""), named_corner().find("class=\"programmed\""));
}

TEST(DrawSvgNames, EveryNameOnTheSheetIsWrittenUprightAndOthersAreNot) {
  const std::string names = group(named_corner(), "names");
  EXPECT_THAT(names, HasSubstr("transform=\"scale(1,-1)\""));
  for (const char* name : {"P1", "R2", "O1", "C1", "L1"}) {
    EXPECT_THAT(names, HasSubstr(">" + std::string(name) + "</text>"));
  }
  EXPECT_THAT(names, Not(HasSubstr("L9")));
}

TEST(DrawSvgNames, APlaceWithoutADotHasNone) {
  EXPECT_THAT(group(named_corner(), "dot"), HasSubstr("d=\"M5 5 h0\""));
}

TEST(DrawSvgNames, AnArrowPointsAlongItsElement) {
  const auto arrows_of = [](const Line& line) {
    const std::vector<NamedShape> one = {{"L1", line}};
    return group(draw_svg(corner_path(), {}, one), "arrow");
  };
  const Line level(UnitVector(Vector{0, 1}), 5);
  // Three points: a wing, the tip, a wing.
  const auto tip_is_ahead = [](const std::string& group) {
    double wing = 0;
    double tip = 0;
    const auto at = group.find("d=\"M");
    EXPECT_EQ(std::sscanf(group.c_str() + at, "d=\"M%lf %*f L%lf", &wing, &tip), 2) << group;
    return tip > wing;
  };
  EXPECT_TRUE(tip_is_ahead(arrows_of(level)));
  EXPECT_FALSE(tip_is_ahead(arrows_of(level.reversed())));
}

TEST(DrawSvgNames, NamesDoNotCoverEachOther) {
  const std::vector<NamedShape> two = {{"P1", NamedSpot{5, 5, true}},
                                       {"P2", NamedSpot{5, 5, true}}};
  const std::string names = group(draw_svg(corner_path(), {}, two), "names");
  const auto place = [&](const std::string& name) {
    const auto end = names.find(">" + name + "<");
    return names.substr(names.rfind("<text", end), end - names.rfind("<text", end));
  };
  EXPECT_NE(place("P1"), place("P2"));
}

TEST(DrawSvgNames, ArrowsStandOnThePathButNotOnLeads) {
  Toolpath path = corner_path();
  EXPECT_THAT(group(draw_svg(path, {}, corner_names()), "head"), HasSubstr("d=\"M"));
  for (Move& move : path.moves) move.role = Role::LeadIn;
  EXPECT_THAT(group(draw_svg(path, {}, corner_names()), "head"), Not(HasSubstr("d=\"M")));
}

TEST(DrawSvgNames, WithoutNamesTheDrawingHasNoneOfIt) {
  EXPECT_THAT(draw_svg(corner_path()), Not(HasSubstr("<text")));
  EXPECT_THAT(draw_svg(corner_path()), Not(HasSubstr("class=\"arrow\"")));
}

TEST(DrawSvg, TheSamePathGivesTheSameBytes) {
  EXPECT_EQ(draw_svg(corner_path()), draw_svg(corner_path()));
}

}  // namespace
}  // namespace dgt
