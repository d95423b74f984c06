// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/picture.h"

#include <QPainter>
#include <cmath>
#include <utility>

#include "apps/studio/drawing/scene_painter.h"

namespace dgt::studio {
namespace {

/// Painted in a few milliseconds.
constexpr std::size_t kAtOnce = 3000;  // curves
constexpr double kBorder = 0.25;       // of the window, on each side

/// Where the upper left corner of the picture stands in the window.
QPointF corner(const SheetView& picture, const SheetView& view) {
  const double scale = view.scale / picture.scale;
  const QPointF middle = view.pixel(picture.centre);
  return middle - scale * QPointF(picture.size.width() / 2, picture.size.height() / 2);
}

/// The same view with its middle on a whole pixel of the window, so that pictures can be moved by
/// whole pixels.
QPointF whole(QPointF p) { return {std::round(p.x()), std::round(p.y())}; }

}  // namespace

ScenePicture paint_picture(ScenePtr scene, const SheetView& view, const Look& look) {
  ScenePicture picture{
      QImage(view.size.toSize(), QImage::Format_ARGB32_Premultiplied), view, look, {}};
  picture.image.fill(Qt::transparent);
  if (scene) {
    QPainter painter(&picture.image);
    paint_scene(painter, *scene, view, look);
  }
  picture.scene = std::move(scene);
  return picture;
}

PictureStore::PictureStore(QObject* parent) : QObject(parent) {}

void PictureStore::paint(QPainter& painter, const ScenePtr& scene, const SheetView& view,
                         const Look& look) {
  settled_ = is_of(scene, look) && fits(view);
  if (!settled_ && (!scene || scene->curves() <= kAtOnce)) {
    picture_ = paint_picture(scene, view, look);
    work_.forget();
    settled_ = true;
  } else if (!settled_) {
    ask(scene, view, look);
  }
  if (picture_.image.isNull()) return;
  const QPointF at = corner(picture_.view, view);
  const double scale = view.scale / picture_.view.scale;
  if (scale == 1) {
    painter.drawImage(whole(at), picture_.image);
  } else {
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale < 4);
    painter.drawImage(QRectF(at, scale * picture_.view.size), picture_.image);
  }
}

std::optional<std::uint32_t> PictureStore::run_to(const ScenePtr& scene) const {
  if (picture_.scene != scene || picture_.image.isNull()) return std::nullopt;
  return picture_.look.run_to;
}

bool PictureStore::is_of(const ScenePtr& scene, const Look& look) const {
  return !picture_.image.isNull() && picture_.scene == scene && picture_.look == look;
}

bool PictureStore::fits(const SheetView& view) const {
  if (picture_.view.scale != view.scale) return false;
  const QPointF at = whole(corner(picture_.view, view));
  return at.x() <= 0 && at.y() <= 0 && at.x() + picture_.view.size.width() >= view.size.width() &&
         at.y() + picture_.view.size.height() >= view.size.height();
}

// A picture in work is finished before the next is begun: while a person goes on zooming, something
// still arrives now and then. One of another scene is not worth waiting for.
void PictureStore::ask(const ScenePtr& scene, const SheetView& view, const Look& look) {
  if (work_.is_busy() && asked_ == scene) return;
  asked_ = scene;
  const QSizeF border(std::ceil(kBorder * view.size.width()),
                      std::ceil(kBorder * view.size.height()));
  work_.ask([this, scene, wide = view.widened(border), look]() -> Background::Outcome {
    return [this, picture = paint_picture(scene, wide, look)] {
      picture_ = picture;
      emit changed();
    };
  });
}

}  // namespace dgt::studio
