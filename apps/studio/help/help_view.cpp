// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/help/help_view.h"

#include <QAbstractTextDocumentLayout>
#include <QFontDatabase>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextTable>

#include "apps/studio/window/theme.h"

namespace dgt::studio {
namespace {

/// What Markdown leaves plain: programs on their paper, tables with lines.
void dress(QTextDocument& document) {
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    if (!block.blockFormat().hasProperty(QTextFormat::BlockCodeFence)) continue;
    QTextCursor cursor(block);
    QTextBlockFormat format = block.blockFormat();
    format.setBackground(colours().current_line);
    format.setLeftMargin(12);
    cursor.setBlockFormat(format);
  }
  for (QTextFrame* const frame : document.rootFrame()->childFrames()) {
    auto* const table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat format = table->format();
    format.setBorder(1);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(colours().grid);
    format.setBorderCollapse(true);
    format.setCellPadding(4);
    table->setFormat(format);
  }
}

}  // namespace

HelpView::HelpView(QWidget* parent) : QTextBrowser(parent) {
  setOpenLinks(false);
  document()->setDocumentMargin(fontMetrics().height());
}

void HelpView::show_page(const QString& markdown) {
  markdown_ = markdown;
  set_page();
  verticalScrollBar()->setValue(0);
}

void HelpView::set_page() {
  document()->setMarkdown(markdown_, QTextDocument::MarkdownDialectGitHub);
  dress(*document());
}

void HelpView::set_figures(std::map<QString, QImage> figures) {
  figures_.merge(figures);
  const int scrolled = verticalScrollBar()->value();
  set_page();
  verticalScrollBar()->setValue(scrolled);
}

void HelpView::go_to_heading(std::size_t heading) {
  std::size_t seen = 0;
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || seen++ != heading) continue;
    setTextCursor(QTextCursor(block));
    const QRectF place = document()->documentLayout()->blockBoundingRect(block);
    verticalScrollBar()->setValue(heading == 0 ? 0 : static_cast<int>(place.top()));
    return;
  }
}

QVariant HelpView::loadResource(int type, const QUrl& name) {
  if (type != QTextDocument::ImageResource || name.scheme() != QStringLiteral("figure"))
    return QTextBrowser::loadResource(type, name);
  const auto found = figures_.find(name.path());
  return found == figures_.end() ? QVariant(QImage(1, 1, QImage::Format_Mono))
                                 : QVariant(found->second);
}

}  // namespace dgt::studio
