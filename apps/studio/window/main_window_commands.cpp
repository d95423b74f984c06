// SPDX-License-Identifier: GPL-3.0-or-later
// What the menus do, where it is more than a word to somebody else.
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>

#include "apps/driver/machine_choice.h"
#include "apps/studio/help/help_window.h"
#include "apps/studio/language.h"
#include "apps/studio/tape/tape_dialog.h"
#include "apps/studio/window/colours_dialog.h"
#include "apps/studio/window/machine_dialog.h"
#include "apps/studio/window/main_window.h"
#include "lang/dgt/formatter.h"

namespace dgt::studio {
namespace {

constexpr int kSentenceTime = 10000;  // ms in the status bar

std::optional<std::string> formatted(const std::string& name, const std::string& bytes) {
  const SourceFile file(name, bytes, Encoding::Utf8);
  DiagnosticBag bag;
  return language::format(file, bag);
}

}  // namespace

void MainWindow::draw() {
  panels_->show(Panels::Panel::Drawing);
  wants_drawing_ = true;
  compiler_->compile_now();
}

// The guide's NC program exists once the program has been drawn; F8 does both.
void MainWindow::show_nc() {
  if (!compiler_->current()) {
    wants_nc_ = true;
    wants_drawing_ = true;
    compiler_->compile_now();
    return;
  }
  if (compiler_->current()->path() == nullptr) {
    statusBar()->showMessage(tr("The program has errors; there is no NC program."), kSentenceTime);
    editor_->go_to_fault(true);
    return;
  }
  if (drawn_ != compiler_->current()) draw_part(compiler_->current());
  if (panels_->nc->choose_dialect()) panels_->show(Panels::Panel::Nc);
}

void MainWindow::use_machine(const QString& file) {
  SettledMachine settled = settle(MachineChoice{file.toStdString(), {}, {}});
  if (settled.settings) {
    machine_ = *std::move(settled.settings);
  } else {
    machine_ = {};
    notices_->show_notice({QStringLiteral("machine"),
                           [file, settled] {
                             return tr("The machine file %1 is not used.").arg(file) + u' ' +
                                    faults_of(settled, message_language());
                           },
                           {{[] { return tr("OK"); }, {}}}});
  }
  panels_->nc->set_machine(settled.settings ? file : QString());
  compiler_->set_source(documents_->document().name(), machine_);
}

void MainWindow::choose_machine() {
  MachineDialog dialog(settings_.machine_file(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  settings_.set_machine_file(dialog.file());
  use_machine(dialog.file());
}

void MainWindow::put_cure(std::size_t fault) {
  if (fault >= editor_->faults().size()) return;
  const Fault& one = editor_->faults()[fault];
  if (!one.cure) return;
  if (one.cure->certainty == Certainty::Guess) {
    QMessageBox question(QMessageBox::Question, tr("DGT Studio"), one.text, QMessageBox::Cancel,
                         this);
    question.setInformativeText(tr("Write “%1” instead of “%2”? This changes what is cut.")
                                    .arg(one.cure->replacement, one.cure->was));
    const QPushButton* const write = question.addButton(tr("Write"), QMessageBox::AcceptRole);
    question.exec();
    if (question.clickedButton() != write) return;
  }
  if (!editor_->cure(fault)) {
    statusBar()->showMessage(tr("The text has changed since."), kSentenceTime);
    return;
  }
  compiler_->compile_now();
  editor_->setFocus();
}

// Laying out a long program takes a while; what is typed meanwhile is worth more.
void MainWindow::format() {
  if (editor_->language() != InputLanguage::Dgt) {
    statusBar()->showMessage(tr("Only programs of DGT can be formatted."), kSentenceTime);
    return;
  }
  const int revision = editor_->document()->revision();
  formatting_.ask(
      [this, revision, name = documents_->document().name().toStdString(), text = editor_->text()] {
        return [this, revision, text = formatted(name, text.toStdString())] {
          take_formatted(revision, text);
        };
      });
}

void MainWindow::take_formatted(int revision, const std::optional<std::string>& text) {
  if (revision != editor_->document()->revision()) {
    statusBar()->showMessage(tr("The text has changed since."), kSentenceTime);
  } else if (!text) {
    statusBar()->showMessage(tr("Lines with errors cannot be formatted."), kSentenceTime);
    editor_->go_to_fault(true);
  } else {
    editor_->replace_text(QString::fromStdString(*text));
  }
}

void MainWindow::ask_for_line() {
  bool chosen = false;
  const int line =
      QInputDialog::getInt(this, tr("Go to line"), tr("Line:"), editor_->current_line(), 1,
                           editor_->blockCount(), 1, &chosen);
  if (!chosen) return;
  editor_->go_to(line);
  editor_->setFocus();
}

void MainWindow::choose_colours() {
  ColoursDialog dialog(this);
  if (dialog.exec() == QDialog::Accepted) {
    settings_.set_colours(Appearance::of_program().theme(), dialog.chosen());
  }
}

void MainWindow::read_tape() {
  TapeDialog dialog(TapeJob::Read, machine_, this);
  connect(&dialog, &TapeDialog::text_read, this,
          [this](const QByteArray& text) { documents_->take_text(QString::fromUtf8(text)); });
  dialog.exec();
}

void MainWindow::punch(const QString& name, const QByteArray& bytes) {
  TapeDialog dialog(TapeJob::Punch, machine_, this);
  dialog.set_program(name, bytes);
  dialog.exec();
}

void MainWindow::duplicate_tape() { TapeDialog(TapeJob::Duplicate, machine_, this).exec(); }

void MainWindow::show_help(const QString& word) {
  if (help_ == nullptr) help_ = new HelpWindow;
  help_->show_topic(word);
  help_->show();
  help_->raise();
  help_->activateWindow();
}

void MainWindow::show_about() {
  QMessageBox::about(
      this, tr("About DGT Studio"),
      tr("<h3>DGT Studio %1</h3><p>Exact contours for wire and plasma cutting.</p>"
         "<p>Free software under the GNU General Public License, version 3 or later.</p>")
          .arg(QStringLiteral(DGT_VERSION)));
}

}  // namespace dgt::studio
