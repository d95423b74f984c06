// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tape dialog does: encodes, punches, reads, joins, compares. Nothing is handed on before
// it is whole.
#include <QCheckBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <utility>

#include "apps/driver/device_messages.h"
#include "apps/studio/editor/fault_list.h"
#include "apps/studio/editor/source_editor.h"
#include "apps/studio/language.h"
#include "apps/studio/tape/device_box.h"
#include "apps/studio/tape/format_box.h"
#include "apps/studio/tape/tape_dialog.h"
#include "apps/studio/tape/tape_view.h"
#include "device/join.h"

namespace dgt::studio {
namespace {

QString qt(const std::string& text) { return QString::fromStdString(text); }

std::vector<Fault> faults_in(const std::shared_ptr<const SourceFile>& file,
                             std::initializer_list<const DiagnosticBag*> bags) {
  std::vector<Fault> faults;
  for (const DiagnosticBag* const bag : bags) {
    Compilation told;
    told.file = file;
    told.bag = *bag;
    for (Fault& fault : faults_of(told, message_language())) faults.push_back(std::move(fault));
  }
  return faults;
}

std::set<std::size_t> damaged_rows(const DecodedTape& decoded) {
  std::set<std::size_t> rows;
  for (const TapeFault& fault : decoded.faults)
    if (fault.kind == TapeFault::Kind::Parity) rows.insert(fault.row);
  return rows;
}

}  // namespace

// --- what goes onto the tape

void TapeDialog::set_program(const QString& name, const QByteArray& bytes) {
  name_ = name;
  bytes_ = bytes;
  encode();
}

void TapeDialog::encode() {
  rows_.clear();
  update_buttons();
  TapeSettings settings = settings_;
  settings.format = format_box_->format();
  const auto format = format_for(settings, name_.toStdString(), settings.format.header);
  if (!format) {
    encoding_work_.forget();
    tell(tr("Lettering and checksum stand before the line %; the start has to be that line."),
         true);
    return;
  }
  format_ = *format;
  encoding_work_.ask([this, name = name_.toStdString(), bytes = bytes_.toStdString(),
                      encoding = encoding_, format = format_]() -> Background::Outcome {
    auto made = std::make_shared<ProgramOnTape>(program_on_tape(name, bytes, encoding, format));
    return [this, made] { show_encoded(made); };
  });
}

void TapeDialog::show_encoded(const std::shared_ptr<ProgramOnTape>& made) {
  rows_ = made->rows;
  text_->setPlainText(QString::fromUtf8(made->file->text().data(),
                                        static_cast<qsizetype>(made->file->text().size())));
  const auto faults = faults_in(made->file, {&made->reading, &made->punching});
  text_->show_faults(faults);
  faults_->show_faults(faults);
  view_->show_tape({rows_, {}});
  from_->setValue(1);
  if (rows_.empty()) {
    tabs_->setCurrentWidget(faults_);
    tell(tr("This cannot be punched; the messages say why. Unknown characters can be left out, or "
            "spelled in Latin letters."),
         true);
  } else {
    tell(tr("%1 rows, %2 mm of tape.").arg(rows_.size()).arg(qt(millimetres_to(rows_.size()))),
         false);
  }
  update_buttons();
}

// --- punching

void TapeDialog::start() {
  is_done_ = false;
  if (job_ == TapeJob::Punch || (job_ == TapeJob::Duplicate && !rows_.empty())) {
    start_punching();
    return;
  }
  reader_->remember();
  ReaderSettings reader = settings_.reader;
  reader.device = reader_->device().toStdString();
  progress_->setRange(0, 0);
  tell(tr("Reading…"), false);
  run_.read(reader, format_box_->format());
}

void TapeDialog::start_punching() {
  punch_->remember();
  PunchSettings punch = settings_.punch;
  punch.device = punch_->device().toStdString();
  const auto from = static_cast<std::size_t>(from_->value() - 1);
  progress_->setRange(0, static_cast<int>(rest_of(rows_, from, format_).size()));
  tell(tr("Punching…"), false);
  run_.punch(punch, rows_, from, format_);
}

void TapeDialog::end_punching() {
  is_done_ = true;
  view_->show_progress(rows_.size());
  tell(tr("Punched: %1 rows, %2 mm, on %3.")
           .arg(rows_.size())
           .arg(qt(millimetres_to(rows_.size())), punch_->device()),
       false);
  from_->setValue(1);
  update_buttons();
  emit ended();
}

void TapeDialog::tell_failed_punch(const PunchFailure& failure) {
  PunchSettings punch = settings_.punch;
  QString sentence = qt(sentence_of(failure.fault, limits_of(punch), message_language())) + u'.';
  using Kind = DeviceFault::Kind;
  const bool has_begun =
      failure.fault.kind != Kind::CannotOpen && failure.fault.kind != Kind::CannotSetUp;
  const auto from = static_cast<std::size_t>(from_->value() - 1);
  if (const auto whole = whole_blocks(rows_, failure, from, format_)) {
    sentence += u'\n' + tr("Whole blocks are on the tape up to row %1, %2 mm (line %3 of the "
                           "program). Cut it there; Punch goes on behind it.")
                            .arg(whole->rows)
                            .arg(qt(millimetres_to(whole->rows)))
                            .arg(whole->lines);
    from_->setValue(static_cast<int>(whole->rows + 1));
    view_->show_progress(whole->rows);
  } else if (has_begun) {
    sentence += u'\n' + tr("No whole block is on the tape; begin anew.");
  }
  tell(sentence, true);
  update_buttons();
  emit ended();
}

// --- reading

/// Puts this reading behind the one before that did not come to its end.
bool TapeDialog::join(Tape& tape) {
  if (!kept_ || !go_on_->isChecked() || tape.rows.empty()) return true;
  auto joined = join_readings(*kept_, tape);
  if (joined) {
    tape = *std::move(joined);
    return true;
  }
  tell(joined.error() == JoinFault::NoOverlap
           ? tr("What was read now does not hold the end of the reading before; begin the tape "
                "further ahead.")
           : tr("The end of the reading before fits in several places; begin the tape further "
                "ahead."),
       true);
  return false;
}

void TapeDialog::take(const TapeTaken& result) {
  TapeTaken taken = result;
  if (taken.file_error) {
    tell(qt(taken.file_error->text()), true);
  } else if (taken.image.bag.has_errors()) {
    faults_->show_faults(faults_in(taken.image.file, {&taken.image.bag}));
    tabs_->setCurrentWidget(faults_);
    tell(tr("This file holds no tape."), true);
  } else {
    const QString why =
        taken.reading.fault
            ? qt(sentence_of(*taken.reading.fault, limits_of(settings_.reader), message_language()))
            : QString();
    Tape& tape = taken.reading.tape;
    if (taken.reading.fault && !tape.rows.empty())
      tape.gaps.push_back({tape.rows.size(), why.toStdString()});
    const bool is_joined = join(tape);
    taken.program = read_program(reader_->device().toStdString(), tape, format_box_->format());
    if (is_joined) take_sound(taken);
    if (taken.reading.fault) {
      if (!tape.rows.empty() && is_joined) kept_ = tape;
      tell(why + u'.' +
               (kept_ ? u'\n' + tr("What was read so far is kept. Begin the tape anywhere "
                                   "before that place and read again.")
                      : QString()),
           true);
    }
    go_on_->setVisible(kept_.has_value());
  }
  retranslate();
  update_buttons();
  emit ended();
}

bool TapeDialog::is_same_again(const TapeTaken& again) {
  const DiagnosticBag bag =
      compare(first_->rows, again.reading.tape, 0, again.program, format_box_->format());
  const bool same = !bag.has_errors() && again.reading.tape.gaps.empty();
  if (!same) {
    faults_->show_faults(faults_in(again.program.file, {&again.program.bag, &bag}));
    tabs_->setCurrentWidget(faults_);
  }
  return same;
}

/// What has come to its end; it may be damaged all the same.
void TapeDialog::take_sound(const TapeTaken& taken) {
  const Tape& tape = taken.reading.tape;
  view_->show_tape(tape);
  show_program(taken.program);
  if (taken.reading.fault) return;
  kept_.reset();
  const DecodedTape& decoded = taken.program.decoded;
  if (decoded.is_damaged()) {
    first_.reset();
    tell(tr("Damaged places: %1; the messages say where.").arg(decoded.damage_count), true);
    return;
  }
  if (twice_->isChecked() && !first_) {
    first_ = tape;
    tell(
        tr("Read: %1 rows. Put the tape in again and read it a second time.").arg(tape.rows.size()),
        false);
    return;
  }
  if (first_ && !is_same_again(taken)) {
    first_.reset();
    tell(tr("The second reading is not the first; nothing is taken."), true);
    return;
  }
  first_.reset();
  is_done_ = true;
  QString sentence =
      tr("Read: %1 rows, %2 mm.").arg(tape.rows.size()).arg(qt(millimetres_to(tape.rows.size())));
  if (job_ == TapeJob::Duplicate) {
    rows_ = tape.rows;
    format_ = format_box_->format();
    sentence += u' ' + tr("Now the copy can be punched.");
  }
  tell(sentence, false);
}

void TapeDialog::show_program(const TapeProgram& program) {
  program_ = program;
  text_->setPlainText(qt(program.decoded.text));
  const auto faults = faults_in(program.file, {&program.bag});
  text_->show_faults(faults);
  faults_->show_faults(faults);
  view_->mark(damaged_rows(program.decoded));
  tabs_->setCurrentWidget(program.decoded.is_damaged() ? static_cast<QWidget*>(faults_) : view_);
}

void TapeDialog::open_text() {
  emit text_read(QByteArray::fromStdString(program_.decoded.text));
  accept();
}

void TapeDialog::save_picture() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the tape"), QString(),
      tr("Rows (*.tap);;Picture in letters (*.txt);;Drawing (*.svg);;Drawing (*.png)"));
  if (file.isEmpty()) return;
  encoding_work_.ask(
      [this, file = file.toStdString(), tape = view_->tape()]() -> Background::Outcome {
        const auto bytes = in_form(tape, tape_form_of(file).value_or(TapeForm::Raw));
        if (!bytes) {
          return [this, rows = tape.rows.size()] {
            tell(tr("%1 rows are too many for one PNG; save SVG.").arg(rows), true);
          };
        }
        const auto written = write_file(file, *bytes);
        return [this, file, why = written ? std::string() : written.error().text()] {
          tell(why.empty() ? tr("Saved as %1.").arg(qt(file)) : qt(why), !why.empty());
        };
      });
}

}  // namespace dgt::studio
