// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/tape/tape_dialog.h"

#include <QCheckBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

#include "apps/studio/editor/fault_list.h"
#include "apps/studio/editor/source_editor.h"
#include "apps/studio/tape/device_box.h"
#include "apps/studio/tape/format_box.h"
#include "apps/studio/tape/tape_view.h"
#include "apps/studio/window/theme.h"

namespace dgt::studio {
namespace {

constexpr int kLettersWide = 110;
constexpr int kLinesHigh = 34;

/// The settings' format as the box shows it; lettering that is the name of the program is there.
TapeFormat shown_format(const TapeSettings& settings) { return settings.format; }

}  // namespace

TapeDialog::TapeDialog(TapeJob job, const Settings& settings, QWidget* parent)
    : QDialog(parent), job_(job), settings_(settings.tape), encoding_(settings.source.encoding) {
  lay_out(settings);
  connect_parts();
  retranslate();
  update_buttons();
  resize(fontMetrics().horizontalAdvance(u'0') * kLettersWide,
         fontMetrics().lineSpacing() * kLinesHigh);
}

TapeDialog::~TapeDialog() { run_.stop(); }

bool TapeDialog::punches() const { return job_ != TapeJob::Read; }

void TapeDialog::lay_out(const Settings& settings) {
  auto* left = new QWidget(this);
  auto* left_column = new QVBoxLayout(left);
  left_column->setContentsMargins(0, 0, 0, 0);
  auto* devices = new QFormLayout;
  devices->setRowWrapPolicy(QFormLayout::WrapAllRows);
  left_column->addLayout(devices);
  const auto row = [&](QLabel*& label, QWidget* field) {
    label = new QLabel(this);
    label->setBuddy(field);
    devices->addRow(label, field);
  };
  if (job_ != TapeJob::Punch) {
    reader_ = new DeviceBox(DeviceBox::Kind::Reader,
                            QString::fromStdString(settings.tape.reader.device), this);
    row(reader_label_, reader_);
  }
  if (punches()) {
    punch_ = new DeviceBox(DeviceBox::Kind::Punch,
                           QString::fromStdString(settings.tape.punch.device), this);
    row(punch_label_, punch_);
  }
  from_ = new QSpinBox(this);
  from_->setObjectName(QStringLiteral("from"));
  from_->setRange(1, 1);
  twice_ = new QCheckBox(this);
  go_on_ = new QCheckBox(this);
  go_on_->setObjectName(QStringLiteral("go_on"));
  go_on_->setChecked(true);
  go_on_->hide();
  if (punches()) {
    row(from_label_, from_);
  } else {
    from_->hide();
  }
  twice_->setVisible(job_ != TapeJob::Punch);
  left_column->addWidget(twice_);
  left_column->addWidget(go_on_);
  format_group_ = new QGroupBox(this);
  format_box_ =
      new FormatBox(job_ == TapeJob::Punch ? FormatBox::Part::Punching : FormatBox::Part::Reading,
                    shown_format(settings.tape), format_group_);
  auto* inside = new QVBoxLayout(format_group_);
  inside->addWidget(format_box_);
  left_column->addWidget(format_group_);
  left_column->addStretch();

  auto* middle = new QHBoxLayout;
  middle->addWidget(left);
  middle->addWidget(result_tabs(), 1);
  status_ = new QLabel(this);
  status_->setObjectName(QStringLiteral("status"));
  status_->setWordWrap(true);
  progress_ = new QProgressBar(this);
  progress_->setVisible(false);
  auto* buttons = new QHBoxLayout;
  const auto button = [&](QPushButton*& place, const char* name) {
    place = new QPushButton(this);
    place->setObjectName(QString::fromLatin1(name));
    place->setAutoDefault(false);
    buttons->addWidget(place);
  };
  button(picture_, "picture");
  buttons->addStretch();
  button(open_, "open");
  button(start_, "start");
  button(stop_, "stop");
  button(close_, "close");
  start_->setDefault(true);
  open_->setVisible(job_ == TapeJob::Read);
  auto* column = new QVBoxLayout(this);
  column->addLayout(middle, 1);
  column->addWidget(status_);
  column->addWidget(progress_);
  column->addLayout(buttons);
}

QWidget* TapeDialog::result_tabs() {
  tabs_ = new QTabWidget(this);
  view_ = new TapeView(tabs_);
  text_ = new SourceEditor(tabs_);
  text_->setReadOnly(true);
  text_->set_language(InputLanguage::Gcode);
  faults_ = new FaultList(tabs_);
  for (QWidget* const page : {static_cast<QWidget*>(view_), static_cast<QWidget*>(text_),
                              static_cast<QWidget*>(faults_)}) {
    tabs_->addTab(page, QString());
  }
  return tabs_;
}

void TapeDialog::connect_parts() {
  for (DeviceBox* const box : {reader_, punch_})
    if (box != nullptr) connect(box, &DeviceBox::changed, this, &TapeDialog::update_buttons);
  connect(format_box_, &FormatBox::changed, this, [this] {
    if (job_ == TapeJob::Punch) encode();
  });
  connect(start_, &QPushButton::clicked, this, &TapeDialog::start);
  connect(stop_, &QPushButton::clicked, this, [this] { run_.stop(); });
  connect(close_, &QPushButton::clicked, this, &TapeDialog::reject);
  connect(open_, &QPushButton::clicked, this, &TapeDialog::open_text);
  connect(picture_, &QPushButton::clicked, this, &TapeDialog::save_picture);
  connect(faults_, &FaultList::fault_chosen, this, [this](int fault) {
    tabs_->setCurrentWidget(text_);
    if (const auto place = text_->place_of(static_cast<std::size_t>(fault)))
      text_->setTextCursor(*place);
    text_->setFocus();
  });
  connect(&run_, &TapeRun::busy_changed, this, &TapeDialog::update_buttons);
  connect(&run_, &TapeRun::progress, this, &TapeDialog::show_progress);
  connect(&run_, &TapeRun::punched, this, &TapeDialog::end_punching);
  connect(&run_, &TapeRun::punch_failed, this, &TapeDialog::tell_failed_punch);
  connect(&run_, &TapeRun::taken, this, &TapeDialog::take);
}

void TapeDialog::reject() {
  if (run_.is_busy()) {
    run_.stop();
  } else {
    QDialog::reject();
  }
}

void TapeDialog::update_buttons() {
  const bool busy = run_.is_busy();
  const bool copies = job_ == TapeJob::Duplicate && !rows_.empty();
  const bool has_device =
      job_ == TapeJob::Punch || copies ? !punch_->device().isEmpty() : !reader_->device().isEmpty();
  start_->setEnabled(!busy && has_device && (job_ != TapeJob::Punch || !rows_.empty()));
  stop_->setEnabled(busy);
  close_->setEnabled(!busy);
  open_->setEnabled(!busy && !program_.decoded.text.empty());
  picture_->setEnabled(!busy && !view_->tape().rows.empty());
  progress_->setVisible(busy);
  for (QWidget* const field : {static_cast<QWidget*>(reader_), static_cast<QWidget*>(punch_),
                               static_cast<QWidget*>(format_group_), static_cast<QWidget*>(from_),
                               static_cast<QWidget*>(twice_), static_cast<QWidget*>(go_on_)}) {
    if (field != nullptr) field->setEnabled(!busy);
  }
  from_->setMaximum(std::max<int>(1, static_cast<int>(rows_.size())));
}

void TapeDialog::tell(const QString& sentence, bool is_error) {
  QPalette look = palette();
  if (is_error) look.setColor(QPalette::WindowText, colours().error);
  status_->setPalette(look);
  status_->setText(sentence);
}

void TapeDialog::show_progress(std::size_t rows, double seconds) {
  const auto total = static_cast<std::size_t>(progress_->maximum());
  const QString mm = QString::fromStdString(millimetres_to(rows));
  if (total == 0) {
    tell(tr("Row %1, %2 mm, %3 s.").arg(rows).arg(mm).arg(seconds, 0, 'f', 0), false);
    return;
  }
  progress_->setValue(static_cast<int>(rows));
  view_->show_progress(rows);
  const double left = rows == 0 ? 0
                                : seconds * static_cast<double>(total - std::min(total, rows)) /
                                      static_cast<double>(rows);
  tell(tr("Row %1 of %2, %3 mm; %4 s left.").arg(rows).arg(total).arg(mm).arg(left, 0, 'f', 0),
       false);
}

void TapeDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

void TapeDialog::retranslate() {
  setWindowTitle(job_ == TapeJob::Read    ? tr("Read a tape")
                 : job_ == TapeJob::Punch ? tr("Punch a tape")
                                          : tr("Copy a tape"));
  if (reader_label_ != nullptr) reader_label_->setText(tr("Rea&der:"));
  if (punch_label_ != nullptr) punch_label_->setText(tr("P&unch:"));
  if (from_label_ != nullptr) from_label_->setText(tr("F&rom row:"));
  from_->setToolTip(
      tr("Row 1 is the whole tape. A later row goes on with a tape that was not punched to its "
         "end, behind blank tape to be spliced."));
  twice_->setText(tr("Read &twice and compare"));
  go_on_->setText(tr("&Go on with what was read"));
  go_on_->setToolTip(tr("The tape begins anywhere before the place where the reading stopped."));
  format_group_->setTitle(tr("Layout of the tape"));
  tabs_->setTabText(0, tr("Tape"));
  tabs_->setTabText(1, tr("Text"));
  tabs_->setTabText(2, tr("Messages"));
  const bool copies = job_ == TapeJob::Duplicate && !rows_.empty();
  start_->setText(job_ == TapeJob::Punch ? tr("&Punch")
                  : copies               ? tr("&Punch the copy")
                                         : tr("&Read"));
  stop_->setText(tr("&Stop"));
  close_->setText(tr("&Close"));
  open_->setText(program_.decoded.is_damaged() ? tr("&Open with damaged rows marked")
                                               : tr("&Open in the editor"));
  picture_->setText(tr("Sa&ve the tape…"));
  picture_->setToolTip(
      tr("As rows (.tap), as a picture in letters (.txt) or as a drawing (.svg, .png)"));
}

}  // namespace dgt::studio
