// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "kernel/toolpath.h"

/// How far one path runs from another: upper bounds with a proof, never samples.
///
/// The distance bounded is the Fréchet distance: both curves can be run through from beginning to
/// end without going back so that the two places are never further apart. It bounds the distance of
/// every point of either curve from the other, both ways, and holds for paths when it holds for
/// their parts, since parts that follow each other are matched at their common ends.
namespace dgt {

/// A place known to within a box, in mm.
struct BallPlace {
  Ball x;
  Ball y;
};

/// Encloses what the doubles of a point are rounded from.
[[nodiscard]] BallPlace place_of(const Point& p);
[[nodiscard]] BallPlace place_of(const RationalPoint& p);
[[nodiscard]] inline BallPlace operator+(const BallPlace& a, const BallPlace& b) {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline BallPlace operator-(const BallPlace& a, const BallPlace& b) {
  return {a.x - b.x, a.y - b.y};
}

/// A segment, or an arc of at most one turn.
struct Curve {
  BallPlace from;
  BallPlace to;
  bool is_line = true;
  BallPlace centre;
  Ball radius;  ///< positive
  bool ccw = true;
  /// Radians, in 0…2π, 2π for a full circle. It tells cases apart that lie far from each other; no
  /// bound is made of it.
  long double sweep = 0;
};

/// The curve of a line, arc or rapid, moved by `shift`.
[[nodiscard]] Curve curve_of(const Move& move, const BallPlace& shift);

/// How far along a curve the place nearest to `p` lies: 0…1, about.
[[nodiscard]] long double progress(const Curve& curve, const BallPlace& p);

/// The part of a curve between two of its points that lie `begin` and `end` along it, 0…1.
struct CurveSpot {
  BallPlace at;
  long double along = 0;
};
[[nodiscard]] Curve part(const Curve& curve, const CurveSpot& begin, const CurveSpot& end);
/// The point of the curve's carrier nearest to `p`; nothing at the centre of an arc.
[[nodiscard]] std::optional<BallPlace> foot(const Curve& curve, const BallPlace& p);

/// An upper bound of |p − q| in mm.
[[nodiscard]] double distance_bound(const BallPlace& p, const BallPlace& q);

/// An upper bound of the distance between the two curves, in mm. The proof is in measure.cpp.
[[nodiscard]] double frechet_bound(const Curve& a, const Curve& b);

}  // namespace dgt
