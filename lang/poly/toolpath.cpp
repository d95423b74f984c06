// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/poly/toolpath.h"

#include <memory>
#include <utility>

namespace dgt {
namespace {

SourcePlace place_of(const Range& range) {
  const Place place = range.place();
  return {0, place.line, place.column};
}

Move rapid_between(const Point& from, const Point& to, const SourcePlace& source) {
  Move move;
  move.kind = MoveKind::Rapid;
  move.role = Role::Position;
  move.from = from;
  move.to = to;
  move.source = source;
  return move;
}

}  // namespace

std::vector<Move> moves_along(const Chain& chain) {
  std::vector<Move> moves;
  moves.reserve(chain.edges.size());
  for (const ChainEdge& edge : chain.edges) {
    Move move;
    move.from = moves.empty() ? Point(edge.from) : moves.back().to;
    move.to = Point(edge.to);
    if (!edge.is_line()) {
      move.kind = MoveKind::Arc;
      move.carrier.base = ElementPtr(Circle(edge.centre(), edge.radius));
    }
    moves.push_back(std::move(move));
  }
  if (chain.closed) moves.back().to = moves.front().from;
  return moves;
}

Toolpath toolpath_of(const std::vector<PolyLoop>& loops, const SourceFile& file) {
  Toolpath path;
  path.files = {file.name()};
  if (loops.empty()) return path;
  path.start = loops.front().chain.edges.front().from;
  Point at(path.start);
  for (const PolyLoop& loop : loops) {
    Contour contour;
    contour.id = static_cast<unsigned>(path.contours.size() + 1);
    contour.closed = loop.chain.closed;
    std::vector<Move> moves = moves_along(loop.chain);
    for (std::size_t i = 0; i < loop.places.size(); ++i) {
      moves[i].source = place_of(loop.places[i]);
    }
    const Move& first = moves.front();
    if (!(first.from == at)) path.moves.push_back(rapid_between(at, first.from, first.source));
    contour.first = path.moves.size();
    path.moves.insert(path.moves.end(), std::make_move_iterator(moves.begin()),
                      std::make_move_iterator(moves.end()));
    contour.last = path.moves.size();
    at = path.moves.back().to;
    path.contours.push_back(std::move(contour));
  }
  return path;
}

}  // namespace dgt
