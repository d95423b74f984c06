// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <variant>

#include "kernel/circle.h"
#include "kernel/line.h"

namespace dgt {

/// What contours run along.
using Element = std::variant<Line, Circle>;
using ElementPtr = std::shared_ptr<const Element>;

[[nodiscard]] Element reversed(const Element& e);
[[nodiscard]] Element offset(const Element& e, const Rational& distance);

/// −1 right of the element's direction, 0 on it, +1 left of it; exactly.
[[nodiscard]] int side_of(const Element& e, const ExactPoint& q);
/// The distance from `q` to the element, in mm, for messages: correctly rounded for lines, within a
/// few units in the last place for circles.
[[nodiscard]] double distance_to(const Element& e, const ExactPoint& q);

/// An element moved sideways by an exact distance: what a cut runs on. The offset element is made
/// when asked for, since most of a program's decisions need its filter values alone.
struct Carrier {
  ElementPtr base;
  std::shared_ptr<const Rational> shift;  ///< to the left, in mm; null for 0

  [[nodiscard]] Element element() const { return shift ? offset(*base, *shift) : *base; }
  [[nodiscard]] bool is_line() const { return std::holds_alternative<Line>(*base); }
};

}  // namespace dgt
