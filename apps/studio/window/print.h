// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QTextDocument;
class QWidget;

namespace dgt::studio {

class DrawingPanel;

/// A preview from which to print, or to save a PDF: the source with line numbers and a heading.
void print_source(const QTextDocument* source, const QString& title, QWidget* parent);
/// The drawing, as large as the page.
void print_drawing(DrawingPanel& drawing, const QString& title, QWidget* parent);

}  // namespace dgt::studio
