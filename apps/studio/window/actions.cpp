// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/actions.h"

#include <QFileInfo>

#include "apps/studio/window/icons.h"

namespace dgt::studio {
namespace {

QList<QKeySequence> key(QKeyCombination keys) { return {QKeySequence(keys)}; }

}  // namespace

// Keys work wherever the focus is, in panels that float too. Those that a text field takes itself
// are shown in the menu and reach it through the same action.
QAction* Actions::add(const char* text, const char* tip, const char* picture,
                      const QList<QKeySequence>& keys) {
  auto* const action = new QAction(this);
  if (picture != nullptr) action->setIcon(icon(QString::fromLatin1(picture)));
  action->setShortcuts(keys);
  action->setShortcutContext(Qt::ApplicationShortcut);
  action->setAutoRepeat(false);
  words_.push_back({action, text, tip});
  return action;
}

QAction* Actions::add_choice(QActionGroup* group, const char* text) {
  QAction* const action = add(text);
  action->setCheckable(true);
  group->addAction(action);
  return action;
}

Actions::Actions(QObject* parent) : QObject(parent) {
  start_new = add(QT_TR_NOOP("&New"), nullptr, "new", QKeySequence::keyBindings(QKeySequence::New));
  open = add(QT_TR_NOOP("&Open…"), nullptr, "open", QKeySequence::keyBindings(QKeySequence::Open));
  read_tape = add(QT_TR_NOOP("&Read from tape…"), nullptr, "tape");
  punch_tape = add(QT_TR_NOOP("&Write to tape…"), nullptr, "tape");
  save = add(QT_TR_NOOP("&Save"), nullptr, "save", QKeySequence::keyBindings(QKeySequence::Save));
  save_as = add(QT_TR_NOOP("Save &as…"), nullptr, "save_as", key(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
  print_source = add(QT_TR_NOOP("&Print…"), QT_TR_NOOP("Print the source, or save it as PDF"),
                     "print", QKeySequence::keyBindings(QKeySequence::Print));
  print_drawing =
      add(QT_TR_NOOP("Print &drawing…"), QT_TR_NOOP("Print the drawing, or save it as PDF"),
          "print", key(Qt::CTRL | Qt::SHIFT | Qt::Key_P));
  execute = add(QT_TR_NOOP("&Execute"), QT_TR_NOOP("Draw the program"), "draw");
  for (QAction*& file : recent) {
    file = new QAction(this);
    file->setVisible(false);
  }
  exit = add(QT_TR_NOOP("E&xit"), nullptr, "exit", key(Qt::CTRL | Qt::Key_Q));

  undo = add(QT_TR_NOOP("&Undo"), nullptr, "undo", QKeySequence::keyBindings(QKeySequence::Undo));
  redo = add(QT_TR_NOOP("Re&do"), nullptr, "redo", QKeySequence::keyBindings(QKeySequence::Redo));
  cut = add(QT_TR_NOOP("Cu&t"), nullptr, "cut");
  copy = add(QT_TR_NOOP("&Copy"), nullptr, "copy");
  paste = add(QT_TR_NOOP("&Paste"), nullptr, "paste");
  select_all = add(QT_TR_NOOP("Select &all"));
  find = add(QT_TR_NOOP("&Find…"), nullptr, "find", key(Qt::CTRL | Qt::Key_F));
  replace = add(QT_TR_NOOP("&Replace…"), nullptr, nullptr, key(Qt::CTRL | Qt::Key_H));
  find_next = add(QT_TR_NOOP("Find &next"), nullptr, nullptr, key(Qt::Key_F3));
  find_previous = add(QT_TR_NOOP("Find &previous"), nullptr, nullptr, key(Qt::SHIFT | Qt::Key_F3));
  go_to_line = add(QT_TR_NOOP("&Go to line…"), nullptr, nullptr, key(Qt::CTRL | Qt::Key_G));
  complete = add(QT_TR_NOOP("&Complete word"), nullptr, nullptr, key(Qt::CTRL | Qt::Key_Space));
  format = add(QT_TR_NOOP("For&mat"), nullptr, nullptr, key(Qt::CTRL | Qt::SHIFT | Qt::Key_F));
  cure = add(QT_TR_NOOP("Fix &error"), QT_TR_NOOP("Put the proposed fix of the line in place"),
             "cure", key(Qt::ALT | Qt::Key_Return));
  next_fault = add(QT_TR_NOOP("Next me&ssage"), nullptr, nullptr, key(Qt::Key_F4));
  previous_fault =
      add(QT_TR_NOOP("Previous mess&age"), nullptr, nullptr, key(Qt::SHIFT | Qt::Key_F4));

  duplicate_tape = add(QT_TR_NOOP("Duplicate tape…"), nullptr, "tape");
  colours = add(QT_TR_NOOP("C&olours…"), nullptr, "colours");
  font_larger =
      add(QT_TR_NOOP("&Larger"), nullptr, nullptr,
          {QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)});
  font_smaller = add(QT_TR_NOOP("&Smaller"), nullptr, nullptr, key(Qt::CTRL | Qt::Key_Minus));
  font_standard = add(QT_TR_NOOP("S&tandard"), nullptr, nullptr, key(Qt::CTRL | Qt::Key_0));
  auto* const languages = new QActionGroup(this);
  russian = add_choice(languages, "Русский");
  english = add_choice(languages, "English");
  auto* const themes = new QActionGroup(this);
  light = add_choice(themes, QT_TR_NOOP("&Light"));
  dark = add_choice(themes, QT_TR_NOOP("&Dark"));
  live = add(QT_TR_NOOP("Draw while t&yping"));
  live->setCheckable(true);
  machine = add(QT_TR_NOOP("&Machine settings…"));

  internal_form = add(QT_TR_NOOP("&Internal form"), QT_TR_NOOP("The program in its internal form"),
                      "internal", key(Qt::Key_F7));
  points = add(QT_TR_NOOP("Control &points"), QT_TR_NOOP("The calculated control points"), "points",
               key(Qt::Key_F6));
  draw =
      add(QT_TR_NOOP("D&raw"), QT_TR_NOOP("Draw the path of the program"), "draw", key(Qt::Key_F5));
  nc = add(QT_TR_NOOP("&NC program"), QT_TR_NOOP("The program for a control"), "nc",
           key(Qt::Key_F8));
  programmed = add(QT_TR_NOOP("Programmed &contour"),
                   QT_TR_NOOP("Draw the path with the contour as programmed"), "programmed");
  programmed->setCheckable(true);
  menu = add(QT_TR_NOOP("Menu"), nullptr, nullptr, key(Qt::Key_F10));

  help_word = add(QT_TR_NOOP("&Help on the word"), QT_TR_NOOP("Explain the word at the cursor"),
                  "help", key(Qt::Key_F1));
  reference = add(QT_TR_NOOP("&Reference"));
  hot_keys = add(QT_TR_NOOP("Hot &keys"));
  about = add(QT_TR_NOOP("&About DGT Studio"));
  retranslate();
}

void Actions::retranslate() {
  for (const Words& one : words_) {
    one.action->setText(tr(one.text));
    QString tip = one.tip != nullptr ? tr(one.tip) : tr(one.text);
    tip.remove(u'&').remove(QStringLiteral("…"));
    const QString keys = one.action->shortcut().toString(QKeySequence::NativeText);
    one.action->setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys));
  }
}

void Actions::show_recent(const QStringList& files) {
  for (std::size_t i = 0; i < recent.size(); ++i) {
    const auto at = static_cast<qsizetype>(i);
    recent[i]->setVisible(at < files.size());
    if (at >= files.size()) continue;
    recent[i]->setText(QStringLiteral("&%1 %2").arg(i + 1).arg(
        QFileInfo(files[at]).fileName().replace(u'&', QStringLiteral("&&"))));
    recent[i]->setToolTip(files[at]);
    recent[i]->setData(files[at]);
  }
}

}  // namespace dgt::studio
