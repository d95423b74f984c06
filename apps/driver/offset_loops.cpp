// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/offset_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <tuple>
#include <utility>

#include "apps/driver/move_json.h"
#include "lang/poly/toolpath.h"
#include "post/poly.h"
#include "post/svg.h"

namespace dgt {
namespace {

bool near(const Rational& a, const Rational& b) {
  static const Rational kReach = power_of_two(kContactExponent);
  return abs(a - b) <= kReach;
}

bool on_one_circle(const Move& a, const Move& b) {
  if (a.kind != MoveKind::Arc || b.kind != MoveKind::Arc) return false;
  const Circle first = a.circle();
  const Circle second = b.circle();
  return near(first.centre().x, second.centre().x) && near(first.centre().y, second.centre().y) &&
         near(first.radius(), second.radius());
}

bool same_as_written(const Point& a, const Point& b) { return a.x() == b.x() && a.y() == b.y(); }

/// Coordinates that come from tangent joints in decimals are this far off their joints, and engines
/// then put arcs between; nothing that is meant is so short. Unit: of the last place of the larger
/// coordinate.
constexpr double kInvisible = 8;

bool nearly_same(const Point& a, const Point& b) {
  const double size = std::max(std::fabs(a.x()), std::fabs(a.y()));
  const double reach = kInvisible * std::numeric_limits<double>::epsilon() * size;
  return std::fabs(a.x() - b.x()) <= reach && std::fabs(a.y() - b.y()) <= reach;
}

/// Ends where it begins, as good as, without being a turn.
bool is_invisible(const OffsetPiece& piece, const Move& move) {
  return nearly_same(piece.from, piece.to) &&
         (move.kind == MoveKind::Line || half_turn_order(move) < 0);
}

Move move_along(const OffsetPiece& piece) {
  Move move;
  move.from = piece.from;
  move.to = piece.to;
  if (!piece.is_line) {
    move.kind = MoveKind::Arc;
    move.carrier.base = ElementPtr(Circle(piece.centre, piece.radius));
  }
  return move;
}

/// A move begins where the one before ends, also when something invisible between them is left out.
std::vector<Move> visible_moves(const OffsetLoop& loop) {
  std::vector<Move> moves;
  for (const OffsetPiece& piece : loop.pieces) {
    Move move = move_along(piece);
    if (is_invisible(piece, move)) continue;
    // A turn that only an invisible gap keeps from being whole, as a circle that touches itself.
    move.full_circle = same_as_written(move.from, move.to);
    if (!moves.empty()) move.from = moves.back().to;
    moves.push_back(std::move(move));
  }
  if (loop.closed && !moves.empty()) moves.back().to = moves.front().from;
  return moves;
}

/// The whole circle of an arc, begun at its lowest point.
Move full_circle(const Move& arc) {
  const Circle circle = arc.circle();
  Move move = arc;
  move.full_circle = true;
  move.from = Point(RationalPoint{circle.centre().x, circle.centre().y - abs(circle.radius())});
  move.to = move.from;
  return move;
}

void join_arcs(std::vector<Move>& moves, bool closed) {
  const auto parted = [&](std::size_t i) {
    return !on_one_circle(moves[(i + moves.size() - 1) % moves.size()], moves[i]);
  };
  std::size_t start = 0;
  while (closed && start < moves.size() && !parted(start)) ++start;
  if (start == moves.size()) {
    moves = {full_circle(moves.front())};
    return;
  }
  std::ranges::rotate(moves, moves.begin() + static_cast<std::ptrdiff_t>(start));
  std::vector<Move> joined;
  for (Move& move : moves) {
    if (!joined.empty() && on_one_circle(joined.back(), move)) {
      joined.back().to = std::move(move.to);
    } else {
      joined.push_back(std::move(move));
    }
  }
  moves = std::move(joined);
}

/// Lowest first, then leftmost; moves out of one vertex by where they lead.
auto order_of(const Move& move) {
  return std::tuple(move.from.y(), move.from.x(), move.to.y(), move.to.x());
}

double area_of(const std::vector<Move>& moves) {
  double circles = 0;
  OffsetLoop loop;
  for (const Move& move : moves) {
    if (move.full_circle) {
      const double r = nearest_double(move.circle().radius());
      circles += std::copysign(std::numbers::pi * r * r, r);
      continue;
    }
    OffsetPiece piece{move.from, move.to, move.kind == MoveKind::Line, {}, 0, {}};
    if (!piece.is_line) {
      piece.centre = move.circle().centre();
      piece.radius = move.circle().radius();
    }
    loop.pieces.push_back(std::move(piece));
  }
  return loop.pieces.empty() ? circles : circles + area(loop);
}

std::vector<Move> written_form(const OffsetLoop& loop) {
  std::vector<Move> moves = visible_moves(loop);
  if (moves.empty()) return moves;
  join_arcs(moves, loop.closed);
  if (loop.closed) std::ranges::rotate(moves, std::ranges::min_element(moves, {}, order_of));
  return moves;
}

}  // namespace

std::vector<EquidistantLoop> in_order(std::vector<OffsetLoop> loops) {
  std::vector<EquidistantLoop> result;
  for (OffsetLoop& loop : loops) {
    EquidistantLoop written;
    written.moves = written_form(loop);
    loop.pieces.clear();
    if (written.moves.empty()) continue;
    written.closed = loop.closed;
    written.area = loop.closed ? area_of(written.moves) : 0;
    written.length = lengths(written.moves).cut;
    result.push_back(std::move(written));
  }
  std::ranges::sort(result, {}, [](const EquidistantLoop& loop) {
    return std::tuple_cat(order_of(loop.moves.front()), std::tuple(loop.area));
  });
  return result;
}

std::string to_json(const std::vector<EquidistantLoop>& loops) {
  MoveJson json;
  json.out = "{\"schema\": \"dgt-offset/1\",\n \"loops\": [";
  for (const EquidistantLoop& loop : loops) {
    json.out += &loop == &loops.front() ? "\n  {\"area\": " : ",\n  {\"area\": ";
    json.number(loop.area);
    json.out += ", \"length\": ";
    json.number(loop.length);
    json.out += loop.closed ? ", \"closed\": true" : ", \"closed\": false";
    json.out += ",\n   \"moves\": ";
    json.moves(loop.moves);
    json.out += '}';
  }
  json.out += "]}\n";
  return std::move(json.out);
}

std::string to_poly(const std::vector<EquidistantLoop>& loops) {
  std::string out;
  for (const EquidistantLoop& loop : loops) append_poly(out, loop.moves);
  return out;
}

std::string to_svg(const std::vector<EquidistantLoop>& loops, const std::vector<Chain>& contours) {
  Toolpath path;
  if (!contours.empty()) path.start = contours.front().edges.front().from;
  for (const Chain& chain : contours) {
    Contour contour;
    contour.closed = chain.closed;
    contour.programmed = moves_along(chain);
    path.contours.push_back(std::move(contour));
  }
  for (const EquidistantLoop& loop : loops) {
    Contour contour;
    contour.closed = loop.closed;
    contour.first = path.moves.size();
    path.moves.insert(path.moves.end(), loop.moves.begin(), loop.moves.end());
    contour.last = path.moves.size();
    path.contours.push_back(std::move(contour));
  }
  return draw_svg(path);
}

}  // namespace dgt
