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
[[nodiscard]] Bounds box_of(const Piece& piece);
/// Whether the ray from the arc's centre along (dx, dy) meets it. Precondition: an arc.
[[nodiscard]] bool in_sector(const Piece& arc, double dx, double dy);
/// The nearest places of two pieces, in plain floating point: what is told to a person. Whether the
/// two come too near is decided elsewhere (stretch.h).
[[nodiscard]] Approach nearest(const Piece& a, const Piece& b);

}  // namespace dgt
