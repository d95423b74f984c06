// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "kernel/circle.h"
#include "lang/nc/length.h"

/// Arcs as controls are told them, on circles with rational numbers.
///
/// A program gives both ends of an arc, and they are kept exactly. What else it gives, a centre on
/// a grid or a radius, hardly ever fits them exactly:
///  * about a centre, the two radii differ by what rounding left. The arc then runs about the point
///    that is nearest to the centre given among those from which both ends are equally far: its
///    foot on the perpendicular bisector of the chord.
///  * the radius, or the centre, is mostly irrational. Rational ones are taken beside them, so that
///    the ends lie within 2^−kArcBits of the circle's size beside it.
namespace dgt {

inline constexpr int kArcBits = 100;

/// The circle of the arc from `from` to `from + chord` about `from + centre`, where the bisector
/// does not matter: the two ends are one for a full circle. Preconditions: `centre` is not 0, and
/// on the bisector of a chord that is not 0 lies no end.
[[nodiscard]] Circle circle_by_centre(const Spot& from, const Spot& chord, const Spot& centre,
                                      bool counter_clockwise);

/// The radii at the two ends: exact squares, in steps² or any other one unit, and mm.
struct EndRadii {
  double from = 0;  ///< mm
  double to = 0;
  bool equal = false;  ///< exactly
};
[[nodiscard]] EndRadii end_radii(const Spot& chord, const Spot& centre);
/// Whether they differ by more than `tolerance` mm, exactly.
[[nodiscard]] bool radii_differ(const Spot& chord, const Spot& centre, const Rational& tolerance);

/// −1, 0, +1 as the arc is less than, exactly or more than half a turn. Ends in one direction from
/// the centre are a whole turn, +1.
[[nodiscard]] int half_turns(const Spot& chord, const Spot& centre, bool counter_clockwise);

/// The circle of the arc with the given radius, the larger one of the two when `major`. Its radius
/// is exact. Precondition: 0 < |chord| ≤ 2 radius.
[[nodiscard]] Circle circle_by_radius(const Spot& from, const Spot& chord, const Length& radius,
                                      bool major, bool counter_clockwise);

/// The circle of the half turn over a chord that is not 0.
[[nodiscard]] Circle half_turn(const Spot& from, const Spot& chord, bool counter_clockwise);

/// −1, 0, +1 as the chord is shorter than, exactly or longer than twice the radius.
[[nodiscard]] int chord_against_diameter(const Spot& chord, const Length& radius);

/// Its length in mm.
[[nodiscard]] double length_of(const Spot& chord);

}  // namespace dgt
