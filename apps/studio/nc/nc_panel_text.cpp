// SPDX-License-Identifier: GPL-3.0-or-later
//
// The NC text as a person changes it: read back, proved, saved.
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTextBlock>

#include "apps/driver/nc_files.h"
#include "apps/driver/tape_jobs.h"
#include "apps/driver/write_messages.h"
#include "apps/studio/editor/fault_list.h"
#include "apps/studio/editor/source_editor.h"
#include "apps/studio/language.h"
#include "apps/studio/nc/certificate_page.h"
#include "apps/studio/nc/machine_sentences.h"
#include "apps/studio/nc/nc_bar.h"
#include "apps/studio/nc/nc_panel.h"
#include "apps/studio/window/notice_bar.h"

namespace dgt::studio {
namespace {

const auto kFile = QStringLiteral("file");

/// What no control and no tape has letters for.
std::vector<Fault> foreign_letters(const QTextDocument& text) {
  std::vector<Fault> faults;
  for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
    const QString line = block.text();
    for (qsizetype i = 0; i < line.size(); ++i) {
      if (line[i].unicode() < 0x80) continue;
      Fault fault;
      fault.severity = Severity::Warning;
      fault.text = NcPanel::tr("“%1” is no character that controls know; it is saved as UTF-8.")
                       .arg(line[i]);
      const auto number = static_cast<std::uint32_t>(block.blockNumber() + 1);
      fault.at.place = {number, static_cast<std::uint32_t>(i + 1), 1};
      faults.push_back(std::move(fault));
      break;  // one a line is enough
    }
  }
  return faults;
}

}  // namespace

// --- messages

/// In the language of the moment.
void NcPanel::collect_messages() {
  told_.clear();
  if (written_) {
    told_ = messages_of(written_->machine, message_language());
    Compilation writer;  // its places are those of the part's sources
    writer.bag = written_->said;
    for (Fault& fault : faults_of(writer, message_language())) told_.push_back(std::move(fault));
  }
  read_from_ = told_.size();
  if (read_) {
    for (Fault& fault : faults_of(read_->compilation, message_language()))
      told_.push_back(std::move(fault));
  }
  if (is_edited()) {  // what is written has none
    for (Fault& fault : foreign_letters(*editor_->document())) told_.push_back(std::move(fault));
  }
  show_faults();
}

// --- reading back

bool NcPanel::is_edited() const {
  return written_ && written_->exists() && editor_->document()->isModified();
}

void NcPanel::take_edit() {
  if (is_loading_ || !written_ || !written_->exists()) return;
  is_saved_ = false;
  proof_page_->outdate();
  proving_.forget();
  reading_soon_.start();
  update_labels();
}

void NcPanel::read_text() {
  if (!written_ || !written_->exists()) return;
  const std::string bytes = program().toStdString();
  const std::string name = suggested_name().toStdString();
  reading_.ask([this, base = written_, name, bytes]() -> Background::Outcome {
    const PartPtr read = read_nc(*base, name, bytes);
    return [this, read] { take_read(read); };
  });
}

void NcPanel::take_read(const PartPtr& read) {
  read_ = read;
  collect_messages();
  if (read->path() != nullptr && is_edited()) {
    is_redrawn_ = true;
    emit part_read(read);
  } else if (!is_edited() && std::exchange(is_redrawn_, false)) {
    emit part_read(part_);
  }
  emit read_back();
}

void NcPanel::show_faults() {
  faults_->show_faults(told_);
  const auto first =
      told_.begin() + static_cast<std::ptrdiff_t>(std::min(read_from_, told_.size()));
  editor_->show_faults({first, told_.end()});
  tabs_->setTabText(0, told_.empty() ? tr("Messages") : tr("Messages (%1)").arg(told_.size()));
}

// Places of the writer are in the sources of the part that was written.
void NcPanel::go_to_source(const QString& file, int line, int column) {
  if (!written_ || !written_->wish.part || written_->wish.part->path() == nullptr) return;
  const std::vector<std::string>& files = written_->wish.part->path()->files;
  const auto found = std::ranges::find(files, file.toStdString());
  if (found != files.end())
    emit place_chosen(static_cast<int>(found - files.begin()), line, column);
}

// --- proving

/// The part as it is now; while its source has errors, as it was when the text was written.
PartPtr NcPanel::exact_part() const {
  return part_ && part_->path() != nullptr ? part_ : written_->wish.part;
}

