// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/print.h"

#include <QCoreApplication>
#include <QDate>
#include <QFontDatabase>
#include <QLocale>
#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QTextBlock>
#include <QTextDocument>
#include <functional>

#include "apps/studio/drawing/drawing_panel.h"

namespace dgt::studio {
namespace {

constexpr int kFontSize = 10;  // points

using Paint = std::function<void(QPrinter&)>;

/// The heading and the number of the page; what room is left below.
QRect paint_heading(QPainter& painter, const QPrinter& printer, const QString& title, int page) {
  const QRect sheet(QPoint(), printer.pageRect(QPrinter::DevicePixel).size().toSize());
  const QFontMetrics metrics = painter.fontMetrics();
  const QRect line(sheet.left(), sheet.top(), sheet.width(), metrics.height());
  const QString date = QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
  painter.drawText(line, Qt::AlignLeft, title);
  painter.drawText(line, Qt::AlignHCenter, date);
  painter.drawText(line, Qt::AlignRight, QCoreApplication::translate("Print", "page %1").arg(page));
  painter.drawLine(line.bottomLeft(), line.bottomRight());
  return sheet.adjusted(0, metrics.height() * 2, 0, 0);
}

/// Lines too long for the page go on below, without a number.
QStringList wrapped(const QString& line, int columns) {
  QStringList parts;
  for (qsizetype at = 0; at < line.size() || at == 0; at += columns) {
    parts.push_back(line.mid(at, columns));
  }
  return parts;
}

void paint_source(QPrinter& printer, const QTextDocument& source, const QString& title) {
  QPainter painter(&printer);
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setPointSize(kFontSize);
  painter.setFont(font);
  const QFontMetrics metrics = painter.fontMetrics();
  const int digits = static_cast<int>(QString::number(source.blockCount()).size());
  const int margin = metrics.horizontalAdvance(u'0') * (digits + 2);
  int page = 1;
  QRect room = paint_heading(painter, printer, title, page);
  int y = room.top();
  const int columns =
      std::max((room.width() - margin) / metrics.horizontalAdvance(u'0'), digits + 1);
  for (QTextBlock block = source.begin(); block.isValid(); block = block.next()) {
    QString number = QString::number(block.blockNumber() + 1).rightJustified(digits);
    for (const QString& part : wrapped(block.text(), columns)) {
      if (y + metrics.height() > room.bottom()) {
        printer.newPage();
        room = paint_heading(painter, printer, title, ++page);
        y = room.top();
      }
      painter.drawText(0, y + metrics.ascent(), number);
      painter.drawText(margin, y + metrics.ascent(), part);
      number.clear();
      y += metrics.height();
    }
  }
}

void preview(const QString& title, QPageLayout::Orientation orientation, const Paint& paint,
             QWidget* parent) {
  QPrinter printer(QPrinter::HighResolution);
  printer.setDocName(title);
  printer.setPageOrientation(orientation);
  QPrintPreviewDialog dialog(&printer, parent);
  dialog.setWindowTitle(QCoreApplication::translate("Print", "Print %1").arg(title));
  QObject::connect(&dialog, &QPrintPreviewDialog::paintRequested, parent,
                   [&paint](QPrinter* paper) { paint(*paper); });
  dialog.exec();
}

}  // namespace

void print_source(const QTextDocument* source, const QString& title, QWidget* parent) {
  preview(
      title, QPageLayout::Portrait,
      [&](QPrinter& printer) { paint_source(printer, *source, title); }, parent);
}

void print_drawing(DrawingPanel& drawing, const QString& title, QWidget* parent) {
  preview(
      title, QPageLayout::Landscape,
      [&](QPrinter& printer) {
        QPainter painter(&printer);
        drawing.paint(painter, paint_heading(painter, printer, title, 1));
      },
      parent);
}

}  // namespace dgt::studio
