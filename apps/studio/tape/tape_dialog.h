// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDialog>

#include "apps/driver/settings.h"

namespace dgt::studio {

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
};

}  // namespace dgt::studio
