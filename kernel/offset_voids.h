// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/offset.h"

/// Internal to the kernel.
namespace dgt {

/// Which loops of a result, fresh from winding numbers, are slivers or void loops.
[[nodiscard]] std::vector<bool> bounding_nothing(const OffsetRegion& region,
                                                 const OffsetSource& source);

}  // namespace dgt
