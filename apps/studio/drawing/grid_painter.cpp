// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/grid_painter.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace dgt::studio {
namespace {

/// Lines that stand at whole multiples of a step; counted, since repeated sums would drift.
struct Ruler {
  double step = 1;
  double first = 0;  ///< of the lines that are seen, counted from 0
  double last = 0;

  Ruler(double apart, double low, double high)
      : step(apart), first(std::ceil(low / apart)), last(std::floor(high / apart)) {}
  template <class Visit>
  void visit(Visit&& line) const {
    for (double i = first; i <= last; ++i) line(i * step, std::fmod(i, 5) == 0);
  }
};

/// As short as it can be: a multiple of 1, 2.5 or 5 · 10ⁿ.
QString short_figure(double value, double step) {
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(step))));
  QString text = QString::number(value, 'f', decimals);
  while (text.contains(u'.') && text.endsWith(u'0')) text.chop(1);
  if (text.endsWith(u'.')) text.chop(1);
  return text == u"-0" ? QStringLiteral("0") : text;
}

class GridPainter {
 public:
  GridPainter(QPainter& painter, const SheetView& view, const Look& look)
      : painter_(painter), view_(view), look_(look) {}

  void paint() {
    constexpr double kLeastGap = 16;  // pixels of the screen between two lines
    const double step = grid_step(kLeastGap * look_.pixel / view_.scale);
    const Box window = view_.window();
    const Ruler across(step, window.left, window.right);
    const Ruler up(step, window.bottom, window.top);
    painter_.save();
    painter_.setRenderHint(QPainter::Antialiasing, false);
    for (const bool strong : {false, true}) {
      QColor colour = look_.colours.grid;
      if (!strong) colour.setAlphaF(0.5F);
      painter_.setPen(QPen(colour, look_.pixel));
      across.visit([&](double x, bool fifth) {
        if (fifth == strong) upright(x);
      });
      up.visit([&](double y, bool fifth) {
        if (fifth == strong) level(y);
      });
    }
    painter_.setPen(QPen(look_.colours.axes, look_.pixel));
    if (window.left <= 0 && window.right >= 0) upright(0);
    if (window.bottom <= 0 && window.top >= 0) level(0);
    painter_.restore();
    figures(Ruler(5 * step, window.left, window.right), Ruler(5 * step, window.bottom, window.top));
  }

 private:
  void upright(double x) {
    const double at = std::floor(view_.pixel({x, 0}).x()) + 0.5;
    painter_.drawLine(QPointF(at, 0), QPointF(at, view_.size.height()));
  }
  void level(double y) {
    const double at = std::floor(view_.pixel({0, y}).y()) + 0.5;
    painter_.drawLine(QPointF(0, at), QPointF(view_.size.width(), at));
  }

  void figures(const Ruler& across, const Ruler& up) {
    const QFontMetricsF metrics(painter_.font(), painter_.device());
    const double gap = 0.3 * metrics.height();
    painter_.setPen(look_.colours.axes);
    const double base = view_.size.height() - gap;
    double taken = 2.5 * metrics.height();  // the corner is left free
    across.visit([&](double x, bool) {
      const QString text = short_figure(x, across.step);
      const double width = metrics.horizontalAdvance(text);
      const double left = view_.pixel({x, 0}).x() + gap;
      if (left < taken || left + width > view_.size.width()) return;
      painter_.drawText(QPointF(left, base), text);
      taken = left + width + 2 * gap;
    });
    const double lowest = base - 1.2 * metrics.height();
    up.visit([&](double y, bool) {
      const double at = view_.pixel({0, y}).y() - gap;
      if (at > lowest || at < metrics.height()) return;
      painter_.drawText(QPointF(gap, at), short_figure(y, up.step));
    });
  }

  QPainter& painter_;
  const SheetView& view_;
  const Look& look_;
};

}  // namespace

double grid_step(double least) {
  double step = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * step >= least) return factor * step;
  }
  return 10 * step;
}

void paint_grid(QPainter& painter, const SheetView& view, const Look& look) {
  GridPainter(painter, view, look).paint();
}

}  // namespace dgt::studio
