// SPDX-License-Identifier: GPL-3.0-or-later
// What the drawing shows: the menu, and what of it is remembered.
#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolButton>
#include <array>

#include "apps/studio/drawing/drawing_panel.h"
#include "apps/studio/drawing/readout.h"
#include "apps/studio/drawing/scene_painter.h"
#include "apps/studio/window/settings_store.h"

namespace dgt::studio {
namespace {

constexpr int kAsMachine = -1;  // digits behind the point
const QString kDecimalsKey = QStringLiteral("drawing/decimals");

/// One entry of the menu.
struct ShownRow {
  bool Shown::*what;
  const char* key;  ///< under which it is remembered
  const char* name;
};
constexpr std::array kRows = {
    ShownRow{&Shown::programmed, "drawing/programmed",
             QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Programmed contour")},
    ShownRow{&Shown::rapids, "drawing/rapids",
             QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Rapid moves")},
    ShownRow{&Shown::tool, "drawing/tool", QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Tool")},
    ShownRow{&Shown::kerf, "drawing/kerf", QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Kerf")},
    ShownRow{&Shown::directions, "drawing/directions",
             QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Directions")},
    ShownRow{&Shown::points, "drawing/points",
             QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Control points")},
    ShownRow{&Shown::names, "drawing/names",
             QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Elements and their names")},
    ShownRow{&Shown::sizes, "drawing/sizes",
             QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Sizes of the part")},
    ShownRow{&Shown::grid, "drawing/grid",
             QT_TRANSLATE_NOOP("dgt::studio::DrawingPanel", "&Grid and axes")},
};

}  // namespace

void DrawingPanel::make_show_menu() {
  show_menu_ = new QMenu(this);
  Shown remembered;
  for (const ShownRow& row : kRows) {
    const bool usual = remembered.*row.what;
    remembered.*row.what = SettingsStore().panel(QString::fromLatin1(row.key), usual).toBool();
  }
  canvas_->show_what(remembered);
  for (const ShownRow& row : kRows) {
    QAction* action = show_menu_->addAction(QString());
    action->setCheckable(true);
    action->setChecked(remembered.*row.what);
    connect(action, &QAction::toggled, this, [this, row](bool shown) {
      Shown all = canvas_->shown();
      all.*row.what = shown;
      show_what(all);
      SettingsStore().set_panel(QString::fromLatin1(row.key), shown);
    });
    choices_.push_back({row.what, action});
  }
  make_decimals_menu();
  show_button_->setMenu(show_menu_);
}

void DrawingPanel::make_decimals_menu() {
  constexpr int kMost = 6;
  decimals_ = SettingsStore().panel(kDecimalsKey, kAsMachine).toInt();
  show_menu_->addSeparator();
  decimals_menu_ = show_menu_->addMenu(QString());
  auto* group = new QActionGroup(this);
  for (int decimals = kAsMachine; decimals <= kMost; ++decimals) {
    QAction* action = decimals_menu_->addAction(QString::number(decimals));
    action->setCheckable(true);
    action->setChecked(decimals == decimals_);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, decimals] {
      decimals_ = decimals;
      SettingsStore().set_panel(kDecimalsKey, decimals);
      apply_decimals();
    });
  }
}

void DrawingPanel::apply_decimals() {
  const int of_machine = decimals_of(part_ ? part_->settings : Settings{});
  const int decimals = decimals_ < 0 ? of_machine : decimals_;
  readout_->set_decimals(decimals);
  canvas_->set_decimals(decimals);
}

void DrawingPanel::show_what(const Shown& shown) {
  const bool was = canvas_->shown().programmed;
  canvas_->show_what(shown);
  for (const Choice& choice : choices_) choice.action->setChecked(shown.*choice.what);
  if (was != shown.programmed) emit programmed_shown(shown.programmed);
}

void DrawingPanel::show_programmed(bool shown) {
  Shown all = canvas_->shown();
  all.programmed = shown;
  show_what(all);
}

void DrawingPanel::retranslate_menu() {
  for (std::size_t i = 0; i < kRows.size(); ++i) choices_[i].action->setText(tr(kRows[i].name));
  decimals_menu_->setTitle(tr("Digits &behind the point"));
  decimals_menu_->actions().first()->setText(tr("As the &machine"));
}

}  // namespace dgt::studio
