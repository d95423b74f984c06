// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/kerf_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "apps/studio/drawing/strokes.h"

namespace dgt::studio {
namespace {

constexpr double kMargin = 4;  // pixels around the window

/// The border of the window in pixels, y down.
Box border(const SheetView& view) {
  return {-kMargin, -kMargin, view.size.width() + kMargin, view.size.height() + kMargin};
}

/// Keeps what lies on one side: where `inside` is not negative.
template <class Inside>
QPolygonF cut(const QPolygonF& polygon, Inside&& inside) {
  QPolygonF kept;
  for (qsizetype i = 0; i < polygon.size(); ++i) {
    const QPointF a = polygon[i];
    const QPointF b = polygon[(i + 1) % polygon.size()];
    const double at_a = inside(a);
    const double at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

DrawnCurve circle(DrawnPlace centre, double radius) {
  const DrawnPlace from{centre.x + radius, centre.y};
  return {from, from, centre, radius, 2 * std::numbers::pi};
}

class KerfPainter {
 public:
  KerfPainter(QPainter& painter, const SheetView& view)
      : painter_(painter), view_(view), window_(view.window(kMargin)) {}

  void fill(const DrawnCurve& curve, double radius) {
    curve.is_arc() ? fill_ring(curve, radius) : fill_strip(curve, radius);
    fill_disc(curve.from, radius);
    fill_disc(curve.to, radius);
  }
  void fill_disc(DrawnPlace centre, double radius) { fill(disc(view_, centre, radius)); }

 private:
  void fill(const QPolygonF& polygon) {
    const QPolygonF seen = clipped(polygon, border(view_));
    if (!seen.isEmpty()) painter_.drawPolygon(seen);
  }

  void fill_strip(const DrawnCurve& line, double radius) {
    const DrawnPlace side = radius * turned_left(direction_at(line, 0));
    fill({view_.pixel(line.from + side), view_.pixel(line.to + side), view_.pixel(line.to - side),
          view_.pixel(line.from - side)});
  }

  /// Between the two equidistants of an arc; the inner one ends in the centre.
  void fill_ring(const DrawnCurve& arc, double radius) {
    QPolygonF ring = edge(arc, radius);
    const QPolygonF inner = edge(arc, -std::min(radius, arc.radius));
    std::copy(inner.rbegin(), inner.rend(), std::back_inserter(ring));
    fill(ring);
  }
  QPolygonF edge(const DrawnCurve& arc, double outward) const {
    const double side = arc.sweep > 0 ? -outward : outward;
    DrawnCurve edge = arc;
    edge.radius = arc.radius + outward;
    edge.from = arc.from + side * turned_left(direction_at(arc, 0));
    edge.to = arc.to + side * turned_left(direction_at(arc, 1));
    if (!edge.is_arc()) return {view_.pixel(arc.centre)};
    std::vector<DrawnPlace> corners = {edge.from};
    flatten(edge, window_, kFlatness / view_.scale, corners);
    QPolygonF polygon;
    for (const DrawnPlace& corner : corners) polygon.push_back(view_.pixel(corner));
    return polygon;
  }

  QPainter& painter_;
  const SheetView& view_;
  Box window_;
};

}  // namespace

QPolygonF clipped(const QPolygonF& polygon, const Box& window) {
  QPolygonF rest = cut(polygon, [&](QPointF p) { return p.x() - window.left; });
  rest = cut(rest, [&](QPointF p) { return window.right - p.x(); });
  rest = cut(rest, [&](QPointF p) { return p.y() - window.bottom; });
  return cut(rest, [&](QPointF p) { return window.top - p.y(); });
}

QPolygonF disc(const SheetView& view, DrawnPlace centre, double radius) {
  std::vector<DrawnPlace> corners;
  flatten(circle(centre, radius), view.window(kMargin), kFlatness / view.scale, corners);
  QPolygonF polygon;
  for (const DrawnPlace& corner : corners) polygon.push_back(view.pixel(corner));
  return clipped(polygon, border(view));
}

void fill_kerf(QPainter& painter, const SheetView& view, const DrawnPath& path,
               std::uint32_t run_to) {
  double widest = 0;  // pixels
  const DrawnLayer& cuts = path.cuts();
  if (cuts.size() > 0) widest = path.widest_kerf() * view.scale;
  if (widest < kFlatness) return;
  KerfPainter kerf(painter, view);
  const auto curve = [&](std::size_t i) {
    const double radius = path.kerf_radius(cuts.number(i));
    if (cuts.number(i) < run_to && radius > 0) kerf.fill(cuts[i], radius);
  };
  const auto speck = [&](std::size_t first, std::size_t) {
    const double radius = path.kerf_radius(cuts.number(first));
    if (cuts.number(first) < run_to && radius > 0) kerf.fill_disc(cuts.begin_of(first), radius);
  };
  cuts.visit(view.window(widest + kMargin), kFlatness / view.scale, curve, speck);
}

}  // namespace dgt::studio
