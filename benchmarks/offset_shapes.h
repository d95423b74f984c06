// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/offset.h"

/// Families of contours to offset, in doubles, the same on every machine.
namespace dgt::shapes {

/// Module 1, eight elements a tooth: root arc, fillet, flank, tip round, land arc, tip round,
/// flank, fillet.
[[nodiscard]] BulgePolyline gear(unsigned teeth);
/// A ring of n vertices about n/2π from its centre, with ±10 % waviness in five lobes and a jitter
/// of 0.4; half of the vertices carry a bulge up to ±0.25.
[[nodiscard]] BulgePolyline ring(unsigned n, unsigned seed = 1);
/// A ring of k radial slots 2 wide and 8 deep with round ends, pitch 4.
[[nodiscard]] BulgePolyline slots(unsigned k);
/// The polyline r = R + A sin kt, sampled every 0.1 mm.
[[nodiscard]] BulgePolyline wavy(unsigned n);

[[nodiscard]] Chain chain(const BulgePolyline& shape);

}  // namespace dgt::shapes
