// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "apps/studio/editor/source_editor.h"
#include "apps/studio/window/document.h"
#include "apps/studio/window/notice_bar.h"
#include "apps/studio/window/recovery.h"
#include "apps/studio/window/settings_store.h"

namespace dgt::studio {

/// What happens with files and whom it has to be asked: between the editor, the document on disk,
/// and the text kept for recovery. Nothing typed is ever lost without a question.
class Documents : public QObject {
  Q_OBJECT

 public:
  Documents(SourceEditor* editor, NoticeBar* notices, SettingsStore* settings, QObject* parent);

  [[nodiscard]] const Document& document() const { return document_; }
  /// How the title calls the document, in the language of the program.
  [[nodiscard]] QString title() const;

  // All of these are false when the person thought better of it, or it failed and was told.
  bool start_new();
  bool open();  ///< asks for the name
  bool open_file(const QString& name);
  bool save();
  bool save_as();
  bool may_close();  ///< saves or gives up what is unsaved
  bool read_again_as(Encoding encoding);
  /// A text from elsewhere, of a tape say, as a new document.
  bool take_text(const QString& text);

  void set_encoding(Encoding encoding);
  void set_line_end(LineEnd line_end);

  /// Offers what a program that is gone has left behind.
  void offer_recovery();
  /// Everything is saved or given up.
  void finish();

 signals:
  void opened();            ///< another text is in the editor
  void document_changed();  ///< its name or form
  void recent_changed();
  void told(QString sentence);  ///< for the status bar

 private:
  void show_loaded(const LoadedText& loaded);
  void tell_how_read(const LoadedText& loaded);
  bool save_to(const QString& name);
  bool agree_to_write_over();
  bool agree_to_encoding(const QString& text);
  bool read_from_disk();
  void keep();
  void note_disk();
  void offer(const LeftText& left);
  void restore(const LeftText& left);
  void forget();
  void drop_restored();
  void tell_failure(const QString& sentence);
  [[nodiscard]] QString suggested_name() const;
  [[nodiscard]] QString file_filters() const;
  [[nodiscard]] QWidget* window() const;

  SourceEditor* editor_;
  NoticeBar* notices_;
  SettingsStore* settings_;
  Document document_;
  Recovery recovery_;
  std::optional<LeftText> restored_;  ///< until it is kept under our name, saved or given up
};

}  // namespace dgt::studio
