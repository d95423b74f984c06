// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of the corners that the equidistant puts in.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>

#include "kernel/contour.h"
#include "kernel/stretch.h"
#include "tests/support/geometry_generators.h"

namespace dgt {
namespace {

/// Where a rational stand-in of a corner lies beside it, with room.
Rational stand_in_error() { return power_of_two(-140); }

Element crossing(const Element& a) {
  if (std::holds_alternative<Line>(a) && *rc::gen::arbitrary<bool>()) return test::any_line();
  return std::visit([](const auto& x) { return Element(test::circle_crossing(x)); }, a);
}

struct Built {
  BuiltContour contour;
  Rational offset;
};

bool has_corner(const BuiltContour& built) {
  return built.faults.empty() && std::any_of(built.moves.begin(), built.moves.end(),
                                             [](const Move& m) { return m.role == Role::Corner; });
}

/// Four elements that cross, cut along the two in the middle, with the tool on the outer side of
/// the corner between them.
std::optional<Built> any_contour(CornerStyle style, const Rational& limit) {
  std::vector<Element> elements{test::any_element()};
  for (int i = 0; i < 3; ++i) elements.push_back(crossing(elements.back()));
  const Rational offset = abs(test::nonzero_decimal(1)) / 10;
  std::vector<ContourItem> items;
  const auto add = [&](auto what) {
    items.push_back({std::move(what), {0, 1, static_cast<std::uint32_t>(items.size() + 1)}});
  };
  add(OffsetItem{offset, true});
  for (const Element& e : elements) add(AlongItem{ElementPtr(e)});
  ContourOptions options;
  options.corner = style;
  options.corner_limit = limit;
  options.gouge = GougePolicy::Warn;
  for (const OffsetSide side : {OffsetSide::Left, OffsetSide::Right}) {
    options.offset_side = side;
    ToolState state;
    Built built{build_contour(items, state, options), offset};
    if (has_corner(built.contour)) return built;
  }
  return std::nullopt;
}

/// The corner put in, the programmed stretches before and behind it, and the corner itself.
struct PutIn {
  Move move;
  Move before, behind;
};
PutIn corner_of(const BuiltContour& built) {
  const auto is_corner = [](const Move& m) { return m.role == Role::Corner; };
  const auto corner = std::find_if(built.moves.begin(), built.moves.end(), is_corner);
  RC_PRE(corner != built.moves.end());
  for (std::size_t i = 1; i < built.programmed.size(); ++i)
    if (built.programmed[i].source == corner->source)
      return {*corner, built.programmed[i - 1], built.programmed[i]};
  RC_PRE(false);
  return {};
}

RC_GTEST_PROP(RoundCorner, IsAnArcOfTheOffsetAboutTheProgrammedCorner, ()) {
  const auto built = any_contour(CornerStyle::Round, 4);
  RC_CLASSIFY(built.has_value(), "with a corner");
  if (!built) return;
  const PutIn corner = corner_of(built->contour);
  const Circle circle = corner.move.circle();
  RC_ASSERT(abs(circle.radius()) == built->offset);
  // Neither nearer nor farther than the offset anywhere: its centre is the corner.
  RC_ASSERT(compare_distance(corner.before.to, circle.centre(),
                             stand_in_error() * stand_in_error()) <= 0);
  const bool lines = corner.before.kind == MoveKind::Line && corner.behind.kind == MoveKind::Line;
  RC_CLASSIFY(lines, "between lines");
  if (lines) RC_ASSERT(Point(circle.centre()) == corner.before.to);
}

RC_GTEST_PROP(RoundCorner, GoesOnFromTheElementsInTheirDirections, ()) {
  const auto built = any_contour(CornerStyle::Round, 4);
  RC_CLASSIFY(built.has_value(), "with a corner");
  if (!built) return;
  const auto& moves = built->contour.moves;
  for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
    if (moves[i].role != Role::Corner) continue;
    for (const Move* beside : {&moves[i - 1], &moves[i + 1]}) {
      const Meeting meeting = meet(beside->carrier, moves[i].carrier);
      const auto* one = std::get_if<OnePoint>(&meeting);
      RC_ASSERT(one != nullptr);
      RC_ASSERT(one->contact);
    }
    RC_ASSERT(half_turn_order(moves[i]) <= 0);
  }
}

// Arcs are left to the gouge check: one that bends away from the tool may come nearer to it behind
// the corner.
RC_GTEST_PROP(Corner, PutInKeepsTheOffsetFromTheLinesItJoins, ()) {
  const Rational limit = 1 + abs(test::any_decimal(1)) / 10;
  const CornerStyle style = *rc::gen::element(CornerStyle::Round, CornerStyle::Chamfer);
  const auto built = any_contour(style, limit);
  RC_CLASSIFY(built.has_value(), "with a corner");
  if (!built) return;
  const PutIn corner = corner_of(built->contour);
  const bool lines = corner.before.kind == MoveKind::Line && corner.behind.kind == MoveKind::Line;
  const Rational kept = lines ? built->offset : Rational(built->offset - stand_in_error());
  RC_CLASSIFY(lines, "between lines");
  for (const Move* side : {&corner.before, &corner.behind}) {
    if (side->kind == MoveKind::Line)
      RC_ASSERT(!comes_nearer(stretch_of(corner.move), stretch_of(*side), kept));
  }
}

RC_GTEST_PROP(ChamferCorner, LiesExactlyTheLimitAwayFromTheCorner, ()) {
  const Rational limit = 1 + abs(test::any_decimal(1)) / 10;
  const auto built = any_contour(CornerStyle::Chamfer, limit);
  RC_CLASSIFY(built.has_value(), "with a corner");
  if (!built) return;
  const PutIn corner = corner_of(built->contour);
  if (corner.move.kind == MoveKind::Arc) return;  // where a circle does not reach the limit
  const Line line = std::get<Line>(corner.move.carrier.element());
  const Vector& n = line.normal().vector();
  const Rational reach = limit * built->offset;
  const Rational slack = stand_in_error();
  const Point& at = corner.before.to;
  const bool left = order_along(n, line.p() - reach - slack, at) > 0 &&
                    order_along(n, line.p() - reach + slack, at) < 0;
  const bool right = order_along(n, line.p() + reach - slack, at) > 0 &&
                     order_along(n, line.p() + reach + slack, at) < 0;
  RC_ASSERT(left || right);
}

}  // namespace
}  // namespace dgt
