// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/marks_painter.h"

#include <QFontMetricsF>
#include <algorithm>
#include <optional>

#include "apps/studio/drawing/figure_text.h"

namespace dgt::studio {
namespace {

QPointF on_screen(DrawnPlace direction) { return {direction.x, -direction.y}; }

void paint_head(QPainter& painter, QPointF middle, QPointF along, double size) {
  const QPointF across(-along.y(), along.x());
  const QPointF tip = middle + 0.5 * size * along;
  const QPointF foot = middle - 0.5 * size * along;
  painter.drawPolygon(QPolygonF{tip, foot + 0.4 * size * across, foot - 0.4 * size * across});
}

/// Dots and numbers. In a crowd only what finds room for its number is marked: dots alone would
/// hide the drawing and tell nothing.
class PointsPainter {
 public:
  PointsPainter(QPainter& painter, const SheetView& view, const Look& look, LabelSpace& space)
      : painter_(painter),
        look_(look),
        view_(view),
        space_(space),
        metrics_(painter.font(), painter.device()),
        radius_(2.5 * look.pixel),
        window_(view.window(radius_)) {}

  void paint(const DrawnPath& path) {
    constexpr std::size_t kCrowd = 1500;
    std::size_t count = 0;
    visit(path, [&](DrawnPlace, std::size_t) { ++count; });
    crowded_ = count > kCrowd;
    visit(path, [&](DrawnPlace place, std::size_t number) { mark(place, number); });
  }

 private:
  /// Calls `point(place, number)` for the points in the window; of moves too short to be seen for
  /// none.
  template <class Visit>
  void visit(const DrawnPath& path, Visit&& point) const {
    if (is_seen(path.start())) point(path.start(), 1);
    const double small = 2 * radius_ / view_.scale;
    for (const DrawnLayer* layer : {&path.cuts(), &path.rapids()}) {
      const auto curve = [&](std::size_t i) {
        const DrawnPlace end = layer->end_of(i);
        if (is_seen(end)) point(end, path.step_of(layer->number(i)) + 2);
      };
      layer->visit(window_, small, curve, [](std::size_t, std::size_t) {});
    }
  }
  [[nodiscard]] bool is_seen(DrawnPlace place) const {
    return overlap(window_, {place.x, place.y, place.x, place.y});
  }

  void mark(DrawnPlace place, std::size_t number) {
    const QPointF at = view_.pixel(place);
    const QString text = QString::number(number);
    const auto base = room_for(at, text);
    if (!base && crowded_) return;
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(look_.colours.points);
    painter_.drawEllipse(at, radius_, radius_);
    if (base) paint_label(painter_, *base, text, look_.colours.points, look_.colours.sheet);
  }

  std::optional<QPointF> room_for(QPointF at, const QString& text) {
    const double gap = 2 * radius_;
    const QSizeF size(metrics_.horizontalAdvance(text), metrics_.ascent());
    const double right = at.x() + gap;
    const double left = at.x() - gap - size.width();
    const double above = at.y() - gap;
    const double below = at.y() + gap + size.height();
    for (const QPointF base : {QPointF(right, above), QPointF(left, above), QPointF(right, below),
                               QPointF(left, below)}) {
      const QRectF letters(base - QPointF(0, size.height()), size);
      if (!space_.is_free(letters)) continue;
      space_.take(letters);
      return base;
    }
    return std::nullopt;
  }

  QPainter& painter_;
  const Look& look_;
  const SheetView& view_;
  LabelSpace& space_;
  QFontMetricsF metrics_;
  double radius_;
  Box window_;
  bool crowded_ = false;
};

}  // namespace

void paint_label(QPainter& painter, QPointF base, const QString& text, const QColor& colour,
                 const QColor& sheet) {
  constexpr int kRim = 1;
  painter.setPen(sheet);
  for (const int dx : {-kRim, 0, kRim}) {
    for (const int dy : {-kRim, 0, kRim}) {
      if (dx != 0 || dy != 0) painter.drawText(base + QPointF(dx, dy), text);
    }
  }
  painter.setPen(colour);
  painter.drawText(base, text);
}

void paint_directions(QPainter& painter, const SheetView& view, const Look& look,
                      const DrawnPath& path) {
  const double size = 9 * look.pixel;
  const double least = 3 * size;  // a shorter cut has no room
  painter.setPen(Qt::NoPen);
  const DrawnLayer& cuts = path.cuts();
  const auto curve = [&](std::size_t i) {
    const DrawnCurve cut = cuts[i];
    if (cut.length() * view.scale < least) return;
    const bool done = cuts.number(i) < look.run_to && !look.stale;
    const QColor& colour = look.colours.equidistant;
    painter.setBrush(done ? colour : dimmed(colour, look.colours.sheet));
    paint_head(painter, view.pixel(place_at(cut, 0.5)), on_screen(direction_at(cut, 0.5)), size);
  };
  cuts.visit(view.window(size), least / 4 / view.scale, curve, [](std::size_t, std::size_t) {});
}

void paint_points(QPainter& painter, const SheetView& view, const Look& look, const DrawnPath& path,
                  LabelSpace& space) {
  PointsPainter(painter, view, look, space).paint(path);
}

void paint_sizes(QPainter& painter, const SheetView& view, const Look& look, const Box& box,
                 LabelSpace& space) {
  if (box.empty()) return;
  const QFontMetricsF metrics(painter.font(), painter.device());
  const QPointF lower = view.pixel({box.left, box.bottom});
  const QPointF upper = view.pixel({box.right, box.top});
  QPen pen(look.colours.axes, look.pixel);
  pen.setDashPattern({2, 3});
  painter.setPen(pen);
  const double border = look.pixel * 4;
  const auto in_window = [&](double at, double end) {
    return std::clamp(at, -border, end + border);
  };
  const QRectF frame(
      QPointF(in_window(lower.x(), view.size.width()), in_window(upper.y(), view.size.height())),
      QPointF(in_window(upper.x(), view.size.width()), in_window(lower.y(), view.size.height())));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(frame);
  const double gap = 0.35 * metrics.height();
  const auto label = [&](QPointF middle, const QString& text) {
    const double width = metrics.horizontalAdvance(text);
    const QPointF base(
        std::clamp(middle.x() - width / 2, 0.0, std::max(0.0, view.size.width() - width)),
        std::clamp(middle.y(), metrics.height(),
                   std::max(metrics.height(), view.size.height() - gap)));
    space.take({base.x(), base.y() - metrics.ascent(), width, metrics.ascent()});
    paint_label(painter, base, text, look.colours.text, look.colours.sheet);
  };
  label({frame.center().x(), frame.top() - gap}, figure_text(box.width(), look.decimals));
  const QString height = figure_text(box.height(), look.decimals);
  const double half = metrics.horizontalAdvance(height) / 2;
  label({frame.right() + half + gap, frame.center().y() + metrics.ascent() / 2}, height);
}

// A cross in a circle: the place where the wire is threaded or the torch begins.
void paint_start(QPainter& painter, const SheetView& view, const Look& look, DrawnPlace start) {
  const QPointF at = view.pixel(start);
  const double radius = 5 * look.pixel;
  painter.setPen(QPen(look.colours.text, 1.5 * look.pixel));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(at, radius, radius);
  for (const QPointF arm : {QPointF(1.6 * radius, 0), QPointF(0, 1.6 * radius)})
    painter.drawLine(at - arm, at + arm);
}

}  // namespace dgt::studio
