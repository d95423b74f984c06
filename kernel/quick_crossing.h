// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "kernel/raw_curve.h"

/// The first stage of the cascade: where two strands cross, in plain doubles with bounds worked out
/// beforehand. Internal to the kernel.
namespace dgt::quick {

/// As Crossing (strand.h), as the engine keeps it.
struct Crossing {
  double x, y;
  std::array<double, 2> position;
  std::array<double, 2> position_rad;
  int turn;
};

struct Crossings {
  bool decided = true;
  int count = 0;
  std::array<Crossing, 2> found;
};

/// Where strands a and b cross inside both, or undecided.
///  (1) What is decided is so: the strands of any numbers within the radii of these cross as told.
///  (2) Positions lie within position_rad; (x, y) is about there.
[[nodiscard]] Crossings cross(const RawCurve& curve, std::uint32_t a, std::uint32_t b);

}  // namespace dgt::quick
