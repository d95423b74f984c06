// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "kernel/circle.h"
#include "kernel/line.h"

namespace dgt::cgal {

/// The two crossings in lexicographic order of their coordinates. Precondition (checked): there are
/// two.
[[nodiscard]] std::array<ExactPoint, 2> crossings(const Line& line, const Circle& circle);
[[nodiscard]] std::array<ExactPoint, 2> crossings(const Circle& a, const Circle& b);

/// The same by their number: 0, 1 (contact), 2.
[[nodiscard]] int crossing_count(const Line& line, const Circle& circle);
[[nodiscard]] int crossing_count(const Circle& a, const Circle& b);

}  // namespace dgt::cgal
