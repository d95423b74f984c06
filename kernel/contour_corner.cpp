// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners of the equidistant.
//
// Nouns. A *corner* is a joint of two legs along elements that do not go on in one direction there.
// The tool runs on its *outer* side when the contour turns away from it: there the offset elements
// end apart, each beside the programmed corner, and something has to join them. On the inner side
// they cross before they get there.
//
// A corner where a circle is met is a point over a root; arcs about it and lines across it are made
// about a rational stand-in, which lies on a line of the corner exactly and within 2⁻¹⁶⁰ mm of the
// corner itself.
#include <cmath>

#include "kernel/construct_bounds.h"
#include "kernel/contour_path.h"
#include "kernel/place_order.h"

namespace dgt {
namespace {

Rational squared(const Rational& value) { return value * value; }

int sense_of(const Circle& circle) { return sgn(circle.radius()); }

/// The sign of the cross product of the directions of two elements where they meet, at `p`.
/// Directions on a circle are turned_left(p − centre), in the sense of its radius.
int turn_between(const Element& a, const Element& b, const Point& p) {
  const auto* line_a = std::get_if<Line>(&a);
  const auto* line_b = std::get_if<Line>(&b);
  if (line_a && line_b)
    return sgn(cross(line_a->direction().vector(), line_b->direction().vector()));
  if (line_a || line_b) {
    // d × turned_left(p − c) = d·(p − c)
    const Vector d = (line_a ? line_a : line_b)->direction().vector();
    const Circle& circle = std::get<Circle>(line_a ? b : a);
    const int turn = sense_of(circle) * order_along(d, dot(d, circle.centre()), p);
    return line_a ? turn : -turn;
  }
  const auto& first = std::get<Circle>(a);
  const auto& second = std::get<Circle>(b);
  // (p − c₁) × (p − c₂) = (p − c₁) × (c₁ − c₂)
  return sense_of(first) * sense_of(second) *
         turn_about(first.centre(), p, first.centre() - second.centre());
}

/// In contact, whether they run against each other there. Precondition: at least one is a circle.
bool is_cusp(const Element& a, const Element& b, const Point& p) {
  const auto* line = std::get_if<Line>(&a);
  if (!line) line = std::get_if<Line>(&b);
  if (line) {
    const auto& circle = std::get<Circle>(std::holds_alternative<Circle>(a) ? a : b);
    return sense_of(circle) * turn_about(circle.centre(), p, line->direction().vector()) < 0;
  }
  const auto& first = std::get<Circle>(a);
  const auto& second = std::get<Circle>(b);
  // 2 (p − c₁)·(p − c₂) = r₁² + r₂² − |c₁ − c₂|²
  const Rational dot = squared(first.radius()) + squared(second.radius()) -
                       squared_length(first.centre() - second.centre());
  return sense_of(first) * sense_of(second) * sgn(dot) < 0;
}

Rational curvature(const Element& e) {
  const auto* circle = std::get_if<Circle>(&e);
  return circle ? Rational(1 / circle->radius()) : Rational(0);
}

int sense_of_corner(const Element& a, const Element& b, const Point& p) {
  const int turn = turn_between(a, b, p);
  if (turn != 0) return turn;
  const bool lines = std::holds_alternative<Line>(a) && std::holds_alternative<Line>(b);
  if (lines || !is_cusp(a, b, p)) return 0;
  // Half a turn: back on the left of where it came from when that bends away to the right of it.
  return -sgn(Rational(curvature(a) + curvature(b)));
}

/// +1: the leg runs along its element, −1: against it, 0: nowhere.
int way_of(const Leg& leg, const ContourLegs& legs) {
  const auto* line = std::get_if<Line>(leg.element.element.get());
  if (!line) return 1;
  return motion_along(*line, legs.joints[leg.from].programmed, legs.joints[leg.to].programmed);
}

std::optional<Turn> turn_of(const ContourLegs& legs, const Leg& in, const Leg& out) {
  const Joint& joint = legs.joints[in.to];
  if (!std::holds_alternative<CrossJoint>(joint.rule) || in.rapid || out.rapid) return std::nullopt;
  // Where U changes the offset no arc about the corner fits both.
  if (legs.steps[in.element.step] != legs.steps[out.element.step]) return std::nullopt;
  const int way = way_of(in, legs);
  if (way == 0 || way != way_of(out, legs)) return std::nullopt;  // the tool changes its side
  return Turn{sense_of_corner(*in.element.element, *out.element.element, joint.programmed), way};
}

bool same_crossing(const Joint& a, const Joint& b) {
  const auto* first = std::get_if<CrossJoint>(&a.rule);
  const auto* second = std::get_if<CrossJoint>(&b.rule);
  return first && second && *first->a.element == *second->a.element &&
         *first->b.element == *second->b.element && a.programmed == b.programmed;
}

void mark_closing_corner(ContourLegs& legs, const Leg& first, const Leg& last) {
  Joint& begin = legs.joints[first.from];
  Joint& end = legs.joints[last.to];
  if (&first == &last || !same_crossing(begin, end)) return;
  const auto& rule = std::get<CrossJoint>(end.rule);
  if (*rule.a.element != *last.element.element || *rule.b.element != *first.element.element) return;
  const auto turn = turn_of(legs, last, first);
  if (!turn) return;
  end.turn = *turn;
  begin.turn = *turn;
  begin.turn.begins = true;
}

/// A corner with its elements moved.
struct MovedCorner {
  Carrier on_a, on_b;
  Element a, b;
  RationalPoint at;
  Rational reach;  ///< |shift|
  Rational shift;
  int side;  ///< +1: the tool runs left of its way, −1: right

