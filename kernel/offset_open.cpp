// SPDX-License-Identifier: GPL-3.0-or-later
// Equidistants of open chains. Run there and back, a chain is a loop that bounds nothing; what lies
// farther from it than the distance is bounded by one or more loops all round. Of these, what keeps
// its distance from the way there, and from its corners, is the equidistant to the left; caps and
// the way back are left out.
#include <algorithm>

#include "kernel/check.h"
#include "kernel/offset.h"
#include "kernel/offset_raw.h"

namespace dgt {
namespace {

Chain there_and_back(const Chain& chain) {
  Chain loop = chain;
  loop.closed = true;
  const Chain back = reversed(chain);
  loop.edges.insert(loop.edges.end(), back.edges.begin(), back.edges.end());
  return loop;
}

/// The parts of a loop that belong to the first `edges` edges and the corners between them.
void take_left(const OffsetLoop& loop, std::size_t edges, std::vector<OffsetLoop>& result) {
  const auto is_left = [edges](const OffsetPiece& p) {
    return p.on.part() == 0 ? p.on.edge() < edges : p.on.edge() + 1 < edges;
  };
  std::vector<OffsetPiece> pieces = loop.pieces;
  const auto other = std::ranges::find_if_not(pieces, is_left);
  if (other == pieces.end()) {
    result.push_back(loop);
    return;
  }
  std::ranges::rotate(pieces, other);
  bool goes_on = false;
  for (OffsetPiece& piece : pieces) {
    const bool left = is_left(piece);
    if (left && !goes_on) result.push_back({{}, false});
    if (left) result.back().pieces.push_back(std::move(piece));
    goes_on = left;
  }
}

}  // namespace

std::vector<OffsetLoop> open_offset(const Chain& chain, const Rational& distance,
                                    const OffsetOptions& options, OffsetEngineKind engine) {
  DGT_CHECK(!chain.closed && !chain.edges.empty() && sgn(distance) != 0);
  const bool right = sgn(distance) < 0;
  const Chain way = there_and_back(right ? reversed(chain) : chain);
  const Rational by = abs(distance);
  const std::vector<OffsetLoop> around = engine == OffsetEngineKind::Production
                                             ? region_about(way, by, options)
                                             : shrunk_by_reference({way}, by, 0, options);
  std::vector<OffsetLoop> result;
  for (const OffsetLoop& loop : around) take_left(loop, chain.edges.size(), result);
  if (right) reverse_loops(result);
  for (OffsetLoop& loop : result) tidy(loop);
  std::erase_if(result, [](const OffsetLoop& loop) { return loop.pieces.empty(); });
  return result;
}

}  // namespace dgt
