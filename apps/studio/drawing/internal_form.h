// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "apps/studio/background.h"
#include "apps/studio/drawing/internal_text.h"
#include "apps/studio/part.h"

class QLabel;
class QLineEdit;
class QListView;
class QToolButton;

namespace dgt::studio {

/// The program in its internal form (F7), as `dgt dump` prints it. To be read, searched, copied and
/// saved.
class InternalForm : public QWidget {
  Q_OBJECT

 public:
  explicit InternalForm(QWidget* parent = nullptr);

  /// A part with errors leaves the last good text.
  void show_part(PartPtr part);
  /// Lights the lines of the moves that were asked for there, and goes to the first; see
  /// DrawingPanel.
  void light_line(int file, int line);
  /// The chosen lines, or all of them.
  [[nodiscard]] QString text() const;
  [[nodiscard]] QListView& lines() { return *view_; }
  [[nodiscard]] bool is_settled() const { return !work_.is_busy(); }

 public slots:
  void find_next();
  void find_previous();
  void save();

 signals:
  /// Enter or a double click on a line: where its move was asked for.
  void place_chosen(int file, int line, int column);
  void settled();

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void retranslate();
  void copy();
  void go_to_source(int row);
  void find(bool backwards);
  void show_note();

  bool is_good_ = true;
  bool is_missing_ = false;
  std::string name_;
  InternalLines lines_;
  QLineEdit* wanted_;
  QToolButton* next_;
  QToolButton* previous_;
  QToolButton* copy_;
  QToolButton* save_;
  QLabel* note_;
  QListView* view_;
  Background work_{this};
};

}  // namespace dgt::studio
