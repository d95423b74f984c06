// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/chain.h"

/// Contours to offset, the same on every machine.
namespace dgt::families {

/// A ring of n vertices, radius about n/2π, with ±10 % waviness in five lobes and jitter; half of
/// the vertices carry a bulge up to ±0.25.
[[nodiscard]] std::vector<Chain> random_ring(unsigned n, unsigned seed);
/// A ring of k radial slots 2 wide and 8 deep with round ends, pitch 4.
[[nodiscard]] std::vector<Chain> slots(unsigned k);
/// A pocket on a whole-number grid: walls 1 apart in many places.
[[nodiscard]] std::vector<Chain> grid_pocket(unsigned cells, unsigned seed);
/// The polyline r = R + A sin kt.
[[nodiscard]] std::vector<Chain> wavy(unsigned n);

}  // namespace dgt::families
