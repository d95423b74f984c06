// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "kernel/double_double.h"

/// Numbers and vectors that carry a bound of their error, in doubles or double-doubles: running
/// error analysis (Higham, *Accuracy and Stability of Numerical Algorithms*, §3.3). They are the
/// filters of the offset engine; Ball (number.h) is the same idea in long doubles.
///
/// Each operation adds the propagated radii, the rounding of its midpoint, and kTiny for what may
/// have underflowed. Radii are positive sums and products of at most a dozen roundings, which kUp
/// covers. Operands of the engine stay below kLargest, and nothing has a degree above six, so
/// nothing overflows.
namespace dgt {

template <class Real>
inline constexpr double kRoundoff = 0x1p-53;
template <>
inline constexpr double kRoundoff<DoubleDouble> = DoubleDouble::kRoundoff;

inline constexpr double kUp = 1 + 0x1p-48;
inline constexpr double kTiny = 0x1p-900;
inline constexpr double kLargest = 0x1p60;

/// A number within `rad` of `mid`.
template <class Real>
struct Enclosed {
  Real mid{};
  double rad = 0;

  /// −1 or +1 when certain, else 0. The factor covers the tail of a double-double.
  [[nodiscard]] int sign() const {
    const double m = coarse(mid) * (1 - 0x1p-51);
    return m > rad ? 1 : m < -rad ? -1 : 0;
  }
  [[nodiscard]] bool may_be_positive() const { return sign() >= 0; }
  [[nodiscard]] double size() const { return std::fabs(coarse(mid)); }

  friend Enclosed operator-(const Enclosed& a) { return {-a.mid, a.rad}; }
  friend Enclosed operator+(const Enclosed& a, const Enclosed& b) {
    const Real m = a.mid + b.mid;
    return {m, (a.rad + b.rad + kRoundoff<Real> * std::fabs(coarse(m))) * kUp};
  }
  friend Enclosed operator-(const Enclosed& a, const Enclosed& b) { return a + (-b); }
  friend Enclosed operator*(const Enclosed& a, const Enclosed& b) {
    const Real m = a.mid * b.mid;
    return {m, (a.size() * b.rad + b.size() * a.rad + a.rad * b.rad +
                kRoundoff<Real> * std::fabs(coarse(m))) *
                       kUp +
                   kTiny};
  }
};

/// a / b. Precondition: b.sign() ≠ 0. With q the quotient of the midpoints, |x/y − q| is at most
/// (rad a + |q| rad b) / |y|.
template <class Real>
[[nodiscard]] Enclosed<Real> operator/(const Enclosed<Real>& a, const Enclosed<Real>& b) {
  const Real m = a.mid / b.mid;
  const double q = std::fabs(coarse(m));
  const double least = b.size() * (1 - 0x1p-50) - b.rad;
  return {m, ((a.rad + q * b.rad) / least + kRoundoff<Real> * q) * kUp + kTiny};
}

/// √a. Precondition: a.sign() > 0. |√x − √m| = |x − m| / (√x + √m).
template <class Real>
[[nodiscard]] Enclosed<Real> root(const Enclosed<Real>& a) {
  const Real m = root(a.mid);
  const double r = coarse(m);
  return {m, (a.rad / r + kRoundoff<Real> * r) * kUp};
}

/// A vector whose components are each within `rad`.
template <class Real>
struct EnclosedVector {
  Real x{};
  Real y{};
  double rad = 0;

  [[nodiscard]] double size() const { return std::fabs(coarse(x)) + std::fabs(coarse(y)); }

  friend EnclosedVector operator-(const EnclosedVector& a) { return {-a.x, -a.y, a.rad}; }
  friend EnclosedVector operator+(const EnclosedVector& a, const EnclosedVector& b) {
    EnclosedVector s{a.x + b.x, a.y + b.y, 0};
    s.rad = (a.rad + b.rad + kRoundoff<Real> * s.size()) * kUp;
    return s;
  }
  friend EnclosedVector operator-(const EnclosedVector& a, const EnclosedVector& b) {
    return a + (-b);
  }
  friend EnclosedVector operator*(const Enclosed<Real>& k, const EnclosedVector& a) {
    EnclosedVector p{k.mid * a.x, k.mid * a.y, 0};
    p.rad =
        (k.size() * a.rad + a.size() * k.rad + k.rad * a.rad + kRoundoff<Real> * p.size()) * kUp +
        kTiny;
    return p;
  }
};

template <class Real>
[[nodiscard]] EnclosedVector<Real> turned_left(const EnclosedVector<Real>& a) {
  return {-a.y, a.x, a.rad};
}

/// For one rounding each of two products p, q and of their sum, the error is at most
/// (2u + u²)(|p| + |q|); propagated: |a| rad b + |b| rad a + 2 rad a rad b in the 1-norms.
template <class Real>
[[nodiscard]] double product_radius(const EnclosedVector<Real>& a, const EnclosedVector<Real>& b,
                                    double p, double q) {
  return (a.size() * b.rad + b.size() * a.rad + 2 * a.rad * b.rad +
          3 * kRoundoff<Real> * (std::fabs(p) + std::fabs(q))) *
             kUp +
         kTiny;
}
template <class Real>
[[nodiscard]] Enclosed<Real> dot(const EnclosedVector<Real>& a, const EnclosedVector<Real>& b) {
  const Real p = a.x * b.x;
  const Real q = a.y * b.y;
  return {p + q, product_radius(a, b, coarse(p), coarse(q))};
}
/// Positive when b lies counter-clockwise of a.
template <class Real>
[[nodiscard]] Enclosed<Real> cross(const EnclosedVector<Real>& a, const EnclosedVector<Real>& b) {
  const Real p = a.x * b.y;
  const Real q = a.y * b.x;
  return {p - q, product_radius(a, b, coarse(p), coarse(q))};
}

}  // namespace dgt
