// SPDX-License-Identifier: GPL-3.0-or-later
// The menus and tools of the guide.
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include "apps/studio/language.h"
#include "apps/studio/window/main_window.h"

namespace dgt::studio {

void MainWindow::build_menus() {
  const auto add = [this](auto* parent, const char* title) {
    QMenu* const menu = parent->addMenu(QString());
    menus_.emplace_back(menu, title);
    return menu;
  };
  Actions& a = *actions_;
  QMenu* const file = add(menuBar(), QT_TR_NOOP("&File"));
  file->addActions({a.start_new, a.open, a.read_tape, a.punch_tape});
  file->addSeparator();
  file->addActions({a.save, a.save_as, a.print_source, a.print_drawing});
  file->addSeparator();
  file->addAction(a.execute);
  file->addSeparator();
  for (QAction* const recent : a.recent) file->addAction(recent);
  file->addSeparator();
  file->addAction(a.exit);

  QMenu* const options = add(menuBar(), QT_TR_NOOP("&Options"));
  options->addActions({a.undo, a.redo});
  options->addSeparator();
  options->addActions({a.copy, a.cut, a.paste, a.select_all});
  options->addSeparator();
  QMenu* const text = add(options, QT_TR_NOOP("Te&xt"));
  text->addActions({a.find, a.replace, a.find_next, a.find_previous, a.go_to_line});
  text->addSeparator();
  text->addActions({a.complete, a.format});
  text->addSeparator();
  text->addActions({a.cure, a.next_fault, a.previous_fault});
  QMenu* const panels = add(options, QT_TR_NOOP("Pa&nels"));
  panels->addActions({a.draw, a.nc, a.internal_form, a.points, a.programmed});
  panels->addSeparator();
  panels->addActions(panels_->toggles());
  options->addSeparator();
  options->addAction(a.duplicate_tape);
  options->addSeparator();
  options->addAction(a.live);
  options->addAction(a.colours);
  add(options, QT_TR_NOOP("&Font size"))
      ->addActions({a.font_larger, a.font_smaller, a.font_standard});
  add(options, QT_TR_NOOP("&Language"))->addActions({a.russian, a.english});
  add(options, QT_TR_NOOP("T&heme"))->addActions({a.light, a.dark});
  options->addMenu(fields_->encodings());
  options->addMenu(fields_->line_ends());
  options->addAction(a.machine);

  QMenu* const help = add(menuBar(), QT_TR_NOOP("&Help"));
  help->addActions({a.help_word, a.reference, a.hot_keys});
  help->addSeparator();
  help->addAction(a.about);
}

// Four groups, as the guide counts them.
void MainWindow::build_tools() {
  QToolBar* const bar = addToolBar(QString());
  bar->setObjectName(QStringLiteral("tools"));
  Actions& a = *actions_;
  bar->addActions({a.start_new, a.open, a.save});
  bar->addSeparator();
  bar->addActions({a.copy, a.paste, a.cut, a.print_source});
  auto* const font = new QToolButton(bar);
  font->setObjectName(QStringLiteral("font_size"));
  font->setPopupMode(QToolButton::InstantPopup);
  font->addActions({a.font_larger, a.font_smaller, a.font_standard});
  font->setFocusPolicy(Qt::NoFocus);
  bar->addWidget(font);
  bar->addSeparator();
  bar->addActions({a.internal_form, a.colours, a.points});
  bar->addSeparator();
  bar->addActions({a.draw, a.nc, a.programmed});
}

void MainWindow::retranslate() {
  actions_->retranslate();
  fields_->retranslate();
  for (const auto& [menu, title] : menus_) menu->setTitle(tr(title));
  auto* const bar = findChild<QToolBar*>(QStringLiteral("tools"));
  bar->setWindowTitle(tr("Tools"));
  findChild<QToolButton*>(QStringLiteral("font_size"))->setToolTip(tr("Font size of the program"));
  (message_language() == Language::Russian ? actions_->russian : actions_->english)
      ->setChecked(true);
  (Appearance::of_program().theme() == Theme::Dark ? actions_->dark : actions_->light)
      ->setChecked(true);
  statusBar()->clearMessage();
  show_title();
  if (shown_) show_faults(*shown_);
}

}  // namespace dgt::studio
