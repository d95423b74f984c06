// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPlainTextEdit>

#include "apps/studio/part.h"

namespace dgt::studio {

/// The source text of a program, with what the compiler says about it.
class SourceEditor : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit SourceEditor(QWidget* parent = nullptr);

  /// Puts the cursor there and shows the place. Lines and columns count from 1, columns in code
  /// points; what lies beyond the text is its end.
  void go_to(int line, int column = 1);
  /// The line with the cursor, from 1.
  [[nodiscard]] int current_line() const;
  /// The word at the cursor, as help looks it up: `C`, `FOR`, `G54`; empty between words.
  [[nodiscard]] QString word_at_cursor() const;
  /// Puts a line of its own below the line with the cursor, or into it when it is blank; one step
  /// of undo.
  void add_line(const QString& line);

 signals:
  void current_line_changed(int line);
};

}  // namespace dgt::studio
