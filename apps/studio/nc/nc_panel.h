// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "apps/studio/background.h"
#include "apps/studio/editor/faults.h"
#include "apps/studio/nc/nc_work.h"
#include "apps/studio/part.h"

class QLabel;
class QStackedWidget;
class QTabWidget;

namespace dgt::studio {

class CertificatePage;
class FaultList;
class NcBar;
class NoticeBar;
class SourceEditor;

/// The NC program of a part: its text in a dialect, to be changed by hand, proved, saved and
/// punched.
class NcPanel : public QWidget {
  Q_OBJECT

 public:
  explicit NcPanel(QWidget* parent = nullptr);
  ~NcPanel() override;

  /// The machine file that a dialect's settings come from; empty: none.
  void set_machine(const QString& file);
  /// Writes the part's text anew in the dialect that was chosen, if one was. A text that was
  /// changed by hand is written over only when the person agrees.
  void show_part(PartPtr part);
  /// Asks for the dialect; false when the person would not say.
  bool choose_dialect();
  /// Chooses without asking: a name of `dgt compile --post list`, or a dialect file.
  void set_dialect(const QString& name);
  [[nodiscard]] QString dialect() const { return dialect_; }  ///< empty: none yet

  /// The program as it is saved and punched, byte for byte; empty when there is none.
  [[nodiscard]] QByteArray program() const;
  /// Whether the text is another than was written.
  [[nodiscard]] bool is_edited() const;
  /// Whether something typed here is in no file.
  [[nodiscard]] bool has_unsaved_edits() const { return is_edited() && !is_saved_; }
  /// Saves whole or not at all; a failure is told in the panel.
  bool save_to(const QString& file);

 public slots:
  void save();     ///< under the name it had, or asks
  void save_as();  ///< asks
  void verify();

 signals:
  /// The text as it stands, changed by hand or not, read back: to be drawn.
  void part_read(dgt::studio::PartPtr part);
  void punch_wanted(QByteArray text);
  /// A place in the part's source was asked for.
  void place_chosen(int file, int line, int column);
  /// The text has been written, refused or taken away.
  void written();
  /// The text as it stands has been read back.
  void read_back();
  /// A verification has come to its end.
  void verified();

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void lay_out();
  void connect_parts();
  // Writing.
  void write_anew();
  void start_writing();
  void show_written(const NcProgramTextPtr& made);
  void show_program();
  void show_why_not(const QString& why);
  void ask_to_overwrite();
  void keep_text();
  [[nodiscard]] QString why_not() const;
  // Reading back.
  void collect_messages();
  void take_edit();
  void read_text();
  void take_read(const PartPtr& read);
  void show_faults();
  void go_to_source(const QString& file, int line, int column);
  // Proving.
  void take_proof(const PartPtr& read, const std::optional<Certificate>& proof);
  [[nodiscard]] PartPtr exact_part() const;
  // Files.
  [[nodiscard]] QString suggested_name() const;
  void update_labels();
  void retranslate();

  QString machine_;
  QString dialect_;
  std::optional<Compensation> compensation_;  // chosen by hand
  PartPtr part_;
  NcProgramTextPtr written_;
  PartPtr read_;             // the text as it was last read back
  std::vector<Fault> told_;  // of the writer and the machine, then of what was read back
  std::size_t read_from_ = 0;
  QString file_;  // where it was saved
  bool is_saved_ = false;
  bool is_stale_ = false;    // to be written when it is seen
  bool keeps_text_ = false;  // what was typed stays, whatever becomes of the source
  bool is_loading_ = false;  // the text changes, not by a person
  bool is_redrawn_ = false;  // what is drawn is the text
  NcBar* bar_ = nullptr;
  NoticeBar* notices_ = nullptr;
  QLabel* certificate_line_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  QLabel* why_ = nullptr;
  SourceEditor* editor_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  FaultList* faults_ = nullptr;
  CertificatePage* proof_page_ = nullptr;
  QTimer reading_soon_;
  Background writing_{this};
  Background reading_{this};
  Background proving_{this};
};

}  // namespace dgt::studio
