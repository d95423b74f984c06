// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/element.h"

#include <cmath>

namespace dgt {
namespace {

/// n·q − p, positive to the left.
OneRoot signed_distance(const Line& line, const ExactPoint& q) {
  return combine(line.normal().x(), q.x, line.normal().y(), q.y, -line.p());
}

/// |q − c|² as a one-root number over the root of q.
OneRoot squared_distance(const RationalPoint& c, const ExactPoint& q) {
  const OneRoot dx = q.x - c.x;
  const OneRoot dy = q.y - c.y;
  const Rational& root = dx.is_rational() ? dy.c : dx.c;
  return {dx.a * dx.a + dy.a * dy.a + dx.b * dx.b * dx.c + dy.b * dy.b * dy.c,
          2 * (dx.a * dx.b + dy.a * dy.b), root};
}

}  // namespace

UnitVector UnitVector::from_half_tangent(const Rational& t) {
  const Rational square = t * t;
  const Rational scale = 1 / (1 + square);
  return unchecked({(1 - square) * scale, 2 * t * scale});
}

Element reversed(const Element& e) {
  return std::visit([](const auto& x) { return Element(x.reversed()); }, e);
}

Element offset(const Element& e, const Rational& distance) {
  return std::visit([&](const auto& x) { return Element(x.offset(distance)); }, e);
}

int side_of(const Element& e, const ExactPoint& q) {
  if (const auto* line = std::get_if<Line>(&e)) return sign(signed_distance(*line, q));
  const auto& circle = std::get<Circle>(e);
  const int outside =
      compare(squared_distance(circle.centre(), q), Rational(circle.radius() * circle.radius()));
  return circle.counter_clockwise() ? -outside : outside;
}

double distance_to(const Element& e, const ExactPoint& q) {
  if (const auto* line = std::get_if<Line>(&e))
    return std::fabs(nearest_double(signed_distance(*line, q)));
  const auto& circle = std::get<Circle>(e);
  const double from_centre = std::sqrt(nearest_double(squared_distance(circle.centre(), q)));
  return std::fabs(from_centre - std::fabs(nearest_double(circle.radius())));
}

}  // namespace dgt
