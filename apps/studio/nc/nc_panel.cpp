// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/nc/nc_panel.h"

#include <QClipboard>
#include <QEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLabel>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTextBlock>
#include <QVBoxLayout>

#include "apps/driver/nc_files.h"
#include "apps/driver/write_messages.h"
#include "apps/studio/editor/fault_list.h"
#include "apps/studio/editor/source_editor.h"
#include "apps/studio/language.h"
#include "apps/studio/nc/certificate_page.h"
#include "apps/studio/nc/dialect_dialog.h"
#include "apps/studio/nc/machine_sentences.h"
#include "apps/studio/nc/nc_bar.h"
#include "apps/studio/window/notice_bar.h"
#include "apps/studio/window/print.h"
#include "apps/studio/window/settings_store.h"

namespace dgt::studio {
namespace {

constexpr int kQuietBeforeReading = 400;  // ms without a key
constexpr int kTextLines = 40;            // to so many of messages, as far as there is room
constexpr int kMessageLines = 13;
const auto kOverwrite = QStringLiteral("overwrite");

}  // namespace

NcPanel::NcPanel(QWidget* parent) : QWidget(parent) {
  dialect_ = SettingsStore().panel(QStringLiteral("nc/dialect"), {}).toString();
  lay_out();
  connect_parts();
  reading_soon_.setSingleShot(true);
  reading_soon_.setInterval(kQuietBeforeReading);
  show_why_not(why_not());
  retranslate();
}

NcPanel::~NcPanel() = default;

void NcPanel::lay_out() {
  bar_ = new NcBar(this);
  notices_ = new NoticeBar(this);
  certificate_line_ = new QLabel(this);
  certificate_line_->setObjectName(QStringLiteral("certificate"));
  certificate_line_->setWordWrap(true);
  stack_ = new QStackedWidget(this);
  why_ = new QLabel(stack_);
  why_->setObjectName(QStringLiteral("why_not"));
  why_->setWordWrap(true);
  why_->setAlignment(Qt::AlignCenter);
  editor_ = new SourceEditor(stack_);
  setFocusProxy(editor_);
  editor_->installEventFilter(this);
  stack_->addWidget(why_);
  stack_->addWidget(editor_);
  tabs_ = new QTabWidget(this);
  faults_ = new FaultList(tabs_);
  proof_page_ = new CertificatePage(tabs_);
  tabs_->addTab(faults_, QString());
  tabs_->addTab(proof_page_, QString());
  auto* split = new QSplitter(Qt::Vertical, this);
  split->addWidget(stack_);
  split->addWidget(tabs_);
  split->setStretchFactor(0, 1);
  const int lines = fontMetrics().lineSpacing();
  split->setSizes({lines * kTextLines, lines * kMessageLines});
  split->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  const int margin = fontMetrics().height() / 4;
  column->setContentsMargins(margin, margin, margin, 0);
  column->addWidget(bar_);
  column->addWidget(certificate_line_);
  column->addWidget(notices_);
  column->addWidget(split, 1);
}

void NcPanel::connect_parts() {
  connect(bar_, &NcBar::dialect_wanted, this, [this] { (void)choose_dialect(); });
  connect(bar_, &NcBar::compensation_chosen, this, [this](Compensation chosen) {
    compensation_ = chosen;
    keeps_text_ = false;
    write_anew();
  });
  connect(bar_, &NcBar::save_wanted, this, &NcPanel::save);
  connect(bar_, &NcBar::save_as_wanted, this, &NcPanel::save_as);
  connect(bar_, &NcBar::copy_wanted, this, [this] {
    const QTextCursor cursor = editor_->textCursor();
    if (cursor.hasSelection()) {
      editor_->copy();
    } else {
      QGuiApplication::clipboard()->setText(editor_->text());
    }
  });
  connect(bar_, &NcBar::print_wanted, this, [this] {
    print_source(editor_->document(), QFileInfo(suggested_name()).fileName(), this);
  });
  connect(bar_, &NcBar::punch_wanted, this, [this] { emit punch_wanted(program()); });
  connect(bar_, &NcBar::verify_wanted, this, &NcPanel::verify);
  connect(editor_->document(), &QTextDocument::contentsChanged, this, &NcPanel::take_edit);
  connect(&reading_soon_, &QTimer::timeout, this, &NcPanel::read_text);
  connect(faults_, &FaultList::place_chosen, this, &NcPanel::go_to_source);
  connect(faults_, &FaultList::fault_chosen, this, [this](int fault) {
    const auto place = editor_->place_of(static_cast<std::size_t>(fault) - read_from_);
    if (place) editor_->setTextCursor(*place);
    editor_->setFocus();
  });
  connect(proof_page_, &CertificatePage::line_chosen, this, [this](int line) {
    editor_->go_to(line);
    editor_->setFocus();
  });
  connect(&proving_, &Background::busy_changed, bar_, &NcBar::show_verifying);
  for (Background* const work : {&writing_, &reading_, &proving_})
    connect(work, &Background::failed, this, &NcPanel::show_why_not);
}

// --- writing

void NcPanel::set_machine(const QString& file) {
  if (file == machine_) return;
  machine_ = file;
  compensation_.reset();
  keeps_text_ = false;
  write_anew();
}

void NcPanel::show_part(PartPtr part) {
  if (part_ && part && part->name != part_->name) file_.clear();
  part_ = std::move(part);
  write_anew();
}

bool NcPanel::choose_dialect() {
  SettingsStore store;
  const auto own = QStringLiteral("nc/own_dialects");
  DialectDialog dialog(dialect_, store.panel(own, {}).toStringList(), this);
  if (dialog.exec() != QDialog::Accepted || dialog.dialect().isEmpty()) return false;
  store.set_panel(own, dialog.own_files());
  set_dialect(dialog.dialect());
  return true;
}

void NcPanel::set_dialect(const QString& name) {
  if (name != dialect_) {
    file_.clear();
    compensation_.reset();
  }
  dialect_ = name;
  SettingsStore().set_panel(QStringLiteral("nc/dialect"), name);
  bar_->show_dialect(name);
  keeps_text_ = false;
  write_anew();
}

QString NcPanel::why_not() const {
  if (!part_) return tr("There is no program yet.");
  if (part_->path() == nullptr) return tr("The program has errors; there is no NC program.");
  if (dialect_.isEmpty()) return tr("Choose the control that the NC program is for (F8).");
  return {};
}

void NcPanel::write_anew() {
  if (is_edited()) {
    if (why_not().isEmpty() && !keeps_text_) ask_to_overwrite();
    return;
  }
  is_stale_ = !isVisible();
  if (!is_stale_) start_writing();
}

void NcPanel::start_writing() {
  is_stale_ = false;
  notices_->withdraw(kOverwrite);
  if (const QString why = why_not(); !why.isEmpty()) {
    writing_.forget();
    written_.reset();
    read_.reset();
    show_why_not(why);
    emit written();
    return;
  }
  const NcWish wish{part_, {machine_.toStdString(), {}, dialect_.toStdString()}, compensation_};
  writing_.ask([this, wish]() -> Background::Outcome {
    const NcProgramTextPtr made = write_nc(wish);
    return [this, made] { show_written(made); };
  });
}

// The text of a person stays until the person says otherwise.
void NcPanel::ask_to_overwrite() {
  notices_->show_notice(
      {kOverwrite,
       [] {
         return tr("The NC text was changed by hand, and there is a new program to be written.");
       },
       {{[] { return tr("Write anew, lose the changes"); }, [this] { start_writing(); }},
        {[] { return tr("Keep the text"); }, [this] { keep_text(); }}}});
}

void NcPanel::keep_text() {
  keeps_text_ = true;
  dialect_ = QString::fromStdString(written_->wish.machine.dialect);
  compensation_ = written_->wish.compensation;
  bar_->show_dialect(dialect_);
  bar_->show_compensation(written_->settings().dialect.compensation);
}

void NcPanel::show_written(const NcProgramTextPtr& made) {
  written_ = made;
  read_.reset();
  reading_soon_.stop();
  reading_.forget();
  proving_.forget();
  proof_page_->clear();
  is_saved_ = false;
  keeps_text_ = false;
  if (made->machine.settings) bar_->show_compensation(made->settings().dialect.compensation);
  if (made->exists()) {
    show_program();
  } else {
    const QString why =
        made->machine.settings ? QString() : sentence_of(made->machine.settings.error());
    show_why_not(tr("Nothing was written.") + u' ' +
                 (why.isEmpty() ? tr("The messages below say why.") : why));
  }
  collect_messages();
  if (std::exchange(is_redrawn_, false)) emit part_read(part_);
  emit written();
}

void NcPanel::show_program() {
  is_loading_ = true;
  const int scrolled = editor_->verticalScrollBar()->value();
  editor_->set_language(language_of(written_->settings().dialect));
  std::string text = written_->written.text;
  if (written_->settings().dialect.line_end == "\r\n") std::erase(text, '\r');
  editor_->setPlainText(QString::fromStdString(text));
  editor_->document()->setModified(false);
  editor_->verticalScrollBar()->setValue(scrolled);
  is_loading_ = false;
  stack_->setCurrentWidget(editor_);
  update_labels();
}

void NcPanel::show_why_not(const QString& why) {
  is_loading_ = true;
  editor_->clear();
  editor_->document()->setModified(false);
  is_loading_ = false;
  proof_page_->clear();
  why_->setText(why);
  stack_->setCurrentWidget(why_);
  collect_messages();
  update_labels();
}

void NcPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (is_stale_ && !is_edited()) start_writing();
}

}  // namespace dgt::studio
