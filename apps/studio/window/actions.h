// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QActionGroup>
#include <QObject>
#include <array>

#include "apps/studio/window/settings_store.h"

namespace dgt::studio {

/// Everything that menus and tools do, with its words, keys and icons. Who owns the windows
/// connects it.
class Actions : public QObject {
  Q_OBJECT

 public:
  explicit Actions(QObject* parent);

  // File.
  QAction* start_new;
  QAction* open;
  QAction* read_tape;
  QAction* punch_tape;
  QAction* save;
  QAction* save_as;
  QAction* print_source;
  QAction* print_drawing;
  QAction* execute;
  std::array<QAction*, kRecentFiles> recent;
  QAction* exit;
  // Options: the text.
  QAction* undo;
  QAction* redo;
  QAction* cut;
  QAction* copy;
  QAction* paste;
  QAction* select_all;
  QAction* find;
  QAction* replace;
  QAction* find_next;
  QAction* find_previous;
  QAction* go_to_line;
  QAction* complete;
  QAction* format;
  QAction* cure;
  QAction* next_fault;
  QAction* previous_fault;
  // Options: the program.
  QAction* duplicate_tape;
  QAction* colours;
  QAction* font_larger;
  QAction* font_smaller;
  QAction* font_standard;
  QAction* russian;
  QAction* english;
  QAction* light;
  QAction* dark;
  QAction* live;
  QAction* machine;
  // Panels and tools.
  QAction* internal_form;
  QAction* points;
  QAction* draw;
  QAction* nc;
  QAction* programmed;
  QAction* menu;  ///< F10
  // Help.
  QAction* help_word;
  QAction* reference;
  QAction* hot_keys;
  QAction* about;

  /// The words of all of them anew.
  void retranslate();
  void show_recent(const QStringList& files);

 private:
  struct Words {
    QAction* action;
    const char* text;
    const char* tip;
  };
  QAction* add(const char* text, const char* tip = nullptr, const char* picture = nullptr,
               const QList<QKeySequence>& keys = {});
  QAction* add_choice(QActionGroup* group, const char* text);

  std::vector<Words> words_;
};

}  // namespace dgt::studio
