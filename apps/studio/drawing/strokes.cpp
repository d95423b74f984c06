// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/strokes.h"

#include <algorithm>
#include <cmath>

namespace dgt::studio {
namespace {

constexpr qsizetype kChain = 128;  // strokes

bool are_near(QPointF a, QPointF b) {
  return std::fabs(a.x() - b.x()) < kFlatness && std::fabs(a.y() - b.y()) < kFlatness;
}

double length(QPointF a) { return std::hypot(a.x(), a.y()); }

/// Narrows [begin, end] to where from + t·way lies in [low, high].
bool narrow(double from, double way, double low, double high, double& begin, double& end) {
  if (way == 0) return from >= low && from <= high;
  const double a = (low - from) / way;
  const double b = (high - from) / way;
  begin = std::max(begin, std::min(a, b));
  end = std::min(end, std::max(a, b));
  return begin <= end;
}

/// Strokes of curves, flattened where the window shows them.
class CurveStrokes {
 public:
  CurveStrokes(QPainter& painter, const SheetView& view, double dash)
      : view_(view),
        window_(view.window(margin(painter))),
        strokes_(painter, view.size, margin(painter)) {
    strokes_.set_dash(dash);
  }
  [[nodiscard]] const Box& window() const { return window_; }

  void begin(DrawnPlace at) { strokes_.begin(view_.pixel(at)); }
  void add(const DrawnCurve& curve) {
    corners_.clear();
    flatten(curve, window_, kFlatness / view_.scale, corners_);
    for (const DrawnPlace& corner : corners_) strokes_.line_to(view_.pixel(corner));
  }
  void line_to(DrawnPlace at) { strokes_.line_to(view_.pixel(at)); }

 private:
  static double margin(const QPainter& painter) { return 2 + 2 * painter.pen().widthF(); }

  const SheetView& view_;
  Box window_;
  Strokes strokes_;
  std::vector<DrawnPlace> corners_;
};

}  // namespace

bool clip(QPointF from, QPointF to, const Box& window, double& begin, double& end) {
  begin = 0;
  end = 1;
  return narrow(from.x(), to.x() - from.x(), window.left, window.right, begin, end) &&
         narrow(from.y(), to.y() - from.y(), window.bottom, window.top, begin, end);
}

Strokes::Strokes(QPainter& painter, QSizeF window, double margin)
    : painter_(painter),
      left_(-margin),
      top_(-margin),
      right_(window.width() + margin),
      bottom_(window.height() + margin) {
  chain_.reserve(kChain + 1);
}

void Strokes::begin(QPointF at) {
  end();
  pen_ = last_ = at;
  way_ = 0;
  drawing_ = true;
}

void Strokes::line_to(QPointF at) {
  last_ = at;
  if (are_near(pen_, at)) return;
  stroke(pen_, at);
  pen_ = at;
}

// A chain of no size is a dot.
void Strokes::end() {
  if (!drawing_) return;
  if (last_ != pen_) stroke(pen_, last_);
  const bool is_dot = way_ == 0 && last_.x() >= left_ && last_.x() <= right_ && last_.y() >= top_ &&
                      last_.y() <= bottom_;
  if (is_dot) painter_.drawPoint(last_);
  flush();
  drawing_ = false;
}

void Strokes::stroke(QPointF from, QPointF to) {
  const double before = way_;
  way_ += length(to - from);
  double begin = 0;
  double end = 1;
  if (!clip(from, to, {left_, top_, right_, bottom_}, begin, end)) return flush();
  const QPointF way = to - from;
  const QPointF entry = begin > 0 ? from + begin * way : from;
  const QPointF exit = end < 1 ? from + end * way : to;
  if (dash_ > 0) return dashes(entry, exit, before + begin * length(way));
  if (begin > 0 || chain_.isEmpty()) {
    flush();
    chain_.push_back(entry);
  }
  chain_.push_back(exit);
  if (end < 1) return flush();
  if (chain_.size() <= kChain) return;
  flush();
  chain_.push_back(exit);
}

void Strokes::dashes(QPointF from, QPointF to, double before) {
  const double whole = length(to - from);
  const QPointF along = (to - from) / whole;
  const double period = 2 * dash_;
  for (double at = -std::fmod(before, period); at < whole; at += period) {
    const double begin = std::max(at, 0.0);
    const double end = std::min(at + dash_, whole);
    if (end > begin) painter_.drawLine(from + begin * along, from + end * along);
  }
}

void Strokes::flush() {
  if (chain_.size() > 1) painter_.drawPolyline(chain_);
  chain_.clear();
}

std::size_t count_strokes(const DrawnLayer& layer, const SheetView& view, CurveRange range,
                          std::size_t enough) {
  std::size_t count = 0;
  const auto is_in = [&](std::size_t i) { return i >= range.first && i < range.last; };
  const auto curve = [&](std::size_t i) { count += is_in(i) ? 1 : 0; };
  const auto speck = [&](std::size_t first, std::size_t) { count += is_in(first) ? 1 : 0; };
  layer.visit(view.window(), kFlatness / view.scale, curve, speck);
  return std::min(count, enough);
}

void stroke_curves(QPainter& painter, const SheetView& view, const DrawnLayer& layer,
                   CurveRange range, double dash) {
  CurveStrokes strokes(painter, view, dash);
  std::size_t next = 0;  // the curve that would go on from the last
  const auto go_to = [&](std::size_t i) {
    const bool goes_on = i > 0 && next == i && layer.end_of(i - 1) == layer.begin_of(i);
    if (!goes_on) strokes.begin(layer.begin_of(i));
  };
  const auto curve = [&](std::size_t i) {
    if (i < range.first || i >= range.last) return;
    go_to(i);
    strokes.add(layer[i]);
    next = i + 1;
  };
  const auto speck = [&](std::size_t first, std::size_t last) {
    first = std::max(first, range.first);
    last = std::min(last, range.last);
    if (first >= last) return;
    go_to(first);
    strokes.line_to(layer.end_of(last - 1));
    next = last;
  };
  layer.visit(strokes.window(), kFlatness / view.scale, curve, speck);
}

void stroke_curve(QPainter& painter, const SheetView& view, const DrawnCurve& curve, double dash) {
  CurveStrokes strokes(painter, view, dash);
  strokes.begin(curve.from);
  strokes.add(curve);
}

}  // namespace dgt::studio
