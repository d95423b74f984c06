// SPDX-License-Identifier: GPL-3.0-or-later
// What the canvas shows; canvas_events.cpp has what a person does to it.
#include "apps/studio/drawing/canvas.h"

#include <QFontInfo>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "apps/studio/drawing/grid_painter.h"
#include "apps/studio/drawing/kerf_painter.h"
#include "apps/studio/drawing/scene_painter.h"
#include "apps/studio/drawing/strokes.h"

namespace dgt::studio {
namespace {

constexpr std::uint32_t kAllDone = std::numeric_limits<std::uint32_t>::max();
constexpr double kMargin = 0.07;  // around a fitted drawing, of the window's shorter side

std::uint32_t first_undone(const DrawnPath& path, std::size_t steps) {
  return steps == path.steps() ? kAllDone : path.move(steps);
}

}  // namespace

Canvas::Canvas(ToolRun& tool, QWidget* parent) : QWidget(parent), tool_(tool) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 90);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(&tool_, &ToolRun::moved, this, &Canvas::refresh);
  connect(&pictures_, &PictureStore::changed, this, &Canvas::refresh);
  connect(&Appearance::of_program(), &Appearance::changed, this, &Canvas::refresh);
}

void Canvas::refresh() {
  settled_ = false;
  update();
}

void Canvas::show_scene(ScenePtr scene) {
  scene_ = std::move(scene);
  hover_.reset();
  measure_.clear();
  if (fitted_) fit();
  if (pointer_) point_at(*pointer_);
  refresh();
}

void Canvas::set_stale(bool stale) {
  stale_ = stale;
  refresh();
}

void Canvas::show_what(const Shown& shown) {
  shown_ = shown;
  refresh();
}

void Canvas::light(const LitLine& lit, bool bring) {
  lit_ = lit;
  refresh();
  if (!bring || !scene_ || lit.line == 0) return;
  Box box;
  for (const DrawnLayer* layer : layers()) {
    for (const std::uint32_t i : layer->of_line(lit.file, lit.line)) {
      const Box around = box_around((*layer)[i]);
      box.add(around.left, around.bottom);
      box.add(around.right, around.top);
    }
  }
  bring_into_view(box);
}

void Canvas::light_point(std::size_t number) {
  lit_point_ = number;
  refresh();
  if (!scene_ || number == 0 || number > scene_->path.steps() + 1) return;
  const DrawnPlace at = scene_->path.place({number - 1, 0});
  bring_into_view({at.x, at.y, at.x, at.y});
}

void Canvas::set_decimals(int decimals) {
  decimals_ = decimals;
  refresh();
}

void Canvas::set_measuring(bool measuring) {
  measuring_ = measuring;
  measure_.clear();
  measure_.leave();
  hover_.reset();
  if (pointer_) point_at(*pointer_);
  emit hint_changed();
  refresh();
}

void Canvas::fit() { set_view(fitted_view(), true); }

SheetView Canvas::fitted_view() const {
  return SheetView::fitting(scene_ ? scene_->path.box() : Box{}, QSizeF(size()), kMargin);
}

void Canvas::zoom(double factor) {
  zoom_about(factor, QPointF(view_.size.width() / 2, view_.size.height() / 2));
}

void Canvas::zoom_about(double factor, QPointF about) {
  const Box box = scene_ ? scene_->path.box() : Box{};
  const double scale = std::clamp(view_.scale * factor, coarsest_scale(box), finest_scale(box));
  set_view(view_.zoomed(scale / view_.scale, about), false);
}

void Canvas::pan(QPointF by) { set_view(view_.moved(by), false); }

/// Moves the drawing only when the box is not to be seen, and leaves the scale where it fits.
void Canvas::bring_into_view(const Box& box) {
  if (box.empty()) return;
  const Box window = view_.window();
  const bool is_seen = box.left >= window.left && box.right <= window.right &&
                       box.bottom >= window.bottom && box.top <= window.top;
  if (is_seen) return;
  SheetView view = SheetView::fitting(box, view_.size, kMargin);
  view.scale = std::min(view.scale, view_.scale);
  set_view(view, false);
}

void Canvas::set_view(const SheetView& view, bool fitted) {
  fitted_ = fitted;
  if (view == view_) return;
  view_ = view;
  if (pointer_) point_at(*pointer_);
  refresh();
  emit view_changed();
}

std::vector<const DrawnLayer*> Canvas::layers() const {
  if (!scene_) return {};
  std::vector<const DrawnLayer*> layers = {&scene_->path.cuts()};
  if (shown_.programmed) layers.push_back(&scene_->path.programmed());
  if (shown_.rapids) layers.push_back(&scene_->path.rapids());
  return layers;
}

