// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "kernel/cgal/arrangement.h"
#include "kernel/offset.h"
#include "kernel/offset_raw.h"

namespace dgt {
namespace {

bool same_support(const OffsetPiece& a, const OffsetPiece& b) {
  if (a.is_line != b.is_line) return false;
  if (!a.is_line) return a.centre == b.centre && a.radius == b.radius;
  // Lines of one edge are cut at one-root points only: their directions agree to rounding.
  const auto direction = [](const OffsetPiece& p) {
    return std::pair(p.to.x() - p.from.x(), p.to.y() - p.from.y());
  };
  const auto [ax, ay] = direction(a);
  const auto [bx, by] = direction(b);
  return std::fabs(ax * by - ay * bx) <= 1e-12 * std::hypot(ax, ay) * std::hypot(bx, by) &&
         ax * bx + ay * by > 0;
}

/// Joins the x-monotone parts of one arc, and of one line, again.
void merge_pieces(OffsetLoop& loop) {
  auto& pieces = loop.pieces;
  // Begin at a true corner, so that no run passes the seam.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const OffsetPiece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
    if (same_support(before, pieces[i])) continue;
    std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(i), pieces.end());
    break;
  }
  std::vector<OffsetPiece> merged;
  for (OffsetPiece& piece : pieces) {
    const bool goes_on =
        !merged.empty() && same_support(merged.back(), piece) && merged.size() + pieces.size() > 3;
    if (goes_on && !(piece.is_line == false && merged.back().from == piece.to))
      merged.back().to = piece.to;
    else
      merged.push_back(std::move(piece));
  }
  pieces = std::move(merged);
}

}  // namespace

std::vector<OffsetLoop> reference_offset(const std::vector<Chain>& loops,
                                         const Rational& distance) {
  if (loops.empty()) return {};
  if (sgn(distance) < 0) {  // growing the region is shrinking what lies beyond it
    std::vector<OffsetLoop> result = reference_offset(reversed(loops), -distance);
    reverse_loops(result);
    return result;
  }
  std::vector<OffsetLoop> result =
      cgal::faces_with_winding_number(raw_curve(loops, distance), number_of_region(loops));
  drop_void_loops(result, loops, distance);
  for (OffsetLoop& loop : result) merge_pieces(loop);
  return result;
}

}  // namespace dgt
