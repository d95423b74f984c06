// SPDX-License-Identifier: GPL-3.0-or-later
// What the editor does at keys, the wheel and the mouse at rest.
#include <QHelpEvent>
#include <QKeyEvent>
#include <QTextBlock>
#include <QToolTip>
#include <QWheelEvent>

#include "apps/studio/editor/completion.h"
#include "apps/studio/editor/line_margin.h"
#include "apps/studio/editor/source_editor.h"

namespace dgt::studio {
namespace {

constexpr int kSmallestFont = 6;  // points, as settings keep them
constexpr int kLargestFont = 48;

}  // namespace

void SourceEditor::show_tip(const QPoint& where, const QPoint& global) {
  const QTextCursor cursor = cursorForPosition(where);
  // The nearest position may lie behind the end of the line.
  const QRect there = cursorRect(cursor);
  const bool beside = where.x() > there.right() + fontMetrics().horizontalAdvance(u'9') ||
                      where.y() > there.bottom();
  auto fault = beside ? std::nullopt : fault_at(cursor.position());
  if (!fault && !beside && cursor.positionInBlock() > 0) fault = fault_at(cursor.position() - 1);
  if (fault) {
    QToolTip::showText(global, tip_of(faults_[*fault]), viewport());
  } else {
    QToolTip::hideText();
  }
}

bool SourceEditor::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* const help = static_cast<QHelpEvent*>(event);
    show_tip(help->pos(), help->globalPos());
    return true;
  }
  return QPlainTextEdit::viewportEvent(event);
}

void SourceEditor::wheelEvent(QWheelEvent* event) {
  if (!event->modifiers().testFlag(Qt::ControlModifier)) {
    QPlainTextEdit::wheelEvent(event);
    return;
  }
  const int step = event->angleDelta().y() > 0 ? 1 : -1;
  set_font_size(std::clamp(font().pointSize() + step, kSmallestFont, kLargestFont));
}

// A line inside a loop goes on where the one above began.
void SourceEditor::indent_new_line() {
  QTextCursor cursor = textCursor();
  const QString line = cursor.block().text().left(cursor.positionInBlock());
  qsizetype blanks = 0;
  while (blanks < line.size() && (line[blanks] == u' ' || line[blanks] == u'\t')) ++blanks;
  cursor.beginEditBlock();
  cursor.insertBlock();
  cursor.insertText(line.left(blanks));
  cursor.endEditBlock();
  setTextCursor(cursor);
  ensureCursorVisible();
}

void SourceEditor::keyPressEvent(QKeyEvent* event) {
  if (completion_->takes(event)) return;
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && event->modifiers() == Qt::NoModifier && !isReadOnly()) {
    indent_new_line();
    return;
  }
  if (event->key() == Qt::Key_Escape) {  // the window's
    event->ignore();
    return;
  }
  QPlainTextEdit::keyPressEvent(event);
  completion_->follow(event);
}

void SourceEditor::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::FontChange && margin_ != nullptr) lay_out_margin();
}

}  // namespace dgt::studio
