// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "kernel/construct.h"
#include "kernel/construct_bounds.h"

namespace dgt {

KnownPoint known_point(const RationalPoint& p) {
  KnownPoint result{ExactPoint(p), p, 0};
  cap_height(result);
  return result;
}

KnownPoint known_point(const ExactPoint& p) {
  if (p.is_rational()) return known_point(RationalPoint{p.x.a, p.y.a});
  constexpr int exponent = -(kStandInBits + 32);
  const auto stand_in = [](const OneRoot& c) {
    return c.is_rational() ? c.a : on_dyadic_grid(rational_within(c, exponent - 1), exponent);
  };
  KnownPoint result{p, {stand_in(p.x), stand_in(p.y)}, std::ldexp(2.0, exponent)};
  cap_height(result);
  return result;
}

Constructed<KnownPoint> point_polar(const KnownPoint& point, const Rational& distance,
                                    const Rational& degrees, int bits) {
  const Direction along = direction_of(degrees, bits);
  KnownPoint p = known_point(point.stand_in + distance * along.unit.vector());
  return {p, along.bound == 0 ? p.bound : p.bound + along.bound * upper_bound(distance), 0};
}

Construction<KnownPoint> meeting_point(const Element& a, const Element& b, Selector selector) {
  const Meeting meeting = meet(a, b);
  if (const auto* apart = std::get_if<Apart>(&meeting)) {
    const bool lines = std::holds_alternative<Line>(a) && std::holds_alternative<Line>(b);
    return Impossible{lines ? Impossible::Why::ParallelLines : Impossible::Why::NoMeeting,
                      nearest_double(apart->gap)};
  }
  if (std::holds_alternative<Coincident>(meeting))
    return Impossible{Impossible::Why::SameElement, 0};
  const auto made = [](const Point& at) {
    KnownPoint p = known_point(at.exact());
    const double bound = p.bound;
    return Constructed<KnownPoint>{std::move(p), bound, 0};
  };
  if (const auto* one = std::get_if<OnePoint>(&meeting)) {
    if (!one->contact && selector != Selector::Default)
      return Impossible{Impossible::Why::NoChoice, 0};
    return made(one->at);
  }
  const auto& two = std::get<TwoPoints>(meeting);
  const auto which = choose(two, Which::Entry, selector);
  if (const auto* no = std::get_if<Impossible>(&which)) return *no;
  return made(two.at(std::get<Which>(which)));
}

std::variant<Which, Impossible> choose(const TwoPoints& crossings, Which first, Selector selector) {
  if (selector == Selector::Default || selector == Selector::I1) return first;
  if (selector == Selector::I2) return other(first);
  const bool by_x = selector == Selector::GreaterX || selector == Selector::SmallerX;
  const bool greater = selector == Selector::GreaterX || selector == Selector::GreaterY;
  const Point entry = crossings.at(Which::Entry);
  const Point exit = crossings.at(Which::Exit);
  // Correct rounding is monotone: doubles that differ order the exact coordinates too.
  const double difference = by_x ? entry.x() - exit.x() : entry.y() - exit.y();
  int order = difference < 0 ? -1 : difference > 0 ? 1 : 0;
  if (order == 0) {
    const ExactPoint a = entry.exact();
    const ExactPoint b = exit.exact();
    order = by_x ? compare(a.x, b.x) : compare(a.y, b.y);
  }
  if (order == 0) return Impossible{Impossible::Why::EqualCandidates, 0};
  return (order > 0) == greater ? Which::Entry : Which::Exit;
}

RationalPoint contact(const Element& a, const Element& b) {
  if (const auto* line = std::get_if<Line>(&a)) {
    const auto& circle = std::get<Circle>(b);
    return circle.centre() - circle.radius() * line->normal().vector();
  }
  const auto& circle = std::get<Circle>(a);
  if (std::holds_alternative<Line>(b)) return contact(b, a);
  const auto& second = std::get<Circle>(b);
  DGT_CHECK(circle.radius() != second.radius());  // else they coincide
  return circle.centre() - (circle.radius() / (circle.radius() - second.radius())) *
                               (circle.centre() - second.centre());
}

RationalPoint placed(const RationalPoint& p, const Frame& frame) {
  const UnitVector& u = frame.rotation;
  return {frame.origin.x + u.x() * p.x - u.y() * p.y, frame.origin.y + u.y() * p.x + u.x() * p.y};
}

ExactPoint placed(const ExactPoint& p, const Frame& frame) {
  const UnitVector& u = frame.rotation;
  return {combine(u.x(), p.x, -u.y(), p.y, frame.origin.x),
          combine(u.y(), p.x, u.x(), p.y, frame.origin.y)};
}

Element placed(const Element& e, const Frame& frame) {
  if (const auto* line = std::get_if<Line>(&e)) {
    UnitVector normal = rotated(line->normal(), frame.rotation);
    Rational p = line->p();
    if (sgn(frame.origin.x) != 0 || sgn(frame.origin.y) != 0)
      p += dot(normal.vector(), frame.origin);
    return Line(std::move(normal), std::move(p));
  }
  const auto& circle = std::get<Circle>(e);
  return Circle(placed(circle.centre(), frame), circle.radius());
}

}  // namespace dgt
