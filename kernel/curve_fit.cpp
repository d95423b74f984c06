// SPDX-License-Identifier: GPL-3.0-or-later
//
// The proof that an arc and a stretch of the curve lie within a tolerance of each other.
//
// Seen from the centre c of the arc, radius r, the stretch is q(t) = Q(t)/W(t) with the homogeneous
// control points Qᵢ = Pᵢ − c wᵢ, W > 0. A polynomial whose Bernstein coefficients have one sign has
// that sign from 0 to 1. So signs of coefficients prove
//  (a) W²((r + δ)² − |q|²) = (r + δ)²W² − |Q|² ≥ 0, and |Q|² − (r − δ)²W² ≥ 0 or r ≤ δ: the stretch
//      is never farther than δ from the circle;
//  (b) q × q' = (Q × Q')/W² has the sign of the arc's turn: the angle about c never goes back;
//  (c) Q·h > 0 for a direction h: the stretch stays in one half plane, hence turns by less than
//      half a turn, as the arc does.
// Taking each point of the stretch to the point of the circle in its direction is, by (b) and (c),
// a monotone map onto an arc of the circle, and moves nothing by more than δ. That arc differs from
// ours at its ends alone. An end s of the stretch that lies within r/2 of the end e of ours, with τ
// of that along the tangent at e, is at |s − c| ≥ r/2 in a direction φ < 90° off with |s − c| sin φ
// = τ; the arc between is r φ ≤ (π/2) r sin φ ≤ π τ < 4 τ long. Hence both lie within δ + 4 τ of
// each other, which is (1) of the header, and more: no part is passed out of order.
//
// For a segment it is enough that the control points, hence the curve, lie within δ of its line and
// no more than δ beyond its ends, and the ends of the stretch within δ of these: by continuity no
// place of the segment is left out.
//
// All of it runs in balls: what they leave open counts as not proved, and the stretch is halved.
#include "kernel/curve_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernel/check.h"

