// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/chain.h"
#include "kernel/meet.h"

/// Robust equidistants: the boundary of all places that lie left of directed loops and at least a
/// distance away from them, islands and collapses included, every decision exact.
///
/// Nouns. The *raw curve* of a loop is its whole convolution with the circle of the offset: each
/// edge moved along its normals, and at each corner an arc about it that turns one edge's normal
/// into the next one's the short way, also where this runs backwards. It closes exactly. Its
/// *winding number* at a place counts (with signs) how the discs about that place meet the loop;
/// where no disc meets it, the number is that of the inside of the region. A *void loop* bounds a
/// place with that number which the loop nevertheless fills: it occurs when a part of the loop fits
/// into the disc.
namespace dgt {

/// An edge of a result: on a line through its ends or on a circle.
struct OffsetPiece {
  Point from;
  Point to;
  bool is_line = true;
  RationalPoint centre;
  Rational radius;  ///< signed, positive counter-clockwise
};
struct OffsetLoop {
  std::vector<OffsetPiece> pieces;
};

/// Loops and pieces smaller than this in both coordinates are what lies between ideal edges and
/// their rational stand-ins, and left out. Unit: mm.
inline constexpr double kOffsetResolution = 1e-9;

/// The reference engine: the raw curves as an exact arrangement, faces labelled by winding number,
/// the boundary read off the faces. Simple and slow: some 100 µs an edge.
///  (1) `distance` > 0 shrinks the region left of the loops, < 0 grows it; convex corners are
///  round. (2) Every place of the region is at least |distance| away from the loops, and every
///  place left of
///      them that is so belongs to it.
///  (3) Outer loops run counter-clockwise, holes clockwise: the region lies to the left.
/// Precondition (checked): the loops are closed; they may touch but not cross.
[[nodiscard]] std::vector<OffsetLoop> reference_offset(const std::vector<Chain>& loops,
                                                       const Rational& distance);

/// The production engine: winding numbers carried along the raw curve, crossings found through a
/// box tree in contour order, every decision in balls (number.h). Where a ball cannot tell
/// (coincident edges, triple points, contacts) the whole input goes to the reference engine. Same
/// loops as reference_offset.
struct OffsetCounts {
  std::size_t pairs = 0;      ///< pieces whose boxes overlap
  std::size_t crossings = 0;  ///< of the raw curves
  bool by_reference = false;  ///< some decision was left open
};
[[nodiscard]] std::vector<OffsetLoop> production_offset(const std::vector<Chain>& loops,
                                                        const Rational& distance,
                                                        OffsetCounts* counts = nullptr);

/// mm², counter-clockwise positive, and mm; within a few units in the last place of the
/// coordinates.
[[nodiscard]] double area(const OffsetLoop& loop);
/// Arcs of at most half a turn.
[[nodiscard]] double area(const Chain& closed);
[[nodiscard]] double length(const OffsetLoop& loop);

/// Whether no edge of the loops comes nearer to `p` than `distance` ≥ 0; exact.
[[nodiscard]] bool keeps_distance(const std::vector<Chain>& loops, const RationalPoint& p,
                                  const Rational& distance);

}  // namespace dgt
