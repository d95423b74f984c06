// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/number.h"

/// What CGAL decides about one-root numbers. The callers filter first; this is the exact stage.
namespace dgt::cgal {

[[nodiscard]] int sign(const OneRoot& x);
[[nodiscard]] int compare(const OneRoot& x, const OneRoot& y);

}  // namespace dgt::cgal
