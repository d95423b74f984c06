// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing under the hands of a person: mouse, wheel and keys.
#include <gmock/gmock.h>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QSet>
#include <QSignalSpy>
#include <QWheelEvent>

#include "apps/driver/summary.h"
#include "tests/studio/drawing_parts.h"
#include "tests/studio/qt_values.h"

namespace dgt::studio {
namespace {

QString shown(QWidget& panel, const char* name) {
  return panel.findChild<QLabel*>(QString::fromLatin1(name))->text();
}

void turn_wheel(Canvas& canvas, QPointF at, int notches) {
  QWheelEvent event(at, canvas.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&canvas, &event);
}

TEST(Drawing, TellsWhereThePointerIs) {
  ShownPanel shown_panel(part_of(kRectangle));
  ASSERT_TRUE(shown_panel.settled);
  Canvas& canvas = shown_panel.canvas();
  const QPoint at = shown_panel.pixel(10, 5);
  QTest::mouseMove(&canvas, at);
  const DrawnPlace place = canvas.view().place(at);
  EXPECT_EQ(shown(shown_panel.panel, "x"), QStringLiteral("X %1").arg(place.x, 0, 'f', 3));
  EXPECT_EQ(shown(shown_panel.panel, "y"), QStringLiteral("Y %1").arg(place.y, 0, 'f', 3));
  EXPECT_NEAR(place.x, 10, 1 / canvas.view().scale);
}

TEST(Drawing, DecimalsAreThoseOfTheMachine) {
  Settings settings;
  settings.dialect.name = "essi";
  settings.dialect.unit = Rational(1, 10);
  ShownPanel shown_panel(part_of(kRectangle, "part.bgt", settings));
  QTest::mouseMove(&shown_panel.canvas(), shown_panel.pixel(11, 6));
  const QRegularExpression one_decimal(QStringLiteral("^X \\d+\\.\\d$"));
  EXPECT_TRUE(one_decimal.match(shown(shown_panel.panel, "x")).hasMatch());
}

TEST(Drawing, TellsBothLengths) {
  const PartPtr part = corpus_part("1P.bgt");
  ShownPanel shown_panel(part);
  const auto told = [&] { return shown(shown_panel.panel, "lengths").replace(QChar::Nbsp, u' '); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return told().contains(QStringLiteral("Contour")); }));
  const WayLengths ways = way_lengths(*part->path());
  EXPECT_NE(ways.programmed, ways.cut);
  EXPECT_TRUE(told().contains(QStringLiteral("Contour %1 mm").arg(ways.programmed, 0, 'f', 3)));
  EXPECT_TRUE(told().contains(QStringLiteral("Path %1 mm").arg(ways.cut, 0, 'f', 3)));
}

TEST(Drawing, AClickMagnifiesByTheFactorAndKeepsThePlace) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  shown_panel.panel.findChild<QDoubleSpinBox*>()->setValue(2);
  for (auto* box : shown_panel.panel.findChildren<QDoubleSpinBox*>()) {
    if (box->prefix().startsWith(u'×')) box->setValue(3.5);
  }
  const QPoint at = shown_panel.pixel(13, 8);
  const DrawnPlace before = canvas.view().place(at);
  const double scale = canvas.view().scale;
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, at);
  EXPECT_DOUBLE_EQ(canvas.view().scale, 3.5 * scale);
  EXPECT_LT(distance(canvas.view().place(at), before), 1e-9);
  QTest::mouseClick(&canvas, Qt::RightButton, {}, at);
  EXPECT_NEAR(canvas.view().scale, scale, 1e-12 * scale);
  EXPECT_LT(distance(canvas.view().place(at), before), 1e-9);
}

TEST(Drawing, TheWheelMagnifiesAboutThePointer) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  const QPointF at = shown_panel.pixel(31, 17);
  const DrawnPlace before = canvas.view().place(at);
  const double scale = canvas.view().scale;
  turn_wheel(canvas, at, 3);
  EXPECT_GT(canvas.view().scale, 1.5 * scale);
  EXPECT_LT(distance(canvas.view().place(at), before), 1e-9);
  for (int i = 0; i < 300; ++i) turn_wheel(canvas, at, 1);
  EXPECT_DOUBLE_EQ(canvas.view().scale, finest_scale({0, 0, 40, 20})) << "and there it ends";
  for (int i = 0; i < 600; ++i) turn_wheel(canvas, at, -1);
  EXPECT_DOUBLE_EQ(canvas.view().scale, coarsest_scale({0, 0, 40, 20}));
}

