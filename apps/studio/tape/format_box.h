// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "device/tape.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace dgt::studio {

/// How a tape is laid out: as the machine's settings say, to be changed for this one.
class FormatBox : public QWidget {
  Q_OBJECT

 public:
  /// What of a format matters to a job.
  enum class Part : std::uint8_t { Punching, Reading };
  FormatBox(Part part, const TapeFormat& format, QWidget* parent = nullptr);

  [[nodiscard]] TapeFormat format() const;
  void set_header(const QString& header);

 signals:
  void changed();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void add(const char* name, QWidget* field);
  void retranslate();

  TapeFormat format_;  // what has no field stays so
  Part part_;
  std::vector<QLabel*> labels_;
  QSpinBox* leader_;
  QSpinBox* trailer_;
  QComboBox* start_;
  QComboBox* line_end_;
  QComboBox* unpunchable_;
  QComboBox* checksum_;
  QComboBox* before_start_;
  QLineEdit* header_;
};

}  // namespace dgt::studio
