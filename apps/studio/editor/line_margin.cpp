// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/editor/line_margin.h"

#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QTextBlock>

#include "apps/studio/editor/source_editor.h"

namespace dgt::studio {

LineMargin::LineMargin(SourceEditor* editor) : QWidget(editor), editor_(editor) {}

int LineMargin::wanted_width() const {
  const QFontMetrics metrics = editor_->fontMetrics();
  const auto digits = QString::number(std::max(editor_->blockCount(), 99)).size();
  return metrics.horizontalAdvance(u'9') * (static_cast<int>(digits) + 2);
}

void LineMargin::paintEvent(QPaintEvent* event) { editor_->paint_margin(event); }

void LineMargin::mousePressEvent(QMouseEvent* event) {
  const QPoint at(0, event->position().toPoint().y());
  QTextCursor cursor = editor_->cursorForPosition(at);
  cursor.movePosition(QTextCursor::StartOfBlock);
  cursor.movePosition(QTextCursor::NextBlock, QTextCursor::KeepAnchor);
  editor_->setTextCursor(cursor);
}

void LineMargin::wheelEvent(QWheelEvent* event) { editor_->wheelEvent(event); }

}  // namespace dgt::studio
