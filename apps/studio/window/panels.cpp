// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/panels.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>

namespace dgt::studio {
namespace {

/// Shares of the window's width: text, drawing, wizard. On 1366 pixels the text has room for forty
/// characters and the wizard for its pictures.
constexpr int kTextShare = 34;
constexpr int kDrawingShare = 42;
constexpr int kWizardShare = 24;
constexpr int kFaultLines = 6;

}  // namespace

Panels::Panels(QMainWindow* window)
    : QObject(window),
      drawing(new DrawingPanel(window)),
      nc(new NcPanel(window)),
      internal_form(new InternalForm(window)),
      points(new PointsPanel(window)),
      wizard(new WizardPanel(window)),
      faults(new FaultList(window)),
      window_(window) {
  add(Panel::Drawing, "drawing", drawing, Qt::RightDockWidgetArea);
  add(Panel::Nc, "nc", nc, Qt::RightDockWidgetArea);
  add(Panel::InternalForm, "internal_form", internal_form, Qt::RightDockWidgetArea);
  add(Panel::Points, "points", points, Qt::RightDockWidgetArea);
  add(Panel::Wizard, "wizard", wizard, Qt::RightDockWidgetArea);
  add(Panel::Faults, "messages", faults, Qt::BottomDockWidgetArea);
  window->installEventFilter(this);
  retranslate();
  lay_out();
}

QDockWidget* Panels::add(Panel panel, const char* name, QWidget* content, Qt::DockWidgetArea area) {
  auto* const dock = new QDockWidget(window_);
  dock->setObjectName(QString::fromLatin1(name) + QStringLiteral("_dock"));
  dock->setWidget(content);
  dock->setFocusPolicy(Qt::ClickFocus);
  dock->installEventFilter(this);
  window_->addDockWidget(area, dock);
  docks_[static_cast<std::size_t>(panel)] = dock;
  return dock;
}

void Panels::lay_out() {
  window_->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  for (QDockWidget* const one : docks_) {
    one->setFloating(false);
    window_->addDockWidget(
        one == dock(Panel::Faults) ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea, one);
  }
  window_->splitDockWidget(dock(Panel::Drawing), dock(Panel::Wizard), Qt::Horizontal);
  for (const Panel behind : {Panel::Nc, Panel::InternalForm, Panel::Points}) {
    window_->tabifyDockWidget(dock(Panel::Drawing), dock(behind));
    dock(behind)->hide();
  }
  for (const Panel shown : {Panel::Drawing, Panel::Wizard, Panel::Faults}) dock(shown)->show();
  dock(Panel::Drawing)->raise();
  const int unit = window_->width() / (kTextShare + kDrawingShare + kWizardShare);
  window_->resizeDocks({dock(Panel::Drawing), dock(Panel::Wizard)},
                       {unit * kDrawingShare, unit * kWizardShare}, Qt::Horizontal);
  const int line = window_->fontMetrics().height() * 3 / 2;
  window_->resizeDocks({dock(Panel::Faults)}, {line * kFaultLines}, Qt::Vertical);
}

void Panels::show(Panel panel) {
  QDockWidget* const one = dock(panel);
  one->show();
  one->raise();
  if (one->isFloating()) one->activateWindow();
  one->widget()->setFocus(Qt::OtherFocusReason);
  if (!has_keyboard(panel))
    one->setFocus(Qt::OtherFocusReason);  // nothing in it wants it; Esc does
}

bool Panels::is_shown(Panel panel) const { return dock(panel)->isVisible(); }

bool Panels::has_keyboard(Panel panel) const {
  const QWidget* const focus = QApplication::focusWidget();
  return focus != nullptr && (focus == dock(panel) || dock(panel)->isAncestorOf(focus));
}

bool Panels::leave() {
  for (std::size_t i = 0; i < kPanels; ++i) {
    const auto panel = static_cast<Panel>(i);
    if (!has_keyboard(panel)) continue;
    const bool over_drawing =
        panel == Panel::Nc || panel == Panel::InternalForm || panel == Panel::Points;
    if (over_drawing || dock(panel)->isFloating()) dock(panel)->hide();
    emit left();
    return true;
  }
  return false;
}

QList<QAction*> Panels::toggles() const {
  QList<QAction*> actions;
  for (const QDockWidget* const one : docks_) actions.push_back(one->toggleViewAction());
  return actions;
}

void Panels::retranslate() {
  dock(Panel::Drawing)->setWindowTitle(tr("Drawing"));
  dock(Panel::Nc)->setWindowTitle(tr("NC program"));
  dock(Panel::InternalForm)->setWindowTitle(tr("Internal form"));
  dock(Panel::Points)->setWindowTitle(tr("Control points"));
  dock(Panel::Wizard)->setWindowTitle(tr("Elements"));
  dock(Panel::Faults)->setWindowTitle(tr("Messages"));
}

// A floating panel is a window of its own, so its Esc never comes to the main window.
bool Panels::eventFilter(QObject* watched, QEvent* event) {
  if (watched == window_) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    return false;
  }
  if (event->type() != QEvent::KeyPress) return false;
  return static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && leave();
}

}  // namespace dgt::studio
