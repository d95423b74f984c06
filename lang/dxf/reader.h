// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/contour.h"
#include "kernel/toolpath.h"
#include "lang/dxf/strand.h"

namespace dgt {

/// A DXF drawing as a tool path.
///  (1) Lines and arcs are those of the drawing, numbers taken digit for digit; ellipses, splines
///      and arcs that a block scales unevenly become arcs within the tolerance, which is proved.
///  (2) Contours are put together as chained() says, or follow the drawing as in_drawn_order()
///      says, and are cut inside_out().
///  (3) With a kerf the tool runs half of it outside closed contours that bound material, and
///      inside holes; `contour` says how corners and gouges are met.
///  (4) What is wrong or left out is told at its line; with an error in the bag the path is not to
///      be used.
[[nodiscard]] Toolpath read_dxf(const SourceFile& file, const DxfOptions& options,
                                const ContourOptions& contour, DiagnosticBag& bag);

}  // namespace dgt
