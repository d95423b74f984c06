// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/offset_raw.h"

namespace dgt::cgal {

/// The boundaries, region to the left, of the faces with winding number `wanted` in the arrangement
/// of closed curves made of `pieces`. Boundaries that touch themselves at a point are parted there.
[[nodiscard]] std::vector<OffsetLoop> faces_with_winding_number(const std::vector<RawPiece>& pieces,
                                                                int wanted);

}  // namespace dgt::cgal
