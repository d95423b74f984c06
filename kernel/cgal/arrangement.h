// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "kernel/offset_raw.h"

namespace dgt::cgal {

/// The boundaries, region to the left, of the faces with winding number `wanted` in the arrangement
/// of closed curves made of `pieces`. Boundaries that touch themselves at a point are parted there.
[[nodiscard]] std::vector<OffsetLoop> faces_with_winding_number(const std::vector<RawPiece>& pieces,
                                                                int wanted);

/// A face whose winding number is neither `wanted` nor one less, by one of its corners, where two
/// pieces meet; by a place of its boundary where it has none.
struct OddFace {
  double x = 0, y = 0;
  RawKey one, other;
  bool at_crossing = false;  ///< further pieces come there: not a corner of one curve
};
/// The lowest such face, of these the leftmost, among those that are larger than kOffsetResolution
/// in some coordinate.
[[nodiscard]] std::optional<OddFace> find_odd_face(const std::vector<RawPiece>& pieces, int wanted);

}  // namespace dgt::cgal
