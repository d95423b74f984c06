// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "post/dialect.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace dgt::studio {

/// The buttons of the NC panel; as many rows as the width needs.
class NcBar : public QWidget {
  Q_OBJECT

 public:
  explicit NcBar(QWidget* parent = nullptr);

  void show_dialect(const QString& name);
  void show_compensation(Compensation compensation);
  /// What needs a program.
  void enable(bool has_program);
  void show_verifying(bool busy);

 signals:
  void dialect_wanted();
  void compensation_chosen(dgt::Compensation compensation);
  void save_wanted();
  void save_as_wanted();
  void copy_wanted();
  void print_wanted();
  void punch_wanted();
  void verify_wanted();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QToolButton* add(const char* name, const QString& icon);
  void retranslate();

  QToolButton* dialect_;
  QComboBox* compensation_;
  QLabel* compensation_label_;
  std::vector<QToolButton*> of_program_;
  QToolButton* save_;
  QToolButton* save_as_;
  QToolButton* copy_;
  QToolButton* print_;
  QToolButton* punch_;
  QToolButton* verify_;
  QString dialect_name_;
  bool is_verifying_ = false;
};

}  // namespace dgt::studio
