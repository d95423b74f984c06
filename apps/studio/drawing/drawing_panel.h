// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QWidget>
#include <atomic>
#include <memory>

#include "apps/studio/background.h"
#include "apps/studio/drawing/canvas.h"
#include "apps/studio/drawing/tool_run.h"
#include "apps/studio/part.h"

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace dgt::studio {

class Readout;
class TransportBar;

/// The drawing of the guide: the programmed contour, the equidistant, rapids and the tool.
class DrawingPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DrawingPanel(QWidget* parent = nullptr);
  ~DrawingPanel() override;

  /// A part with errors leaves the last good drawing, dim, and says so.
  void show_part(PartPtr part);
  /// Lights the moves that were asked for in a line of the source (`file` counts into
  /// Toolpath::files, lines from 1; line 0: none).
  void light_line(int file, int line, bool bring_into_view = false);
  /// The whole drawing on paper.
  void paint(QPainter& painter, const QRect& where);
  /// Whether all that was asked for is to be seen; see `settled`.
  [[nodiscard]] bool is_settled() const;

  [[nodiscard]] Canvas& canvas() { return *canvas_; }
  [[nodiscard]] ToolRun& tool() { return tool_; }
  /// What is shown, as a menu: a person finds it on the button, and elsewhere.
  [[nodiscard]] QMenu& show_menu() { return *show_menu_; }

 public slots:
  void light_point(int number);      ///< of a control point; 0: none
  void show_programmed(bool shown);  ///< the contour with W = 0
  void set_measuring(bool measuring);
  void fit();  ///< the whole part in view
  /// Asks for a name and writes the drawing as PNG, SVG, PDF or DXF, as `dgt plot` does.
  void save_picture();

 signals:
  /// A move was clicked: where it was asked for. Counted as in light_line, columns from 1.
  void place_chosen(int file, int line, int column);
  void programmed_shown(bool shown);
  /// The drawing has come to rest after a change.
  void settled();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// One of Shown, as an entry of the menu.
  struct Choice {
    bool Shown::*what;
    QAction* action;
  };

  void make_controls();
  void make_show_menu();
  void make_decimals_menu();
  void apply_decimals();
  void show_hint();
  void retranslate();
  void retranslate_menu();
  void take_scene(ScenePtr scene);
  void show_what(const Shown& shown);
  void show_banner();
  [[nodiscard]] QString first_error() const;

  PartPtr part_;
  ScenePtr scene_;
  ToolRun tool_;
  /// Set when nobody wants the scene in work any more.
  std::shared_ptr<std::atomic<bool>> given_up_;
  Background scenes_{this};
  Background lengths_{this};
  Background files_{this};

  Canvas* canvas_;
  Readout* readout_;
  TransportBar* transport_;
  QLabel* banner_;
  QLabel* hint_;
  QMenu* show_menu_;
  QToolButton* show_button_;
  QToolButton* fit_button_;
  QToolButton* in_button_;
  QToolButton* out_button_;
  QToolButton* measure_button_;
  QToolButton* save_button_;
  std::vector<Choice> choices_;
  QMenu* decimals_menu_ = nullptr;
  int decimals_ = -1;  ///< as chosen; negative: as the machine
};

}  // namespace dgt::studio
