// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/offset.h"

namespace dgt::cgal {

/// A piece of a raw curve: a segment or an arc of at most half a turn, with rational ends.
struct RawPiece {
  RationalPoint from;
  RationalPoint to;
  bool is_line = true;
  RationalPoint centre;
  Rational squared_radius;
  bool counter_clockwise = true;
};

/// The boundaries, region to the left, of the faces with winding number `wanted` in the arrangement
/// of closed curves made of `pieces`. Boundaries that touch themselves at a point are parted there.
[[nodiscard]] std::vector<OffsetLoop> faces_with_winding_number(const std::vector<RawPiece>& pieces,
                                                                int wanted);

}  // namespace dgt::cgal
