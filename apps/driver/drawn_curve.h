// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "post/figures.h"

/// Lines and arcs in doubles, to be shown and pointed at. Nothing of it is ever written to a
/// program: what counts is decided on the exact path.
namespace dgt {

/// A place or a vector in mm.
struct DrawnPlace {
  double x = 0;
  double y = 0;

  friend bool operator==(const DrawnPlace&, const DrawnPlace&) = default;
};
[[nodiscard]] inline DrawnPlace operator+(DrawnPlace a, DrawnPlace b) {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline DrawnPlace operator-(DrawnPlace a, DrawnPlace b) {
  return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline DrawnPlace operator*(double k, DrawnPlace a) { return {k * a.x, k * a.y}; }
[[nodiscard]] inline DrawnPlace turned_left(DrawnPlace a) { return {-a.y, a.x}; }
[[nodiscard]] double distance(DrawnPlace a, DrawnPlace b);

/// A move that travels. Its ends, its centre and its radius are the exact ones, each rounded once.
struct DrawnCurve {
  DrawnPlace from;
  DrawnPlace to;
  DrawnPlace centre;  ///< of an arc
  double radius = 0;  ///< mm, positive; 0: a line
  double sweep = 0;   ///< radians, counter-clockwise positive, ±2π once round

  [[nodiscard]] bool is_arc() const { return radius > 0; }
  [[nodiscard]] double length() const;
};

/// Which of the two arcs between two points an arc is, is decided exactly.
[[nodiscard]] DrawnCurve drawn(const Move& move);

/// The place `part` of the way along, 0…1. It is reckoned from the nearer end, so that it is off by
/// a few ulps of its distance from there, however far away the centre lies; at 0 and 1 it is the
/// end itself.
[[nodiscard]] DrawnPlace place_at(const DrawnCurve& curve, double part);
/// The unit vector of travel there; (1, 0) where there is none.
[[nodiscard]] DrawnPlace direction_at(const DrawnCurve& curve, double part);

/// The curve from its beginning to the place `part` of the way along, 0…1.
[[nodiscard]] DrawnCurve beginning_of(const DrawnCurve& curve, double part);

/// A box that holds the curve, but for a few ulps; seldom the least.
[[nodiscard]] Box box_around(const DrawnCurve& curve);
[[nodiscard]] bool overlap(const Box& a, const Box& b);

/// Where a curve comes nearest to a place.
struct NearestPlace {
  double distance = 0;  ///< mm
  double part = 0;      ///< of the way along, 0…1
  DrawnPlace at;
};
[[nodiscard]] NearestPlace nearest_place(const DrawnCurve& curve, DrawnPlace to);

/// Appends the corners of a polygonal chain that stands for the curve, without its beginning.
///  (1) It ends in `to`, and all its corners lie on the curve.
///  (2) Where it comes into `window` it runs within `tolerance` mm of the curve.
///  (3) Where the curve stays outside so does the chain, in few strokes.
void flatten(const DrawnCurve& curve, const Box& window, double tolerance,
             std::vector<DrawnPlace>& corners);

}  // namespace dgt
