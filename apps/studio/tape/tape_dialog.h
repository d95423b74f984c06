// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDialog>

#include "apps/driver/settings.h"
#include "apps/studio/background.h"
#include "apps/studio/tape/tape_run.h"

class QCheckBox;
class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTabWidget;

namespace dgt::studio {

class DeviceBox;
class FaultList;
class FormatBox;
class SourceEditor;
class TapeView;

enum class TapeJob : std::uint8_t { Read, Punch, Duplicate };

/// Paper tape, on a device or in a file: reads a program, punches one, copies a tape.
class TapeDialog : public QDialog {
  Q_OBJECT

 public:
  TapeDialog(TapeJob job, const Settings& settings, QWidget* parent = nullptr);
  ~TapeDialog() override;

  /// What is to be punched: the bytes of a file of that name, source or NC program.
  void set_program(const QString& name, const QByteArray& bytes);

 signals:
  /// The program that was read, UTF-8, lines end in LF.
  void text_read(QByteArray text);
  /// The work that was started has come to its end, well or not.
  void ended();

 public slots:
  void reject() override;  ///< while a device works: stops it

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void lay_out(const Settings& settings);
  void add_devices();
  QWidget* result_tabs();
  void connect_parts();
  void update_buttons();
  void tell(const QString& sentence, bool is_error);
  void show_progress(std::size_t rows, double seconds);
  void retranslate();
  // What goes onto the tape.
  void encode();
  void show_encoded(const std::shared_ptr<ProgramOnTape>& made);
  // The jobs.
  void start();
  void start_punching();
  void end_punching();
  void tell_failed_punch(const PunchFailure& failure);
  void take(const TapeTaken& taken);
  void take_sound(const TapeTaken& taken);
  [[nodiscard]] bool join(Tape& tape);
  [[nodiscard]] bool is_same_again(const TapeTaken& again);
  void show_program(const TapeProgram& program);
  void open_text();
  void save_picture();
  [[nodiscard]] bool punches() const;

  TapeJob job_;
  TapeSettings settings_;
  std::optional<Encoding> encoding_;
  QString name_;
  QByteArray bytes_;
  std::vector<Row> rows_;      // that are to be punched
  TapeFormat format_;          // of them
  TapeProgram program_;        // that was read
  std::optional<Tape> kept_;   // a reading that has not come to its end
  std::optional<Tape> first_;  // to be compared with the second reading
  bool is_done_ = false;
  DeviceBox* reader_ = nullptr;
  DeviceBox* punch_ = nullptr;
  QLabel* reader_label_ = nullptr;
  QLabel* punch_label_ = nullptr;
  QLabel* from_label_ = nullptr;
  QSpinBox* from_ = nullptr;
  QCheckBox* twice_ = nullptr;
  QCheckBox* go_on_ = nullptr;
  QGroupBox* format_group_ = nullptr;
  FormatBox* format_box_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  TapeView* view_ = nullptr;
  SourceEditor* text_ = nullptr;
  FaultList* faults_ = nullptr;
  QLabel* status_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* stop_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* picture_ = nullptr;
  QPushButton* close_ = nullptr;
  Background encoding_work_{this};
  TapeRun run_{this};
};

}  // namespace dgt::studio
