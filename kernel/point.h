// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/number.h"

namespace dgt {

/// A point or vector with rational coordinates, in millimetres.
struct RationalPoint {
  Rational x;
  Rational y;

  friend bool operator==(const RationalPoint&, const RationalPoint&) = default;
};
using Vector = RationalPoint;

[[nodiscard]] inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline Vector operator-(const Vector& a) { return {-a.x, -a.y}; }
[[nodiscard]] inline Vector operator*(const Rational& k, const Vector& a) {
  return {k * a.x, k * a.y};
}
[[nodiscard]] inline Rational dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}
/// Positive when b lies counter-clockwise of a.
[[nodiscard]] inline Rational cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}
[[nodiscard]] inline Rational squared_length(const Vector& a) { return dot(a, a); }
/// A quarter turn counter-clockwise.
[[nodiscard]] inline Vector turned_left(const Vector& a) { return {-a.y, a.x}; }
/// A quarter turn clockwise.
[[nodiscard]] inline Vector turned_right(const Vector& a) { return {a.y, -a.x}; }

/// A point whose coordinates are one-root numbers: where lines and circles with rational data meet.
struct ExactPoint {
  OneRoot x;
  OneRoot y;

  ExactPoint() = default;
  ExactPoint(OneRoot x_, OneRoot y_) : x(std::move(x_)), y(std::move(y_)) {}
  explicit ExactPoint(const RationalPoint& p) : x(p.x), y(p.y) {}

  [[nodiscard]] bool is_rational() const { return x.is_rational() && y.is_rational(); }
};

/// Equal coordinates, exactly.
[[nodiscard]] inline bool same_place(const ExactPoint& a, const ExactPoint& b) {
  return compare(a.x, b.x) == 0 && compare(a.y, b.y) == 0;
}

}  // namespace dgt
