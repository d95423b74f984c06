// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "kernel/offset.h"
#include "kernel/toolpath.h"

namespace dgt {

/// One loop of an equidistant, as it is written.
struct EquidistantLoop {
  std::vector<Move> moves;
  bool closed = true;
  double area = 0;    ///< mm², counter-clockwise positive; 0 when open
  double length = 0;  ///< mm
};

/// Loops of an offset engine in the one order in which they are written, whatever order the engine
/// found them in.
///  (1) A closed loop begins at its lowest vertex, of these at the leftmost; a loop that is one
///  full
///      circle at the lowest point of it. Loops follow each other by the same rule. What counts are
///      the coordinates as written.
///  (2) Arcs that go on along one circle (within 2^kContactExponent mm) are one arc, and what is
///      shorter than a few units in the last place of its coordinates is left out.
///  (3) Moves that follow each other share their point.
[[nodiscard]] std::vector<EquidistantLoop> in_order(std::vector<OffsetLoop> loops);

/// The loops as JSON of the schema `dgt-offset/1` (apps/README.md).
[[nodiscard]] std::string to_json(const std::vector<EquidistantLoop>& loops);
/// The loops as polylines with bulges; empty when there are none.
[[nodiscard]] std::string to_poly(const std::vector<EquidistantLoop>& loops);
/// The loops as an SVG drawing, above the contours that they were made from.
[[nodiscard]] std::string to_svg(const std::vector<EquidistantLoop>& loops,
                                 const std::vector<Chain>& contours);

}  // namespace dgt
