// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace dgt::studio {

class SourceEditor;

/// Find and replace, below the text. Enter finds the next place, Shift+Enter the one before, Esc
/// closes.
class FindBar : public QWidget {
  Q_OBJECT

 public:
  FindBar(SourceEditor* editor, QWidget* parent);

  /// Opens with what is selected in the editor.
  void open(bool to_replace);
  void find(bool forward);
  void replace();
  /// Every place in the text, as one step of undo.
  void replace_all();
  void close_bar();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void show_found();
  [[nodiscard]] QRegularExpression pattern() const;
  [[nodiscard]] QString replacement_for(const QRegularExpressionMatch& match) const;

  SourceEditor* editor_;
  QLineEdit* sought_;
  QLineEdit* replacement_;
  QCheckBox* case_;
  QCheckBox* expression_;
  QToolButton* previous_;
  QToolButton* next_;
  QToolButton* replace_;
  QToolButton* replace_all_;
  QToolButton* close_;
  QLabel* result_;
};

}  // namespace dgt::studio
