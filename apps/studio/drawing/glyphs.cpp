// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/glyphs.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>

namespace dgt::studio {
namespace {

constexpr double kGrid = 16;  // glyphs are drawn in a square of this side

void triangle(QPainter& painter, double foot, double tip) {
  painter.drawPolygon(QPolygonF{{foot, 3}, {tip, 8}, {foot, 13}});
}

void bar(QPainter& painter, double left) { painter.drawRect(QRectF(left, 3, 2, 10)); }

void lens(QPainter& painter, bool plus) {
  painter.drawEllipse(QPointF(7, 7), 5, 5);
  painter.drawLine(QPointF(10.8, 10.8), QPointF(14.5, 14.5));
  painter.drawLine(QPointF(4.5, 7), QPointF(9.5, 7));
  if (plus) painter.drawLine(QPointF(7, 4.5), QPointF(7, 9.5));
}

void corners(QPainter& painter) {
  for (const QPointF at : {QPointF(2, 2), QPointF(14, 2), QPointF(2, 14), QPointF(14, 14)}) {
    const double x = at.x() < 8 ? 4 : -4;
    const double y = at.y() < 8 ? 4 : -4;
    painter.drawLine(at, at + QPointF(x, 0));
    painter.drawLine(at, at + QPointF(0, y));
  }
  painter.drawRect(QRectF(5.5, 5.5, 5, 5));
}

void dimension(QPainter& painter) {
  painter.drawLine(QPointF(2, 3), QPointF(2, 13));
  painter.drawLine(QPointF(14, 3), QPointF(14, 13));
  painter.drawLine(QPointF(2, 8), QPointF(14, 8));
  painter.drawPolyline(QPolygonF{{5, 5.5}, {2.4, 8}, {5, 10.5}});
  painter.drawPolyline(QPolygonF{{11, 5.5}, {13.6, 8}, {11, 10.5}});
}

void draw(QPainter& painter, Glyph glyph) {
  switch (glyph) {
    case Glyph::Fit:
      return corners(painter);
    case Glyph::ZoomIn:
      return lens(painter, true);
    case Glyph::ZoomOut:
      return lens(painter, false);
    case Glyph::Measure:
      return dimension(painter);
    case Glyph::Start:
      bar(painter, 2);
      return triangle(painter, 13, 5);
    case Glyph::Back:
      return triangle(painter, 11, 4);
    case Glyph::Run:
      return triangle(painter, 4, 13);
    case Glyph::Pause:
      bar(painter, 4.5);
      return bar(painter, 9.5);
    case Glyph::Step:
      return triangle(painter, 5, 12);
    case Glyph::End:
      bar(painter, 12);
      return triangle(painter, 3, 11);
  }
}

bool is_filled(Glyph glyph) {
  return glyph != Glyph::Fit && glyph != Glyph::ZoomIn && glyph != Glyph::ZoomOut &&
         glyph != Glyph::Measure;
}

class GlyphEngine : public QIconEngine {
 public:
  explicit GlyphEngine(Glyph glyph) : glyph_(glyph) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const QColor colour = QGuiApplication::palette().color(group, QPalette::ButtonText);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / kGrid, rect.height() / kGrid);
    painter->setPen(is_filled(glyph_) ? QPen(Qt::NoPen)
                                      : QPen(colour, 1.4, Qt::SolidLine, Qt::RoundCap));
    painter->setBrush(is_filled(glyph_) ? QBrush(colour) : QBrush(Qt::NoBrush));
    draw(*painter, glyph_);
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect({0, 0}, size), mode, state);
    return pixmap;
  }
  [[nodiscard]] QIconEngine* clone() const override { return new GlyphEngine(glyph_); }

 private:
  Glyph glyph_;
};

}  // namespace

QIcon icon_of(Glyph glyph) { return QIcon(new GlyphEngine(glyph)); }

}  // namespace dgt::studio