namespace dgt {
namespace {

/// Where stretches meet is rounded to a grid, which costs less than a thousandth of any tolerance.
constexpr int kGridExponent = -56;
/// Tangents are turned by less than 2⁻⁴⁰ rad; they need not be the curve's, only near it.
constexpr int kTangentBits = 40;
/// A stretch is halved so often at most; a thousandth of a millimetre of a kilometre is 2⁻³⁰.
constexpr int kMaxDepth = 48;
/// Of the tolerance, δ takes 7/8 and the ends 1/8.
constexpr long double kForEnds = 0.125L;
/// What leaves its chord by less than this part of the tolerance is a segment.
constexpr long double kStraight = 1.0L / 64;

struct BallPoint {
  Ball x, y, w;
};
using Stretch = std::vector<BallPoint>;

bool surely_positive(const Ball& v) { return v.mid > v.rad; }
bool surely_not_negative(const Ball& v) { return v.mid >= v.rad; }

Ball exactly(long double v) { return {v, 0}; }
Ball halved(const Ball& v) { return {v.mid / 2, v.rad / 2}; }

struct BallVector {
  Ball x, y;
};
BallVector ball_of(const RationalPoint& p) { return {Ball(p.x), Ball(p.y)}; }
Ball dot(const BallVector& a, const BallVector& b) { return a.x * b.x + a.y * b.y; }
Ball cross(const BallVector& a, const BallVector& b) { return a.x * b.y - a.y * b.x; }
BallVector operator-(const BallVector& a, const BallVector& b) { return {a.x - b.x, a.y - b.y}; }

/// de Casteljau; both parts share the point at t.
std::pair<Stretch, Stretch> split(Stretch points, long double t) {
  const auto between = [&](const Ball& a, const Ball& b) {
    return t == 0.5L ? halved(a + b) : a + exactly(t) * (b - a);
  };
  const std::size_t n = points.size();
  Stretch first{points.front()};
  Stretch last(n);
  last[n - 1] = points.back();
  for (std::size_t level = 1; level < n; ++level) {
    for (std::size_t i = 0; i + level < n; ++i) {
      points[i] = {between(points[i].x, points[i + 1].x), between(points[i].y, points[i + 1].y),
                   between(points[i].w, points[i + 1].w)};
    }
    first.push_back(points.front());
    last[n - 1 - level] = points[n - 1 - level];
  }
  return {std::move(first), std::move(last)};
}

/// Where the control point stands; its weight is surely positive.
std::optional<BallVector> place(const BallPoint& p) {
  const auto x = divide(p.x, p.w);
  const auto y = divide(p.y, p.w);
  if (!x || !y) return std::nullopt;
  return BallVector{*x, *y};
}

Rational rational(long double v) {
  int exponent = 0;
  const long double mantissa = std::frexp(v, &exponent);
  // 64 bits of mantissa, in two halves that doubles hold.
  const auto high = static_cast<double>(std::trunc(std::ldexp(mantissa, 32)));
  const auto low = static_cast<double>(std::ldexp(mantissa, 64) -
                                       std::ldexp(static_cast<long double>(high), 32));
  return Rational(high) * power_of_two(exponent - 32) + Rational(low) * power_of_two(exponent - 64);
}

RationalPoint on_grid(const BallVector& p) {
  return {on_dyadic_grid(rational(p.x.mid), kGridExponent),
          on_dyadic_grid(rational(p.y.mid), kGridExponent)};
}

UnitVector direction_near(long double x, long double y) {
  return direction_of({rational(x), rational(y)}, kTangentBits).unit;
}

/// The direction of travel at an end, towards the next place that is another one; nothing when all
/// are one.
std::optional<UnitVector> end_tangent(const Stretch& stretch, bool at_end) {
  const std::size_t n = stretch.size();
  const auto at = [&](std::size_t i) { return place(stretch[at_end ? n - 1 - i : i]); };
  const auto origin = at(0);
  for (std::size_t i = 1; i < n && origin; ++i) {
    const auto other = at(i);
    if (!other) return std::nullopt;
    const BallVector w = *other - *origin;
    // A direction that is known to a part in 2²⁰ is one.
    const long double size = std::hypot(w.x.mid, w.y.mid);
    if (size <= 0x1p20L * (w.x.rad + w.y.rad)) continue;
    return at_end ? direction_near(-w.x.mid, -w.y.mid) : direction_near(w.x.mid, w.y.mid);
  }
  return std::nullopt;
}

constexpr std::size_t kMaxDegree = 32;
using Row = std::array<long double, 2 * kMaxDegree + 1>;

/// The binomials of n, exactly: those up to twice kMaxDegree are below 2⁶³.
Row binomials(std::size_t n) {
  Row row{};
  row[0] = 1;
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t k = i; k > 0; --k) row[k] += row[k - 1];
  return row;
}

/// Whether the polynomial of these Bernstein coefficients is surely not negative from 0 to 1. They
/// lie above and below it, the nearer the shorter the stretch: where they do not tell, halves may.
bool is_not_negative(std::vector<Ball> coefficients, int halvings) {
  if (std::ranges::all_of(coefficients, surely_not_negative)) return true;
  // The outer ones are values of the polynomial.
  if (halvings == 0 || !surely_not_negative(coefficients.front()) ||
      !surely_not_negative(coefficients.back()))
    return false;
  const std::size_t n = coefficients.size();
  std::vector<Ball> first{coefficients.front()};
  for (std::size_t level = 1; level < n; ++level) {
    for (std::size_t i = 0; i + level < n; ++i)
      coefficients[i] = halved(coefficients[i] + coefficients[i + 1]);
    first.push_back(coefficients.front());
  }
  // What is left in place is the second half.
  return is_not_negative(std::move(first), halvings - 1) &&
         is_not_negative(std::move(coefficients), halvings - 1);
}

/// The same of Σ term(i, j) over the products of the Bernstein polynomials of degrees n and m.
template <class Term>
bool is_not_negative(std::size_t n, std::size_t m, Term&& term) {
  constexpr int kHalvings = 3;
  const Row first = binomials(n);
  const Row second = binomials(m);
  const Row both = binomials(n + m);
  std::vector<Ball> coefficients;
  for (std::size_t k = 0; k <= n + m; ++k) {
    Ball sum;
    for (std::size_t i = k > m ? k - m : 0; i <= std::min(n, k); ++i)
      sum = sum + exactly(first[i] * second[k - i]) * term(i, k - i);
    const auto coefficient = divide(sum, exactly(both[k]));
    if (!coefficient) return false;
    coefficients.push_back(*coefficient);
  }
  return is_not_negative(std::move(coefficients), kHalvings);
}

class Fitting {
 public:
  Fitting(const Rational& tolerance, std::size_t most)
      : tolerance_(static_cast<long double>(nearest_double(tolerance)) * (1 - 0x1p-40L)),
        most_(most) {}

