// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/editor/source_editor.h"

#include <QTextBlock>

namespace dgt::studio {

SourceEditor::SourceEditor(QWidget* parent) : QPlainTextEdit(parent) {
  setLineWrapMode(QPlainTextEdit::NoWrap);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this,
          [this] { emit current_line_changed(current_line()); });
}

void SourceEditor::go_to(int line, int column) {
  QTextBlock block = document()->findBlockByNumber(line - 1);
  if (!block.isValid()) block = document()->lastBlock();
  QTextCursor cursor(block);
  // Columns count code points, the document UTF-16 units.
  const QString text = block.text();
  qsizetype at = 0;
  for (int i = 1; i < column && at < text.size(); ++i) at += text[at].isHighSurrogate() ? 2 : 1;
  cursor.setPosition(block.position() + static_cast<int>(at));
  setTextCursor(cursor);
  centerCursor();
}

int SourceEditor::current_line() const { return textCursor().blockNumber() + 1; }

QString SourceEditor::word_at_cursor() const {
  QTextCursor cursor = textCursor();
  cursor.select(QTextCursor::WordUnderCursor);
  return cursor.selectedText();
}

void SourceEditor::add_line(const QString& line) {
  QTextCursor cursor = textCursor();
  cursor.beginEditBlock();
  cursor.movePosition(QTextCursor::EndOfBlock);
  if (!cursor.block().text().trimmed().isEmpty()) cursor.insertBlock();
  cursor.insertText(line);
  cursor.endEditBlock();
  setTextCursor(cursor);
}

}  // namespace dgt::studio
