// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/meet.h"

/// Exact questions about places of a path: coordinates are one-root numbers, and two places seldom
/// have one root. Each is answered in balls around the correctly rounded coordinates first, and
/// where these cannot tell, in the exact numbers.
namespace dgt {

/// Encloses the exact coordinate that a correctly rounded double stands for.
[[nodiscard]] Ball around(double coordinate);

/// The sign of (a − c) × (b − c): +1 when b lies counter-clockwise of a as seen from c.
[[nodiscard]] int turn_about(const RationalPoint& c, const Point& a, const Point& b);
/// The sign of (a − c) × v.
[[nodiscard]] int turn_about(const RationalPoint& c, const Point& a, const Vector& v);
/// The sign of d·b − d·a: +1 when b lies further along d.
[[nodiscard]] int order_along(const Vector& d, const Point& a, const Point& b);
/// The sign of d·b − along.
[[nodiscard]] int order_along(const Vector& d, const Rational& along, const Point& b);
/// The sign of |a − b|² − square.
[[nodiscard]] int compare_distance(const Point& a, const Point& b, const Rational& square);
[[nodiscard]] int compare_distance(const Point& a, const RationalPoint& b, const Rational& square);

/// The same by the exact stage alone, for the tests that hold one against the other.
namespace stages {
[[nodiscard]] int exact_turn_about(const RationalPoint& c, const ExactPoint& a,
                                   const ExactPoint& b);
[[nodiscard]] int exact_compare_distance(const ExactPoint& a, const ExactPoint& b,
                                         const Rational& square);
}  // namespace stages

}  // namespace dgt
