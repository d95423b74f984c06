// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/offset_raw.h"

namespace dgt::cgal {

/// The places where the supports of two raw pieces meet, exactly.
[[nodiscard]] std::vector<ExactPoint> support_crossings(const RawPiece& a, const RawPiece& b);

}  // namespace dgt::cgal
