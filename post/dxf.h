// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "kernel/toolpath.h"

namespace dgt {

/// The tool path as a DXF drawing (release 12, ASCII, millimetres), which every CAD program reads:
/// LINE, ARC and CIRCLE on the layers CONTOUR (programmed, green), EQUIDISTANT (cut, yellow) and
/// RAPIDS (grey, dashed).
///  (1) Arcs are arcs, always counter-clockwise as DXF has them, full circles circles.
///  (2) Numbers are the doubles of the path, in shortest form.
///  (3) The same path gives the same bytes.
///  (4) It begins with the remark `dgt plot`, by which the reader knows that the entities of a
///  layer
///      are one path, in order.
[[nodiscard]] std::string draw_dxf(const Toolpath& path);

}  // namespace dgt