TEST(Drawing, DraggingMovesTheDrawingWithThePointer) {
  for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton}) {
    ShownPanel shown_panel(part_of(kRectangle));
    Canvas& canvas = shown_panel.canvas();
    QSignalSpy chosen(&shown_panel.panel, &DrawingPanel::place_chosen);
    const QPoint from = shown_panel.pixel(20, 0);
    const DrawnPlace held = canvas.view().place(from);
    const double scale = canvas.view().scale;
    QTest::mousePress(&canvas, button, {}, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(60, -25), canvas.mapToGlobal(from),
                     Qt::NoButton, button, Qt::NoModifier);
    QApplication::sendEvent(&canvas, &move);
    QTest::mouseRelease(&canvas, button, {}, from + QPoint(60, -25));
    EXPECT_LT(distance(canvas.view().place(from + QPoint(60, -25)), held), 1e-9);
    EXPECT_EQ(canvas.view().scale, scale) << "a drag is no click";
    EXPECT_EQ(chosen.count(), 0);
  }
}

TEST(Drawing, AClickOnAMoveTellsItsPlaceInTheSource) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  QSignalSpy chosen(&shown_panel.panel, &DrawingPanel::place_chosen);
  const double scale = canvas.view().scale;
  const QPoint at = shown_panel.pixel(40, 13);
  QTest::mouseMove(&canvas, at);
  EXPECT_EQ(canvas.cursor().shape(), Qt::PointingHandCursor);
  EXPECT_TRUE(canvas.hint().contains(QStringLiteral("line 7")));
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, at);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0], (QList<QVariant>{0, 7, 10})) << "L2 of the contour";
  EXPECT_EQ(canvas.view().scale, scale);
  QTest::mouseClick(&canvas, Qt::LeftButton, Qt::ControlModifier, at);
  EXPECT_EQ(chosen.count(), 1) << "Ctrl magnifies anywhere";
  EXPECT_EQ(canvas.view().scale, 2 * scale);
}

TEST(Drawing, KeysZoomMoveAndFit) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  const SheetView fitted = canvas.view();
  QTest::keyClick(&canvas, Qt::Key_Plus);
  EXPECT_DOUBLE_EQ(canvas.view().scale, 1.25 * fitted.scale);
  EXPECT_EQ(canvas.view().centre, fitted.centre);
  QTest::keyClick(&canvas, Qt::Key_Right);
  EXPECT_GT(canvas.view().centre.x, fitted.centre.x);
  QTest::keyClick(&canvas, Qt::Key_Up);
  EXPECT_GT(canvas.view().centre.y, fitted.centre.y);
  QTest::keyClick(&canvas, Qt::Key_0);
  EXPECT_EQ(canvas.view(), fitted);
}

TEST(Drawing, AFittedDrawingStaysFittedWhenTheWindowGrowsAndAZoomedOneStaysInPlace) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  const double scale = canvas.view().scale;
  shown_panel.panel.resize(1300, 1000);
  QApplication::processEvents();
  EXPECT_GT(canvas.view().scale, 1.2 * scale);
  canvas.zoom(2);
  const SheetView before = canvas.view();
  shown_panel.panel.resize(900, 700);
  QApplication::processEvents();
  EXPECT_EQ(canvas.view().centre, before.centre);
  EXPECT_EQ(canvas.view().scale, before.scale);
}

TEST(Drawing, ALineOfTheSourceLightsItsMovesAndComesIntoViewWhenAskedTo) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  const QImage plain = canvas.grab().toImage();
  shown_panel.panel.light_line(0, 7);
  const QImage lit = canvas.grab().toImage();
  EXPECT_NE(plain, lit);
  shown_panel.panel.light_line(0, 1);
  EXPECT_EQ(canvas.grab().toImage(), plain) << "a definition moves nothing";
  turn_wheel(canvas, shown_panel.pixel(20, 10), 40);
  const SheetView inside = canvas.view();
  shown_panel.panel.light_line(0, 7);
  EXPECT_EQ(canvas.view(), inside);
  shown_panel.panel.light_line(0, 7, true);
  EXPECT_LE(canvas.view().window().left, 0);
  EXPECT_GE(canvas.view().window().right, 40);
}

