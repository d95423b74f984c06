// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/check.h"
#include "kernel/point.h"

namespace dgt {

/// A vector of length 1, exactly: x² + y² = 1 in rationals.
class UnitVector {
 public:
  UnitVector() : v_{1, 0} {}
  /// Precondition (checked): v has length 1.
  explicit UnitVector(Vector v) : v_(std::move(v)) { DGT_CHECK(squared_length(v_) == 1); }

  /// The unit vector of the angle 2·arctan(t): ((1−t²)/(1+t²), 2t/(1+t²)).
  [[nodiscard]] static UnitVector from_half_tangent(const Rational& t);

  [[nodiscard]] const Rational& x() const { return v_.x; }
  [[nodiscard]] const Rational& y() const { return v_.y; }
  [[nodiscard]] const Vector& vector() const { return v_; }

  friend UnitVector operator-(const UnitVector& a) { return unchecked({-a.v_.x, -a.v_.y}); }
  friend UnitVector turned_left(const UnitVector& a) { return unchecked({-a.v_.y, a.v_.x}); }
  friend UnitVector turned_right(const UnitVector& a) { return unchecked({a.v_.y, -a.v_.x}); }
  /// The sum of the two angles.
  friend UnitVector rotated(const UnitVector& a, const UnitVector& by) {
    return unchecked({a.v_.x * by.v_.x - a.v_.y * by.v_.y, a.v_.x * by.v_.y + a.v_.y * by.v_.x});
  }
  friend bool operator==(const UnitVector&, const UnitVector&) = default;

 private:
  static UnitVector unchecked(Vector v) {
    UnitVector u;
    u.v_ = std::move(v);
    return u;
  }
  Vector v_;
};

/// An oriented line: the points with n·x = p, where the rational unit vector n points to the left
/// of the direction of travel. Offsetting is exact and keeps the direction.
class Line {
 public:
  Line(UnitVector normal, Rational p) : normal_(std::move(normal)), p_(std::move(p)) {}

  /// The line through `point` with the left normal `normal`.
  [[nodiscard]] static Line through(const RationalPoint& point, UnitVector normal) {
    Rational p = dot(normal.vector(), point);
    return {std::move(normal), std::move(p)};
  }

  [[nodiscard]] const UnitVector& normal() const { return normal_; }
  [[nodiscard]] const Rational& p() const { return p_; }
  [[nodiscard]] UnitVector direction() const { return turned_right(normal_); }

  [[nodiscard]] Line reversed() const { return {-normal_, -p_}; }
  /// Moved to the left by `distance` mm (to the right when negative).
  [[nodiscard]] Line offset(const Rational& distance) const { return {normal_, p_ + distance}; }

  /// How far `q` lies to the left of the line, in mm.
  [[nodiscard]] Rational distance_to_left(const RationalPoint& q) const {
    return dot(normal_.vector(), q) - p_;
  }
  /// The foot of the perpendicular from `q`.
  [[nodiscard]] RationalPoint foot(const RationalPoint& q) const {
    return q - distance_to_left(q) * normal_.vector();
  }

  friend bool operator==(const Line&, const Line&) = default;

 private:
  UnitVector normal_;
  Rational p_;
};

}  // namespace dgt
