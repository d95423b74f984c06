// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "kernel/toolpath.h"

namespace dgt {

/// The calculated control points, numbered from 1: the start, then where each move that travels
/// ends, with what leads there. One line a point: number, X, Y, kind of move, then for arcs the
/// centre and the radius (negative: clockwise). Millimetres with six decimals.
[[nodiscard]] std::string list_points(const Toolpath& path);

}  // namespace dgt
