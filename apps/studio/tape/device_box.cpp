// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/tape/device_box.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include "apps/studio/window/settings_store.h"

namespace dgt::studio {
namespace {

QString key_of(DeviceBox::Kind kind) {
  return kind == DeviceBox::Kind::Reader ? QStringLiteral("tape/reader")
                                         : QStringLiteral("tape/punch");
}

/// The lines that this computer has.
QStringList lines_of_computer() {
  const QDir devices(QStringLiteral("/dev"));
  const QStringList found = devices.entryList({QStringLiteral("ttyS?"), QStringLiteral("ttyUSB*"),
                                               QStringLiteral("ttyACM*"), QStringLiteral("lp?")},
                                              QDir::System | QDir::Files, QDir::Name);
  QStringList names;
  for (const QString& name : found) names << devices.filePath(name);
  return names;
}

}  // namespace

DeviceBox::DeviceBox(Kind kind, const QString& set, QWidget* parent)
    : QWidget(parent), kind_(kind) {
  name_ = new QComboBox(this);
  name_->setObjectName(kind == Kind::Reader ? QStringLiteral("reader") : QStringLiteral("punch"));
  name_->setEditable(true);
  name_->setInsertPolicy(QComboBox::NoInsert);
  const QString last = SettingsStore().panel(key_of(kind), {}).toString();
  QStringList names;
  for (const QString& name : QStringList{set, last} + lines_of_computer())
    if (!name.isEmpty() && !names.contains(name)) names << name;
  name_->addItems(names);
  name_->setCurrentText(names.value(0));
  file_ = new QPushButton(this);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(name_, 1);
  row->addWidget(file_);
  setFocusProxy(name_);
  connect(name_, &QComboBox::editTextChanged, this, &DeviceBox::changed);
  connect(file_, &QPushButton::clicked, this, &DeviceBox::choose_file);
  retranslate();
}

QString DeviceBox::device() const { return name_->currentText().trimmed(); }
void DeviceBox::set_device(const QString& name) { name_->setCurrentText(name); }
void DeviceBox::remember() const { SettingsStore().set_panel(key_of(kind_), device()); }

void DeviceBox::choose_file() {
  const QString filter = tr("Tapes (*.tap *.txt);;All files (*)");
  const QString name = kind_ == Kind::Reader
                           ? QFileDialog::getOpenFileName(this, tr("Tape file"), device(), filter)
                           : QFileDialog::getSaveFileName(this, tr("Tape file"), device(), filter);
  if (!name.isEmpty()) set_device(name);
}

void DeviceBox::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void DeviceBox::retranslate() {
  file_->setText(tr("&File…"));
  file_->setToolTip(tr("A file in place of the device"));
  name_->setToolTip(kind_ == Kind::Reader
                        ? tr("The reader: a serial line, a character device, a tape file")
                        : tr("The punch: a serial line, a character device, a tape file"));
}

}  // namespace dgt::studio
