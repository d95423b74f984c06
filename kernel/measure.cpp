// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two arcs P and Q are run through with the same share t of their angles (a segment: of its
// length), after both have been halved together until neither turns by more than kLeafSweep. With
// f(t) = P(t) − Q(t), E the larger of |f(0)| and |f(1)|, and M the largest |f|:
//
//   a function lies no further from its chord than h²/8 times its largest second derivative, h = 1:
//       M ≤ E + max|f''| / 8                                                                   (1)
//   P'' = −α² p and Q'' = −β² q, where α and β are the angles turned and p, q the radius vectors.
//   Of one sense: P'' − Q'' = −α² (p − q) − (α² − β²) q, and p − q = f − (centre P − centre Q), so
//       max|f''| ≤ α² (M + D) + |α² − β²| r,     D the distance of the centres, r the radius of Q
//   which put into (1) gives
//       M ≤ (E + (α² D + |α² − β²| r) / 8) / (1 − α²/8).                                       (2)
//   Whatever the senses, a segment having the angle 0:
//       M ≤ E + (α² R + β² r) / 8.                                                             (3)
//
// Where arcs agree, (2) exceeds E by a small share of it only; a segment beside an arc gets its
// sagitta by (3). Angles come from chords, 2 asin(c/2r), as balls.
#include "kernel/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dgt {
namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;
/// Radians. A turn gives 16 leaves, and (2) exceeds what it must by about α²/8, two parts in a
/// hundred.
constexpr long double kLeafSweep = 0.4L;
constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

/// Sums of a few non-negative numbers in long double, rounded up.
long double up(long double x) { return x * (1 + 0x1p-58L); }
long double upper(const Ball& b) { return up(std::fabs(b.mid) + b.rad); }

