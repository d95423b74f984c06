// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "post/deviation.h"

/// Arcs a control can be told, chosen to run as close as can be to an exact one. Lengths in units.
namespace dgt {

/// An arc between two grid points as a control is told it.
struct WrittenArc {
  GridPoint from;
  GridPoint to;
  bool ccw = true;
  bool major = false;       ///< more than half a turn
  std::int64_t radius = 0;  ///< radius form
  GridPoint centre;         ///< centre form
};

struct FittedArc {
  WrittenArc arc;
  double deviation = 0;  ///< certified, in units
  double mismatch =
      0;             ///< upper bound of the difference of the two radii, in units; radius form: 0
  ArcBalls as_read;  ///< what a reader makes of it (lang/nc/arc.h)
};

/// The best whole radius for an arc from `from` to `to`.
///  (1) The chord is at most twice the radius.
///  (2) The arc written is the one meant: its sense is that of `exact`, and it is the major arc
///  only
///      where `exact` is.
/// Nothing when the two points are one or the radius passes kMaxUnits.
[[nodiscard]] std::optional<FittedArc> fit_by_radius(const GridPoint& from, const GridPoint& to,
                                                     const ArcBalls& exact);

/// The grid point that serves best as centre: of those near the foot of the exact centre on the
/// perpendicular bisector of the chord (where the two radii are equal), and of these among those
/// whose radii differ by less than `most_mismatch` if there are any, the one with the least sum of
/// the difference of the radii and of the error in the middle of the arc. Nothing as above.
[[nodiscard]] std::optional<FittedArc> fit_by_centre(const GridPoint& from, const GridPoint& to,
                                                     const ArcBalls& exact, double most_mismatch);

}  // namespace dgt
