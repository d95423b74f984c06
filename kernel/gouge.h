// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/piece.h"

/// Whether the tool, a disc on its way along the equidistant, cuts into the programmed contour. The
/// equidistant of a contour is local: each element is offset and met with its neighbours. This
/// looks at all the others.
namespace dgt {

/// A tool that comes nearer to the contour than its radius by no more than this does no harm that
/// anything could show, and everything below it is rounding: distances are right within 32 units in
/// the last place, 10⁻⁹ mm at 10⁵ mm. Unit: mm.
inline constexpr double kGougeResolution = 1e-6;

/// One stretch of a path with what it comes from.
struct CutPiece {
  Piece piece;
  double reach = 0;      ///< |offset| of its element, mm: the tool keeps at least this far away
  std::size_t item = 0;  ///< of the contour
};

struct Gouge {
  std::size_t path = 0;        ///< the stretch of the equidistant
  std::size_t programmed = 0;  ///< the stretch of the contour it cuts into
  double depth = 0;            ///< mm
  double x = 0, y = 0;         ///< where the tool stands then
};

/// Every stretch of `path` that comes nearer than its reach to one of `programmed`, each pair of
/// items once, at its deepest, in the order of the path. Of two different reaches the smaller
/// counts: the larger is an allowance there. `tolerance`, in mm, is allowed on top of the
/// resolution.
[[nodiscard]] std::vector<Gouge> find_gouges(const std::vector<CutPiece>& path,
                                             const std::vector<CutPiece>& programmed,
                                             double tolerance);

/// How much nearer than allowed the two come, in mm; not positive: they keep their distance.
[[nodiscard]] double gouge_depth(const CutPiece& path, const CutPiece& programmed, Approach& where);

}  // namespace dgt
