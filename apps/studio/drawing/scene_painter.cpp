// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/scene_painter.h"

#include <QImage>
#include <limits>

#include "apps/studio/drawing/kerf_painter.h"
#include "apps/studio/drawing/marks_painter.h"
#include "apps/studio/drawing/strokes.h"

namespace dgt::studio {
namespace {

constexpr double kDash = 5;             // pixels of the screen
constexpr double kProgrammedWidth = 3;  // wider, to be seen under the equidistant where both run
constexpr double kCutWidth = 1.5;
constexpr double kRapidWidth = 1;
constexpr double kLitWidth = 3.5;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The painter draws pens of one pixel ten to a hundred times faster than wider ones. Where there
/// is more than this to be seen, width would be lost in the crowd.
constexpr std::size_t kCrowd = 3000;

class ScenePainter {
 public:
  ScenePainter(QPainter& painter, const SheetView& view, const Look& look)
      : painter_(painter), view_(view), look_(look) {}

  void curves(const DrawnLayer& layer, CurveRange range, QColor colour, double width, bool dim,
              double dash = 0) {
    if (range.first >= range.last) return;
    if (dim || look_.stale) colour = dimmed(colour, look_.colours.sheet);
    const bool crowded = count_strokes(layer, view_, range, kCrowd) >= kCrowd;
    QPen pen(colour, crowded ? look_.pixel : width * look_.pixel);
    if (crowded && look_.pixel < 4) pen.setWidthF(1);  // on a screen; paper has finer pixels
    pen.setCosmetic(true);
    pen.setCapStyle(dash > 0 ? Qt::FlatCap : Qt::RoundCap);
    pen.setJoinStyle(Qt::RoundJoin);
    painter_.setPen(pen);
    stroke_curves(painter_, view_, layer, range, dash * look_.pixel);
  }

  /// The way of the tool in the moves [first, last).
  void way(const DrawnPath& path, std::uint32_t first, std::uint32_t last, bool dim) {
    const auto range = [&](const DrawnLayer& layer) {
      return CurveRange{layer.count_before(first), layer.count_before(last)};
    };
    const Colours& colours = look_.colours;
    if (look_.shown.rapids)
      curves(path.rapids(), range(path.rapids()), colours.rapid, kRapidWidth, dim, kDash);
    curves(path.cuts(), range(path.cuts()), colours.equidistant, kCutWidth, dim);
  }

  /// The moves of one line of the source.
  void lit(const DrawnPath& path) {
    for (const DrawnLayer* layer : {&path.programmed(), &path.rapids(), &path.cuts()}) {
      if (layer == &path.programmed() && !look_.shown.programmed) continue;
      const auto curves = layer->of_line(look_.lit.file, look_.lit.line);
      QPen pen(look_.colours.lit, curves.size() < kCrowd ? kLitWidth * look_.pixel : 1);
      pen.setCosmetic(true);
      pen.setCapStyle(Qt::RoundCap);
      painter_.setPen(pen);
      const Box window = view_.window();
      for (const std::uint32_t i : curves) {
        const DrawnCurve curve = (*layer)[i];
        if (overlap(box_around(curve), window)) stroke_curve(painter_, view_, curve);
      }
    }
  }

  void kerf(const DrawnPath& path) {
    constexpr qreal kOpacity = 0.28;
    QImage layer(view_.size.toSize(), QImage::Format_ARGB32_Premultiplied);
    layer.fill(Qt::transparent);
    QPainter painter(&layer);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(look_.colours.tool);
    fill_kerf(painter, view_, path, look_.run_to);
    painter.end();
    painter_.setOpacity(kOpacity);
    painter_.drawImage(QPointF(0, 0), layer);
    painter_.setOpacity(1);
  }

 private:
  QPainter& painter_;
  const SheetView& view_;
  const Look& look_;
};

}  // namespace

void paint_scene(QPainter& painter, const Scene& scene, const SheetView& view, const Look& look) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(look.font);
  const DrawnPath& path = scene.path;
  ScenePainter work(painter, view, look);
  LabelSpace space(view.size, 4 * look.pixel);
  if (look.shown.kerf) work.kerf(path);
  if (look.shown.programmed) {
    const DrawnLayer& layer = path.programmed();
    work.curves(layer, {0, layer.size()}, look.colours.programmed, kProgrammedWidth, false);
  }
  work.way(path, look.run_to, kNone, true);
  work.way(path, 0, look.run_to, false);
  if (look.lit.line > 0) work.lit(path);
  if (look.shown.directions) paint_directions(painter, view, look, path);
  if (look.shown.sizes) paint_sizes(painter, view, look, path.part_box(), space);
  if (look.shown.points) paint_points(painter, view, look, path, space);
  if (look.shown.names) paint_names(painter, view, look, scene.names, space);
  paint_start(painter, view, look, path.start());
}

void paint_step(QPainter& painter, const SheetView& view, const Look& look, const DrawnPath& path,
                std::size_t step, bool done, double part) {
  const bool rapid = path.is_rapid(step);
  if (rapid && !look.shown.rapids) return;
  const QColor& colour = rapid ? look.colours.rapid : look.colours.equidistant;
  QPen pen(done ? colour : dimmed(colour, look.colours.sheet),
           (rapid ? kRapidWidth : kCutWidth) * look.pixel);
  pen.setCapStyle(rapid ? Qt::FlatCap : Qt::RoundCap);
  painter.setPen(pen);
  stroke_curve(painter, view, beginning_of(path.curve(step), part), rapid ? kDash * look.pixel : 0);
}

int decimals_of(const Settings& settings) {
  constexpr int kUnknown = 3;
  constexpr int kMost = 6;
  if (settings.dialect.name.empty()) return kUnknown;
  int decimals = 0;
  for (Rational unit = settings.dialect.unit; unit < 1 && decimals < kMost; unit *= 10) ++decimals;
  return decimals;
}

}  // namespace dgt::studio
