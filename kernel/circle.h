// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/check.h"
#include "kernel/point.h"

namespace dgt {

/// An oriented circle: rational centre, rational signed radius, positive when it runs
/// counter-clockwise. Its left side is the inside when counter-clockwise and the outside when
/// clockwise, so an offset to the left by w is the radius r − w for both.
class Circle {
 public:
  /// Precondition (checked): radius ≠ 0.
  Circle(RationalPoint centre, Rational radius)
      : centre_(std::move(centre)), radius_(std::move(radius)) {
    DGT_CHECK(sgn(radius_) != 0);
  }

  [[nodiscard]] const RationalPoint& centre() const { return centre_; }
  /// Signed, in mm.
  [[nodiscard]] const Rational& radius() const { return radius_; }
  [[nodiscard]] bool counter_clockwise() const { return sgn(radius_) > 0; }

  [[nodiscard]] Circle reversed() const { return {centre_, -radius_}; }
  /// Moved to the left by `distance` mm. Precondition (checked): the radius does not become 0; see
  /// `survives_offset`.
  [[nodiscard]] Circle offset(const Rational& distance) const {
    return {centre_, radius_ - distance};
  }
  /// False when the offset eats the circle: its radius reaches the resolution of 0 or turns over.
  [[nodiscard]] bool survives_offset(const Rational& distance) const {
    const Rational r = radius_ - distance;
    return sgn(r) == sgn(radius_) && abs(r) > power_of_two(kZeroExponent);
  }

  friend bool operator==(const Circle&, const Circle&) = default;

 private:
  RationalPoint centre_;
  Rational radius_;
};

}  // namespace dgt
