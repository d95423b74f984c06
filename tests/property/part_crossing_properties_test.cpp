// SPDX-License-Identifier: GPL-3.0-or-later
// Rapids over random polygons, against what topology says: who goes in comes through the boundary.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "kernel/construct.h"
#include "kernel/part_crossing.h"

namespace dgt {
namespace {

using Corners = std::vector<RationalPoint>;

RationalPoint any_place() {
  return {Rational(*rc::gen::inRange(-40, 41)), Rational(*rc::gen::inRange(-40, 41))};
}

/// A simple polygon: star-shaped about the origin, its corners on a coarse grid.
Corners any_polygon() {
  Corners corners;
  const int n = *rc::gen::inRange(3, 14);
  for (int i = 0; i < n; ++i) {
    const Rational r = Rational(*rc::gen::inRange(50, 300)) / 10;
    const UnitVector u = direction_of(Rational(360 * i) / n).unit;
    corners.push_back({on_dyadic_grid(r * u.x(), -3), on_dyadic_grid(r * u.y(), -3)});
  }
  return corners;
}

Toolpath sheet_of(const Corners& corners) {
  Toolpath path;
  Contour& contour = path.contours.emplace_back();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const RationalPoint& from = corners[i];
    const RationalPoint& to = corners[(i + 1) % corners.size()];
    const auto line = line_through(known_point(from), known_point(to));
    Move& move = path.moves.emplace_back();
    move.from = Point(from);
    move.to = Point(to);
    move.carrier = carrier(std::get<Constructed<Line>>(line).value);
  }
  contour.closed = true;
  contour.last = path.moves.size();
  return path;
}

Move& add_rapid(Toolpath& path, const RationalPoint& from, const RationalPoint& to) {
  Move& move = path.moves.emplace_back();
  move.kind = MoveKind::Rapid;
  move.role = Role::Position;
  move.from = Point(from);
  move.to = Point(to);
  return move;
}

/// How often the polygon winds round `q`; nothing on its boundary. Exact.
std::optional<int> winding(const Corners& corners, const RationalPoint& q) {
  int turns = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const RationalPoint& a = corners[i];
    const RationalPoint& b = corners[(i + 1) % corners.size()];
    const int side = sgn(cross(b - a, q - a));
    const bool up = a.y <= q.y && q.y < b.y;
    const bool down = b.y <= q.y && q.y < a.y;
    if (side == 0 && sgn(dot(a - q, b - q)) <= 0) return std::nullopt;
    if (up && side > 0) ++turns;
    if (down && side < 0) --turns;
  }
  return turns;
}

/// Whether the closed segments share a place, exactly.
bool meets(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
           const RationalPoint& d) {
  const auto on = [](const RationalPoint& p, const RationalPoint& q, const RationalPoint& x) {
    return sgn(cross(q - p, x - p)) == 0 && sgn(dot(p - x, q - x)) <= 0;
  };
  const int ab = sgn(cross(b - a, c - a)) * sgn(cross(b - a, d - a));
  const int cd = sgn(cross(d - c, a - c)) * sgn(cross(d - c, b - c));
  return (ab < 0 && cd < 0) || on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b);
}

RC_GTEST_PROP(PartCrossings, WhoGoesInComesThroughTheBoundary, ()) {
  const Corners corners = any_polygon();
  const RationalPoint from{Rational(*rc::gen::inRange(-4, 5)), Rational(*rc::gen::inRange(-4, 5))};
  const RationalPoint to = any_place();
  const auto first = winding(corners, from);
  const auto last = winding(corners, to);
  RC_PRE(first && last);
  Toolpath path = sheet_of(corners);
  add_rapid(path, from, to);
  const bool told = !find_part_crossings(path, CrossingMoves::All, 0).empty();
  RC_ASSERT(told || *first == *last);
}

RC_GTEST_PROP(PartCrossings, AMoveOffTheContourIsToldExactlyWhenItMeetsASide, ()) {
  const Corners corners = any_polygon();
  const RationalPoint from = any_place();
  const RationalPoint to = any_place();
  RC_PRE(winding(corners, from) && winding(corners, to) && from != to);
  Toolpath path = sheet_of(corners);
  add_rapid(path, from, to);
  bool expected = false;
  for (std::size_t i = 0; i < corners.size(); ++i)
    expected = expected || meets(from, to, corners[i], corners[(i + 1) % corners.size()]);
  RC_ASSERT(find_part_crossings(path, CrossingMoves::All, 0).empty() != expected);
}

RC_GTEST_PROP(PartCrossings, ManyMovesAreEachToldAsIfAlone, ()) {
  const Corners corners = any_polygon();
  Toolpath together = sheet_of(corners);
  std::size_t alone = 0;
  for (int i = 0; i < 8; ++i) {
    const RationalPoint from = any_place();
    const RationalPoint to = any_place();
    Toolpath single = sheet_of(corners);
    add_rapid(single, from, to);
    add_rapid(together, from, to);
    alone += find_part_crossings(single, CrossingMoves::All, 0).size();
  }
  RC_ASSERT(find_part_crossings(together, CrossingMoves::All, 0).size() == alone);
}

}  // namespace
}  // namespace dgt
