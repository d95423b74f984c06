// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/machine_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>

#include "apps/studio/language.h"
#include "apps/studio/window/document.h"

namespace dgt::studio {
namespace {

QString sentence_of(const MachineFault& fault) {
  if (const auto* const file = std::get_if<FileError>(&fault)) return studio::sentence_of(*file);
  if (const auto* const setting = std::get_if<SettingFault>(&fault)) {
    return MachineDialog::tr("The setting %1 is wrong.").arg(QString::fromStdString(setting->key));
  }
  if (const auto* const dialect = std::get_if<UnknownDialect>(&fault)) {
    return MachineDialog::tr("There is no dialect %1.").arg(QString::fromStdString(dialect->name));
  }
  return MachineDialog::tr("The file has errors; it is not used.");
}

}  // namespace

QString faults_of(const SettledMachine& machine, Language language) {
  QString said;
  for (const MachineMessages& messages : machine.messages) {
    for (const Diagnostic& d : messages.bag.all()) {
      said += MachineDialog::tr("Line %1: %2")
                  .arg(d.range.place().line)
                  .arg(QString::fromStdString(text(d.message, d.arguments, language))) +
              u'\n';
    }
  }
  if (!machine.settings) said += sentence_of(machine.settings.error());
  return said.trimmed();
}

MachineDialog::MachineDialog(const QString& file, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit(file, this)),
      said_(new QPlainTextEdit(this)),
      verdict_(new QLabel(this)),
      ends_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setWindowTitle(tr("Machine settings"));
  auto* const grid = new QGridLayout(this);
  auto* const what = new QLabel(
      tr("A machine file holds settings as TOML: the dialect, limits of the control, speeds, tape. "
         "Without one the standard settings hold."),
      this);
  what->setWordWrap(true);
  auto* const browse = new QPushButton(tr("&Choose…"), this);
  auto* const none = new QPushButton(tr("&None"), this);
  name_->setObjectName(QStringLiteral("machine_file"));
  said_->setReadOnly(true);
  said_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  said_->setLineWrapMode(QPlainTextEdit::NoWrap);
  verdict_->setWordWrap(true);
  grid->addWidget(what, 0, 0, 1, 3);
  grid->addWidget(name_, 1, 0);
  grid->addWidget(browse, 1, 1);
  grid->addWidget(none, 1, 2);
  grid->addWidget(said_, 2, 0, 1, 3);
  grid->addWidget(verdict_, 3, 0, 1, 3);
  grid->addWidget(ends_, 4, 0, 1, 3);
  resize(fontMetrics().averageCharWidth() * 90, fontMetrics().height() * 24);
  connect(browse, &QPushButton::clicked, this, &MachineDialog::choose);
  connect(none, &QPushButton::clicked, name_, &QLineEdit::clear);
  connect(name_, &QLineEdit::textChanged, this, &MachineDialog::show_file);
  connect(ends_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(ends_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  show_file();
}

QString MachineDialog::file() const { return name_->text().trimmed(); }

void MachineDialog::choose() {
  const QString name = QFileDialog::getOpenFileName(
      this, tr("Machine file"), QFileInfo(file()).absolutePath(),
      tr("Machine files (*.toml)") + QStringLiteral(";;") + tr("All files (*)"));
  if (!name.isEmpty()) name_->setText(name);
}

void MachineDialog::show_file() {
  said_->clear();
  verdict_->clear();
  QString faults;
  if (!file().isEmpty()) {
    faults = faults_of(settle(MachineChoice{file().toStdString(), {}, {}}), message_language());
    if (const auto bytes = read_file(file().toStdString())) {
      said_->setPlainText(QString::fromStdString(*bytes));
    }
  }
  verdict_->setText(faults);
  ends_->button(QDialogButtonBox::Ok)->setEnabled(faults.isEmpty());
}

}  // namespace dgt::studio