Look Canvas::look() const {
  Look look;
  look.colours = colours();
  look.font = font();
  look.shown = shown_;
  look.lit = lit_;
  look.decimals = decimals_;
  look.stale = stale_;
  return look;
}

/// A running tool does not need a new picture at each frame: the few moves that differ are painted
/// over the last one.
Look Canvas::look_of_picture() const {
  constexpr std::size_t kFew = 200;  // moves
  Look wanted = look();
  wanted.pixel = devicePixelRatioF();
  wanted.font.setPixelSize(
      static_cast<int>(std::lround(QFontInfo(font()).pixelSize() * wanted.pixel)));
  if (!scene_) return wanted;
  const DrawnPath& path = scene_->path;
  wanted.run_to = first_undone(path, tool_.place().steps);
  const auto painted = pictures_.run_to(scene_);
  if (!painted || shown_.kerf || tool_.is_at_end()) return wanted;
  const std::size_t before = path.step_of(*painted);
  const std::size_t now = tool_.place().steps;
  if (std::max(before, now) - std::min(before, now) <= kFew) wanted.run_to = *painted;
  return wanted;
}

void Canvas::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const Look plain = look();
  painter.fillRect(rect(), plain.colours.sheet);
  if (shown_.grid) paint_grid(painter, view_, plain);
  const double ratio = devicePixelRatioF();
  painter.save();
  painter.scale(1 / ratio, 1 / ratio);
  pictures_.paint(painter, scene_, view_.on_pixels(ratio), look_of_picture());
  painter.restore();
  if (scene_) paint_over(painter, plain);
  const bool was_settled = std::exchange(settled_, pictures_.is_settled());
  if (settled_ && !was_settled)
    QMetaObject::invokeMethod(this, &Canvas::settled, Qt::QueuedConnection);
}

void Canvas::paint_over(QPainter& painter, const Look& plain) const {
  painter.setRenderHint(QPainter::Antialiasing);
  paint_run(painter, plain);
  paint_hover(painter, plain);
  paint_lit_point(painter, plain);
  if (shown_.tool && !stale_) paint_tool(painter, plain);
  if (measuring_) measure_.paint(painter, view_, plain);
}

void Canvas::paint_run(QPainter& painter, const Look& look) const {
  const auto painted = pictures_.run_to(scene_);
  if (stale_ || !painted) return;
  const DrawnPath& path = scene_->path;
  const std::size_t before = path.step_of(*painted);
  const ToolPlace now = tool_.place();
  for (std::size_t step = before; step < now.steps; ++step)
    paint_step(painter, view_, look, path, step, true);
  for (std::size_t step = now.steps; step < before; ++step)
    paint_step(painter, view_, look, path, step, false);
  if (now.part > 0) paint_step(painter, view_, look, path, now.steps, true, now.part);
}

void Canvas::paint_hover(QPainter& painter, const Look& look) const {
  if (!hover_) return;
  QPen pen(look.colours.lit, 2.5);
  pen.setCapStyle(Qt::RoundCap);
  painter.setPen(pen);
  stroke_curve(painter, view_, (*hover_->layer)[hover_->curve]);
}

void Canvas::paint_lit_point(QPainter& painter, const Look& look) const {
  if (lit_point_ == 0 || lit_point_ > scene_->path.steps() + 1) return;
  constexpr double kRing = 8;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(look.colours.lit, 2.5));
  painter.drawEllipse(view_.pixel(scene_->path.place({lit_point_ - 1, 0})), kRing, kRing);
}

/// The disc of the kerf, and a cross in its middle, which a disc too small to be seen still has.
void Canvas::paint_tool(QPainter& painter, const Look& look) const {
  const DrawnPlace place = scene_->path.place(tool_.place());
  const QPolygonF outline = disc(view_, place, scene_->path.kerf_radius(tool_.place()));
  QColor fill = look.colours.tool;
  fill.setAlphaF(0.3F);
  painter.setBrush(fill);
  painter.setPen(QPen(look.colours.tool, 1.5));
  if (outline.size() > 2) painter.drawPolygon(outline);
  constexpr double kArm = 6;
  const QPointF at = view_.pixel(place);
  painter.drawLine(at - QPointF(kArm, 0), at + QPointF(kArm, 0));
  painter.drawLine(at - QPointF(0, kArm), at + QPointF(0, kArm));
}

}  // namespace dgt::studio
