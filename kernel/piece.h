// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/box_tree.h"
#include "kernel/toolpath.h"

namespace dgt {

/// A line segment or an arc in doubles, for measuring: each coordinate lies within half a unit in
/// the last place of the exact one.
struct Piece {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool arc = false;
  bool full_circle = false;
  double cx = 0, cy = 0;
  double radius = 0;  ///< signed: positive counter-clockwise
};

/// Two places, one on each of two pieces, and how far they are apart.
struct Approach {
  double distance = 0;
  double x = 0;  ///< on the first piece
  double y = 0;
};

[[nodiscard]] Piece piece_of(const Move& move);
[[nodiscard]] Box box_of(const Piece& piece);
/// Whether the ray from the arc's centre along (dx, dy) meets it. Precondition: an arc.
[[nodiscard]] bool in_sector(const Piece& arc, double dx, double dy);
/// The nearest places of two pieces. The distance is right within 32 units in the last place of the
/// largest coordinate or radius: each candidate is a chain of fewer than 16 rounded operations on
/// such numbers, and the least distance depends on its candidates continuously, so that a place
/// taken for inside a sector or segment although it lies a rounding error outside changes nothing
/// more.
[[nodiscard]] Approach nearest(const Piece& a, const Piece& b);

/// Whether the two cross away from their ends: at a place further than `margin` mm from each.
[[nodiscard]] bool cross_inside(const Piece& a, const Piece& b, double margin);

}  // namespace dgt
