// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/offset_input.h"

#include <vector>

#include "kernel/check.h"
#include "kernel/contour_path.h"

namespace dgt {
namespace {

/// Finer than the stand-ins of elements, so that rounding a joint does not show beside them.
constexpr int kJointExponent = -(kStandInBits + 8);
/// Rational joints of more bits go to the grid as well: they come of long constructions, and every
/// number of the offset would carry them.
constexpr std::size_t kMaxJointHeight = 128;

Rational stand_in(const OneRoot& x) {
  if (x.is_rational() && height(x.a) <= kMaxJointHeight) return x.a;
  return on_dyadic_grid(rational_within(x, kJointExponent), kJointExponent);
}

RationalPoint stand_in(const Point& p) {
  const ExactPoint exact = p.exact();
  return {stand_in(exact.x), stand_in(exact.y)};
}

std::vector<Move> part_of(const Toolpath& path, const Contour& contour) {
  std::vector<Move> part;
  for (const Move& move : programmed_moves(path, contour)) {
    if (is_part(move)) part.push_back(move);
  }
  return part;
}

bool is_connected(const std::vector<Move>& moves) {
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (!(moves[i - 1].to == moves[i].from)) return false;
  }
  return true;
}

/// Takes away what the beginning or the end runs beyond the place where they meet.
bool close(std::vector<Move>& part) {
  Move& first = part.front();
  Move& last = part.back();
  if (first.from == last.to) return true;
  if (part.size() == 1) return false;
  if (covers(first, last.to)) {
    first.from = last.to;
    if (first.from == first.to) part.erase(part.begin());
    return true;
  }
  if (covers(last, first.from)) {
    last.to = first.from;
    if (last.from == last.to) part.pop_back();
    return true;
  }
  return false;
}

/// The vertices at which the move begins and, for a full circle, which it passes half way.
void add_vertices(std::vector<BulgeVertex>& vertices, const Move& move) {
  const RationalPoint from = stand_in(move.from);
  if (move.kind == MoveKind::Line) {
    vertices.push_back({from, 0});
    return;
  }
  const Circle circle = move.circle();
  if (move.full_circle) {
    const Rational half = circle.counter_clockwise() ? 1 : -1;
    vertices.push_back({from, half});
    vertices.push_back({2 * circle.centre() - from, half});
    return;
  }
  const RationalPoint to = stand_in(move.to);
  const Rational bulge = from == to ? Rational(0) : bulge_of(circle, from, to);
  vertices.push_back({from, on_dyadic_grid(bulge, kJointExponent)});
}

}  // namespace

std::optional<Chain> loop_of(const Toolpath& path, const Contour& contour) {
  std::vector<Move> part = part_of(path, contour);
  if (part.empty() || !is_connected(part)) return std::nullopt;
  const bool closed = close(part);
  std::vector<BulgeVertex> vertices;
  for (const Move& move : part) add_vertices(vertices, move);
  if (!closed) vertices.push_back({stand_in(part.back().to), 0});
  return chain_of(vertices, closed);
}

}  // namespace dgt