  struct End {
    RationalPoint at;
    UnitVector tangent;
  };

  bool fit(const Stretch& stretch, const End& from, const End& to, int depth) {
    if (from.at == to.at && is_within(stretch, from.at, tolerance_)) return true;
    if (!(from.at == to.at) && fit_segment(stretch, from.at, to.at)) return room();
    if (!(from.at == to.at) && fit_biarc(stretch, from, to)) return room();
    if (depth == kMaxDepth || !room()) return false;
    const auto [first, last] = split(stretch, 0.5L);
    const auto middle = place(first.back());
    if (!middle) return false;
    const auto behind = end_tangent(last, false);
    const auto before = end_tangent(first, true);
    const RationalPoint at = on_grid(*middle);
    if (!behind || !before) return add_tiny(stretch, from.at, to.at);
    const bool is_cusp = sgn(dot(before->vector(), behind->vector())) < 0;
    return fit(first, from, {at, is_cusp ? *before : *behind}, depth + 1) &&
           fit(last, {at, *behind}, to, depth + 1);
  }

  [[nodiscard]] std::vector<ChainEdge> take() { return std::move(edges_); }

 private:
  [[nodiscard]] bool room() const { return edges_.size() <= most_; }

  /// Whether all of the stretch lies within `delta` of a place.
  static bool is_within(const Stretch& stretch, const RationalPoint& centre, long double delta) {
    const BallVector c = ball_of(centre);
    for (const BallPoint& p : stretch) {
      const auto at = place(p);
      if (!at) return false;
      const BallVector w = *at - c;
      if (!surely_not_negative(exactly(delta) * exactly(delta) - dot(w, w))) return false;
    }
    return true;
  }

  /// A stretch whose tangents cannot be told, of no size to speak of.
  bool add_tiny(const Stretch& stretch, const RationalPoint& from, const RationalPoint& to) {
    if (!is_within(stretch, from, tolerance_)) return false;
    if (!(from == to)) edges_.push_back(segment(from, to));
    return room();
  }

  static bool is_straight(const Stretch& stretch, const RationalPoint& from,
                          const RationalPoint& to, long double delta) {
    const BallVector a = ball_of(from);
    const BallVector w = ball_of(to) - a;
    const Ball square = dot(w, w);
    const long double each = delta * 0.7L;  // aside and along, no farther than δ together
    const Ball slack = exactly(each) * exactly(each) * square;
    const long double beyond = each * std::sqrt(square.mid) * (1 - 0x1p-40L);
    if (!is_within({stretch.front()}, from, delta) || !is_within({stretch.back()}, to, delta))
      return false;
    for (const BallPoint& p : stretch) {
      const auto at = place(p);
      if (!at) return false;
      const BallVector v = *at - a;
      const Ball aside = cross(w, v);
      const Ball along = dot(w, v);
      if (!surely_not_negative(slack - aside * aside)) return false;
      if (along.mid - along.rad < -beyond) return false;
      if (along.mid + along.rad > square.mid - square.rad + beyond) return false;
    }
    return true;
  }

