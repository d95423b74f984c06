// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QObject>
#include <array>

#include "apps/studio/drawing/drawing_panel.h"
#include "apps/studio/drawing/internal_form.h"
#include "apps/studio/drawing/points_panel.h"
#include "apps/studio/editor/fault_list.h"
#include "apps/studio/nc/nc_panel.h"
#include "apps/studio/wizard/wizard_panel.h"

namespace dgt::studio {

/// The panels around the editor: the drawing with the windows of F6, F7 and F8 behind it, the
/// wizard at the right, messages below. They can be moved, floated and closed, and are found again
/// where they were.
class Panels : public QObject {
  Q_OBJECT

 public:
  explicit Panels(QMainWindow* window);

  DrawingPanel* drawing;
  NcPanel* nc;
  InternalForm* internal_form;
  PointsPanel* points;
  WizardPanel* wizard;
  FaultList* faults;

  enum class Panel : std::uint8_t { Drawing, Nc, InternalForm, Points, Wizard, Faults };
  /// Shows a panel in front of others and gives it the keyboard.
  void show(Panel panel);
  void hide(Panel panel) { dock(panel)->hide(); }
  [[nodiscard]] bool is_shown(Panel panel) const;
  [[nodiscard]] bool has_keyboard(Panel panel) const;
  /// Esc: whether a panel had the keyboard. One that was opened over the drawing goes.
  bool leave();
  /// Where all of them stand when nobody has moved them.
  void lay_out();
  /// The actions that show and hide them, for a menu.
  [[nodiscard]] QList<QAction*> toggles() const;

 signals:
  /// A panel was left; the editor is to have the keyboard.
  void left();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  static constexpr std::size_t kPanels = 6;

  QDockWidget* add(Panel panel, const char* name, QWidget* content, Qt::DockWidgetArea area);
  [[nodiscard]] QDockWidget* dock(Panel panel) const {
    return docks_[static_cast<std::size_t>(panel)];
  }
  void retranslate();

  QMainWindow* window_;
  std::array<QDockWidget*, kPanels> docks_{};
};

}  // namespace dgt::studio
