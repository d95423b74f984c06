// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/main_window.h"

#include <QCloseEvent>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QStatusBar>
#include <QVBoxLayout>

#include "apps/studio/help/help_window.h"
#include "apps/studio/language.h"
#include "apps/studio/window/languages.h"

namespace dgt::studio {
namespace {

constexpr QSize kFirstSize(1366, 768);
/// Places of docks and tools that an older layout does not know are not taken from it.
constexpr int kLayoutVersion = 1;

}  // namespace

MainWindow::MainWindow(const Options& options, QWidget* parent)
    : QMainWindow(parent),
      actions_(new Actions(this)),
      notices_(new NoticeBar),
      editor_(new SourceEditor),
      find_bar_(nullptr),
      panels_(nullptr),
      fields_(new StatusFields(statusBar(), this)),
      documents_(new Documents(editor_, notices_, &settings_, this)),
      compiler_(new LiveCompiler([this] { return editor_->text(); }, this)) {
  setObjectName(QStringLiteral("main_window"));
  use_language(options.language.value_or(settings_.language()));
  const Theme theme = options.theme.value_or(settings_.theme());
  Appearance::of_program().set(theme, settings_.colours(theme));
  resize(kFirstSize);
  build_centre();
  panels_ = new Panels(this);
  build_menus();
  build_tools();
  join_actions();
  join_text_actions();
  join_panels();
  join_documents();
  editor_->set_font_size(settings_.font_size());
  actions_->live->setChecked(settings_.draws_live());
  use_machine(options.machine_file.isEmpty() ? settings_.machine_file() : options.machine_file);
  restoreGeometry(settings_.geometry());
  restoreState(settings_.layout(), kLayoutVersion);
  retranslate();
  editor_->setFocus();
}

MainWindow::~MainWindow() {
  delete help_;  // a window of its own, without a parent
}

void MainWindow::build_centre() {
  auto* const centre = new QWidget(this);
  auto* const column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  find_bar_ = new FindBar(editor_, centre);
  column->addWidget(notices_);
  column->addWidget(editor_, 1);
  column->addWidget(find_bar_);
  setCentralWidget(centre);
}

void MainWindow::join_documents() {
  connect(documents_, &Documents::opened, this, [this] {
    compiler_->set_source(documents_->document().name(), machine_);
    compiler_->compile_now();
    editor_->setFocus();
  });
  connect(documents_, &Documents::document_changed, this, [this] {
    fields_->show_form(documents_->document().form());
    show_title();
  });
  connect(documents_, &Documents::recent_changed, this,
          [this] { actions_->show_recent(settings_.recent_files()); });
  connect(documents_, &Documents::told, this,
          [this](const QString& sentence) { statusBar()->showMessage(sentence, 10000); });
  connect(fields_, &StatusFields::read_again_wanted, documents_, &Documents::read_again_as);
  connect(fields_, &StatusFields::encoding_chosen, documents_, &Documents::set_encoding);
  connect(fields_, &StatusFields::line_end_chosen, documents_, &Documents::set_line_end);
  connect(editor_->document(), &QTextDocument::contentsChanged, compiler_, &LiveCompiler::touch);
  connect(compiler_, &LiveCompiler::made, this, &MainWindow::take_part);
  connect(compiler_, &LiveCompiler::working, fields_, &StatusFields::show_working);
  connect(compiler_, &LiveCompiler::failed, this, [this](const QString& why) {
    statusBar()->showMessage(tr("The compiler failed: %1").arg(why));
  });
  actions_->show_recent(settings_.recent_files());
}

void MainWindow::show_title() {
  setWindowTitle(tr("%1[*] – DGT Studio").arg(documents_->title()));
  setWindowModified(editor_->document()->isModified());
}

void MainWindow::set_language(Language language) {
  settings_.set_language(language);
  use_language(language);
}

void MainWindow::set_theme(Theme theme) {
  settings_.set_theme(theme);
  Appearance::of_program().set(theme, settings_.colours(theme));
}

void MainWindow::set_font_size(int points) {
  settings_.set_font_size(points);
  editor_->set_font_size(settings_.font_size());
}

// A layout that was made on a larger screen must not leave the window outside of this one.
void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (std::exchange(shown_once_, true)) return;
  if (settings_.layout().isEmpty()) panels_->lay_out();
  const QRect room = screen()->availableGeometry();
  if (!room.contains(frameGeometry().center())) move(room.topLeft());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!documents_->may_close() || !may_leave_nc()) {
    event->ignore();
    return;
  }
  documents_->finish();
  settings_.set_window(saveGeometry(), saveState(kLayoutVersion));
  delete std::exchange(help_, nullptr);
  QMainWindow::closeEvent(event);
}

bool MainWindow::may_leave_nc() {
  if (!panels_->nc->has_unsaved_edits()) return true;
  QMessageBox question(QMessageBox::Question, tr("DGT Studio"),
                       tr("The NC program was changed by hand and is not saved. Save it?"),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  question.setDefaultButton(QMessageBox::Save);
  const int answer = question.exec();
  if (answer != QMessageBox::Save) return answer == QMessageBox::Discard;
  panels_->nc->save();
  return !panels_->nc->has_unsaved_edits();
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) {
    QMainWindow::keyPressEvent(event);
  } else if (find_bar_->isVisible()) {
    find_bar_->close_bar();
  } else if (!panels_->leave()) {
    ask_to_exit();
  }
}

void MainWindow::ask_to_exit() {
  // Whoever has something unsaved is asked about that.
  if (!editor_->document()->isModified()) {
    QMessageBox question(QMessageBox::Question, tr("DGT Studio"), tr("Exit DGT Studio?"),
                         QMessageBox::Yes | QMessageBox::No, this);
    question.setDefaultButton(QMessageBox::Yes);
    if (question.exec() != QMessageBox::Yes) return;
  }
  close();
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::LanguageChange && panels_ != nullptr) retranslate();
}

}  // namespace dgt::studio
