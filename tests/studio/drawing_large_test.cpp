// SPDX-License-Identifier: GPL-3.0-or-later
// Many moves, parts that follow each other quickly, and paper.
#include <gmock/gmock.h>

#include <QElapsedTimer>
#include <QImage>
#include <QPainter>

#include "tests/studio/drawing_parts.h"

namespace dgt::studio {
namespace {

TEST(Drawing, AHundredThousandMovesAreDrawnWithoutFreezingTheWindow) {
  DrawingPanel panel;
  panel.resize(900, 700);
  panel.show();
  const PartPtr part = many_moves(100001);
  ASSERT_NE(part->path(), nullptr);
  ASSERT_GE(part->path()->moves.size(), 100000U);
  panel.show_part(part);
  ASSERT_TRUE(settle(panel));
  Canvas& canvas = panel.canvas();
  const QImage whole = canvas.grab().toImage();
  QElapsedTimer clock;
  clock.start();
  constexpr int kFrames = 20;
  for (int i = 0; i < kFrames; ++i) {
    QTest::keyClick(&canvas, Qt::Key_Right);
    canvas.repaint();
  }
  // Frames take some milliseconds; the bound leaves room for sanitizers and busy machines.
  EXPECT_LT(clock.elapsed(), kFrames * 200);
  ASSERT_TRUE(settle(panel));
  EXPECT_NE(canvas.grab().toImage(), whole);
  QTest::keyClick(&canvas, Qt::Key_0);
  ASSERT_TRUE(settle(panel));
  EXPECT_EQ(canvas.grab().toImage(), whole);
}

TEST(Drawing, ANewerPartReplacesOneThatIsStillBeingPrepared) {
  DrawingPanel panel;
  panel.resize(900, 700);
  panel.show();
  panel.show_part(many_moves(50000));
  panel.show_part(part_of(kRectangle));
  ASSERT_TRUE(settle(panel));
  EXPECT_EQ(panel.tool().steps(), 4U);
}

TEST(Drawing, IsPaintedOnPaperAsAWhole) {
  ShownPanel shown_panel(part_of(kRectangle));
  QImage paper(600, 400, QImage::Format_ARGB32_Premultiplied);
  paper.fill(Qt::white);
  QPainter painter(&paper);
  shown_panel.panel.paint(painter, QRect(100, 50, 400, 300));
  painter.end();
  QRect ink;
  for (int y = 0; y < paper.height(); ++y) {
    for (int x = 0; x < paper.width(); ++x) {
      if (paper.pixelColor(x, y) != Qt::white) ink |= QRect(x, y, 1, 1);
    }
  }
  EXPECT_TRUE(QRect(100, 50, 400, 300).contains(ink));
  EXPECT_NEAR(ink.width(), 376, 40) << "the rectangle fills the breadth";
}

}  // namespace
}  // namespace dgt::studio
