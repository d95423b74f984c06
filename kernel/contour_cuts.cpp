// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts to legs. Their ends lie within 2⁻⁹⁶ mm of their elements, which are rational stand-ins; a
// joint is the crossing nearest to the programmed point, or, where the elements go on in one
// direction, the foot of that point on the next.
#include <cmath>
#include <memory>
#include <utility>

#include "kernel/check.h"
#include "kernel/construct_bounds.h"
#include "kernel/contour_path.h"

namespace dgt {
namespace {

RationalPoint rational(const Point& p) {
  const ExactPoint exact = p.exact();
  DGT_CHECK(exact.is_rational());
  return {exact.x.a, exact.y.a};
}

ElementPtr line_of(const Move& move) {
  const RationalPoint from = rational(move.from);
  const UnitVector normal = turned_left(direction_of(rational(move.to) - from).unit);
  return ElementPtr(Line::through(from, normal));
}

/// Whether `b` goes on in the direction in which `a` ends, to within the contact resolution.
bool goes_on(const Element& a, const Element& b) {
  const auto* line_a = std::get_if<Line>(&a);
  const auto* line_b = std::get_if<Line>(&b);
  if (line_a && line_b) {
    const Vector& n = line_a->normal().vector();
    const Vector& m = line_b->normal().vector();
    return is_contact(cross(n, m)) && sgn(dot(n, m)) > 0;
  }
  if (line_a || line_b) {
    const Line& line = line_a ? *line_a : *line_b;
    const auto& circle = std::get<Circle>(line_a ? b : a);
    return is_contact(line.distance_to_left(circle.centre()) - circle.radius());
  }
  const auto& first = std::get<Circle>(a);
  const auto& second = std::get<Circle>(b);
  if (first.centre() == second.centre()) return is_contact(first.radius() - second.radius());
  return in_oriented_contact(first, second);
}

double distance_between(const Point& a, const Point& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// Which of two crossings is the programmed joint. They lie as far apart as rounding in the program
/// made them, or the joint is both.
Which nearest_crossing(const Element& a, const Element& b, const Point& at) {
  const Meeting meeting = meet(a, b);
  const auto* two = std::get_if<TwoPoints>(&meeting);
  if (!two) return Which::Entry;
  const double entry = distance_between(two->at(Which::Entry), at);
  const double exit = distance_between(two->at(Which::Exit), at);
  return exit < entry ? Which::Exit : Which::Entry;
}

class CutLayout {
 public:
  CutLayout(const std::vector<Move>& cuts, const Rational& distance) : cuts_(cuts) {
    legs_.steps.front() = distance;
  }

  ContourLegs run() {
    for (std::size_t i = 0; i < cuts_.size(); ++i) take(i);
    DGT_CHECK(last_ != nullptr);
    close();
    for (std::size_t i = 0; i < legs_.legs.size(); ++i) {
      Leg& leg = legs_.legs[i];
      if (leg.travel == Leg::Travel::Stop && leg.from == kBeforeFirst) leg.from = leg.to = 0;
    }
    return std::move(legs_);
  }

 private:
  static constexpr std::size_t kBeforeFirst = static_cast<std::size_t>(-1);

  void take(std::size_t i) {
    const Move& move = cuts_[i];
    if (!move.travels() || (!move.full_circle && indistinct(move.from, move.to))) {
      if (!move.travels() || move.z) stop(move);
      return;
    }
    if (move.kind == MoveKind::Line) return along(move, {line_of(move), 0, i}, move.to, move.z);
    const UsedElement circle{move.carrier.base, 0, i};
    if (move.full_circle) {
      const RationalPoint centre = move.circle().centre();
      along(move, circle, Point(2 * centre - rational(move.from)), nullptr);
    }
    along(move, circle, move.to, move.z);
  }

  void stop(const Move& move) {
    Leg& leg = legs_.legs.emplace_back();
    leg.travel = Leg::Travel::Stop;
    leg.from = leg.to = legs_.joints.empty() ? kBeforeFirst : legs_.joints.size() - 1;
    leg.z = move.z;
    leg.feed = move.feed;
    leg.seconds = move.seconds;
    leg.code = move.code;
    leg.place = move.source;
  }

  void along(const Move& move, const UsedElement& element, const Point& to, RationalPtr z) {
    if (last_ == nullptr) {
      legs_.first_element = element;
      legs_.tool_before = move.from;
      legs_.joints.push_back({FootJoint{move.from, element}, move.from});
    } else {
      legs_.joints.back() =
          joint(legs_.legs[last_leg_].element, element, legs_.joints.back().programmed);
    }
    legs_.joints.push_back({FootJoint{to, element}, to});
    last_leg_ = legs_.legs.size();
    Leg& leg = legs_.legs.emplace_back();
    leg.travel = Leg::Travel::Along;
    leg.role = move.role;
    leg.element = element;
    leg.from = legs_.joints.size() - 2;
    leg.to = legs_.joints.size() - 1;
    leg.z = std::move(z);
    leg.feed = move.feed;
    leg.place = move.source;
    last_ = &move;
  }

  static Joint joint(const UsedElement& a, const UsedElement& b, const Point& at) {
    if (goes_on(*a.element, *b.element)) return {FootJoint{at, b}, at};
    return {CrossJoint{a, b, nearest_crossing(*a.element, *b.element, at)}, at};
  }

  void close() {
    Joint& begin = legs_.joints.front();
    Joint& end = legs_.joints.back();
    if (legs_.joints.size() < 3 || !indistinct(begin.programmed, end.programmed)) return;
    const UsedElement& first = *legs_.first_element;
    const UsedElement& last = legs_.legs[last_leg_].element;
    if (goes_on(*last.element, *first.element)) return;            // both ends move alike
    if (goes_on(*last.element, reversed(*first.element))) return;  // out by the way it came in
    const Point at = begin.programmed;
    begin = joint(last, first, at);
    end = begin;
  }

  const std::vector<Move>& cuts_;
  ContourLegs legs_;
  const Move* last_ = nullptr;
  std::size_t last_leg_ = 0;
};

}  // namespace

BuiltContour build_equidistant(const std::vector<Move>& cuts, const Rational& distance, Side side,
                               const ContourOptions& options) {
  DGT_CHECK(sgn(distance) > 0 && side != Side::None);
  ContourLegs legs = CutLayout(cuts, distance).run();
  mark_corners(legs);
  BuiltContour out;
  out.offset = distance;
  out.side = side;
  ToolState state;
  run_legs(legs, side == Side::Left ? 1 : -1, options, out, state);
  return out;
}

}  // namespace dgt
