// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "kernel/raw_curve.h"

/// The first stage of the cascade: where two strands cross, in plain doubles with bounds worked out
/// beforehand. Internal to the kernel.
namespace dgt::quick {

/// Two strands that cross.
struct Passing {
  double x, y;                          ///< about where
  std::array<double, 2> along;          ///< position on each (strand.h)
  std::array<float, 2> along_rad;       ///< within which it is
  std::array<std::uint32_t, 2> strand;  ///< the two
  std::int8_t turn;                     ///< of the second against the first (strand.h)
  bool last;                            ///< of the two crossings of these strands
};

/// Appends where strands a and b cross inside both; appends nothing and returns false when plain
/// doubles cannot tell. What is told holds for the strands of any numbers within the radii of
/// these.
[[nodiscard]] bool cross(const RawCurve& curve, std::uint32_t a, std::uint32_t b,
                         std::vector<Passing>& found);

}  // namespace dgt::quick
