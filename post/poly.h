// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "kernel/toolpath.h"

namespace dgt {

/// Appends a run of lines and arcs as a loop of a polyline with bulges: `x y bulge` a vertex, bulge
/// = tan(sweep/4), then a blank line between loops.
///  (1) Coordinates are the doubles of the path, the bulge is the double nearest to that of the
///  exact arc; each is the shortest decimal without exponent that reads back as this double.
///  (2) A full circle is two halves.
///  (3) A run that ends where it begins is closed, any other begins with `open` and ends with its
///  last point.
/// Precondition: not empty; the moves follow each other, and none but lines and arcs is among them.
void append_poly(std::string& out, std::span<const Move> moves);

}  // namespace dgt
