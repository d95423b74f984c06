// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QPushButton;

namespace dgt::studio {

/// Names a punch or a reader: a line of the computer, or a file in its place.
class DeviceBox : public QWidget {
  Q_OBJECT

 public:
  enum class Kind : std::uint8_t { Reader, Punch };
  /// `set` is what the machine's settings name; empty: nothing.
  DeviceBox(Kind kind, const QString& set, QWidget* parent = nullptr);

  [[nodiscard]] QString device() const;
  void set_device(const QString& name);
  /// For the next time.
  void remember() const;

 signals:
  void changed();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void choose_file();
  void retranslate();

  Kind kind_;
  QComboBox* name_;
  QPushButton* file_;
};

}  // namespace dgt::studio
