// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "apps/driver/machine_choice.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace dgt::studio {

/// What is wrong with a machine file, in sentences for the person; empty: nothing.
[[nodiscard]] QString faults_of(const SettledMachine& machine, Language language);

/// Chooses the machine file and shows what it says, or what is wrong with it.
class MachineDialog : public QDialog {
  Q_OBJECT

 public:
  explicit MachineDialog(const QString& file, QWidget* parent = nullptr);

  [[nodiscard]] QString file() const;  ///< empty: none

 private:
  void choose();
  void show_file();

  QLineEdit* name_;
  QPlainTextEdit* said_;
  QLabel* verdict_;
  QDialogButtonBox* ends_;
};

}  // namespace dgt::studio
