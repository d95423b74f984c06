// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "kernel/circle.h"
#include "lang/nc/length.h"

/// The arcs of arc.h where all lengths are whole steps, as nearly everywhere: the same numbers,
/// worked out in machine words as far as these reach. Internal to arc.cpp.
namespace dgt::grid {

__extension__ typedef __int128 Wide;

/// A way in steps. Differences of places fit 52 bits, so that sums of their products fit a Wide.
struct Vector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};
/// Precondition: on the grid.
[[nodiscard]] inline Vector steps_of(const Spot& v) { return {v.x.steps(), v.y.steps()}; }

[[nodiscard]] inline Wide dot(const Vector& a, const Vector& b) {
  return static_cast<Wide>(a.x) * b.x + static_cast<Wide>(a.y) * b.y;
}
[[nodiscard]] inline Wide cross(const Vector& a, const Vector& b) {
  return static_cast<Wide>(a.x) * b.y - static_cast<Wide>(a.y) * b.x;
}

[[nodiscard]] double root_in_millimetres(Wide squared);
/// Whether √a and √b differ by more than `tolerance` mm; nothing when that is too close to tell.
[[nodiscard]] std::optional<bool> roots_differ(Wide a, Wide b, const Rational& tolerance);

[[nodiscard]] Circle circle_by_centre(const Vector& from, const Vector& chord, const Vector& centre,
                                      bool counter_clockwise, int bits);
[[nodiscard]] Circle circle_by_radius(const Vector& from, const Vector& chord, std::int64_t radius,
                                      bool major, bool counter_clockwise, int bits);

}  // namespace dgt::grid
