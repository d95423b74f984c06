// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/documents.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "apps/driver/pipeline.h"

namespace dgt::studio {
namespace {

constexpr auto kOnDisk = "disk";
constexpr auto kReading = "reading";

QString subject(const char* name) { return QString::fromLatin1(name); }

}  // namespace

Documents::Documents(SourceEditor* editor, NoticeBar* notices, SettingsStore* settings,
                     QObject* parent)
    : QObject(parent),
      editor_(editor),
      notices_(notices),
      settings_(settings),
      recovery_(Recovery::standard_folder(), this) {
  connect(&document_, &Document::changed, this, &Documents::document_changed);
  connect(&document_, &Document::changed_on_disk, this, &Documents::note_disk);
  connect(&recovery_, &Recovery::wanted, this, &Documents::keep);
  connect(&recovery_, &Recovery::kept, this, &Documents::drop_restored);
  connect(&recovery_, &Recovery::failed, this, [this](const QString& why) {
    emit told(tr("Unsaved text cannot be kept for recovery: %1").arg(why));
  });
  connect(editor_->document(), &QTextDocument::contentsChanged, this, [this] {
    if (editor_->document()->isModified()) recovery_.touch();
  });
  connect(editor_->document(), &QTextDocument::modificationChanged, this, [this](bool modified) {
    if (!modified) forget();
    emit document_changed();
  });
}

QWidget* Documents::window() const { return editor_->window(); }

QString Documents::title() const {
  return document_.name().isEmpty() ? tr("New program") : document_.title();
}

void Documents::tell_failure(const QString& sentence) {
  QMessageBox::warning(window(), tr("DGT Studio"), sentence);
}

QString Documents::file_filters() const {
  return QStringList{tr("Programs (*.bgt *.dgt *.BGT *.DGT)"), tr("Macros (*.mac *.MAC)"),
                     tr("NC programs (*.ess *.essi *.nc *.cnc *.gcode *.ngc *.tap *.3b)"),
                     tr("Polylines (*.poly)"), tr("All files (*)")}
      .join(QStringLiteral(";;"));
}

QString Documents::suggested_name() const {
  if (!document_.name().isEmpty()) return document_.name();
  const QStringList recent = settings_->recent_files();
  const QString folder = recent.isEmpty()
                             ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                             : QFileInfo(recent.first()).absolutePath();
  return folder + QStringLiteral("/program.bgt");
}

bool Documents::may_close() {
  if (!editor_->document()->isModified()) return true;
  QMessageBox question(QMessageBox::Question, tr("DGT Studio"),
                       tr("%1 has changes that are not saved. Save them?").arg(title()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window());
  question.setDefaultButton(QMessageBox::Save);
  switch (question.exec()) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

bool Documents::start_new() {
  if (!may_close()) return false;
  document_.start_new();
  show_loaded({});
  return true;
}

bool Documents::open() {
  const QString name = QFileDialog::getOpenFileName(
      window(), tr("Open"), QFileInfo(suggested_name()).absolutePath(), file_filters());
  return !name.isEmpty() && open_file(name);
}

bool Documents::open_file(const QString& name) {
  if (!may_close()) return false;
  const auto loaded = document_.load(name);
  if (!loaded) {
    settings_->remove_recent_file(name);
    emit recent_changed();
    tell_failure(loaded.error());
    return false;
  }
  show_loaded(*loaded);
  settings_->add_recent_file(document_.name());
  emit recent_changed();
  return true;
}

bool Documents::read_again_as(Encoding encoding) {
  if (document_.name().isEmpty()) {
    set_encoding(encoding);
    return true;
  }
  if (!may_close()) return false;
  const auto loaded = document_.load(document_.name(), encoding);
  if (!loaded) {
    tell_failure(loaded.error());
    return false;
  }
  show_loaded(*loaded);
  return true;
}

bool Documents::read_from_disk() {
  const int line = editor_->current_line();
  const auto loaded = document_.load(document_.name(), document_.form().encoding);
  if (!loaded) {
    tell_failure(loaded.error());
    return false;
  }
  show_loaded(*loaded);
  editor_->go_to(line);
  return true;
}

bool Documents::take_text(const QString& text) {
  if (!may_close()) return false;
  document_.start_new();
  show_loaded({.text = text, .form = {}});
  editor_->document()->setModified(true);
  return true;
}

void Documents::show_loaded(const LoadedText& loaded) {
  forget();
  notices_->withdraw(subject(kOnDisk));
  notices_->withdraw(subject(kReading));
  const std::string name = document_.name().toStdString();
  editor_->set_language(language_of(name).value_or(InputLanguage::Dgt));
  QApplication::setOverrideCursor(Qt::WaitCursor);  // 10 MB take a second
  editor_->setPlainText(loaded.text);
  QApplication::restoreOverrideCursor();
  editor_->document()->setModified(false);
  tell_how_read(loaded);
  emit opened();
  emit document_changed();
}

void Documents::tell_how_read(const LoadedText& loaded) {
  if (loaded.strays > 0) {
    notices_->show_notice(
        {subject(kReading),
         [count = loaded.strays] {
           return tr("Bytes of the file that are no text in this encoding: %1. Saving would lose "
                     "them. Choose another encoding at the bottom of the window.")
               .arg(count);
         },
         {{[] { return tr("OK"); }, {}}}});
  } else if (loaded.unsure) {
    notices_->show_notice({subject(kReading),
                           [] {
                             return tr(
                                 "The encoding of the file was guessed. If letters look "
                                 "wrong, choose another at the bottom of the window.");
                           },
                           {{[] { return tr("OK"); }, {}}}});
  } else if (loaded.form.mixed_line_ends) {
    emit told(tr("Lines of the file end in different ways; saving makes them alike."));
  }
}

bool Documents::save() {
  return document_.name().isEmpty() ? save_as() : save_to(document_.name());
}

bool Documents::save_as() {
  QFileDialog dialog(window(), tr("Save as"), suggested_name(), file_filters());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("bgt"));
  dialog.selectFile(QFileInfo(suggested_name()).fileName());
  if (dialog.exec() != QDialog::Accepted) return false;
  return save_to(dialog.selectedFiles().value(0));
}

// Nobody's work is written over unasked: neither the other's on disk nor letters of one's own.
bool Documents::save_to(const QString& name) {
  const QString text = editor_->text();
  if (name == document_.name() && !agree_to_write_over()) return false;
  if (!agree_to_encoding(text)) return false;
  const auto saved = document_.save(name, text);
  if (!saved) {
    tell_failure(tr("The program was not saved. %1\nYour text is still here; save it elsewhere.")
                     .arg(saved.error()));
    return false;
  }
  notices_->withdraw(subject(kOnDisk));
  editor_->document()->setModified(false);
  forget();
  editor_->set_language(language_of(document_.name().toStdString()).value_or(InputLanguage::Dgt));
  settings_->add_recent_file(document_.name());
  emit recent_changed();
  emit document_changed();
  emit told(tr("Saved: %1").arg(document_.name()));
  return true;
}

bool Documents::agree_to_write_over() {
  if (document_.on_disk() != Document::OnDisk::Changed) return true;
  QMessageBox question(
      QMessageBox::Warning, tr("DGT Studio"),
      tr("%1 has been changed on disk by another program. Write over it?").arg(title()),
      QMessageBox::Cancel, window());
  const QPushButton* const write =
      question.addButton(tr("Write over"), QMessageBox::DestructiveRole);
  question.exec();
  return question.clickedButton() == write;
}

bool Documents::agree_to_encoding(const QString& text) {
  const QString lacking = document_.unsayable(text);
  if (lacking.isEmpty()) return true;
  QMessageBox question(
      QMessageBox::Question, tr("DGT Studio"),
      tr("The encoding %1 has no “%2”. Save the file as UTF-8?")
          .arg(QString::fromUtf8(name_of(document_.form().encoding).data()), lacking.left(20)),
      QMessageBox::Cancel, window());
  const QPushButton* const utf8 = question.addButton(tr("As UTF-8"), QMessageBox::AcceptRole);
  const QPushButton* const marks =
      question.addButton(tr("With “?” instead"), QMessageBox::DestructiveRole);
  question.exec();
  if (question.clickedButton() == utf8) {
    set_encoding(Encoding::Utf8);
    return true;
  }
  return question.clickedButton() == marks;
}

void Documents::set_encoding(Encoding encoding) {
  TextForm form = document_.form();
  if (form.encoding == encoding) return;
  form.encoding = encoding;
  form.byte_order_mark = false;
  document_.set_form(form);
  editor_->document()->setModified(true);
  recovery_.touch();
}

void Documents::set_line_end(LineEnd line_end) {
  TextForm form = document_.form();
  if (form.line_end == line_end) return;
  form.line_end = line_end;
  document_.set_form(form);
  editor_->document()->setModified(true);
  recovery_.touch();
}

void Documents::finish() { forget(); }

}  // namespace dgt::studio
