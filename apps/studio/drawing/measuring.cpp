// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/measuring.h"

#include <QStringList>

#include "apps/studio/drawing/figure_text.h"
#include "apps/studio/drawing/marks_painter.h"
#include "apps/studio/drawing/strokes.h"

namespace dgt::studio {
namespace {

QString name_of(SnapKind kind) {
  switch (kind) {
    case SnapKind::Free:
      return Measuring::tr("free place");
    case SnapKind::End:
      return Measuring::tr("end");
    case SnapKind::Middle:
      return Measuring::tr("middle");
    case SnapKind::Centre:
      return Measuring::tr("centre");
    case SnapKind::Tangent:
      return Measuring::tr("tangent");
    case SnapKind::Perpendicular:
      return Measuring::tr("perpendicular");
    case SnapKind::OnMove:
      return Measuring::tr("on the contour");
  }
  return {};
}

/// Each kind has its own mark, as in other drawing programs.
void paint_mark(QPainter& painter, QPointF at, SnapKind kind, double size) {
  switch (kind) {
    case SnapKind::End:
      painter.drawRect(QRectF(at.x() - size, at.y() - size, 2 * size, 2 * size));
      return;
    case SnapKind::Middle:
      painter.drawPolygon(
          QPolygonF{at + QPointF(0, -size), at + QPointF(size, size), at + QPointF(-size, size)});
      return;
    case SnapKind::Centre:
      painter.drawEllipse(at, size, size);
      painter.drawLine(at - QPointF(size, 0), at + QPointF(size, 0));
      painter.drawLine(at - QPointF(0, size), at + QPointF(0, size));
      return;
    case SnapKind::Tangent:
      painter.drawEllipse(at, size, size);
      painter.drawLine(at + QPointF(-size, -size), at + QPointF(size, -size));
      return;
    case SnapKind::Perpendicular:
      painter.drawPolyline(QPolygonF{at + QPointF(-size, -size), at + QPointF(-size, size),
                                     at + QPointF(size, size)});
      painter.drawPolyline(QPolygonF{at + QPointF(-size, 0), at, at + QPointF(0, size)});
      return;
    case SnapKind::OnMove:
    case SnapKind::Free:
      painter.drawLine(at - QPointF(size, size), at + QPointF(size, size));
      painter.drawLine(at - QPointF(size, -size), at + QPointF(size, -size));
      return;
  }
}

}  // namespace

void Measuring::point(const std::vector<const DrawnLayer*>& layers, DrawnPlace pointer,
                      double reach) {
  const bool is_second = first_ && !second_;
  pointed_ = snap(layers, pointer, reach,
                  is_second ? std::optional<DrawnPlace>(first_->at) : std::nullopt);
}

void Measuring::take() {
  if (!pointed_) return;
  if (!first_ || second_) {
    first_ = pointed_;
    second_.reset();
  } else {
    second_ = pointed_;
  }
}

void Measuring::clear() {
  first_.reset();
  second_.reset();
}

std::optional<Measurement> Measuring::measurement() const {
  const auto to = end();
  if (!first_ || !to) return std::nullopt;
  return measured(first_->at, to->at);
}

QString Measuring::text(int decimals) const {
  QStringList parts;
  if (const auto m = measurement()) {
    parts << tr("Distance %1 mm").arg(figure_text(m->distance, decimals))
          << tr("dX %1").arg(figure_text(m->dx, decimals))
          << tr("dY %1").arg(figure_text(m->dy, decimals))
          << tr("angle %1°").arg(figure_text(m->degrees, 3));
  }
  if (pointed_) {
    if (pointed_->curve && pointed_->curve->is_arc())
      parts << tr("radius %1").arg(figure_text(pointed_->curve->radius, decimals));
    parts << name_of(pointed_->kind);
  }
  return parts.join(QStringLiteral("   "));
}

void Measuring::paint(QPainter& painter, const SheetView& view, const Look& look) const {
  const double size = 5 * look.pixel;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(look.colours.measure, 1.5 * look.pixel));
  const auto to = end();
  if (first_ && to) stroke_curve(painter, view, {first_->at, to->at, {}, 0, 0});
  for (const auto& place : {first_, second_, pointed_}) {
    if (place) paint_mark(painter, view.pixel(place->at), place->kind, size);
  }
  const auto m = measurement();
  if (!m) return;
  const QPointF middle = (view.pixel(first_->at) + view.pixel(to->at)) / 2;
  paint_label(painter, middle + QPointF(2 * size, -2 * size),
              figure_text(m->distance, look.decimals), look.colours.measure, look.colours.sheet);
}

}  // namespace dgt::studio
