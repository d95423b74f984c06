// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the window say to each other.
#include <QClipboard>
#include <QFileInfo>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolButton>
#include <algorithm>

#include "apps/studio/language.h"
#include "apps/studio/window/icons.h"
#include "apps/studio/window/main_window.h"
#include "apps/studio/window/print.h"

namespace dgt::studio {

void MainWindow::join_actions() {
  const Actions& a = *actions_;
  const auto on = [this](QAction* action, auto act) {
    addAction(action);  // keys of actions without a menu work too
    connect(action, &QAction::triggered, this, act);
  };
  on(a.start_new, [this] { documents_->start_new(); });
  on(a.open, [this] { documents_->open(); });
  // Where one types, there one saves.
  on(a.save, [this] {
    if (panels_->has_keyboard(Panels::Panel::Nc)) {
      panels_->nc->save();
    } else {
      documents_->save();
    }
  });
  on(a.save_as, [this] {
    if (panels_->has_keyboard(Panels::Panel::Nc)) {
      panels_->nc->save_as();
    } else {
      documents_->save_as();
    }
  });
  on(a.read_tape, [this] { read_tape(); });
  on(a.punch_tape, [this] {
    const Document& document = documents_->document();
    const Encoded encoded = encode(editor_->text().toStdString(), document.form());
    punch(document.name(), QByteArray::fromStdString(encoded.bytes));
  });
  on(a.duplicate_tape, [this] { duplicate_tape(); });
  on(a.print_source, [this] { print_source(editor_->document(), documents_->title(), this); });
  on(a.print_drawing, [this] { print_drawing(*panels_->drawing, documents_->title(), this); });
  on(a.execute, [this] { draw(); });
  on(a.exit, [this] { close(); });
  for (QAction* const recent : a.recent) {
    on(recent, [this, recent] { documents_->open_file(recent->data().toString()); });
  }
  on(a.draw, [this] { draw(); });
  on(a.nc, [this] { show_nc(); });
  on(a.internal_form, [this] { panels_->show(Panels::Panel::InternalForm); });
  on(a.points, [this] { panels_->show(Panels::Panel::Points); });
  on(a.programmed, [this](bool shown) { panels_->drawing->show_programmed(shown); });
  on(a.menu, [this] {
    menuBar()->setFocus(Qt::MenuBarFocusReason);
    menuBar()->setActiveAction(menuBar()->actions().first());
  });
  on(a.colours, [this] { choose_colours(); });
  on(a.machine, [this] { choose_machine(); });
  on(a.live, [this](bool live) {
    settings_.set_draws_live(live);
    if (live && shown_) draw_part(shown_);
  });
  on(a.russian, [this] { set_language(Language::Russian); });
  on(a.english, [this] { set_language(Language::English); });
  on(a.light, [this] { set_theme(Theme::Light); });
  on(a.dark, [this] { set_theme(Theme::Dark); });
  on(a.help_word, [this] { show_help(editor_->word_at_cursor()); });
  on(a.reference, [this] { show_help({}); });
  on(a.hot_keys, [this] { show_help(QStringLiteral("F5")); });
  on(a.about, [this] { show_about(); });
}

void MainWindow::join_text_actions() {
  const Actions& a = *actions_;
  // These keys mean the text; panels with the keyboard have their own use for them.
  const auto on = [this](QAction* action, auto act) {
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    centralWidget()->addAction(action);
    connect(action, &QAction::triggered, this, act);
  };
  on(a.undo, [this] { editor_->undo(); });
  on(a.redo, [this] { editor_->redo(); });
  on(a.cut, [this] { editor_->cut(); });
  on(a.copy, [this] { editor_->copy(); });
  on(a.paste, [this] { editor_->paste(); });
  on(a.select_all, [this] {
    editor_->selectAll();
    editor_->setFocus();
  });
  on(a.find, [this] { find_bar_->open(false); });
  on(a.replace, [this] { find_bar_->open(true); });
  on(a.find_next, [this] { find_bar_->find(true); });
  on(a.find_previous, [this] { find_bar_->find(false); });
  on(a.go_to_line, [this] { ask_for_line(); });
  on(a.complete, [this] { editor_->complete(); });
  on(a.format, [this] { format(); });
  on(a.cure, [this] {
    if (const auto fault = editor_->curable_fault()) {
      put_cure(*fault);
    } else {
      statusBar()->showMessage(tr("Nothing in this line has a fix."), 5000);
    }
  });
  on(a.next_fault, [this] { editor_->go_to_fault(true); });
  on(a.previous_fault, [this] { editor_->go_to_fault(false); });
  on(a.font_larger, [this] { set_font_size(editor_->font().pointSize() + 1); });
  on(a.font_smaller, [this] { set_font_size(editor_->font().pointSize() - 1); });
  on(a.font_standard, [this] { set_font_size(SettingsStore::standard_font_size()); });
  findChild<QToolButton*>(QStringLiteral("font_size"))->setIcon(icon(QStringLiteral("font")));
  connect(editor_, &SourceEditor::font_size_changed, this,
          [this](int points) { settings_.set_font_size(points); });
  const auto follow = [](QAction* action, auto signal, QPlainTextEdit* editor) {
    action->setEnabled(false);
    connect(editor, signal, action, &QAction::setEnabled);
  };
  follow(a.undo, &QPlainTextEdit::undoAvailable, editor_);
  follow(a.redo, &QPlainTextEdit::redoAvailable, editor_);
  follow(a.cut, &QPlainTextEdit::copyAvailable, editor_);
  follow(a.copy, &QPlainTextEdit::copyAvailable, editor_);
}

void MainWindow::join_panels() {
  const Panels& p = *panels_;
  connect(editor_, &SourceEditor::cursorPositionChanged, this, [this] {
    const QTextCursor cursor = editor_->textCursor();
    fields_->show_cursor(cursor.blockNumber() + 1, cursor.positionInBlock() + 1);
  });
  connect(editor_, &SourceEditor::current_line_changed, this, &MainWindow::light_line);
  connect(editor_, &SourceEditor::fault_reached, p.faults, &FaultList::choose);
  connect(p.faults, &FaultList::fault_chosen, this, [this](int fault) {
    if (const auto place = editor_->place_of(static_cast<std::size_t>(fault))) {
      QTextCursor cursor = *place;
      cursor.setPosition(place->selectionStart());
      editor_->setTextCursor(cursor);
      editor_->centerCursor();
      editor_->setFocus();
    }
  });
  connect(p.faults, &FaultList::cure_chosen, this,
          [this](int fault) { put_cure(static_cast<std::size_t>(fault)); });
  connect(p.faults, &FaultList::place_chosen, this,
          [this](const QString& file, int line, int column) {
            if (!file.isEmpty() && !documents_->open_file(file)) return;
            editor_->go_to(line, column);
            editor_->setFocus();
          });
  connect(fields_, &StatusFields::faults_wanted, this,
          [this] { panels_->show(Panels::Panel::Faults); });
  connect(p.drawing, &DrawingPanel::place_chosen, this, &MainWindow::go_to_place);
  actions_->programmed->setChecked(p.drawing->canvas().shown().programmed);
  connect(p.drawing, &DrawingPanel::programmed_shown, actions_->programmed, &QAction::setChecked);
  connect(p.points, &PointsPanel::point_chosen, p.drawing, &DrawingPanel::light_point);
  connect(p.points, &PointsPanel::place_chosen, this, &MainWindow::go_to_place);
  connect(p.internal_form, &InternalForm::place_chosen, this, &MainWindow::go_to_place);
  connect(p.nc, &NcPanel::place_chosen, this, &MainWindow::go_to_place);
  connect(p.nc, &NcPanel::part_read, this, &MainWindow::draw_part);
  connect(p.nc, &NcPanel::punch_wanted, this,
          [this](const QByteArray& text) { punch(documents_->document().name(), text); });
  connect(p.wizard, &WizardPanel::line_finished, editor_, &SourceEditor::add_line);
  connect(p.wizard, &WizardPanel::left, this, [this] { editor_->setFocus(); });
  connect(panels_, &Panels::left, this, [this] { editor_->setFocus(); });
}

void MainWindow::take_part(const PartPtr& part) {
  shown_ = part;
  editor_->set_part(part);
  show_faults(*part);
  panels_->wizard->show_source(editor_->text());
  panels_->internal_form->show_part(part);
  panels_->points->show_part(part);
  if (actions_->live->isChecked() || std::exchange(wants_drawing_, false)) draw_part(part);
  panels_->nc->show_part(part);
  if (std::exchange(wants_nc_, false)) show_nc();
}

void MainWindow::show_faults(const Part& part) {
  editor_->show_faults(faults_of(part.compilation, message_language()));
  panels_->faults->show_faults(editor_->faults());
  fields_->show_faults(editor_->faults());
}

void MainWindow::draw_part(const PartPtr& part) {
  drawn_ = part;
  panels_->drawing->show_part(part);
  light_line(editor_->current_line());
}

// Places of an NC program that is drawn are the NC panel's own.
void MainWindow::go_to_place(int file, int line, int column) {
  const Part* const part = sender() == panels_->drawing ? drawn_.get() : shown_.get();
  if (part == nullptr || part->path() == nullptr || part != shown_.get()) return;
  const auto& files = part->path()->files;
  if (file < 0 || static_cast<std::size_t>(file) >= files.size()) return;
  const std::string& name = files[static_cast<std::size_t>(file)];
  if (name != part->compilation.file->name() &&
      !documents_->open_file(QString::fromStdString(name))) {
    return;
  }
  editor_->go_to(line, column);
  // The drawing keeps the keyboard: Space steps the tool, and would else go into the program.
  if (sender() != panels_->drawing) editor_->setFocus();
}

void MainWindow::light_line(int line) {
  const Part* const part = drawn_.get();
  int file = 0;
  int lit = 0;
  if (part != nullptr && part == shown_.get() && part->path() != nullptr) {
    const auto& files = part->path()->files;
    const auto found = std::ranges::find(files, part->compilation.file->name());
    if (found != files.end()) {
      file = static_cast<int>(found - files.begin());
      lit = line;
    }
  }
  panels_->drawing->light_line(file, lit);
  panels_->internal_form->light_line(file, lit);
}

}  // namespace dgt::studio
