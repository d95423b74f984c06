// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does to the canvas.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>
#include <cmath>

#include "apps/studio/drawing/canvas.h"
#include "apps/studio/drawing/figure_text.h"

namespace dgt::studio {
namespace {

constexpr double kReach = 6;       // pixels: how near counts as on
constexpr double kSnapReach = 10;  // pixels
constexpr double kDragBegins = 4;  // pixels
constexpr double kKeyFactor = 1.25;
constexpr double kWheelNotch = 120;  // eighths of a degree

QString kind_of(const DrawnLayer& layer, const DrawnPath& path, std::size_t curve) {
  const bool arc = layer.is_arc(curve);
  if (&layer == &path.rapids()) return Canvas::tr("rapid");
  if (&layer == &path.programmed())
    return arc ? Canvas::tr("arc of the contour") : Canvas::tr("straight line of the contour");
  return arc ? Canvas::tr("arc") : Canvas::tr("straight line");
}

}  // namespace

void Canvas::resizeEvent(QResizeEvent* /*event*/) {
  SheetView view = view_;
  view.size = QSizeF(size());
  fitted_ ? set_view(fitted_view(), true) : set_view(view, false);
}

void Canvas::mousePressEvent(QMouseEvent* event) {
  pressed_ = dragged_ = event->position();
  dragging_ = event->button() == Qt::MiddleButton;
  if (dragging_) setCursor(Qt::ClosedHandCursor);
}

void Canvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  const bool holds = pressed_ && (event->buttons() & (Qt::LeftButton | Qt::MiddleButton));
  if (holds && !dragging_) {
    dragging_ = (at - *pressed_).manhattanLength() >= kDragBegins;
    if (dragging_) setCursor(Qt::ClosedHandCursor);
  }
  if (holds && dragging_) {
    // By whole pixels, so that the picture stays as sharp as it is.
    const QPointF by((at - dragged_).toPoint());
    dragged_ += by;
    pan(by);
  }
  point_at(at);
}

void Canvas::mouseReleaseEvent(QMouseEvent* event) {
  const bool was_click = pressed_ && !dragging_;
  pressed_.reset();
  dragging_ = false;
  if (was_click) click(event->position(), event->button(), event->modifiers());
  point_at(event->position());
}

void Canvas::click(QPointF pixel, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  if (button == Qt::RightButton) return zoom_about(1 / factor_, pixel);
  if (button != Qt::LeftButton) return;
  point_at(pixel);
  if (measuring_) {
    measure_.take();
    refresh();
    emit hint_changed();
  } else if (hover_ && !(modifiers & Qt::ControlModifier)) {
    const SourcePlace& place = hover_->layer->source(hover_->curve);
    emit place_chosen(static_cast<int>(place.file), static_cast<int>(place.line),
                      static_cast<int>(place.column));
  } else {
    zoom_about(factor_, pixel);
  }
}

void Canvas::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / kWheelNotch;
  if (notches == 0) return event->ignore();
  zoom_about(std::pow(kKeyFactor, notches), event->position());
  event->accept();
}

bool Canvas::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
    if (gesture.gestureType() == Qt::ZoomNativeGesture) {
      zoom_about(1 + gesture.value(), gesture.position());
      return true;
    }
  }
  return QWidget::event(event);
}

void Canvas::keyPressEvent(QKeyEvent* event) {
  constexpr double kNudge = 48;  // pixels
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  const double nudge = shift ? 4 * kNudge : kNudge;
  switch (event->key()) {
    case Qt::Key_Space:
      return shift ? tool_.step_back() : tool_.step();
    case Qt::Key_Backspace:
      return tool_.step_back();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return tool_.run(!tool_.is_running());
    case Qt::Key_Home:
      return tool_.to_start();
    case Qt::Key_End:
      return tool_.to_end();
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kKeyFactor);
    case Qt::Key_Minus:
      return zoom(1 / kKeyFactor);
    case Qt::Key_0:
      return fit();
    case Qt::Key_Left:
      return pan({nudge, 0});
    case Qt::Key_Right:
      return pan({-nudge, 0});
    case Qt::Key_Up:
      return pan({0, nudge});
    case Qt::Key_Down:
      return pan({0, -nudge});
    case Qt::Key_Escape:
      if (measuring_) return emit measuring_left();
      break;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

void Canvas::leaveEvent(QEvent* /*event*/) {
  pointer_.reset();
  hover_.reset();
  measure_.leave();
  refresh();
  emit pointed_away();
  emit hint_changed();
}

void Canvas::point_at(QPointF pixel) {
  pointer_ = pixel;
  const DrawnPlace place = view_.place(pixel);
  if (measuring_) {
    measure_.point(layers(), place, kSnapReach / view_.scale);
    refresh();
  } else if (!dragging_) {
    const auto under = hit(pixel);
    if (under != hover_) refresh();
    hover_ = under;
  }
  if (!dragging_) setCursor(hover_ ? Qt::PointingHandCursor : Qt::CrossCursor);
  emit pointed_at(place.x, place.y);
  emit hint_changed();
}

std::optional<Canvas::Hit> Canvas::hit(QPointF pixel) const {
  const DrawnPlace pointer = view_.place(pixel);
  double least = kReach / view_.scale;
  const Box window{pointer.x - least, pointer.y - least, pointer.x + least, pointer.y + least};
  std::optional<Hit> found;
  for (const DrawnLayer* layer : layers()) {
    layer->visit(window, [&](std::size_t i) {
      if (layer->source(i).line == 0) return;
      const double far = nearest_place((*layer)[i], pointer).distance;
      if (far >= least) return;
      least = far;
      found = Hit{layer, i};
    });
  }
  return found;
}

QString Canvas::describe(const Hit& hit) const {
  const DrawnCurve curve = (*hit.layer)[hit.curve];
  QString text = kind_of(*hit.layer, scene_->path, hit.curve);
  text += u' ' + tr("%1 mm").arg(figure_text(curve.length(), decimals_));
  if (curve.is_arc()) text += u' ' + tr("R%1").arg(figure_text(curve.radius, decimals_));
  return text;
}

QString Canvas::hint() const {
  if (measuring_) {
    const QString measure = measure_.text(decimals_);
    if (!measure.isEmpty()) return measure;
    return tr("Measuring: click two places. Esc ends it.");
  }
  if (hover_) {
    return tr("%1. Click: line %2. Ctrl+click: zoom in.")
        .arg(describe(*hover_))
        .arg(hover_->layer->source(hover_->curve).line);
  }
  return tr("Click: zoom in, right click: out. Drag: move. Space: step. Enter: run.");
}

}  // namespace dgt::studio
