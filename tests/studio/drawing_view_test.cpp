// SPDX-License-Identifier: GPL-3.0-or-later
// Windows onto the plane, and what is painted through them.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <QImage>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "apps/studio/drawing/grid_painter.h"
#include "apps/studio/drawing/kerf_painter.h"
#include "apps/studio/drawing/strokes.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {
namespace {

double any(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

SheetView any_view() {
  return {{any(-1000, 1000), any(-1000, 1000)}, std::pow(10, any(-1, 7)), {900, 700}};
}

RC_GTEST_PROP(SheetView, PixelAndPlaceAreInverse, ()) {
  const SheetView view = any_view();
  const QPointF pixel(any(0, 900), any(0, 700));
  const QPointF back = view.pixel(view.place(pixel));
  RC_ASSERT(std::hypot(back.x() - pixel.x(), back.y() - pixel.y()) < 1e-5);
}

RC_GTEST_PROP(SheetView, ZoomingKeepsThePlaceUnderThePointer, ()) {
  const SheetView view = any_view();
  const QPointF about(any(0, 900), any(0, 700));
  const DrawnPlace before = view.place(about);
  const SheetView zoomed = view.zoomed(std::pow(10, any(-1, 2)), about);
  RC_ASSERT(distance(zoomed.place(about), before) < 1e-9);
}

RC_GTEST_PROP(SheetView, MovingMovesAllPlacesAlike, ()) {
  const SheetView view = any_view();
  const QPointF by(any(-500, 500), any(-500, 500));
  const DrawnPlace place = view.place({any(0, 900), any(0, 700)});
  const QPointF moved = view.moved(by).pixel(place) - view.pixel(place);
  RC_ASSERT(std::hypot(moved.x() - by.x(), moved.y() - by.y()) < 1e-5);
}

TEST(SheetView, FitsABoxWithItsMargin) {
  const SheetView view = SheetView::fitting({0, 0, 40, 20}, {1000, 800}, 0.1);
  EXPECT_DOUBLE_EQ(view.pixel({0, 0}).x(), 80);
  EXPECT_DOUBLE_EQ(view.pixel({40, 0}).x(), 920);
  EXPECT_DOUBLE_EQ(view.pixel({20, 10}).y(), 400);
}

TEST(SheetView, ABoxOfOnePointIsShownInTheMiddle) {
  const SheetView view = SheetView::fitting({5, 7, 5, 7}, {100, 100}, 0);
  EXPECT_EQ(view.pixel({5, 7}), QPointF(50, 50));
  EXPECT_TRUE(std::isfinite(view.scale));
  EXPECT_GT(SheetView::fitting({}, {100, 100}, 0).scale, 0) << "nothing to show";
}

TEST(SheetView, TheFinestPixelIsSixteenStepsOfTheFarthestCoordinate) {
  const double far = 1e6;
  const double step = std::nextafter(far, 2 * far) - far;
  EXPECT_GE(1 / finest_scale({0, 0, far, 1}), 16 * step);
  EXPECT_LE(1 / finest_scale({0, 0, far, 1}), 64 * step);
}

TEST(Grid, StepsAreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(grid_step(0.7), 1);
  EXPECT_DOUBLE_EQ(grid_step(1), 1);
  EXPECT_DOUBLE_EQ(grid_step(1.01), 2);
  EXPECT_DOUBLE_EQ(grid_step(3e-7), 5e-7);
  EXPECT_DOUBLE_EQ(grid_step(7000), 10000);
}

// --- strokes ------------------------------------------------------------------------------------

QImage sheet(QSize size) {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  return image;
}

template <class Draw>
QImage drawn(QSize size, Draw&& draw) {
  QImage image = sheet(size);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  QPen pen(Qt::black, 1);
  pen.setCosmetic(true);
  painter.setPen(pen);
  draw(painter);
  return image;
}

/// Where the ink of a column of pixels has its middle; −1 without ink.
double middle_of_ink(const QImage& image, int x) {
  double ink = 0;
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    const int alpha = qAlpha(image.pixel(x, y));
    ink += alpha;
    sum += alpha * (y + 0.5);
  }
  return ink > 0 ? sum / ink : -1;
}

// Ten million pixels to a millimetre: a polygon of a thousand corners for the whole circle would
// miss the window by kilometres of screen.
TEST(Strokes, AMillionFoldArcIsWhereTheCircleIs) {
  const double radius = 50;
  const double angle = std::numbers::pi / 2 - 0.3;
  const DrawnPlace right{radius, 0};
  const DrawnCurve circle{right, right, {0, 0}, radius, 2 * std::numbers::pi};
  const DrawnPlace centre{radius * std::cos(angle), radius * std::sin(angle)};
  const SheetView view{centre, 1e7, {800, 600}};
  const QImage image =
      drawn({800, 600}, [&](QPainter& painter) { stroke_curve(painter, view, circle); });
  for (int x = 1; x < 799; ++x) {
    // The circle beside its point `centre`, to the second order: the third is 10⁻⁹ pixels.
    const double along = (x + 0.5 - 400) / view.scale;
    const double slope = -std::cos(angle) / std::sin(angle);
    const double bend = -1 / (2 * radius * std::pow(std::sin(angle), 3));
    const double y = 300 - (slope * along + bend * along * along) * view.scale;
    ASSERT_NEAR(middle_of_ink(image, x), y, 0.5) << "column " << x;
  }
}

TEST(Strokes, FarFromTheOriginThePictureIsTheSame) {
  const auto picture = [](double shift) {
    const DrawnCurve arc{
        {shift + 1, shift}, {shift, shift + 1}, {shift, shift}, 1, std::numbers::pi / 2};
    const SheetView view{{shift + 0.5, shift + 0.5}, 200, {300, 300}};
    return drawn({300, 300}, [&](QPainter& painter) { stroke_curve(painter, view, arc); });
  };
  EXPECT_EQ(picture(0), picture(1 << 20)) << "a kilometre away";
}

TEST(Strokes, DashesDoNotCreepWhenTheDrawingIsMoved) {
  const DrawnCurve rapid{{-1e6, -3e5}, {1e6, 3e5}, {}, 0, 0};
  const SheetView view{{0, 0}, 10, {400, 300}};
  const auto picture = [&](const SheetView& seen) {
    return drawn({400, 300}, [&](QPainter& painter) { stroke_curve(painter, seen, rapid, 5); });
  };
  const QImage before = picture(view);
  const QImage after = picture(view.moved({17, 9}));
  EXPECT_EQ(before.copy(100, 50, 200, 200), after.copy(117, 59, 200, 200));
  EXPECT_NE(before.copy(100, 50, 200, 200), after.copy(100, 50, 200, 200));
}

TEST(Strokes, AChainOfNoSizeIsADot) {
  const DrawnCurve speck{{1, 1}, {1, 1 + 1e-9}, {}, 0, 0};
  const SheetView view{{1, 1}, 1, {21, 21}};
  const QImage image =
      drawn({21, 21}, [&](QPainter& painter) { stroke_curve(painter, view, speck); });
  EXPECT_NE(image, sheet({21, 21}));
}

RC_GTEST_PROP(Clip, KeepsWhatIsInsideAndEndsOnTheBorder, ()) {
  const Box window{-10, -5, 10, 5};
  const QPointF from(any(-30, 30), any(-20, 20));
  const QPointF to(any(-30, 30), any(-20, 20));
  double begin = 0;
  double end = 1;
  const bool meets = clip(from, to, window, begin, end);
  const auto is_inside = [&](QPointF p) {
    return p.x() >= -10 && p.x() <= 10 && p.y() >= -5 && p.y() <= 5;
  };
  RC_ASSERT(meets || !is_inside(from));
  RC_ASSERT(meets || !is_inside(to));
  if (!meets) return;
  for (const double part : {begin, end}) {
    const QPointF p = from + part * (to - from);
    RC_ASSERT(std::fabs(p.x()) <= 10 + 1e-12);
    RC_ASSERT(std::fabs(p.y()) <= 5 + 1e-12);
    const double border = std::min(10 - std::fabs(p.x()), 5 - std::fabs(p.y()));
    RC_ASSERT(part == 0 || part == 1 || border < 1e-12);
  }
}

TEST(Disc, AtAnyZoomItsEdgeStaysInTheWindow) {
  for (const double scale : {0.01, 1.0, 1e4, 1e9}) {
    const SheetView view{{0.2, 0}, scale, {400, 300}};
    for (const QPointF& corner : disc(view, {0, 0}, 0.2)) {
      EXPECT_LE(std::fabs(corner.x() - 200), 205);
      EXPECT_LE(std::fabs(corner.y() - 150), 155);
    }
  }
}

}  // namespace
}  // namespace dgt::studio
