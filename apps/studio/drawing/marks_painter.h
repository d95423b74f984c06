// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>

#include "apps/studio/drawing/label_space.h"
#include "apps/studio/drawing/look.h"
#include "apps/studio/drawing/scene.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {

/// Arrow heads half-way along cuts that have room for one.
void paint_directions(QPainter& painter, const SheetView& view, const Look& look,
                      const DrawnPath& path);
/// Dots on the control points, with their numbers where there is room.
void paint_points(QPainter& painter, const SheetView& view, const Look& look, const DrawnPath& path,
                  LabelSpace& space);
/// The elements thin, with their names.
void paint_names(QPainter& painter, const SheetView& view, const Look& look,
                 const std::vector<NamedShape>& names, LabelSpace& space);
/// The box around the part, with its width and height in mm.
void paint_sizes(QPainter& painter, const SheetView& view, const Look& look, const Box& box,
                 LabelSpace& space);
/// Where the tool stands before the first move.
void paint_start(QPainter& painter, const SheetView& view, const Look& look, DrawnPlace start);

/// Letters with a rim in the colour of the sheet, so that strokes beneath do not disturb.
void paint_label(QPainter& painter, QPointF base, const QString& text, const QColor& colour,
                 const QColor& sheet);

}  // namespace dgt::studio
