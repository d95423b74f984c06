// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/rounding.h"

#include <cmath>

namespace dgt {
namespace {

/// A coordinate of a Point: correctly rounded, so off by at most 2⁻⁵³ of its size, and 0 for
/// anything within 2⁻⁶⁴ mm of 0.
Ball coordinate(double value) {
  static const long double zero = std::ldexp(1.0L, kZeroExponent);
  static const long double half_ulp = std::ldexp(1.0L, -53);
  return {value, value == 0 ? zero : std::fabs(static_cast<long double>(value)) * half_ulp};
}

std::optional<std::int64_t> within_limits(const Integer& k) {
  static const Integer limit(static_cast<long>(kMaxUnits));
  if (abs(k) > limit) return std::nullopt;
  return k.get_si();
}

/// The whole number nearest to every number of the ball, when there is one such.
std::optional<std::int64_t> certain_nearest(const Ball& t) {
  const long double k = std::round(t.mid);
  // The difference is exact (both are close); twice the radius covers the rounding of this test.
  if (!(0.5L - std::fabs(t.mid - k) > 2 * t.rad)) return std::nullopt;
  return static_cast<std::int64_t>(k);
}

bool clearly_beyond(const Ball& t) {
  return !(std::fabs(t.mid) + t.rad < 2 * static_cast<long double>(kMaxUnits));
}

std::optional<std::int64_t> nearest_on_axis(const Ball& t, const Point& p,
                                            OneRoot ExactPoint::*axis, const Rational& origin,
                                            const Rational& unit) {
  if (clearly_beyond(t)) return std::nullopt;
  if (const auto certain = certain_nearest(t)) {
    if (std::abs(*certain) > kMaxUnits) return std::nullopt;
    return certain;
  }
  const ExactPoint exact = p.exact();
  return within_limits(nearest_integer((exact.*axis - origin) * Rational(1 / unit)));
}

}  // namespace

Grid::Grid(Rational unit, RationalPoint origin)
    : unit_(std::move(unit)),
      origin_(std::move(origin)),
      per_unit_((DGT_CHECK(sgn(unit_) > 0), Ball(Rational(1 / unit_)))),
      origin_x_(origin_.x),
      origin_y_(origin_.y) {}

std::optional<GridPoint> Grid::nearest(const Point& p) const {
  const BallPoint t = enclosure(p);
  const auto x = nearest_on_axis(t.x, p, &ExactPoint::x, origin_.x, unit_);
  const auto y = nearest_on_axis(t.y, p, &ExactPoint::y, origin_.y, unit_);
  if (!x || !y) return std::nullopt;
  return GridPoint{*x, *y};
}

std::optional<std::int64_t> Grid::nearest_height(const Rational& z) const {
  return within_limits(nearest_integer(Rational(z / unit_)));
}

BallPoint Grid::enclosure(const Point& p) const {
  return {(coordinate(p.x()) - origin_x_) * per_unit_, (coordinate(p.y()) - origin_y_) * per_unit_};
}

BallPoint Grid::enclosure(const RationalPoint& p) const {
  return {(Ball(p.x) - origin_x_) * per_unit_, (Ball(p.y) - origin_y_) * per_unit_};
}

}  // namespace dgt