void NcPanel::verify() {
  if (!written_ || !written_->exists()) return;
  const std::string bytes = program().toStdString();
  const std::string name = suggested_name().toStdString();
  proving_.ask([this, base = written_, exact = exact_part(), name, bytes]() -> Background::Outcome {
    const PartPtr read = read_nc(*base, name, bytes);
    std::optional<Certificate> proof;
    if (read->path() != nullptr) proof = prove_nc(*read, *exact, base->settings());
    return [this, read, proof] { take_proof(read, proof); };
  });
}

void NcPanel::take_proof(const PartPtr& read, const std::optional<Certificate>& proof) {
  if (proof) {
    proof_page_->show_proof(*proof);
  } else {
    take_read(read);
    proof_page_->show_refusal(tr("The text has errors; it is no program that could be proved."));
  }
  tabs_->setCurrentWidget(proof_page_);
  emit verified();
}

// --- files

QByteArray NcPanel::program() const {
  if (!written_ || !written_->exists()) return {};
  if (!is_edited()) return QByteArray::fromStdString(written_->written.text);
  return QByteArray::fromStdString(
      with_line_ends(editor_->text().toStdString(), written_->settings().dialect.line_end));
}

QString NcPanel::suggested_name() const {
  if (!file_.isEmpty()) return file_;
  if (!part_ || !written_ || !written_->exists()) return {};
  const QFileInfo source(QString::fromStdString(part_->name));
  const QString name =
      source.completeBaseName() + QString::fromLatin1(extension_of(written_->settings().dialect));
  return source.path() == QStringLiteral(".") ? name : source.path() + u'/' + name;
}

void NcPanel::save() {
  if (file_.isEmpty()) {
    save_as();
  } else {
    (void)save_to(file_);
  }
}

void NcPanel::save_as() {
  if (!written_ || !written_->exists()) return;
  auto* dialog = new QFileDialog(this, tr("Save the NC program"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QString extension = QString::fromLatin1(extension_of(written_->settings().dialect)).mid(1);
  dialog->setNameFilters({tr("NC programs (*.%1)").arg(extension), tr("All files (*)")});
  dialog->setDefaultSuffix(extension);
  const QFileInfo suggested(suggested_name());
  dialog->setDirectory(suggested.path());
  dialog->selectFile(suggested.fileName());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& file) { (void)save_to(file); });
  dialog->open();
}

// While the NC text has the focus, the key that saves means it and not the source.
bool NcPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool is_key =
      event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!is_key || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Save))
    return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::KeyPress) save();
  event->accept();
  return true;
}

bool NcPanel::save_to(const QString& file) {
  const QByteArray bytes = program();
  const auto done =
      write_file(file.toStdString(), {bytes.data(), static_cast<std::size_t>(bytes.size())});
  if (!done) {
    const QString why = QString::fromStdString(done.error().text());
    notices_->show_notice({kFile,
                           [why] { return tr("The NC program was not saved: %1").arg(why); },
                           {{[] { return tr("Close"); }, [] {}}}});
    return false;
  }
  notices_->withdraw(kFile);
  file_ = file;
  is_saved_ = true;
  update_labels();
  return true;
}

// --- words

void NcPanel::update_labels() {
  const bool exists = written_ && written_->exists();
  bar_->enable(exists);
  certificate_line_->setVisible(exists);
  if (!exists) return;
  const WriteReport& report = written_->written.report;
  QString line = tr("%1: blocks: %2, at most %3 mm off the exact path (certified).")
                     .arg(QString::fromStdString(written_->settings().dialect.name))
                     .arg(report.blocks)
                     .arg(QString::fromStdString(told(report.deviation)));
  if (is_edited()) {
    line =
        tr("<b>Edited by hand</b>: nothing is certified any more. Verify proves the text as it "
           "stands.");
  }
  if (is_saved_) line += u' ' + tr("Saved as %1.").arg(QFileInfo(file_).fileName());
  certificate_line_->setText(line);
}

void NcPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

// What was said is said anew: messages come in the language of the moment.
void NcPanel::retranslate() {
  bar_->show_dialect(dialect_);
  tabs_->setTabText(1, tr("Certificate"));
  if (stack_->currentIndex() == 0 && !why_not().isEmpty()) why_->setText(why_not());
  update_labels();
  collect_messages();
}

}  // namespace dgt::studio