  bool fit_segment(const Stretch& stretch, const RationalPoint& from, const RationalPoint& to) {
    if (!is_straight(stretch, from, to, tolerance_ * kStraight)) return false;
    edges_.push_back(segment(from, to));
    return true;
  }

  /// The biarc whose two control legs are as long as each other.
  bool fit_biarc(const Stretch& stretch, const End& from, const End& to) {
    const auto middle = joint_of(from, to);
    if (!middle) return false;
    const auto at = parameter_of(stretch, *middle);
    if (!at) return false;
    const auto [first, last] = split(stretch, *at);
    const auto a = edge_of(from.at, from.tangent, middle->at);
    const auto b = edge_of(middle->at, middle->tangent, to.at);
    if (!a || !b) return false;
    if (!runs_along(first, *a) || !runs_along(last, *b)) return false;
    if (a->is_line() && b->is_line())
      edges_.push_back(segment(from.at, to.at));
    else
      edges_.insert(edges_.end(), {*a, *b});
    return true;
  }

  /// p₁ − p₀ = α(d₀ + m) + β(m + d₁) makes two arcs with the tangents d₀, m, d₁, for any unit m. α
  /// = β gives m up to rounding; then α and β are solved for exactly.
  static std::optional<End> joint_of(const End& from, const End& to) {
    const Vector chord = to.at - from.at;
    const Vector& d0 = from.tangent.vector();
    const Vector& d1 = to.tangent.vector();
    if (d0 == d1) {  // α + β is all that is determined, for the m that mirrors d₀ in the chord
      const Vector m = (2 * dot(d0, chord) / squared_length(chord)) * chord - d0;
      if (sgn(dot(chord, d0)) <= 0) return std::nullopt;
      return End{from.at + Rational(1, 2) * chord, UnitVector(m)};
    }
    const auto vx = static_cast<long double>(nearest_double(chord.x));
    const auto vy = static_cast<long double>(nearest_double(chord.y));
    const auto sx = static_cast<long double>(nearest_double(d0.x + d1.x));
    const auto sy = static_cast<long double>(nearest_double(d0.y + d1.y));
    // |v|²x² − 2 v·s x + |s|² − 4 = 0 for x = 1/α.
    const long double square = vx * vx + vy * vy;
    const long double half = vx * sx + vy * sy;
    const long double rest = sx * sx + sy * sy - 4;
    const long double x = (half + std::sqrt(half * half - square * rest)) / square;
    const long double mx = x * vx - sx;
    const long double my = x * vy - sy;
    if (!(std::fabs(mx) + std::fabs(my) > 0x1p-20L) || !std::isfinite(mx + my)) return std::nullopt;
    const UnitVector m = direction_near(mx, my);
    const Vector a = d0 + m.vector();
    const Vector b = m.vector() + d1;
    const Rational turn = cross(a, b);
    if (sgn(turn) == 0) return std::nullopt;
    const Rational alpha = cross(chord, b) / turn;
    const Rational beta = cross(a, chord) / turn;
    if (sgn(alpha) <= 0 || sgn(beta) <= 0) return std::nullopt;
    return End{from.at + alpha * a, m};
  }

