// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPolygonF>

#include "apps/driver/drawn_path.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {

/// The circle in pixels, cut off at the window.
[[nodiscard]] QPolygonF disc(const SheetView& view, DrawnPlace centre, double radius);

/// Fills what the tool cuts away along the cuts before move `run_to`, in the painter's brush.
/// Overlaps are filled twice: the brush has to be opaque.
void fill_kerf(QPainter& painter, const SheetView& view, const DrawnPath& path,
               std::uint32_t run_to);

/// A polygon cut off at an upright rectangle, edges along its border included (I. E. Sutherland, G.
/// W. Hodgman, Reentrant polygon clipping, 1974).
[[nodiscard]] QPolygonF clipped(const QPolygonF& polygon, const Box& window);

}  // namespace dgt::studio
