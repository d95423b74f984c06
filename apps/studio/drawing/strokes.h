// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPolygonF>
#include <vector>

#include "apps/driver/drawn_layer.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {

/// How far a drawn line may be from what it stands for, in pixels.
inline constexpr double kFlatness = 0.25;

/// Draws chains of strokes in pixels.
///  (1) What lies outside the window is cut off in doubles before the painter's smaller numbers
///      could overflow.
///  (2) Corners within kFlatness of the last one drawn are left out, so that a frame costs what is
///      seen and not what there is.
///  (3) Few strokes are handed over at a time: the painter takes a chain at once, and more than in
///      proportion to its length.
class Strokes {
 public:
  /// `margin`: pixels around the window in which strokes are still to be drawn.
  Strokes(QPainter& painter, QSizeF window, double margin);
  ~Strokes() { end(); }
  Strokes(const Strokes&) = delete;
  Strokes& operator=(const Strokes&) = delete;

  void begin(QPointF at);
  void line_to(QPointF at);
  void end();
  /// Drawn with dashes of that many pixels; 0: drawn through. They begin at `begin`, wherever that
  /// lies, and so do not creep when the drawing is moved.
  void set_dash(double pixels) { dash_ = pixels; }

 private:
  void stroke(QPointF from, QPointF to);
  void dashes(QPointF from, QPointF to, double before);
  void flush();

  QPainter& painter_;
  double left_, top_, right_, bottom_;
  QPolygonF chain_;
  QPointF pen_;     ///< where the last stroke ended
  QPointF last_;    ///< the last corner, drawn or left out
  double way_ = 0;  ///< pixels, from `begin` to the pen
  double dash_ = 0;
  bool drawing_ = false;
};

/// The part [from, to] of a stroke within an upright rectangle, as parts 0…1 of it; false: none.
[[nodiscard]] bool clip(QPointF from, QPointF to, const Box& window, double& begin, double& end);

/// Which curves of a layer are drawn.
struct CurveRange {
  std::size_t first = 0;
  std::size_t last = 0;
};
/// How many strokes a range comes to at least; counting ends at `enough`.
[[nodiscard]] std::size_t count_strokes(const DrawnLayer& layer, const SheetView& view,
                                        CurveRange range, std::size_t enough);
/// Draws the curves with the painter's pen; `dash`: see Strokes.
void stroke_curves(QPainter& painter, const SheetView& view, const DrawnLayer& layer,
                   CurveRange range, double dash = 0);
/// The same for one curve.
void stroke_curve(QPainter& painter, const SheetView& view, const DrawnCurve& curve,
                  double dash = 0);

}  // namespace dgt::studio
