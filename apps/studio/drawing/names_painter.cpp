// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFontMetricsF>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "apps/studio/drawing/marks_painter.h"
#include "apps/studio/drawing/strokes.h"

namespace dgt::studio {
namespace {

/// Where an element may carry its name: beside a place on it, and the way it runs there.
struct Perch {
  QPointF on;
  QPointF along;
};

class NamesPainter {
 public:
  NamesPainter(QPainter& painter, const SheetView& view, const Look& look, LabelSpace& space)
      : painter_(painter),
        view_(view),
        look_(look),
        space_(space),
        metrics_(painter.font(), painter.device()) {}

  void paint(const NamedShape& named) {
    std::visit([&](const auto& shape) { paint(QString::fromStdString(named.name), shape); },
               named.shape);
  }

 private:
  void paint(const QString& name, const Line& line) {
    const auto seen = stroke(line);
    if (!seen) return;
    const auto [from, to] = *seen;
    const QPointF way = to - from;
    const double whole = std::hypot(way.x(), way.y());
    std::vector<Perch> perches;
    // Best near the end that the line runs to.
    const double step = 1.5 * metrics_.height();
    for (double back = 1.5 * step; back < whole; back += step)
      perches.push_back({to - back / whole * way, way / whole});
    label(name, perches, true);
  }

  void paint(const QString& name, const Circle& circle) {
    const DrawnPlace centre{coordinate(circle.centre().x), coordinate(circle.centre().y)};
    const double radius = nearest_double(abs(circle.radius()));
    const double sense = circle.counter_clockwise() ? 1 : -1;
    const DrawnPlace right{centre.x + radius, centre.y};
    set_pen();
    stroke_curve(painter_, view_, {right, right, centre, radius, 2 * std::numbers::pi});
    std::vector<Perch> perches;
    constexpr int kSectors = 24;
    for (int i = 0; i < kSectors; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 3) / kSectors;
      const DrawnPlace out{std::cos(angle), std::sin(angle)};
      perches.push_back({view_.pixel(centre + radius * out),
                         sense * QPointF(-std::sin(angle), -std::cos(angle))});
    }
    label(name, perches, true);
  }

  void paint(const QString& name, const NamedSpot& spot) {
    const QPointF at = view_.pixel({spot.x, spot.y});
    if (spot.dot) {
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(look_.colours.element);
      painter_.drawEllipse(at, 2.5 * look_.pixel, 2.5 * look_.pixel);
    }
    label(name, {{at, {1, 0}}, {at, {0, 1}}}, false);
  }

  void paint(const QString& name, const NamedAxes& axes) {
    const QPointF at = view_.pixel({axes.x, axes.y});
    const double length = 2.5 * metrics_.height();
    painter_.setPen(QPen(look_.colours.element, 1.5 * look_.pixel));
    for (const QPointF axis :
         {QPointF(axes.along_x, -axes.along_y), QPointF(-axes.along_y, -axes.along_x)}) {
      painter_.drawLine(at, at + length * axis);
      head(at + length * axis, axis);
    }
    label(name, {{at, {1, 0}}, {at, {0, 1}}}, false);
  }

  void set_pen() {
    painter_.setPen(QPen(dimmed(look_.colours.element, look_.colours.sheet), look_.pixel));
    painter_.setBrush(Qt::NoBrush);
  }

  /// Across the window.
  std::optional<std::pair<QPointF, QPointF>> stroke(const Line& line) {
    const DrawnPlace along{nearest_double(line.direction().x()),
                           nearest_double(line.direction().y())};
    const RationalPoint nearest_point =
        line.foot({Rational(view_.centre.x), Rational(view_.centre.y)});
    const QPointF foot = view_.pixel({coordinate(nearest_point.x), coordinate(nearest_point.y)});
    const QPointF way(along.x, -along.y);
    const double reach = 2 * (view_.size.width() + view_.size.height());
    const Box window{0, 0, view_.size.width(), view_.size.height()};
    double begin = 0;
    double end = 1;
    const QPointF from = foot - reach * way;
    const QPointF to = foot + reach * way;
    if (!clip(from, to, window, begin, end)) return std::nullopt;
    set_pen();
    const std::pair seen(from + begin * (to - from), from + end * (to - from));
    painter_.drawLine(seen.first, seen.second);
    return seen;
  }

  void head(QPointF tip, QPointF along) {
    const double size = 7 * look_.pixel;
    const QPointF across(-along.y(), along.x());
    painter_.drawLine(tip, tip - size * along + 0.5 * size * across);
    painter_.drawLine(tip, tip - size * along - 0.5 * size * across);
  }

  void label(const QString& name, const std::vector<Perch>& perches, bool with_head) {
    const QSizeF size(metrics_.horizontalAdvance(name), metrics_.ascent());
    for (const Perch& perch : perches) {
      for (const double side : {1.0, -1.0}) {
        const QPointF across = side * QPointF(-perch.along.y(), perch.along.x());
        const double gap = 0.4 * size.height() + 0.5 * (std::fabs(across.x()) * size.width() +
                                                        std::fabs(across.y()) * size.height());
        const QPointF middle = perch.on + gap * across;
        const QRectF letters(middle - QPointF(size.width() / 2, size.height() / 2), size);
        if (!space_.is_free(letters)) continue;
        space_.take(letters);
        painter_.setPen(QPen(look_.colours.element, 1.5 * look_.pixel));
        if (with_head) head(perch.on, perch.along);
        paint_label(painter_, letters.bottomLeft(), name, look_.colours.element,
                    look_.colours.sheet);
        return;
      }
    }
  }

  QPainter& painter_;
  const SheetView& view_;
  const Look& look_;
  LabelSpace& space_;
  QFontMetricsF metrics_;
};

}  // namespace

void paint_names(QPainter& painter, const SheetView& view, const Look& look,
                 const std::vector<NamedShape>& names, LabelSpace& space) {
  NamesPainter work(painter, view, look, space);
  for (const NamedShape& named : names) work.paint(named);
}

}  // namespace dgt::studio
