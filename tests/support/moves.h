// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "kernel/toolpath.h"

/// Moves put down by hand, for tests of what reads a tool path.
namespace dgt::support {

[[nodiscard]] inline Point at(const Rational& x, const Rational& y) {
  return Point(RationalPoint{x, y});
}

[[nodiscard]] inline Move straight(MoveKind kind, const Point& from, const Point& to) {
  Move move;
  move.kind = kind;
  move.from = from;
  move.to = to;
  return move;
}
[[nodiscard]] inline Move line(const Point& from, const Point& to) {
  return straight(MoveKind::Line, from, to);
}
[[nodiscard]] inline Move rapid(const Point& from, const Point& to) {
  return straight(MoveKind::Rapid, from, to);
}

/// Both ends must lie on the circle; a negative radius runs clockwise.
[[nodiscard]] inline Move arc(const RationalPoint& centre, const Rational& radius,
                              const Point& from, const Point& to) {
  Move move = straight(MoveKind::Arc, from, to);
  move.carrier.base = ElementPtr(Circle(centre, radius));
  return move;
}
[[nodiscard]] inline Move full_circle(const RationalPoint& centre, const Rational& radius,
                                      const Point& from) {
  Move move = arc(centre, radius, from, from);
  move.full_circle = true;
  return move;
}

}  // namespace dgt::support
