// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "kernel/offset.h"

/// What both offset engines share: the raw curve, the number wanted, what is taken off the result.
/// Internal to the kernel.
namespace dgt {

/// A piece of a raw curve: a segment or an arc of at most half a turn, with rational ends.
struct RawPiece {
  RationalPoint from;
  RationalPoint to;
  bool is_line = true;
  RationalPoint centre;
  Rational squared_radius;
  bool counter_clockwise = true;
  RawKey key;  ///< where the raw curve of all loops has it
};

/// `edge` moved to the left; nothing for an arc shrunk to its centre.
[[nodiscard]] std::optional<RawPiece> raw_edge(const ChainEdge& edge, const Rational& distance);
/// What turns the normal at the end of `edge` into that of `next`; nothing at a tangent joint,
/// and without an offset. The short way about the corner, or where this is on its outer side, as
/// the options say. An edge that doubles back on itself turns to the right: its end is kept away
/// from on all sides.
[[nodiscard]] std::vector<RawPiece> raw_corner(const ChainEdge& edge, const ChainEdge& next,
                                               const Rational& distance,
                                               const OffsetOptions& options);
/// The raw curves of all loops, one after the other.
[[nodiscard]] std::vector<RawPiece> raw_curve(const std::vector<Chain>& loops,
                                              const Rational& distance,
                                              const OffsetOptions& options);

struct CoarsePoint {
  double x = 0;
  double y = 0;
};
/// Whether two equidistants that end in `from` with the heading `before`, and begin in `to` with
/// `behind`, meet in `at` when they are prolonged, not too far from the corner. Both engines ask
/// this of the same doubles but for their last bits; the limit has room for those.
[[nodiscard]] bool is_ahead(CoarsePoint at, CoarsePoint from, CoarsePoint before, CoarsePoint to,
                            CoarsePoint behind, CoarsePoint corner, double limit);

/// The winding number of the region left of the loops: 1 inside an outermost counter-clockwise
/// loop, 0 where the region reaches to infinity.
[[nodiscard]] int number_of_region(const std::vector<Chain>& loops);

/// What the reference engine does once it knows the number of the region.
[[nodiscard]] std::vector<OffsetLoop> shrunk_by_reference(const std::vector<Chain>& loops,
                                                          const Rational& distance, int number,
                                                          const OffsetOptions& options);

/// All that lies farther than the distance from an open chain, run there and back; by the
/// production engine. Pieces as they come.
[[nodiscard]] std::vector<OffsetLoop> region_about(const Chain& there_and_back,
                                                   const Rational& distance,
                                                   const OffsetOptions& options);

/// Takes off slivers and, where a part of the region may fit into the disc, void loops.
void drop_void_loops(std::vector<OffsetLoop>& result, const std::vector<Chain>& loops,
                     const Rational& distance);

/// Leaves out what is minute, and joins the parts of one arc, or of one line.
void tidy(OffsetLoop& loop);

[[nodiscard]] std::vector<Chain> reversed(const std::vector<Chain>& loops);
/// The same loops run the other way.
void reverse_loops(std::vector<OffsetLoop>& loops);

}  // namespace dgt
