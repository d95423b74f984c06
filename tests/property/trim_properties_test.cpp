// SPDX-License-Identifier: GPL-3.0-or-later
// Trimmed equidistants against the reference engine, which shares neither strands nor joints with
// them: the region left of the contour, shrunk by the offset.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "kernel/contour.h"
#include "kernel/offset.h"
#include "kernel/stretch.h"
#include "tests/support/geometry_generators.h"

namespace dgt {
namespace {

struct Room {
  std::vector<RationalPoint> corners;  // counter-clockwise about the origin
  Rational offset;
  Rational fillet;  // at every corner but those of the first side; 0: none
};

Room any_room() {
  Room room;
  const int n = *rc::gen::inRange(4, 16);
  const bool waisted = *rc::gen::arbitrary<bool>();  // narrow near the middle of the sides
  for (int i = 0; i < n; ++i) {
    const bool narrow = waisted && (4 * i / n) % 2 == 1;
    const Rational r = Rational(*rc::gen::inRange(narrow ? 20 : 60, narrow ? 60 : 300)) / 10;
    const UnitVector u = direction_of(Rational(360 * i) / n + *rc::gen::inRange(0, 10)).unit;
    room.corners.push_back({on_dyadic_grid(r * u.x(), -10), on_dyadic_grid(r * u.y(), -10)});
  }
  room.offset = Rational(*rc::gen::inRange(2, 60)) / 10;
  room.fillet = *rc::gen::inRange(0, 3) == 0 ? Rational(1) : Rational(0);
  return room;
}

std::optional<BuiltContour> built(const Room& room) {
  std::vector<ContourItem> items;
  const auto add = [&](auto what) { items.push_back({std::move(what), {}}); };
  const std::size_t n = room.corners.size();
  std::vector<ElementPtr> sides;
  for (std::size_t i = 0; i < n; ++i) {
    const auto line =
        line_through(known_point(room.corners[i]), known_point(room.corners[(i + 1) % n]));
    if (std::holds_alternative<Impossible>(line)) return std::nullopt;
    sides.push_back(ElementPtr(std::get<Constructed<Line>>(line).value));
  }
  const Vector half = Rational(1, 2) * (room.corners[0] + room.corners[1]);
  const Point begin(half);
  add(OffsetItem{room.offset, true});
  add(PointItem{begin});
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 1 && sgn(room.fillet) != 0) add(FilletItem{room.fillet});
    add(AlongItem{sides[i]});
  }
  add(AlongItem{sides[0]});
  add(PointItem{begin});
  ContourOptions options;
  options.offset_side = OffsetSide::Left;
  options.gouge = GougePolicy::Trim;
  options.corner = CornerStyle::Round;
  ToolState state;
  return build_contour(items, state, options);
}

/// The programmed contour as the engines take it.
Chain chain_of_contour(const BuiltContour& contour) {
  std::vector<BulgeVertex> vertices;
  const auto near = [](const Point& p) {
    const ExactPoint e = p.exact();
    return RationalPoint{rational_within(e.x, -120), rational_within(e.y, -120)};
  };
  for (const Move& move : contour.programmed) {
    if (!is_part(move)) continue;
    const RationalPoint from = near(move.from);
    const bool arc = move.kind == MoveKind::Arc;
    vertices.push_back({from, arc ? bulge_of(move.circle(), from, near(move.to)) : Rational(0)});
  }
  return chain_of(vertices, true).value();
}

double area_of(const std::vector<Move>& moves) {
  OffsetLoop loop;
  for (const Move& move : moves) {
    if (!is_part(move)) continue;
    OffsetPiece piece{move.from, move.to, move.kind == MoveKind::Line, {}, {}, {}};
    if (!piece.is_line) {
      piece.centre = move.circle().centre();
      piece.radius = move.circle().radius();
    }
    loop.pieces.push_back(piece);
  }
  return area(loop);
}

double length_of(const std::vector<Move>& moves) {
  double sum = 0;
  for (const Move& move : moves)
    if (is_part(move)) sum += length(move);
  return sum;
}

RC_GTEST_PROP(Trim, GivesTheLoopOfTheReferenceOrSaysThatThereIsNotOne, ()) {
  const Room room = any_room();
  const auto contour = built(room);
  if (!contour || contour->programmed.empty() || !contour->closed) return;
  const auto loops = reference_offset({chain_of_contour(*contour)}, room.offset);
  const bool trimmed =
      std::any_of(contour->notices.begin(), contour->notices.end(),
                  [](const auto& n) { return n.kind == ContourNotice::Kind::Trimmed; });
  RC_TAG("compared");
  RC_CLASSIFY(trimmed && contour->faults.empty(), "trimmed");
  RC_CLASSIFY(loops.size() > 1, "falls apart");
  RC_CLASSIFY(loops.empty(), "nothing left");
  if (!contour->faults.empty()) {
    const auto why = contour->faults.back().kind;
    if (why == ContourFault::Kind::BlendsOverlap) return;  // of the programmed contour itself
    RC_CLASSIFY(why == ContourFault::Kind::TrimStart, "begins in a gouge");
    RC_ASSERT(loops.size() != 1 || why == ContourFault::Kind::TrimStart);
    return;
  }
  RC_ASSERT(loops.size() == 1U);
  const double area_there = area(loops.front());
  RC_ASSERT(std::fabs(area_of(contour->moves) - area_there) < 1e-9 * (1 + area_there));
  RC_ASSERT(std::fabs(length_of(contour->moves) - length(loops.front())) <
            1e-9 * (1 + length(loops.front())));
}

RC_GTEST_PROP(Trim, KeepsTheOffsetFromTheWholeContourExactly, ()) {
  const Room room = any_room();
  const auto contour = built(room);
  if (!contour || !contour->faults.empty()) return;
  const Rational kept = room.offset - power_of_two(-60);
  for (const Move& cut : contour->moves) {
    for (const Move& wall : contour->programmed) {
      if (is_part(cut) && is_part(wall))
        RC_ASSERT(!comes_nearer(stretch_of(cut), stretch_of(wall), kept));
    }
  }
  for (std::size_t i = 1; i < contour->moves.size(); ++i)
    RC_ASSERT(contour->moves[i - 1].to == contour->moves[i].from);
}

}  // namespace
}  // namespace dgt
