// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/toolpath.h"

/// Moves on the way to a contour, away from it or between two that go over a part. The equidistant
/// itself is held against its contour elsewhere (gouge.h); here are the moves that belong to no
/// part: they have no element, and nothing else looks at them.
namespace dgt {

/// Which moves are looked at.
enum class CrossingMoves : std::uint8_t {
  All,    ///< leads and rapids
  Leads,  ///< cuts that lead to a contour or away from it
  None
};

/// A move that crosses a programmed contour.
struct PartCrossing {
  std::size_t move = 0;     ///< counts into Toolpath::moves
  std::size_t contour = 0;  ///< into Toolpath::contours
  std::size_t wall = 0;     ///< into the contour's programmed moves: what it meets there
  double depth =
      0;  ///< of a cut with an offset: how far the tool reaches into the part, mm; else 0
  double x = 0, y = 0;  ///< where on the move, mm
};

/// A contour is met away from the ends of a move when it is met further from them than this: a lead
/// ends on its contour, and a contact within 2⁻⁷⁰ mm reaches √(2r·2⁻⁷⁰) along a circle of radius r,
/// which stays below this up to r = 500 km. Unit: mm.
inline constexpr double kArrival = 1e-6;

/// The moves that go over a part, in their order, each with a contour once: of a lead the deepest
/// place, of a rapid the first.
///  (1) A rapid crosses when its line meets the programmed contour away from its own ends.
///  (2) A lead of a contour with an offset crosses when the tool comes nearer to a programmed
///      contour than its reach there, as in Walls: exactly, by more than `tolerance` (mm) and
///      the resolution of gouges. Where either has no offset its line is held against the
///      contour as a rapid's is.
///  (3) Lines cut against their direction on an offset contour bound nothing, and what a closed
///      contour overlaps at its beginning or end is lead, not part.
/// A move between irrational places is taken for the rational line beside it, within 2⁻⁷⁰ mm.
/// n log n in the moves, for crossings few.
[[nodiscard]] std::vector<PartCrossing> find_part_crossings(const Toolpath& path,
                                                            CrossingMoves which,
                                                            const Rational& tolerance);

}  // namespace dgt
