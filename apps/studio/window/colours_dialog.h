// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "apps/studio/window/theme.h"

class QDialogButtonBox;
class QLabel;
class QPushButton;

namespace dgt::studio {

/// The colours of the theme in force, changed before one's eyes. Cancel puts them back.
class ColoursDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ColoursDialog(QWidget* parent = nullptr);

  [[nodiscard]] const Colours& chosen() const { return chosen_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void choose(std::size_t row);
  void show_chosen();

  Colours before_;
  Colours chosen_;
  std::vector<QLabel*> labels_;
  std::vector<QPushButton*> buttons_;
  QPushButton* standard_;
  QDialogButtonBox* ends_;
};

}  // namespace dgt::studio