  MovedCorner(const Joint& joint, const Shifts& shifts)
      : on_a(moved(std::get<CrossJoint>(joint.rule).a, shifts)),
        on_b(moved(std::get<CrossJoint>(joint.rule).b, shifts)),
        a(on_a.element()),
        b(on_b.element()),
        at(rational_near(joint.programmed)),
        reach(abs(*on_a.shift)),
        shift(*on_a.shift),
        side(sgn(*on_a.shift) * joint.turn.way) {
    if (const auto* line = std::get_if<Line>(on_a.base.get()))
      at = line->foot(at);
    else if (const auto* other = std::get_if<Line>(on_b.base.get()))
      at = other->foot(at);
  }

  /// Where the offset elements end beside the corner.
  [[nodiscard]] RationalPoint begin() const { return contact(Circle(at, -shift), a); }
  [[nodiscard]] RationalPoint end() const { return contact(Circle(at, -shift), b); }

 private:
  static Carrier moved(const UsedElement& used, const Shifts& shifts) {
    return {used.element, shifts[used.step]};
  }
};

CornerPath arc_about(const MovedCorner& corner) {
  const Circle circle(corner.at, -corner.side * corner.reach);
  return {Point(corner.begin()), Point(corner.end()), carrier(circle)};
}

/// Square to the bisector of the corner, `reach` away from it, run as the tool runs.
Line line_across(const MovedCorner& corner, const Rational& reach) {
  const Vector from = corner.begin() - corner.at;
  const Vector to = corner.end() - corner.at;
  const Vector sum = from + to;
  // Of a sharp corner the normals all but cancel; its travel there and back does not.
  const Vector there = corner.side > 0 ? turned_right(from - to) : turned_left(from - to);
  const UnitVector outward = direction_of(sgn(dot(from, to)) >= 0 ? sum : there).unit;
  const Line line(outward, dot(outward.vector(), corner.at) + reach);
  return corner.side > 0 ? line : line.reversed();
}

/// Where the tool, on its way along the offset element, crosses `across` to the outer side (or back
/// from there). Nothing where a circle does not reach it.
std::optional<Point> crossing_of(const Carrier& on, const Carrier& across, int side,
                                 bool to_outside) {
  const Meeting meeting = meet(across, on);
  if (const auto* one = std::get_if<OnePoint>(&meeting))
    return one->contact ? std::nullopt : std::optional(one->at);
  const auto* two = std::get_if<TwoPoints>(&meeting);
  if (!two) return std::nullopt;
  // A counter-clockwise circle comes to the left of a line where the line leaves its disc.
  const bool ccw = std::get<Circle>(*on.base).counter_clockwise();
  const bool to_left = to_outside == (side > 0);
  return two->at(ccw == to_left ? Which::Exit : Which::Entry);
}

/// Less than half a turn of an arc, or any way along a line. The arcs in question are far from half
/// a turn, or the corner is rounded instead.
bool is_short_way(const Element& on, const Point& from, const Point& to) {
  const auto* circle = std::get_if<Circle>(&on);
  return !circle || std::fabs(coarse_sweep(*circle, from, to)) < 180;
}

std::optional<CornerPath> cut_across(const MovedCorner& corner, const Rational& reach) {
  const Line line = line_across(corner, reach);
  const Carrier across = carrier(line);
  const auto begin = crossing_of(corner.on_a, across, corner.side, true);
  const auto end = crossing_of(corner.on_b, across, corner.side, false);
  if (!begin || !end || order_along(line.direction().vector(), *begin, *end) <= 0)
    return std::nullopt;
  const bool reached = is_short_way(corner.a, Point(corner.begin()), *begin) &&
                       is_short_way(corner.b, *end, Point(corner.end()));
  if (!reached) return std::nullopt;
  return CornerPath{*begin, *end, across};
}

}  // namespace

void mark_corners(ContourLegs& legs) {
  const Leg* before = nullptr;
  const Leg* first = nullptr;
  for (const Leg& leg : legs.legs) {
    if (leg.travel != Leg::Travel::Along) continue;
    if (!first) first = &leg;
    if (before && before->to == leg.from) {
      if (const auto turn = turn_of(legs, *before, leg)) legs.joints[leg.from].turn = *turn;
    }
    before = &leg;
  }
  if (first) mark_closing_corner(legs, *first, *before);
}

bool is_outer_corner(const Joint& joint, const Shifts& shifts) {
  if (joint.turn.sense == 0) return false;
  const RationalPtr& shift = shifts[std::get<CrossJoint>(joint.rule).a.step];
  return shift && sgn(*shift) * joint.turn.way == -joint.turn.sense;
}

bool is_long_corner(const Joint& corner, const Shifts& shifts, const Point& extended,
                    const ContourOptions& options) {
  const Rational& shift = *shifts[std::get<CrossJoint>(corner.rule).a.step];
  return compare_distance(extended, corner.programmed, squared(options.corner_limit * shift)) > 0;
}

std::optional<CornerPath> path_round(const Joint& corner, const Shifts& shifts,
                                     const std::optional<Point>& extended,
                                     const ContourOptions& options) {
  if (options.corner == CornerStyle::Extend) return std::nullopt;
  const bool cuts = options.corner == CornerStyle::Chamfer;
  if (cuts && extended && !is_long_corner(corner, shifts, *extended, options)) return std::nullopt;
  const MovedCorner moved(corner, shifts);
  if (cuts) {
    if (auto cut = cut_across(moved, options.corner_limit * moved.reach)) return cut;
  }
  CornerPath arc = arc_about(moved);
  if (extended && indistinct(arc.begin, arc.end)) return std::nullopt;
  return arc;
}

}  // namespace dgt