  /// Where the stretch passes the joint: its offset along the tangent there is 0, by Newton.
  static std::optional<long double> parameter_of(const Stretch& stretch, const End& joint) {
    const auto jx = static_cast<long double>(nearest_double(joint.at.x));
    const auto jy = static_cast<long double>(nearest_double(joint.at.y));
    const auto mx = static_cast<long double>(nearest_double(joint.tangent.x()));
    const auto my = static_cast<long double>(nearest_double(joint.tangent.y()));
    constexpr int kSteps = 8;
    constexpr long double kMargin = 0x1p-6L;
    long double t = 0.5L;
    for (int i = 0; i < kSteps; ++i) {
      const auto [first, last] = split(stretch, t);
      const BallPoint& p = last[0];
      const BallPoint& q = last[1];
      const long double value = (p.x.mid / p.w.mid - jx) * mx + (p.y.mid / p.w.mid - jy) * my;
      // The derivative at the left end, up to the weights: n (q − p) w₁/w₀ over what is left of t.
      const long double slope = ((q.x.mid - p.x.mid * q.w.mid / p.w.mid) * mx +
                                 (q.y.mid - p.y.mid * q.w.mid / p.w.mid) * my) /
                                p.w.mid * static_cast<long double>(stretch.size() - 1) / (1 - t);
      const long double next = t - value / slope;
      if (!(next > kMargin && next < 1 - kMargin)) return std::nullopt;
      if (next == t) break;
      t = next;
    }
    return t;
  }

  /// The edge with the tangent at its beginning.
  static std::optional<ChainEdge> edge_of(const RationalPoint& from, const UnitVector& tangent,
                                          const RationalPoint& to) {
    const Vector w = to - from;
    const UnitVector start = turned_left(tangent);
    const Rational along = dot(w, start.vector());
    if (sgn(along) == 0) return segment(from, to);
    const Rational square = squared_length(w);
    const UnitVector end(start.vector() - (2 * along / square) * w);
    return ChainEdge{from, to, start, end, square / (2 * along)};
  }

  [[nodiscard]] bool runs_along(const Stretch& stretch, const ChainEdge& edge) const {
    if (edge.is_line())
      return is_straight(stretch, edge.from, edge.to, tolerance_ * (1 - kForEnds));
    const bool ccw = sgn(edge.radius) > 0;
    const Ball radius{std::fabs(Ball(edge.radius).mid), Ball(edge.radius).rad};
    const BallVector centre = ball_of(edge.centre());
    Stretch seen;
    for (const BallPoint& p : stretch)
      seen.push_back({p.x - centre.x * p.w, p.y - centre.y * p.w, p.w});
    return ends_fit(stretch, edge, radius) && stays_ahead(seen, edge, centre) &&
           never_turns_back(seen, ccw) && stays_beside(seen, radius);
  }

  /// Both ends of the stretch against those of the arc, 4 τ each within their part of the
  /// tolerance.
  [[nodiscard]] bool ends_fit(const Stretch& stretch, const ChainEdge& edge,
                              const Ball& radius) const {
    const auto fits = [&](const BallPoint& p, const RationalPoint& end, const UnitVector& normal) {
      const auto at = place(p);
      if (!at) return false;
      const BallVector w = *at - ball_of(end);
      const Ball tau = cross(w, ball_of(normal.vector()));
      const bool is_near = surely_not_negative(radius * radius - exactly(4) * dot(w, w));
      return is_near && 4 * (std::fabs(tau.mid) + tau.rad) <= tolerance_ * kForEnds;
    };
    return fits(stretch.front(), edge.from, edge.start) && fits(stretch.back(), edge.to, edge.end);
  }

  /// (c): from the centre all lies towards the middle of the chord.
  static bool stays_ahead(const Stretch& seen, const ChainEdge& edge, const BallVector& centre) {
    const BallVector a = ball_of(edge.from) - centre;
    const BallVector b = ball_of(edge.to) - centre;
    const BallVector ahead{a.x + b.x, a.y + b.y};
    for (const BallPoint& p : seen) {
      if (!surely_positive(dot(BallVector{p.x, p.y}, ahead))) return false;
    }
    return true;
  }