TEST(Drawing, APartWithErrorsLeavesTheLastGoodDrawingDimAndSaysSo) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  const auto banner = [&]() -> QString {
    for (const auto* label : shown_panel.panel.findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().startsWith(QStringLiteral("The drawing")))
        return label->text();
    }
    return {};
  };
  EXPECT_EQ(banner(), QString());
  const QSize size = canvas.size();
  const QImage good = canvas.grab().toImage();
  shown_panel.panel.show_part(part_of("L1=X0\nL2=\n"));
  EXPECT_TRUE(banner().contains(QStringLiteral("Line 2: "))) << banner().toStdString();
  EXPECT_NE(canvas.grab().toImage(), good);
  shown_panel.panel.show_part(part_of(kRectangle));
  ASSERT_TRUE(settle(shown_panel.panel));
  EXPECT_EQ(banner(), QString());
  QApplication::processEvents();
  EXPECT_EQ(canvas.size(), size);
  EXPECT_EQ(canvas.grab().toImage(), good);
}

TEST(Drawing, WithoutAnyDrawingTheFirstErrorIsTold) {
  DrawingPanel panel;
  panel.resize(600, 400);
  panel.show();
  panel.show_part(part_of("L1=\n"));
  EXPECT_TRUE(panel.is_settled() || settle(panel));
  QTest::keyClick(&panel.canvas(), Qt::Key_Space);
  QTest::mouseClick(&panel.canvas(), Qt::LeftButton, {}, {100, 100});
  panel.grab();
}

TEST(Drawing, WhatIsShownCanBeChosenFromTheMenu) {
  ShownPanel shown_panel(corpus_part("1P.bgt"));
  Canvas& canvas = shown_panel.canvas();
  QSignalSpy programmed(&shown_panel.panel, &DrawingPanel::programmed_shown);
  QSet<QByteArray> seen;
  const auto look = [&] {
    const QImage image = canvas.grab().toImage();
    seen.insert(QByteArray(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes()));
  };
  look();
  QList<QAction*> actions = shown_panel.panel.show_menu().actions();
  actions.removeIf([](const QAction* action) { return !action->isCheckable(); });
  for (QAction* action : actions) {
    action->toggle();
    look();
  }
  EXPECT_EQ(seen.size(), actions.size() + 1) << "each of them changes the drawing";
  EXPECT_EQ(programmed.count(), 1);
  shown_panel.panel.show_programmed(true);
  EXPECT_EQ(programmed.count(), 2);
  EXPECT_TRUE(actions[0]->isChecked());
}

TEST(Drawing, MeasuresBetweenPlacesThatCatchThePointer) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  shown_panel.panel.set_measuring(true);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, shown_panel.pixel(0, 0) + QPoint(4, -3));
  QTest::mouseMove(&canvas, shown_panel.pixel(40, 20) + QPoint(-2, 5));
  EXPECT_TRUE(canvas.hint().contains(QStringLiteral("Distance 44.721 mm")));
  EXPECT_TRUE(canvas.hint().contains(QStringLiteral("dX 40.000")));
  EXPECT_TRUE(canvas.hint().contains(QStringLiteral("dY 20.000")));
  EXPECT_TRUE(canvas.hint().contains(QStringLiteral("angle 26.565°")));
  EXPECT_TRUE(canvas.hint().contains(QStringLiteral("end")));
  QTest::mouseMove(&canvas, shown_panel.pixel(20, 20) + QPoint(3, 2));
  EXPECT_TRUE(canvas.hint().contains(QStringLiteral("middle")));
  QTest::keyClick(&canvas, Qt::Key_Escape);
  EXPECT_FALSE(canvas.is_measuring());
  const double scale = canvas.view().scale;
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, shown_panel.pixel(20, 10));
  EXPECT_EQ(canvas.view().scale, 2 * scale) << "a click magnifies again";
}

TEST(Drawing, TellsTheRadiusOfAnArcThatIsMeasured) {
  ShownPanel shown_panel(part_of("P1=X0Y0\nC1=P1R12.5\nP2=X12.5Y0\nG54P2\nK1 P2 C1 P2\n"));
  Canvas& canvas = shown_panel.canvas();
  shown_panel.panel.set_measuring(true);
  QTest::mouseMove(&canvas, shown_panel.pixel(8.8388, 8.8388));
  EXPECT_TRUE(canvas.hint().contains(QStringLiteral("radius 12.500")))
      << canvas.hint().toStdString();
}

}  // namespace
}  // namespace dgt::studio
