// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "apps/studio/drawing/look.h"
#include "apps/studio/drawing/measuring.h"
#include "apps/studio/drawing/picture.h"
#include "apps/studio/drawing/scene.h"
#include "apps/studio/drawing/tool_run.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {

/// The sheet on which a part is drawn, looked at and pointed at.
class Canvas : public QWidget {
  Q_OBJECT

 public:
  explicit Canvas(ToolRun& tool, QWidget* parent = nullptr);

  void show_scene(ScenePtr scene);
  void set_stale(bool stale);  ///< the text is ahead of the drawing
  void show_what(const Shown& shown);
  void light(const LitLine& lit, bool bring_into_view);
  void light_point(std::size_t number);  ///< of a control point; 0: none
  void set_decimals(int decimals);
  void set_factor(double factor) { factor_ = factor; }  ///< of a click
  void set_measuring(bool measuring);

  [[nodiscard]] const Shown& shown() const { return shown_; }
  [[nodiscard]] bool is_measuring() const { return measuring_; }
  [[nodiscard]] const SheetView& view() const { return view_; }  ///< in pixels of the widget
  [[nodiscard]] bool is_settled() const { return settled_; }
  /// What is under the pointer, and what a click does there.
  [[nodiscard]] QString hint() const;

 public slots:
  void fit();
  void zoom(double factor);  ///< about the middle

 signals:
  void pointed_at(double x, double y);  ///< mm
  void pointed_away();
  void hint_changed();
  void place_chosen(int file, int line, int column);
  void measuring_left();
  void view_changed();
  /// A painting has shown all there is to show.
  void settled();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  /// A move under the pointer.
  struct Hit {
    const DrawnLayer* layer = nullptr;
    std::size_t curve = 0;

    friend bool operator==(const Hit&, const Hit&) = default;
  };

  void set_view(const SheetView& view, bool fitted);
  void zoom_about(double factor, QPointF about);
  void pan(QPointF by);
  void bring_into_view(const Box& box);
  [[nodiscard]] SheetView fitted_view() const;

  void point_at(QPointF pixel);
  void click(QPointF pixel, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
  [[nodiscard]] std::optional<Hit> hit(QPointF pixel) const;
  [[nodiscard]] std::vector<const DrawnLayer*> layers() const;
  [[nodiscard]] QString describe(const Hit& hit) const;

  [[nodiscard]] Look look() const;
  [[nodiscard]] Look look_of_picture() const;
  void refresh();  ///< what is seen is out of date
  void paint_over(QPainter& painter, const Look& look) const;
  void paint_tool(QPainter& painter, const Look& look) const;
  void paint_run(QPainter& painter, const Look& look) const;
  void paint_hover(QPainter& painter, const Look& look) const;
  void paint_lit_point(QPainter& painter, const Look& look) const;

  ToolRun& tool_;
  ScenePtr scene_;
  PictureStore pictures_{this};
  SheetView view_;
  bool fitted_ = true;
  Shown shown_;
  LitLine lit_;
  std::size_t lit_point_ = 0;
  int decimals_ = 3;
  double factor_ = 2;
  bool stale_ = false;
  bool measuring_ = false;
  bool settled_ = false;
  Measuring measure_;
  std::optional<Hit> hover_;
  std::optional<QPointF> pointer_;
  std::optional<QPointF> pressed_;  ///< where a button went down
  QPointF dragged_;                 ///< where the drawing was moved to last
  bool dragging_ = false;
};

}  // namespace dgt::studio