  /// (b)
  static bool never_turns_back(const Stretch& seen, bool ccw) {
    const std::size_t n = seen.size() - 1;
    return is_not_negative(n, n - 1, [&](std::size_t i, std::size_t j) {
      const BallVector step{seen[j + 1].x - seen[j].x, seen[j + 1].y - seen[j].y};
      const Ball turn = cross({seen[i].x, seen[i].y}, step);
      return ccw ? turn : -turn;
    });
  }

  /// (a)
  [[nodiscard]] bool stays_beside(const Stretch& seen, const Ball& radius) const {
    const std::size_t n = seen.size() - 1;
    const Ball delta = exactly(tolerance_ * (1 - kForEnds));
    const Ball outer = radius + delta;
    const Ball inner = radius - delta;
    const auto square_at = [&](std::size_t i, std::size_t j) {
      return dot(BallVector{seen[i].x, seen[i].y}, BallVector{seen[j].x, seen[j].y});
    };
    const bool is_inside = is_not_negative(n, n, [&](std::size_t i, std::size_t j) {
      return outer * outer * seen[i].w * seen[j].w - square_at(i, j);
    });
    if (!is_inside) return false;
    if (inner.mid + inner.rad <= 0) return true;
    return is_not_negative(n, n, [&](std::size_t i, std::size_t j) {
      return square_at(i, j) - inner * inner * seen[i].w * seen[j].w;
    });
  }

  long double tolerance_;
  std::size_t most_;
  std::vector<ChainEdge> edges_;
};

/// An end of the curve, as it is when its numbers are short, else on the grid.
RationalPoint end_point(const BezierPoint& p) {
  constexpr std::size_t kShort = 96;
  const RationalPoint at{p.x / p.w, p.y / p.w};
  if (height(at.x) <= kShort && height(at.y) <= kShort) return at;
  return {on_dyadic_grid(at.x, kGridExponent), on_dyadic_grid(at.y, kGridExponent)};
}

Stretch stretch_of(const RationalCurve& curve) {
  DGT_CHECK(curve.size() >= 2 && curve.size() <= kMaxDegree + 1);
  Stretch stretch;
  for (const BezierPoint& p : curve) {
    DGT_CHECK(sgn(p.w) > 0);
    stretch.push_back({Ball(p.x), Ball(p.y), Ball(p.w)});
  }
  return stretch;
}

/// A piece of the curve with its ends.
struct Ended {
  Stretch stretch;
  Fitting::End from;
  Fitting::End to;
};

bool is_one_direction(const UnitVector& a, const UnitVector& b) {
  return sgn(dot(a.vector(), b.vector())) > 0 &&
         abs(cross(a.vector(), b.vector())) < power_of_two(-20);
}

/// The pieces that have a size; where one goes on from the other smoothly, with one tangent.
std::vector<Ended> ended(const std::vector<RationalCurve>& pieces) {
  std::vector<Ended> found;
  for (const RationalCurve& curve : pieces) {
    Stretch stretch = stretch_of(curve);
    const auto begin = end_tangent(stretch, false);
    const auto end = end_tangent(stretch, true);
    if (!begin || !end) continue;
    found.push_back(
        {std::move(stretch), {end_point(curve.front()), *begin}, {end_point(curve.back()), *end}});
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    Ended& next = found[(i + 1) % found.size()];
    if (i + 1 < found.size()) DGT_CHECK(found[i].to.at == next.from.at);
    if (found[i].to.at == next.from.at && is_one_direction(found[i].to.tangent, next.from.tangent))
      found[i].to.tangent = next.from.tangent;
  }
  return found;
}

}  // namespace

std::optional<std::vector<ChainEdge>> arcs_along(const std::vector<RationalCurve>& pieces,
                                                 const Rational& tolerance, std::size_t most) {
  DGT_CHECK(sgn(tolerance) > 0);
  Fitting fitting(tolerance, most);
  for (const Ended& piece : ended(pieces)) {
    if (!fitting.fit(piece.stretch, piece.from, piece.to, 0)) return std::nullopt;
  }
  return fitting.take();
}

}  // namespace dgt
