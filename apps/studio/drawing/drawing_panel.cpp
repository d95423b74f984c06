// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/drawing_panel.h"

#include <utility>

namespace dgt::studio {

DrawingPanel::DrawingPanel(QWidget* parent) : QWidget(parent) {}

void DrawingPanel::show_part(PartPtr part) { part_ = std::move(part); }

void DrawingPanel::light_line(int /*file*/, int /*line*/) {}

void DrawingPanel::paint(QPainter& /*painter*/, const QRect& /*where*/) {}

void DrawingPanel::show_programmed(bool shown) { emit programmed_shown(shown); }

void DrawingPanel::fit() {}

}  // namespace dgt::studio
