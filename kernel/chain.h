// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "kernel/angle.h"
#include "kernel/circle.h"

namespace dgt {

/// One edge of a chain: a segment or an arc with rational ends, and the left unit normals there. An
/// arc's centre lies at from + radius·start = to + radius·end, the radius signed: positive
/// counter-clockwise. A segment has radius 0 and equal normals. Moved to the left by d, a point p
/// with normal n goes to p + d n and the radius to radius − d: everything stays rational.
struct ChainEdge {
  RationalPoint from;
  RationalPoint to;
  UnitVector start;
  UnitVector end;
  Rational radius;

  [[nodiscard]] bool is_line() const { return sgn(radius) == 0; }
  [[nodiscard]] RationalPoint centre() const { return from + radius * start.vector(); }
};

/// Edges that follow each other exactly. Closed: the last ends where the first begins.
struct Chain {
  std::vector<ChainEdge> edges;
  bool closed = true;
};

/// The segment from `from` to `to`. Precondition (checked): they differ.
[[nodiscard]] ChainEdge segment(const RationalPoint& from, const RationalPoint& to);

/// The arc from `from` to `to` with the bulge tan(sweep/4), positive counter-clockwise. Its ends
/// are exact. Its radius is |w|²/(2 w·n) for w = to − from and the left normal n at its beginning;
/// n is rational and within 2^−bits of the ideal, so that chains close exactly and nothing grows.
/// Precondition (checked): the ends differ, bulge ≠ 0.
[[nodiscard]] ChainEdge arc(const RationalPoint& from, const RationalPoint& to,
                            const Rational& bulge, int bits = kStandInBits);

/// Edges of a smaller bulge are segments: the arc would leave its chord by less than 2⁻⁸¹ of it,
/// and its radius would be known to too few bits.
inline constexpr int kStraightBulgeExponent = -80;

/// tan(sweep/4) of the arc of `circle` from `from` to `to` in its sense, within 2^exponent of its
/// size: with |w| the chord and h the distance at which the centre lies to its left,
/// |w|/(2 (r + h)). Precondition: the ends lie on the circle, as near as stand-ins do, and differ.
[[nodiscard]] Rational bulge_of(const Circle& circle, const RationalPoint& from,
                                const RationalPoint& to, int exponent = -kStandInBits);

/// A vertex of a polyline with bulges; the bulge is that of the edge to the next vertex.
struct BulgeVertex {
  RationalPoint at;
  Rational bulge;
};
/// The chain of a polyline; vertices that coincide with the one before are left out. Arcs of more
/// than half a turn are halved. Nothing when fewer than two distinct vertices are left.
[[nodiscard]] std::optional<Chain> chain_of(const std::vector<BulgeVertex>& vertices, bool closed);

[[nodiscard]] ChainEdge reversed(const ChainEdge& edge);
[[nodiscard]] Chain reversed(const Chain& chain);

}  // namespace dgt
