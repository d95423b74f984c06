// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/dxf/chaining.h"

namespace dgt {

/// How contours lie in each other.
struct Nesting {
  /// For each contour the smallest closed one around it; its own index: none.
  std::vector<std::size_t> parent;
  /// How many closed contours lie around it: with an even number a closed contour bounds material,
  /// with an odd one it is a hole.
  std::vector<std::size_t> depth;
};

/// Decided exactly for one place of each contour: contours that cross lie somehow.
[[nodiscard]] Nesting nesting_of(const std::vector<DxfContour>& contours);

/// Twice the signed area in mm², counter-clockwise positive, near enough to tell its sign unless it
/// is a billionth of the square of its extent; then 0.
[[nodiscard]] double doubled_area(const DxfContour& contour);

/// The order of cutting: what lies in a contour before it, and of those that may be next the one
/// that begins nearest to where the tool stands.
[[nodiscard]] std::vector<std::size_t> inside_out(const std::vector<DxfContour>& contours,
                                                  const Nesting& nesting);

}  // namespace dgt
