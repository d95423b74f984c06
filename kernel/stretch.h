// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/piece.h"
#include "kernel/place_order.h"

/// Stretches of a path and exact questions about two of them.
namespace dgt {

/// A segment or an arc on an element with rational data, run from `from` to `to`: an arc in the
/// sense of its circle, a segment with its line or against it. Both ends lie on the carrier, or
/// within the contact resolution of it. An arc whose ends coincide is a full circle.
struct Stretch {
  Point from;
  Point to;
  Carrier carrier;
};
/// Precondition: the move has a carrier.
[[nodiscard]] Stretch stretch_of(const Move& move);
/// The same in doubles, for measuring.
[[nodiscard]] Piece piece_of(const Stretch& stretch);
/// A box that surely holds the stretch.
[[nodiscard]] Bounds box_around(const Stretch& stretch);

/// Whether `p`, a place of the carrier, lies on the stretch; the ends belong to it.
[[nodiscard]] bool covers(const Stretch& stretch, const Point& p);

/// Whether some place of the one comes nearer than `distance` to some place of the other, exactly.
/// The least distance is taken at an end of either, where they cross (then it is 0), or where the
/// line between the two places stands square on both: for a line and a circle on the normal through
/// the centre, for two circles on the line of centres. Never true for a distance ≤ 0.
[[nodiscard]] bool comes_nearer(const Stretch& a, const Stretch& b, const Rational& distance);

/// A stretch in balls: made once, asked many times.
struct StretchBalls {
  bool is_line = true;
  Ball from_x, from_y, to_x, to_y;
  Ball normal_x, normal_y, p;        ///< of a line, moved as its carrier says
  Ball centre_x, centre_y, radius;   ///< of a circle; the radius is not negative
  Ball first_x, first_y;             ///< an arc covers the directions from here counter-clockwise
  Ball last_x, last_y;               ///< to here, both from the centre
  bool whole = false, wide = false;  ///< a full circle; more than half a turn
  Bounds box;
};
[[nodiscard]] StretchBalls balls_of(const Stretch& stretch);

namespace stages {
/// comes_nearer as far as balls can tell. Precondition: distance > 0.
[[nodiscard]] std::optional<bool> filtered_nearer(const StretchBalls& a, const StretchBalls& b,
                                                  const Ball& distance);
}  // namespace stages

/// The places where their carriers cross or touch that lie on both; of coincident carriers the ends
/// of the one that lie on the other.
[[nodiscard]] std::vector<Point> common_places(const Stretch& a, const Stretch& b);

/// Where the two cross away from all four ends; contacts do not count.
[[nodiscard]] std::vector<Point> crossings_inside(const Stretch& a, const Stretch& b);

}  // namespace dgt
