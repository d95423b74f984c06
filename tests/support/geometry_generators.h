// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <array>
#include <ostream>

#include "kernel/construct.h"

/// Operands for property tests: what a programmer writes (decimals of up to four digits after the
/// point) mixed with the families in which float geometry goes wrong. Each degenerate family is
/// made exactly, never by luck.
namespace dgt {

// Shown by RapidCheck when a property fails, in a form that can be pasted into a test.
inline void showValue(const RationalPoint& p, std::ostream& out) {
  out << "{" << p.x << ", " << p.y << "}";
}
inline void showValue(const Line& l, std::ostream& out) {
  out << "Line(UnitVector({" << l.normal().x() << ", " << l.normal().y() << "}), " << l.p() << ")";
}
inline void showValue(const Circle& c, std::ostream& out) {
  out << "Circle({" << c.centre().x << ", " << c.centre().y << "}, " << c.radius() << ")";
}

}  // namespace dgt

namespace dgt::test {

/// A decimal in [−limit, limit] with up to four digits after the point; whole numbers are likely.
inline Rational any_decimal(int limit = 500) {
  static constexpr std::array<int, 5> kScales = {1, 1, 10, 100, 10000};
  const int scale = kScales[*rc::gen::inRange<std::size_t>(0, kScales.size())];
  Rational value(*rc::gen::inRange(-limit * scale, limit * scale + 1), scale);
  value.canonicalize();
  return value;
}

inline Rational nonzero_decimal(int limit = 500) {
  const Rational value = any_decimal(limit);
  return sgn(value) == 0 ? Rational(1) : value;
}

/// A signed radius: ordinary, minute (down to 0.0001) or huge (up to 10⁶).
inline Rational any_radius() {
  const int kind = *rc::gen::inRange(0, 8);
  if (kind == 0) return nonzero_decimal(5) / 10000;
  if (kind == 1) return nonzero_decimal(1000) * 1000;
  return nonzero_decimal(100);
}

inline RationalPoint any_point(int limit = 500) { return {any_decimal(limit), any_decimal(limit)}; }

/// A unit vector from a Pythagorean triple, in any octant, or along an axis.
inline UnitVector pythagorean_unit() {
  static constexpr std::array<std::array<int, 3>, 7> kTriples = {
      {{1, 0, 1}, {3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}, {9, 40, 41}}};
  const auto& t = kTriples[*rc::gen::inRange<std::size_t>(0, kTriples.size())];
  Vector v{Rational(t[0], t[2]), Rational(t[1], t[2])};
  v.x.canonicalize();
  v.y.canonicalize();
  if (*rc::gen::arbitrary<bool>()) std::swap(v.x, v.y);
  if (*rc::gen::arbitrary<bool>()) v.x = -v.x;
  if (*rc::gen::arbitrary<bool>()) v.y = -v.y;
  return UnitVector(v);
}

/// An angle in degrees: a decimal, or a multiple of 15.
inline Rational any_angle() {
  if (*rc::gen::inRange(0, 3) == 0) return 15 * *rc::gen::inRange(-48, 49);
  return any_decimal(1000);
}

inline UnitVector any_unit() {
  return *rc::gen::arbitrary<bool>() ? pythagorean_unit() : direction_of(any_angle()).unit;
}

inline Line any_line() { return {any_unit(), any_decimal()}; }
inline Circle any_circle() { return {any_point(), any_radius()}; }
inline Element any_element() {
  return *rc::gen::arbitrary<bool>() ? Element(any_line()) : Element(any_circle());
}

/// 0 mostly, else a gap or overlap far below what a machine sees and far above the resolution.
inline Rational near_miss() {
  static const Rational kMiss = Rational(1) / 1000000000;
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return kMiss;
    case 1:
      return -kMiss;
    default:
      return 0;
  }
}

/// A circle in oriented contact with the given element, or 10⁻⁹ mm from it.
inline Circle circle_touching(const Circle& a) {
  const Rational r = any_radius();
  const Rational distance = a.radius() - r + near_miss();
  return {a.centre() - distance * pythagorean_unit().vector(), r};
}
inline Circle circle_touching(const Line& a) {
  const Rational r = any_radius();
  const Rational p = a.p() + r + near_miss();
  return {p * a.normal().vector() + any_decimal() * a.direction().vector(), r};
}

/// A second circle, often related to the first: apart by a rational distance, in contact,
/// concentric.
inline Circle circle_beside(const Circle& a) {
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return {a.centre() + any_decimal() * pythagorean_unit().vector(), any_radius()};
    case 1:
      return circle_touching(a);
    case 2:
      return circle_touching(a.reversed());
    case 3:
      return {a.centre(), any_radius()};
    default:
      return any_circle();
  }
}
inline Circle circle_beside(const Line& a) {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return circle_touching(a);
    case 1:
      return circle_touching(a.reversed());
    default:
      return any_circle();
  }
}
inline Element element_beside(const Element& a) {
  if (*rc::gen::inRange(0, 3) == 0) return any_line();
  return std::visit([](const auto& x) { return Element(circle_beside(x)); }, a);
}

/// Two circles that cross properly, of any size and sense.
inline Circle circle_crossing(const Circle& a) {
  const Rational r = any_radius();
  const Rational low = abs(abs(a.radius()) - abs(r));
  const Rational high = abs(a.radius()) + abs(r);
  const Rational distance = low + (high - low) * Rational(*rc::gen::inRange(1, 64)) / 64;
  return {a.centre() + distance * any_unit().vector(), r};
}
inline Circle circle_crossing(const Line& a) {
  const Rational r = any_radius();
  const Rational h = abs(r) * Rational(*rc::gen::inRange(-63, 64)) / 64;
  return {(a.p() + h) * a.normal().vector() + any_decimal() * a.direction().vector(), r};
}

}  // namespace dgt::test
