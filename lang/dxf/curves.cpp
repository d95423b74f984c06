// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/curves.h"

#include <span>
#include <utility>

namespace dgt {
namespace {

/// The parameter from `from` to `to`, less than half a turn: with τ = tan(θ/2) the unit circle is
/// (1 − τ², 2τ)/(1 + τ²), τ from 0 to s.
RationalCurve quarter_of(const PlacedEllipse& ellipse, const UnitVector& from,
                         const UnitVector& to) {
  const UnitVector back(Vector{from.x(), -from.y()});
  const UnitVector sweep = rotated(to, back);
  const Rational s = sweep.y() / (1 + sweep.x());
  const auto point = [&](const Rational& x, const Rational& y, const Rational& w) {
    const Rational cos = x * from.x() - y * from.y();
    const Rational sin = x * from.y() + y * from.x();
    const Vector at = w * ellipse.centre + cos * ellipse.major + sin * ellipse.minor;
    return BezierPoint{at.x, at.y, w};
  };
  return {point(1, 0, 1), point(1, s, 1), point(1 - s * s, 2 * s, 1 + s * s)};
}

BezierPoint between(const BezierPoint& a, const BezierPoint& b, const Rational& t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
}

/// The polar form of the spline over the span that begins at knot `span`, by de Boor's triangle.
BezierPoint polar_form(const DxfSpline& spline, std::size_t span,
                       std::span<const Rational> arguments) {
  const std::size_t n = spline.degree;
  const std::vector<Rational>& u = spline.knots;
  std::vector<BezierPoint> d(spline.points.begin() + static_cast<std::ptrdiff_t>(span - n),
                             spline.points.begin() + static_cast<std::ptrdiff_t>(span + 1));
  for (std::size_t r = 1; r <= n; ++r) {
    for (std::size_t k = n; k >= r; --k) {
      const std::size_t i = span - n + k;
      const Rational t = (arguments[r - 1] - u[i]) / (u[i + n - r + 1] - u[i]);
      d[k] = between(d[k - 1], d[k], t);
    }
  }
  return d[n];
}

}  // namespace

bool is_circle(const PlacedEllipse& ellipse) {
  const Rational a = squared_length(ellipse.major);
  const Rational rounding = a / 1'000'000'000;
  return abs(squared_length(ellipse.minor) - a) <= rounding &&
         abs(dot(ellipse.major, ellipse.minor)) <= rounding;
}

std::vector<RationalCurve> curves_of(const PlacedEllipse& ellipse, const UnitVector& start,
                                     const UnitVector& end) {
  std::vector<RationalCurve> curves;
  UnitVector at = start;
  do {
    const Rational ahead = dot(at.vector(), end.vector());
    const Rational aside = cross(at.vector(), end.vector());
    const bool is_last = sgn(aside) > 0 && sgn(ahead) >= 0;
    const UnitVector next = is_last ? end : turned_left(at);
    curves.push_back(quarter_of(ellipse, at, next));
    at = next;
  } while (!(at == end));
  return curves;
}

std::vector<RationalCurve> curves_of(const DxfSpline& spline, const Placement& placement) {
  const std::size_t n = spline.degree;
  const std::vector<Rational>& u = spline.knots;
  std::vector<RationalCurve> curves;
  for (std::size_t span = n; span + n + 1 < u.size(); ++span) {
    if (u[span] == u[span + 1]) continue;
    RationalCurve curve;
    for (std::size_t k = 0; k <= n; ++k) {
      std::vector<Rational> arguments(n, u[span]);
      for (std::size_t i = 0; i < k; ++i) arguments[n - 1 - i] = u[span + 1];
      const BezierPoint p = polar_form(spline, span, arguments);
      const Vector at = placement.turned({p.x, p.y}) + p.w * placement.origin;
      curve.push_back({at.x, at.y, p.w});
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace dgt
