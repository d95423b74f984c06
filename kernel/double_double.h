// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

/// Numbers of two doubles, some 106 bits: the second stage of decisions that doubles leave open.
namespace dgt {

/// hi + lo with |lo| ≤ ulp(hi)/2.
///
/// With u = 2⁻⁵³ the relative errors are at most 3u² + 13u³ for sums, 5u² for products, 10u² for
/// quotients and 4u² for roots (Joldes, Muller, Popescu, *Tight and rigorous error bounds for basic
/// building blocks of double-word arithmetic*, 2017; Lefèvre, Louvet, Muller, Picot, Rideau,
/// *Accurate calculation of Euclidean norms using double-word arithmetic*, 2023), as long as
/// nothing overflows or underflows. kRoundoff is above them all.
struct DoubleDouble {
  double hi = 0;
  double lo = 0;

  DoubleDouble() = default;
  constexpr DoubleDouble(double value) : hi(value) {}  // NOLINT: every double is one
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}

  static constexpr double kRoundoff = 0x1p-102;

  /// a + b, the error kept: exact (Knuth).
  static DoubleDouble sum(double a, double b) {
    const double s = a + b;
    const double t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  /// The same for |a| ≥ |b| (Dekker).
  static DoubleDouble ordered_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static DoubleDouble product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }

  friend DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }
  friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble s = sum(a.hi, b.hi);
    const DoubleDouble t = sum(a.lo, b.lo);
    const DoubleDouble v = ordered_sum(s.hi, s.lo + t.hi);
    return ordered_sum(v.hi, t.lo + v.lo);
  }
  friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }
  friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = product(a.hi, b.hi);
    return ordered_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
  }
  friend DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.hi / b.hi;
    const DoubleDouble rest = a - b * first;
    const double second = rest.hi / b.hi;
    const DoubleDouble last = rest - b * second;
    return ordered_sum(first, second) + DoubleDouble(last.hi / b.hi);
  }
};

[[nodiscard]] inline DoubleDouble root(DoubleDouble a) {
  if (a.hi <= 0) return {};
  const double first = std::sqrt(a.hi);
  const DoubleDouble rest = a - DoubleDouble::product(first, first);
  return DoubleDouble::ordered_sum(first, rest.hi / (2 * first));
}
[[nodiscard]] inline double root(double a) { return std::sqrt(a); }

[[nodiscard]] inline double coarse(DoubleDouble a) { return a.hi; }
[[nodiscard]] inline double coarse(double a) { return a; }

}  // namespace dgt
