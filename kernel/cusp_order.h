// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/offset_raw.h"
#include "kernel/strand.h"

namespace dgt {

/// Two strands that follow each other, `into` and `out`, with a cusp between, and a third that
/// crosses both about `at`, a distance h from it: along the third, they lie (κ₁ − κ₂) h²/2 apart,
/// which may be far too little to measure. Where all three run straight on for that h, their
/// curvatures tell the order all the same: +1 when the third meets `into` first, −1 when `out`, 0
/// when this is not the case in hand. Internal to the kernel.
[[nodiscard]] int order_at_cusp(const Strand<DoubleDouble>& into, const Strand<DoubleDouble>& out,
                                const Strand<DoubleDouble>& third, CoarsePoint at);

}  // namespace dgt
