// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>

#include "apps/studio/drawing/look.h"
#include "apps/studio/drawing/scene.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {

/// Paints a part: kerf, contours, rapids, the way of the tool, and marks. The grid, the tool and
/// what is lit are not of it. Any thread may call it.
void paint_scene(QPainter& painter, const Scene& scene, const SheetView& view, const Look& look);

/// How the machine's unit is shown: digits behind the point of a millimetre.
[[nodiscard]] int decimals_of(const Settings& settings);

/// One move of the tool, done or still to come; or the part of it that `part` says, 0…1.
void paint_step(QPainter& painter, const SheetView& view, const Look& look, const DrawnPath& path,
                std::size_t step, bool done, double part = 1);

}  // namespace dgt::studio
