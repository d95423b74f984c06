// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

#include "apps/studio/editor/faults.h"
#include "lang/text/encoding.h"

class QLabel;
class QMenu;
class QStatusBar;
class QToolButton;

namespace dgt::studio {

/// The fields of the status bar: what the compiler is at, the cursor, the encoding and the line
/// ends of the file, which can be changed there.
class StatusFields : public QObject {
  Q_OBJECT

 public:
  StatusFields(QStatusBar* bar, QObject* parent);

  void show_cursor(int line, int column);
  void show_form(const TextForm& form);
  void show_working(bool at_work);
  void show_faults(const std::vector<Fault>& faults);
  /// The menus to choose from; the window's menu shows them too.
  [[nodiscard]] QMenu* encodings() const { return encodings_; }
  [[nodiscard]] QMenu* line_ends() const { return line_ends_; }
  void retranslate();

 signals:
  void read_again_wanted(dgt::Encoding encoding);
  void encoding_chosen(dgt::Encoding encoding);
  void line_end_chosen(dgt::LineEnd line_end);
  void faults_wanted();

 private:
  void fill_encodings();
  void fill_line_ends();
  void show_verdict();

  QToolButton* verdict_;
  QLabel* cursor_;
  QToolButton* encoding_;
  QToolButton* line_end_;
  QMenu* encodings_;
  QMenu* line_ends_;
  TextForm form_;
  int line_ = 1;
  int column_ = 1;
  bool at_work_ = false;
  int errors_ = 0;
  int warnings_ = 0;
};

}  // namespace dgt::studio
