// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <compare>
#include <optional>
#include <string>
#include <string_view>

/// The numbers of the kernel.
///
///  * Rational  exact, what every element is made of;
///  * OneRoot   a + b√c, what elements meet in;
///  * Ball      a midpoint and a radius that surely holds the number meant: the filter in front of
///              the exact types, about as dear as plain floating point.
namespace dgt {

using Rational = mpq_class;
using Integer = mpz_class;

/// Coordinates nearer to zero than this leave the program as 0. Rational stand-ins for irrational
/// elements are off by about 2⁻⁹⁶ of their size, so a coordinate whose ideal value is 0 comes out
/// as something around 10⁻²⁵ mm; no machine and no double of a part's size can tell 5·10⁻²⁰ mm
/// from nothing. Unit: mm.
inline constexpr int kZeroExponent = -64;

/// Two elements whose gap (or overlap) is at most 2⁻⁷⁰ mm are in contact. It lies far above the
/// 2⁻⁹⁶ of the stand-ins, and far below what can be seen: contacts taken for crossings this way
/// move along a circle of radius r by at most √(2r·2⁻⁷⁰), less than 10⁻⁹ mm up to r = 500 mm. Unit:
/// mm.
inline constexpr int kContactExponent = -70;

/// 2^exponent, exactly.
[[nodiscard]] Rational power_of_two(int exponent);

/// The value of a decimal such as `12`, `5.`, `.5`, `-0.25`, `+7`; nothing when `text` is none.
[[nodiscard]] std::optional<Rational> parse_decimal(std::string_view text);

/// The same with an exponent at most: `2e-5`, `1.5E+3`. Nothing, too, when the exponent is beyond
/// ±kMaxDecimalExponent, which no double reaches.
inline constexpr int kMaxDecimalExponent = 400;
[[nodiscard]] std::optional<Rational> parse_scientific(std::string_view text);

/// `value` with exactly `decimals` digits after the point, rounded to nearest, ties away from zero.
/// Never prints a negative zero.
[[nodiscard]] std::string to_decimal(const Rational& value, int decimals);

/// The shortest decimal that is exactly `value` when one of at most `max_decimals` digits exists,
/// else `value` rounded to `max_decimals` digits without trailing zeros.
[[nodiscard]] std::string to_short_decimal(const Rational& value, int max_decimals = 9);

/// The double nearest to `value` (ties to even).
[[nodiscard]] double nearest_double(const Rational& value);

/// The whole number nearest to `value`, ties away from zero.
[[nodiscard]] Integer nearest_integer(const Rational& value);

/// The square root, when it is rational.
[[nodiscard]] std::optional<Rational> exact_sqrt(const Rational& value);

/// A rational r with |r − √value| ≤ 2^exponent and r ≥ 0. Precondition: value ≥ 0.
[[nodiscard]] Rational sqrt_within(const Rational& value, int exponent);

/// The multiple of 2^exponent nearest to `value`.
[[nodiscard]] Rational on_dyadic_grid(const Rational& value, int exponent);

/// Bits of the larger of numerator and denominator.
[[nodiscard]] std::size_t height(const Rational& value);

/// A real number known to within a radius: |x − mid| ≤ rad.
///
/// The radius is kept by running error analysis: every operation adds the propagated radii and the
/// rounding error of its own midpoint, u = 2⁻⁶³ relative (one ulp of a 64-bit significand, taken
/// doubled so that the rounding of the radius itself is covered too). Where `long double` is wider
/// or narrower than that, only the speed changes: u comes from its own epsilon.
struct Ball {
  long double mid = 0;
  long double rad = 0;

  Ball() = default;
  Ball(long double m, long double r) : mid(m), rad(r) {}
  explicit Ball(const Rational& value);

  /// −1, 0 (only the exact zero) or +1 when certain.
  [[nodiscard]] std::optional<int> sign() const;
  /// The nearest double when the whole ball rounds to one; applies the rule of kZeroExponent.
  [[nodiscard]] std::optional<double> nearest_double() const;

  friend Ball operator+(const Ball& a, const Ball& b);
  friend Ball operator-(const Ball& a, const Ball& b);
  friend Ball operator*(const Ball& a, const Ball& b);
  friend Ball operator-(const Ball& a) { return {-a.mid, a.rad}; }
};

/// The quotient, unless the divisor may be zero.
[[nodiscard]] std::optional<Ball> divide(const Ball& a, const Ball& b);
/// The root, unless the operand may be negative.
[[nodiscard]] std::optional<Ball> sqrt(const Ball& a);

/// a + b√c with rational a, b, c and c ≥ 0.
struct OneRoot {
  Rational a;
  Rational b;
  Rational c;

  OneRoot() = default;
  OneRoot(Rational value) : a(std::move(value)) {}  // NOLINT: every rational is a one-root number
  OneRoot(Rational a_, Rational b_, Rational c_)
      : a(std::move(a_)), b(std::move(b_)), c(std::move(c_)) {}

  [[nodiscard]] bool is_rational() const { return sgn(b) == 0 || sgn(c) == 0; }
};

/// Sums with, and multiples by, a rational stay in the same field.
[[nodiscard]] OneRoot operator+(const OneRoot& x, const Rational& y);
[[nodiscard]] OneRoot operator-(const OneRoot& x, const Rational& y);
[[nodiscard]] OneRoot operator*(const OneRoot& x, const Rational& y);
[[nodiscard]] OneRoot operator-(const OneRoot& x);

/// k·x + l·y + m for numbers over the same root. Precondition: x.c == y.c or one is rational.
[[nodiscard]] OneRoot combine(const Rational& k, const OneRoot& x, const Rational& l,
                              const OneRoot& y, const Rational& m);

/// −1, 0, +1, exactly.
[[nodiscard]] int sign(const OneRoot& x);
/// −1, 0, +1 as x < y, x = y, x > y, exactly; the roots may differ.
[[nodiscard]] int compare(const OneRoot& x, const OneRoot& y);
[[nodiscard]] int compare(const OneRoot& x, const Rational& y);

/// The double nearest to x; 0 within the rule of kZeroExponent.
[[nodiscard]] double nearest_double(const OneRoot& x);
/// The whole number nearest to x, ties away from zero, exactly.
[[nodiscard]] Integer nearest_integer(const OneRoot& x);
/// A rational within 2^exponent of x.
[[nodiscard]] Rational rational_within(const OneRoot& x, int exponent);
[[nodiscard]] Ball enclosure(const OneRoot& x);

}  // namespace dgt
