// SPDX-License-Identifier: GPL-3.0-or-later
// What others do with the text: programs that change the file on disk, and kills after which it is
// offered again.
#include <QFileInfo>
#include <QLocale>

#include "apps/driver/pipeline.h"
#include "apps/studio/window/documents.h"

namespace dgt::studio {

void Documents::note_disk() {
  const QString subject = QStringLiteral("disk");
  if (document_.on_disk() == Document::OnDisk::Gone) {
    editor_->document()->setModified(true);
    notices_->show_notice(
        {subject,
         [name = document_.title()] {
           return tr("%1 is no longer on disk. Your text is still here.").arg(name);
         },
         {{[] { return tr("Save"); }, [this] { save(); }}, {[] { return tr("Leave"); }, {}}}});
    return;
  }
  const bool unsaved = editor_->document()->isModified();
  notices_->show_notice(
      {subject,
       [unsaved, name = document_.title()] {
         return unsaved ? tr("%1 has been changed on disk, and here too.").arg(name)
                        : tr("%1 has been changed on disk.").arg(name);
       },
       {{[unsaved] { return unsaved ? tr("Read it, give up mine") : tr("Read it"); },
         [this] { read_from_disk(); }},
        {[] { return tr("Keep mine"); },
         [this] {
           document_.accept_disk();
           editor_->document()->setModified(true);
           recovery_.touch();
         }}}});
}

void Documents::keep() {
  if (!editor_->document()->isModified()) return;
  recovery_.keep(
      {document_.name(), document_.form(), editor_->text(), QDateTime::currentDateTime()});
}

void Documents::offer_recovery() {
  for (const LeftText& left : recovery_.left_behind()) offer(left);
}

void Documents::offer(const LeftText& left) {
  const auto text = [left] {
    const QString when =
        QLocale().toString(left.kept.when, QLocale().dateTimeFormat(QLocale::ShortFormat));
    return left.kept.name.isEmpty()
               ? tr("The program ended without saving a new text of %1.").arg(when)
               : tr("The program ended without saving %1, changed %2.")
                     .arg(QFileInfo(left.kept.name).fileName(), when);
  };
  notices_->show_notice({left.file,
                         text,
                         {{[] { return tr("Restore"); }, [this, left] { restore(left); }},
                          {[] { return tr("Delete it"); }, [left] { Recovery::remove(left); }},
                          {[] { return tr("Later"); }, {}}}});
}

void Documents::restore(const LeftText& left) {
  if (!may_close()) {
    offer(left);
    return;
  }
  document_.take_over(left.kept.name, left.kept.form);
  show_loaded({.text = left.kept.text, .form = left.kept.form});
  editor_->document()->setModified(true);
  restored_ = left;
  keep();
}

void Documents::forget() {
  recovery_.forget();
  drop_restored();
}

void Documents::drop_restored() {
  if (restored_) Recovery::remove(*restored_);
  restored_.reset();
}

}  // namespace dgt::studio
