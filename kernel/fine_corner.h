// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/offset_source.h"

/// Corners other than one arc, in double-doubles: as raw_corner (offset_raw.h) makes them in
/// rationals. Internal to the kernel.
namespace dgt {

/// The tangents at the ends of the corner's arc, and between them the one at its middle. Nothing
/// when the edge all but doubles back.
[[nodiscard]] std::vector<Strand<DoubleDouble>> fine_chamfer(
    const EnclosedEdge<DoubleDouble>& edge, const EnclosedEdge<DoubleDouble>& next,
    const Enclosed<DoubleDouble>& distance);

/// The equidistants of both edges, prolonged until they meet. Nothing when they do not meet ahead,
/// or farther than `limit` distances from the corner.
[[nodiscard]] std::vector<Strand<DoubleDouble>> fine_sharp_corner(
    const EnclosedEdge<DoubleDouble>& edge, const EnclosedEdge<DoubleDouble>& next,
    const Enclosed<DoubleDouble>& distance, double limit);

}  // namespace dgt
