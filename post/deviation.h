// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "post/rounding.h"

/// How far a written curve may lie from the exact one: upper bounds with a proof, never samples.
///
/// All lengths are in units of the grid. The distance bounded is the Fréchet distance: both curves
/// can be run through from their beginnings to their ends, without going back, so that the two
/// places are never further apart than the bound. It bounds the distance of every point of either
/// curve from the other (Hausdorff, both ways), and keeps its meaning when moves are strung
/// together, since matched moves meet in matched points.
namespace dgt {

/// An arc from `from` to `to` about `centre`. What the balls hold are one true arc's numbers.
struct ArcBalls {
  BallPoint centre;
  Ball radius;
  BallPoint from;
  BallPoint to;
  bool ccw = true;
  bool major = false;  ///< the larger of the two arcs; a half turn may be called either
};

[[nodiscard]] BallPoint balls(const GridPoint& p);

/// The distance of two points. Rounded up.
[[nodiscard]] double distance_bound(const BallPoint& a, const BallPoint& b);

/// Of an arc of at most half a turn from its chord; larger ones: of the circle. Rounded up.
[[nodiscard]] double sagitta_bound(const ArcBalls& arc);

/// A written segment against an exact one. The distance at equal fractions of both is a convex
/// function of the fraction, so it is largest at an end. A segment of length 0 stands for a move
/// that was not written.
[[nodiscard]] double deviation_of_line(const GridPoint& from, const GridPoint& to,
                                       const BallPoint& exact_from, const BallPoint& exact_to);

/// A written segment against an exact arc of at most half a turn: such an arc is the graph of a
/// function over its chord, nowhere higher than its sagitta; to this comes the distance of the
/// chords.
[[nodiscard]] double deviation_of_chord(const GridPoint& from, const GridPoint& to,
                                        const ArcBalls& exact);

/// A written arc against an exact one of the same sense. `band`: the written curve may run anywhere
/// within this distance of the radius of `written` (controls differ in how they run an arc whose
/// two radii differ). The proof is in deviation.cpp.
[[nodiscard]] double deviation_of_arc(const ArcBalls& written, double band, const ArcBalls& exact);

}  // namespace dgt
