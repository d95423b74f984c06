// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a drawing means, entity by entity.
#include <gmock/gmock.h>

#include <cmath>
#include <set>
#include <string>

#include "lang/dxf/reader.h"
#include "lang/text/render.h"
#include "tests/lang/dxf_text.h"

namespace dgt {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

Toolpath path_of(const std::string& text, const DxfOptions& options = {}) {
  const SourceFile file("t.dxf", text);
  DiagnosticBag bag;
  Toolpath path = read_dxf(file, options, {}, bag);
  EXPECT_FALSE(bag.has_errors()) << render(bag);
  return path;
}

/// The moves of the entities as to_text() prints them, without places and contours.
std::string moves(std::string_view entities, const DxfOptions& options = {},
                  std::string_view sections = "") {
  Toolpath path = path_of(dxf_file(entities, sections), options);
  for (Move& move : path.moves) move.source = {};
  path.contours.clear();
  return to_text(path);
}

std::string rectangle(double x, double y, double w, double h) {
  const auto vertex = [](double a, double b) {
    return "|10 " + std::to_string(a) + "|20 " + std::to_string(b);
  };
  return "0 LWPOLYLINE|70 1" + vertex(x, y) + vertex(x + w, y) + vertex(x + w, y + h) +
         vertex(x, y + h);
}

// --- numbers ------------------------------------------------------------------------------------

TEST(Dxf, DecimalsAreExact) {
  const Toolpath path = path_of(dxf_file("0 LINE|10 0.1|20 -1e-3|11 .30000000000000000001|21 7."));
  ASSERT_THAT(path.moves, SizeIs(1));
  const ExactPoint from = path.moves[0].from.exact();
  const ExactPoint to = path.moves[0].to.exact();
  EXPECT_EQ(from.x.a, Rational(1, 10));
  EXPECT_EQ(from.y.a, Rational(-1, 1000));
  EXPECT_EQ(to.x.a, *parse_decimal("0.30000000000000000001"));
  EXPECT_EQ(to.y.a, 7);
}

TEST(Dxf, UnitsBecomeMillimetres) {
  const std::string_view line = "0 LINE|10 0|20 0|11 1|21 2";
  const auto in_unit = [&](const char* unit) {
    const std::string header = std::string("0 SECTION|2 HEADER|9 $INSUNITS|70 ") + unit +
                               "|0 ENDSEC|0 SECTION|2 ENTITIES|" + std::string(line) +
                               "|0 ENDSEC|0 EOF";
    return path_of(dxf_text(header)).moves.at(0).to.exact().y.a;
  };
  EXPECT_EQ(in_unit("1"), Rational(254, 5));
  EXPECT_EQ(in_unit("4"), 2);
  EXPECT_EQ(in_unit("5"), 20);
  EXPECT_EQ(in_unit("6"), 2000);
  EXPECT_EQ(in_unit("13"), Rational(1, 500));
  EXPECT_EQ(in_unit("0"), 2);
  EXPECT_EQ(path_of(dxf_file(line), {.unit = DxfUnit::Inch}).moves.at(0).to.exact().y.a,
            Rational(254, 5));
}

// --- entities -----------------------------------------------------------------------------------

TEST(Dxf, AnArcRunsCounterClockwiseBetweenItsAngles) {
  EXPECT_EQ(moves("0 ARC|10 10|20 0|40 5|50 270|51 90"),
            "start X10.000000 Y-5.000000\n"
            "1 arc X10.000000 Y5.000000 centre X10.000000 Y0.000000 radius 5.000000 sweep "
            "180.000000 contour\n");
}

TEST(Dxf, AnArcSeenFromBehindIsMirrored) {
  EXPECT_EQ(moves("0 ARC|10 10|20 0|40 5|50 0|51 90|210 0|220 0|230 -1"),
            "start X-10.000000 Y5.000000\n"
            "1 arc X-15.000000 Y0.000000 centre X-10.000000 Y0.000000 radius 5.000000 "
            "sweep 90.000000 contour\n");
}

TEST(Dxf, LinesAreInCoordinatesOfTheWorldWhereverTheyAreSeenFrom) {
  EXPECT_EQ(moves("0 LINE|10 1|20 2|11 3|21 4|230 -1"),
            "start X1.000000 Y2.000000\n1 line X3.000000 Y4.000000 contour\n");
}

TEST(Dxf, ABulgeIsTheTangentOfAQuarterOfTheSweep) {
  EXPECT_EQ(moves("0 LWPOLYLINE|70 0|10 0|20 0|42 1|10 10|20 0|42 -1|10 20|20 0"),
            "start X0.000000 Y0.000000\n"
            "1 arc X10.000000 Y0.000000 centre X5.000000 Y0.000000 radius 5.000000 sweep "
            "180.000000 contour\n"
            "2 arc X20.000000 Y0.000000 centre X15.000000 Y0.000000 radius 5.000000 sweep "
            "-180.000000 contour\n");
}

TEST(Dxf, OldPolylinesAreReadWithoutTheFrameOfTheirCurves) {
  EXPECT_EQ(moves("0 POLYLINE|66 1|70 0|0 VERTEX|10 0|20 0|0 VERTEX|10 5|20 5|70 16|0 "
                  "VERTEX|10 10|20 0|0 SEQEND"),
            "start X0.000000 Y0.000000\n1 line X10.000000 Y0.000000 contour\n");
}

TEST(Dxf, AClosedPolylineWhoseEndRepeatsItsBeginningHasNoEdgeOfNoLength) {
  const Toolpath path =
      path_of(dxf_file("0 LWPOLYLINE|70 1|10 0|20 0|10 9|20 0|10 9|20 9|10 0|20 0"));
  EXPECT_THAT(path.moves, SizeIs(3));
  EXPECT_TRUE(path.contours.at(0).closed);
}

TEST(Dxf, AnglesBesideAQuarterTurnAreOne) {
  const Toolpath path = path_of(dxf_file("0 ARC|10 0|20 0|40 5|50 89.99999999999999|51 180"));
  EXPECT_EQ(path.moves.at(0).from.exact().x.a, 0);
}

// --- curves -------------------------------------------------------------------------------------

/// The largest |f| over places of the moves, 200 on each.
template <class Deviation>
double largest(const Toolpath& path, Deviation&& f) {
  double most = 0;
  for (const Move& move : path.moves) {
    constexpr int kPlaces = 200;
    for (int i = 0; i <= kPlaces; ++i) {
      const double t = static_cast<double>(i) / kPlaces;
      double x = move.from.x() + t * (move.to.x() - move.from.x());
      double y = move.from.y() + t * (move.to.y() - move.from.y());
      if (move.kind == MoveKind::Arc) {
        const Circle circle = move.circle();
        const double cx = nearest_double(circle.centre().x);
        const double cy = nearest_double(circle.centre().y);
        const double begin = std::atan2(move.from.y() - cy, move.from.x() - cx);
        const double angle = begin + t * sweep_degrees(move) * std::acos(-1.0) / 180;
        const double radius = std::fabs(nearest_double(circle.radius()));
        x = cx + radius * std::cos(angle);
        y = cy + radius * std::sin(angle);
      }
      most = std::max(most, std::fabs(f(x, y)));
    }
  }
  return most;
}

/// About how far a place lies from the ellipse (x/a)² + (y/b)² = 1.
double beside_ellipse(double x, double y, double a, double b) {
  const double f = x * x / (a * a) + y * y / (b * b) - 1;
  return f / (2 * std::hypot(x / (a * a), y / (b * b)));
}

TEST(Dxf, AnEllipseIsArcsWithinTheToleranceAndNotMuchFiner) {
  for (const int denominator : {10, 1000, 100'000}) {
    const Toolpath path = path_of(dxf_file("0 ELLIPSE|10 0|20 0|11 20|21 0|40 0.3"),
                                  {.curve_tolerance = Rational(1, denominator)});
    const double tolerance = 1.0 / denominator;
    const double worst =
        largest(path, [](double x, double y) { return beside_ellipse(x, y, 20, 6); });
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, tolerance / 50);
    EXPECT_TRUE(path.contours.at(0).closed);
    for (const Move& move : path.moves) EXPECT_EQ(move.kind, MoveKind::Arc);
  }
}

TEST(Dxf, ACircleScaledUnevenlyIsAnEllipse) {
  const Toolpath path = path_of(dxf_file("0 INSERT|2 O|10 0|20 0|41 4|42 -2",
                                         "0 SECTION|2 BLOCKS|0 BLOCK|2 o|10 1|20 "
                                         "1|0 CIRCLE|10 1|20 1|40 3|0 ENDBLK|0 ENDSEC"));
  EXPECT_GT(path.moves.size(), 8U);
  EXPECT_LE(largest(path, [](double x, double y) { return beside_ellipse(x, y, 12, 6); }), 0.001);
}

TEST(Dxf, AnEllipseOfEqualAxesIsOneCircle) {
  const Toolpath path = path_of(dxf_file("0 ELLIPSE|10 1|20 2|11 3|21 4|40 1"));
  ASSERT_THAT(path.moves, SizeIs(1));
  EXPECT_TRUE(path.moves[0].full_circle);
  EXPECT_EQ(path.moves[0].circle(), Circle({1, 2}, 5));
}

TEST(Dxf, ASplineOfACircleIsArcsOfThatCircle) {
  const Toolpath path = path_of(dxf_file(
      "0 SPLINE|71 2|40 0|40 0|40 0|40 1|40 1|40 1|41 1|41 0.7071067811865476|41 1|10 5|20 0|10 "
      "5|20 5|10 0|20 5"));
  EXPECT_THAT(path.moves, SizeIs(2));
  EXPECT_LE(largest(path, [](double x, double y) { return std::hypot(x, y) - 5; }), 1e-9);
}

TEST(Dxf, ASplineOfDegreeOneIsItsPolygon) {
  EXPECT_EQ(moves("0 SPLINE|71 1|40 0|40 0|40 1|40 2|40 2|10 0|20 0|10 5|20 5|10 9|20 0"),
            "start X0.000000 Y0.000000\n1 line X5.000000 Y5.000000 contour\n"
            "2 line X9.000000 Y0.000000 contour\n");
}

TEST(Dxf, ASplineWithACuspStaysWithinTheTolerance) {
  // x = t², y = t³ from −1 to 1: back on itself at the origin.
  const Toolpath path = path_of(dxf_file(
      "0 SPLINE|71 3|40 0|40 0|40 0|40 0|40 1|40 1|40 1|40 1|10 1|20 -1|10 -0.3333333333|20 1|10 "
      "-0.3333333333|20 -1|10 1|20 1"));
  const double worst = largest(path, [](double x, double y) {
    // The nearest of many places of the curve.
    double least = 9;
    for (int i = -4000; i <= 4000; ++i) {
      const double t = i / 4000.0;
      least = std::min(least, std::hypot(x - t * t, y - t * t * t));
    }
    return least;
  });
  EXPECT_LE(worst, 0.001 + 0.0004);  // and the step of the search
}

TEST(Dxf, ASplineWithAJumpIsTwoContours) {
  const Toolpath path = path_of(dxf_file(
      "0 SPLINE|71 1|40 0|40 0|40 1|40 1|40 2|40 2|10 0|20 0|10 5|20 0|10 5|20 5|10 9|20 5"));
  EXPECT_THAT(path.contours, SizeIs(2));
}

// --- blocks -------------------------------------------------------------------------------------

TEST(Dxf, BlocksAreTurnedScaledMirroredAndNested) {
  const std::string_view blocks =
      "0 SECTION|2 BLOCKS|0 BLOCK|2 L|10 1|20 0|0 LINE|10 1|20 0|11 3|21 0|0 ENDBLK|0 BLOCK|2 "
      "TWO|0 INSERT|2 L|10 0|20 0|50 90|0 ENDBLK|0 ENDSEC";
  EXPECT_EQ(moves("0 INSERT|2 TWO|10 10|20 5|41 -2|42 3", {}, blocks),
            "start X10.000000 Y5.000000\n1 line X10.000000 Y11.000000 contour\n");
  EXPECT_EQ(moves("0 INSERT|2 TWO|10 10|20 5|50 90", {}, blocks),
            "start X10.000000 Y5.000000\n1 line X8.000000 Y5.000000 contour\n");
}

TEST(Dxf, ArraysAreTurnedWithTheirBlock) {
  const Toolpath path =
      path_of(dxf_file("0 INSERT|2 D|10 0|20 0|50 90|70 3|71 2|44 10|45 4",
                       "0 SECTION|2 BLOCKS|0 BLOCK|2 D|0 CIRCLE|10 0|20 0|40 1|0 ENDBLK|0 ENDSEC"));
  std::set<std::pair<double, double>> centres;
  for (const Contour& contour : path.contours) {
    const RationalPoint centre = programmed_moves(path, contour).front().circle().centre();
    centres.emplace(nearest_double(centre.x), nearest_double(centre.y));
  }
  const std::set<std::pair<double, double>> expected = {{0, 0},  {0, 10},  {0, 20},
                                                        {-4, 0}, {-4, 10}, {-4, 20}};
  EXPECT_EQ(centres, expected);
}

TEST(Dxf, ABlockOnLayerZeroTakesTheLayerItIsPutOn) {
  const std::string_view block =
      "0 SECTION|2 BLOCKS|0 BLOCK|2 D|0 CIRCLE|8 0|10 0|20 0|40 1|0 CIRCLE|8 X|10 0|20 0|40 2|0 "
      "ENDBLK|0 ENDSEC";
  const auto radius = [&](const char* layer) {
    const Toolpath path =
        path_of(dxf_file("0 INSERT|8 CUT|2 D|10 0|20 0", block), {.layers = {layer}});
    EXPECT_THAT(path.moves, SizeIs(1));
    return path.moves.at(0).circle().radius();
  };
  EXPECT_EQ(radius("cut"), 1);
  EXPECT_EQ(radius("x"), 2);
}

// --- contours -----------------------------------------------------------------------------------

TEST(Dxf, PiecesInAnyOrderAndDirectionAreOneContour) {
  const Toolpath path = path_of(
      dxf_file("0 LINE|10 0|20 0|11 10|21 0|0 LINE|10 0|20 10|11 0|21 0|0 LINE|10 10|20 0|11 "
               "10|21 10|0 LINE|10 10|20 10|11 0|21 10"));
  ASSERT_THAT(path.contours, SizeIs(1));
  EXPECT_TRUE(path.contours[0].closed);
  EXPECT_THAT(path.moves, SizeIs(4));
  EXPECT_EQ(path.moves[0].from, Point(RationalPoint{0, 0}));
  EXPECT_EQ(path.moves[0].to, Point(RationalPoint{10, 0}));
  EXPECT_EQ(path.moves[3].to, path.moves[0].from);
}

TEST(Dxf, TheFirstDirectedPieceGivesTheDirection) {
  // The arc runs counter-clockwise by nature, the line clockwise by the hand that drew it.
  EXPECT_EQ(moves("0 ARC|10 0|20 0|40 5|50 0|51 180|0 LINE|10 5|20 0|11 -5|21 0"),
            "start X-5.000000 Y0.000000\n"
            "1 arc X5.000000 Y0.000000 centre X0.000000 Y0.000000 radius 5.000000 sweep "
            "-180.000000 contour\n"
            "2 line X-5.000000 Y0.000000 contour\n");
}

TEST(Dxf, GapsWithinTheToleranceCloseAndArcsFollowTheirEnds) {
  const Toolpath path = path_of(
      dxf_file("0 ARC|10 0|20 0|40 5|50 0|51 180|0 LINE|10 -5.004|20 -0.003|11 5|21 0.006"));
  ASSERT_THAT(path.contours, SizeIs(1));
  EXPECT_TRUE(path.contours[0].closed);
  ASSERT_THAT(path.moves, SizeIs(2));
  EXPECT_EQ(path.moves[0].to, Point(RationalPoint{{-1251, 250}, {-3, 1000}}));
  EXPECT_EQ(path.moves[1].to, path.moves[0].from);
  const Circle circle = path.moves[0].circle();
  EXPECT_NEAR(nearest_double(circle.radius()), 5, 0.01);
  EXPECT_NEAR(nearest_double(circle.centre().x), 0, 0.01);
}

TEST(Dxf, AnArcOfNearlyAWholeTurnKeepsItsPlaceWhenItsEndsAreMoved) {
  // A keyhole: the ends of the arc are 0.4 mm apart, those of the lines 0.004 mm off.
  const Toolpath path = path_of(
      dxf_file("0 ARC|10 0|20 0|40 5|50 2.3|51 357.7|0 LINE|10 5|20 0.2|11 9|21 0.2|0 LINE|10 "
               "9|20 -0.2|11 5|21 -0.2|0 LINE|10 9|20 0.2|11 9|21 -0.2"));
  ASSERT_THAT(path.contours, SizeIs(1));
  EXPECT_TRUE(path.contours[0].closed);
  EXPECT_THAT(path.moves, SizeIs(5));  // the arc is two
  for (const Move& move : path.moves) {
    if (move.kind != MoveKind::Arc) continue;
    EXPECT_NEAR(nearest_double(move.circle().centre().x), 0, 0.01);
    EXPECT_NEAR(nearest_double(move.circle().centre().y), 0, 0.01);
  }
}

TEST(Dxf, LoopsThatTouchInOnePlaceAreTwoContours) {
  const Toolpath path = path_of(
      dxf_file("0 LINE|10 0|20 0|11 10|21 0|0 LINE|10 10|20 0|11 5|21 5|0 LINE|10 5|20 5|11 0|21 "
               "0|0 LINE|10 "
               "0|20 0|11 -10|21 0|0 LINE|10 -10|20 0|11 -5|21 -5|0 LINE|10 -5|20 -5|11 0|21 0"));
  ASSERT_THAT(path.contours, SizeIs(2));
  for (const Contour& contour : path.contours) {
    EXPECT_TRUE(contour.closed);
    EXPECT_EQ(programmed_moves(path, contour).size(), 3U);
  }
}

TEST(Dxf, HolesAreCutBeforeWhatTheyLieIn) {
  const std::string entities = rectangle(0, 0, 100, 100) + "|" + rectangle(10, 10, 80, 80) + "|" +
                               rectangle(20, 20, 60, 60) + "|" + rectangle(200, 0, 9, 9);
  const Toolpath path = path_of(dxf_file(entities));
  ASSERT_THAT(path.contours, SizeIs(4));
  std::vector<double> begins;
  for (const Contour& contour : path.contours)
    begins.push_back(programmed_moves(path, contour).front().from.x());
  EXPECT_EQ(begins, (std::vector<double>{20, 10, 0, 200}));
}

TEST(Dxf, AnEllipseInAPlateIsAHoleOfIt) {
  const Toolpath path =
      path_of(dxf_file(rectangle(0, 0, 100, 60) + "|0 ELLIPSE|10 50|20 30|11 15|21 0|40 0.1"));
  ASSERT_THAT(path.contours, SizeIs(2));
  EXPECT_EQ(programmed_moves(path, path.contours[0]).front().from.x(), 65);
}

TEST(Dxf, ThePartLiesOnTheSideThatIsAskedFor) {
  const std::string entities = rectangle(0, 0, 100, 100) + "|0 CIRCLE|10 50|20 50|40 20";
  const auto hole_runs_ccw = [&](DxfDirection direction) {
    DxfOptions options;
    options.direction = direction;
    const Toolpath path = path_of(dxf_file(entities), options);
    EXPECT_EQ(path.moves.back().to, Point(RationalPoint{0, 0}));  // begins and ends where it did
    const bool plate_runs_ccw = path.moves.back().from == Point(RationalPoint{0, 100});
    const bool hole = path.moves.front().circle().counter_clockwise();
    EXPECT_EQ(hole == plate_runs_ccw, direction == DxfDirection::Drawn);
    return hole;
  };
  EXPECT_TRUE(hole_runs_ccw(DxfDirection::Drawn));
  EXPECT_FALSE(hole_runs_ccw(DxfDirection::PartLeft));
  EXPECT_TRUE(hole_runs_ccw(DxfDirection::PartRight));
}

TEST(Dxf, InDrawnOrderNothingIsSorted) {
  const std::string entities = rectangle(0, 0, 100, 100) + "|" + rectangle(10, 10, 80, 80);
  const Toolpath path = path_of(dxf_file(entities), {.order = DxfOrder::File});
  EXPECT_EQ(programmed_moves(path, path.contours.at(0)).front().from.x(), 0);
}

TEST(Dxf, TheKerfRunsOutsidePartsAndInsideHoles) {
  const std::string entities = rectangle(0, 0, 100, 100) + "|0 CIRCLE|10 50|20 50|40 20";
  const Toolpath path = path_of(dxf_file(entities), {.kerf_width = 2});
  ASSERT_THAT(path.contours, SizeIs(2));
  const auto extent = [&](std::size_t contour) {
    double right = 0;
    for (std::size_t i = path.contours[contour].first; i < path.contours[contour].last; ++i)
      right = std::max(right, path.moves[i].from.x());
    return right;
  };
  EXPECT_EQ(extent(0), 69);   // the hole
  EXPECT_EQ(extent(1), 101);  // the plate
  EXPECT_EQ(path.contours[0].offset, 1);
}

TEST(Dxf, APlateOfTenThousandHolesIsReadAtOnce) {
  std::string entities = rectangle(0, 0, 1010, 1010);
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) {
      entities += "|0 CIRCLE|10 " + std::to_string(10 * i + 10) + "|20 " +
                  std::to_string(10 * j + 10) + "|40 3";
    }
  }
  const Toolpath path = path_of(dxf_file(entities), {.kerf_width = Rational(1, 2)});
  EXPECT_THAT(path.contours, SizeIs(10'001));
  EXPECT_LT(lengths(path.moves).rapid, 1.5 * 10 * 10'000);
}

TEST(Dxf, ABlotOfEndsIsRead) {
  std::string entities;
  for (int i = 0; i < 3000; ++i) {
    const std::string x = std::to_string(1e-9 * i);
    entities += (i == 0 ? "0 LINE|10 " : "|0 LINE|10 ") + x + "|20 0|11 " +
                std::to_string(1e-9 * (7 * i % 3000)) + "|21 " + std::to_string(i);
  }
  EXPECT_GT(path_of(dxf_file(entities)).contours.size(), 0U);
}

TEST(Dxf, SourcesAreTheLinesOfTheFile) {
  const Toolpath path = path_of(dxf_file("0 LINE|10 0|20 0|11 1|21 0|0 LINE|10 5|20 0|11 6|21 0"));
  EXPECT_EQ(path.moves.front().source.line, 16U);
  EXPECT_EQ(path.moves.back().source.line, 26U);
}

}  // namespace
}  // namespace dgt