double up_to_double(long double x) {
  if (!(x <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::infinity();
  const auto d = static_cast<double>(x);
  return d >= x ? d : std::nextafter(d, std::numeric_limits<double>::infinity());
}

Ball ball_of(double rounded) {
  // Half an ulp is at most 2⁻⁵³ of the value; what rounds to 0 may be 2⁻⁶⁴.
  return {rounded, std::fabs(static_cast<long double>(rounded)) * 0x1p-53L + 0x1p-64L};
}

BallPlace scaled(const Ball& k, const BallPlace& v) { return {k * v.x, k * v.y}; }
Ball squared(const BallPlace& v) { return v.x * v.x + v.y * v.y; }
long double length_above(const BallPlace& v) { return up(std::hypot(upper(v.x), upper(v.y))); }

/// The point of the circle in the direction of `v` from its centre.
std::optional<BallPlace> in_direction(const Curve& arc, const BallPlace& v) {
  const auto length = sqrt(squared(v));
  if (!length) return std::nullopt;
  const auto scale = divide(arc.radius, *length);
  if (!scale) return std::nullopt;
  return arc.centre + scaled(*scale, v);
}

/// Half-way round. The sum of the two radius vectors points there or away from it, and near half a
/// turn, where it vanishes, the normal of the chord does.
std::optional<BallPlace> middle(const Curve& arc) {
  if (arc.sweep >= 2 * kPi) return arc.centre + (arc.centre - arc.from);
  if (std::fabs(arc.sweep - kPi) < 1) {
    const BallPlace chord = arc.to - arc.from;
    const BallPlace right{chord.y, -chord.x};
    return in_direction(arc, arc.ccw ? right : BallPlace{-chord.y, chord.x});
  }
  const BallPlace sum = (arc.from - arc.centre) + (arc.to - arc.centre);
  return in_direction(arc, arc.sweep < kPi ? sum : BallPlace{-sum.x, -sum.y});
}

using Halves = std::array<Curve, 2>;

std::optional<Halves> halves_of(const Curve& curve) {
  std::optional<BallPlace> at;
  if (curve.is_line) {
    const Ball half(0.5L, 0);
    at = BallPlace{half * (curve.from.x + curve.to.x), half * (curve.from.y + curve.to.y)};
  } else {
    at = middle(curve);
  }
  if (!at) return std::nullopt;
  Halves halves{curve, curve};
  halves[0].to = halves[1].from = *at;
  halves[0].sweep = halves[1].sweep = curve.sweep / 2;
  return halves;
}

/// The square of the angle that a leaf turns.
std::optional<Ball> squared_angle(const Curve& leaf) {
  if (leaf.is_line) return Ball(0, 0);
  const auto chord = sqrt(squared(leaf.to - leaf.from));
  if (!chord) return std::nullopt;
  const auto s = divide(*chord, Ball(2, 0) * leaf.radius);
  if (!s || !(upper(*s) < 0.3L)) return std::nullopt;
  const Ball s2 = *s * *s;
  // asin s = s + s³/6 + 3s⁵/40 + 5s⁷/112 + 35s⁹/1152 + 63s¹¹/2816 + …, the rest below 0.02 s¹³.
  constexpr std::array kTerms = {63 / 2816.0L, 35 / 1152.0L, 5 / 112.0L, 3 / 40.0L, 1 / 6.0L, 1.0L};
  Ball series;
  for (const long double term : kTerms) series = series * s2 + Ball(term, 0x1p-64L);
  Ball half = *s * series;
  half.rad += up(0.02L * std::pow(upper(*s), 13.0L));
  return Ball(4, 0) * half * half;
}

/// Both curves of at most kLeafSweep.
long double leaf_bound(const Curve& p, const Curve& q) {
  const long double ends = std::max(length_above(p.from - q.from), length_above(p.to - q.to));
  const auto a = squared_angle(p);
  const auto b = squared_angle(q);
  if (!a || !b) {
    // An arc of less than half a radian lies within twice its chord of either end.
    return up(ends + 2 * (length_above(p.to - p.from) + length_above(q.to - q.from)));
  }
  const long double of_p = p.is_line ? 0 : upper(*a * p.radius);
  const long double of_q = q.is_line ? 0 : upper(*b * q.radius);
  const long double apart = up(ends + up(of_p + of_q) / 8);
  if (p.is_line || q.is_line || p.ccw != q.ccw) return apart;
  const long double alpha = upper(*a);
  const long double centres = length_above(p.centre - q.centre);
  const long double bend = up(up(alpha * centres) + up(upper(*a - *b) * upper(q.radius)));
  return std::min(apart, up(up(ends + bend / 8) / (1 - up(alpha / 8))));
}

/// 2⁻⁶ of a turn is below kLeafSweep.
constexpr int kMostHalvings = 6;

long double bound(const Curve& p, const Curve& q, int halvings) {
  if (p.sweep <= kLeafSweep && q.sweep <= kLeafSweep) return leaf_bound(p, q);
  const auto of_p = halves_of(p);
  const auto of_q = halves_of(q);
  if (!of_p || !of_q || halvings == 0) return kInfinity;
  return std::max(bound((*of_p)[0], (*of_q)[0], halvings - 1),
                  bound((*of_p)[1], (*of_q)[1], halvings - 1));
}

/// Radians from one direction to another in the arc's sense, 0…2π.
long double angle_between(const Curve& arc, const BallPlace& from, const BallPlace& to) {
  const BallPlace a = from - arc.centre;
  const BallPlace b = to - arc.centre;
  const long double cross = a.x.mid * b.y.mid - a.y.mid * b.x.mid;
  const long double dot = a.x.mid * b.x.mid + a.y.mid * b.y.mid;
  const long double angle = std::atan2(arc.ccw ? cross : -cross, dot);
  return angle < 0 ? angle + 2 * kPi : angle;
}

/// The angle of an arc that is no full circle. Which half it lies in is known exactly: a tiny arc
/// is told from nearly a turn by that.
long double sweep_of(const Move& move, const Curve& arc) {
  const long double angle = angle_between(arc, arc.from, arc.to);
  const int half = half_turn_order(move);
  if (half < 0 && angle > kPi * 1.5L) return 0;
  if (half > 0 && angle < kPi / 2) return 2 * kPi;
  return angle;
}

}  // namespace

BallPlace place_of(const Point& p) { return {ball_of(p.x()), ball_of(p.y())}; }
BallPlace place_of(const RationalPoint& p) { return {Ball(p.x), Ball(p.y)}; }

Curve curve_of(const Move& move, const BallPlace& shift) {
  Curve curve;
  curve.from = place_of(move.from) + shift;
  curve.to = place_of(move.to) + shift;
  if (move.kind != MoveKind::Arc) return curve;
  const Circle circle = move.circle();
  curve.is_line = false;
  curve.centre = place_of(circle.centre()) + shift;
  curve.radius = Ball(abs(circle.radius()));
  curve.ccw = circle.counter_clockwise();
  curve.sweep = move.full_circle ? 2 * kPi : sweep_of(move, curve);
  return curve;
}

long double progress(const Curve& curve, const BallPlace& p) {
  if (curve.is_line) {
    const BallPlace along = curve.to - curve.from;
    const BallPlace to_p = p - curve.from;
    const long double square = along.x.mid * along.x.mid + along.y.mid * along.y.mid;
    if (square == 0) return 0;
    const long double t = (along.x.mid * to_p.x.mid + along.y.mid * to_p.y.mid) / square;
    return std::clamp(t, 0.0L, 1.0L);
  }
  if (curve.sweep == 0) return 0;
  const long double angle = angle_between(curve, curve.from, p);
  if (angle <= curve.sweep) return angle / curve.sweep;
  return angle - curve.sweep < 2 * kPi - angle ? 1 : 0;  // beyond the end or before the beginning
}

Curve part(const Curve& curve, const CurveSpot& begin, const CurveSpot& end) {
  Curve cut = curve;
  cut.from = begin.at;
  cut.to = end.at;
  cut.sweep = std::max(0.0L, end.along - begin.along) * curve.sweep;
  return cut;
}

std::optional<BallPlace> foot(const Curve& curve, const BallPlace& p) {
  if (!curve.is_line) return in_direction(curve, p - curve.centre);
  const BallPlace along = curve.to - curve.from;
  const BallPlace to_p = p - curve.from;
  const auto share = divide(along.x * to_p.x + along.y * to_p.y, squared(along));
  if (!share) return std::nullopt;
  return curve.from + scaled(*share, along);
}

double distance_bound(const BallPlace& p, const BallPlace& q) {
  return up_to_double(length_above(p - q));
}

double frechet_bound(const Curve& a, const Curve& b) {
  return up_to_double(bound(a, b, kMostHalvings));
}

}  // namespace dgt
