// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>

#include "apps/studio/drawing/look.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {

/// The grid, the axes of coordinates and the figures along the lower and left edges. Lines stand 1,
/// 2 or 5 · 10ⁿ mm apart.
void paint_grid(QPainter& painter, const SheetView& view, const Look& look);

/// The step of the grid in mm: the least of 1, 2 or 5 · 10ⁿ that is at least `least` mm.
[[nodiscard]] double grid_step(double least);

}  // namespace dgt::studio
