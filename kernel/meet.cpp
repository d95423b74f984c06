// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/meet.h"

#include <array>
#include <cmath>

#include "kernel/cgal/crossings.h"

// Formulas. With the line n·x = p, its direction d = (n.y, −n.x), a circle of centre c and radius
// r, and h = n·c − p: the crossings are c − h n ± √(r² − h²) d; travelling along d, the minus comes
// first and enters the disc. Two circles with v = c2 − c1, D = |v|², k = (D + r1² − r2²) / 2D: the
// crossings are c1 + k v ± √(r1²/D − k²) v⊥ with v⊥ = v turned left. A counter-clockwise first
// circle comes through the disc of the second from the right of v (minus: entry) to its left; a
// clockwise one the other way.
namespace dgt {
namespace {

const Rational& contact_resolution() {
  static const Rational value = power_of_two(kContactExponent);
  return value;
}

// --- Balls of elements ------------------------------------------------------------------------

struct LineBalls {
  Ball nx, ny, p;
};
struct CircleBalls {
  Ball x, y, r;
};

LineBalls balls(const Line& line, const Carrier& carrier) {
  Ball p(line.p());
  if (carrier.shift) p = p + Ball(*carrier.shift);
  return {Ball(line.normal().x()), Ball(line.normal().y()), p};
}

CircleBalls balls(const Circle& circle, const Carrier& carrier) {
  Ball r(circle.radius());
  if (carrier.shift) r = r - Ball(*carrier.shift);
  return {Ball(circle.centre().x), Ball(circle.centre().y), r};
}

Ball absolute(const Ball& b) { return {std::fabs(b.mid), b.rad}; }

stages::Verdict verdict_of_gap(const Ball& gap) {
  const long double resolution = std::ldexp(1.0L, kContactExponent);
  if (gap.mid - gap.rad > 2 * resolution) return stages::Verdict::Apart;
  if (gap.mid + gap.rad < -2 * resolution) return stages::Verdict::Crossing;
  return stages::Verdict::Unknown;
}

stages::Verdict verdict_of_gap(const OneRoot& gap) {
  if (compare(gap, contact_resolution()) > 0) return stages::Verdict::Apart;
  if (compare(gap, -contact_resolution()) < 0) return stages::Verdict::Crossing;
  return stages::Verdict::Contact;
}

// --- filtered coordinates ---------------------------------------------------------------------

struct BallPoint {
  Ball x, y;
};

std::optional<BallPoint> filtered_crossing(const LineBalls& line, const CircleBalls& circle,
                                           Which which) {
  const Ball h = line.nx * circle.x + line.ny * circle.y - line.p;
  auto s = sqrt((circle.r - h) * (circle.r + h));
  if (!s) return std::nullopt;
  if (which == Which::Entry) s = -*s;
  return BallPoint{circle.x - h * line.nx + *s * line.ny, circle.y - h * line.ny - *s * line.nx};
}

std::optional<BallPoint> filtered_crossing(const CircleBalls& a, const CircleBalls& b,
                                           Which which) {
  const Ball vx = b.x - a.x;
  const Ball vy = b.y - a.y;
  const Ball square = vx * vx + vy * vy;
  const Ball half(0.5L, 0);
  const auto k = divide(half * (square + (a.r - b.r) * (a.r + b.r)), square);
  const auto ratio = divide(a.r * a.r, square);
  if (!k || !ratio) return std::nullopt;
  auto s = sqrt(*ratio - *k * *k);
  const auto sense = a.r.sign();
  if (!s || !sense) return std::nullopt;
  if ((which == Which::Entry) == (*sense > 0)) s = -*s;
  return BallPoint{a.x + *k * vx - *s * vy, a.y + *k * vy + *s * vx};
}

std::optional<BallPoint> filtered_crossing(const LineBalls& a, const LineBalls& b) {
  const Ball det = a.nx * b.ny - a.ny * b.nx;
  const auto x = divide(a.p * b.ny - b.p * a.ny, det);
  const auto y = divide(a.nx * b.p - b.nx * a.p, det);
  if (!x || !y) return std::nullopt;
  return BallPoint{*x, *y};
}

std::optional<BallPoint> filtered_crossing(const Carrier& a, const Carrier& b, Which which) {
  const auto* line_a = std::get_if<Line>(a.base.get());
  const auto* line_b = std::get_if<Line>(b.base.get());
  if (line_a && line_b) return filtered_crossing(balls(*line_a, a), balls(*line_b, b));
  if (line_a) {
    return filtered_crossing(balls(*line_a, a), balls(std::get<Circle>(*b.base), b), which);
  }
  const auto& circle_a = std::get<Circle>(*a.base);
  if (line_b) return filtered_crossing(balls(*line_b, b), balls(circle_a, a), which);
  return filtered_crossing(balls(circle_a, a), balls(std::get<Circle>(*b.base), b), which);
}

// --- the exact stage --------------------------------------------------------------------------

RationalPoint exact_crossing(const Line& a, const Line& b) {
  const Rational det = cross(a.normal().vector(), b.normal().vector());
  return {(a.p() * b.normal().y() - b.p() * a.normal().y()) / det,
          (a.normal().x() * b.p() - b.normal().x() * a.p()) / det};
}

/// The crossing that comes first along `heading`, a vector along the line through both.
ExactPoint pick(std::array<ExactPoint, 2> lexicographic, const Vector& heading, Which which) {
  const bool ascending = sgn(heading.x) != 0 ? sgn(heading.x) > 0 : sgn(heading.y) > 0;
  return std::move(lexicographic[(which == Which::Entry) == ascending ? 0 : 1]);
}

ExactPoint exact_crossing(const Line& line, const Circle& circle, Which which) {
  return pick(cgal::crossings(line, circle), line.direction().vector(), which);
}

ExactPoint exact_crossing(const Circle& a, const Circle& b, Which which) {
  const Vector left = turned_left(b.centre() - a.centre());
  return pick(cgal::crossings(a, b), a.counter_clockwise() ? left : -left, which);
}

/// Nearest approach or contact, found without roots where that is possible.
struct Nearness {
  OneRoot gap;  ///< negative when they cross
  ExactPoint on_a, on_b;
  bool anywhere = false;
};

Nearness nearness(const Line& line, const Circle& circle) {
  const Rational h = line.distance_to_left(circle.centre());
  const Rational r = abs(circle.radius());
  // The point of the circle nearest to the line lies on the normal, on the line's side.
  const RationalPoint on_circle = circle.centre() - (sgn(h) < 0 ? -r : r) * line.normal().vector();
  return {OneRoot(abs(h) - r), ExactPoint(line.foot(circle.centre())), ExactPoint(on_circle)};
}

/// The point of `circle` in the direction ±v from its centre, |v|² = square.
ExactPoint point_towards(const Circle& circle, const Vector& v, const Rational& square, int sense) {
  const Rational k = sense * abs(circle.radius()) / square;  // r/|v| = r·√square / square
  const RationalPoint& c = circle.centre();
  if (const auto length = exact_sqrt(square))
    return ExactPoint(RationalPoint{c.x + k * *length * v.x, c.y + k * *length * v.y});
  return {OneRoot(c.x, k * v.x, square), OneRoot(c.y, k * v.y, square)};
}

Nearness nearness(const Circle& a, const Circle& b) {
  const Vector v = b.centre() - a.centre();
  const Rational square = squared_length(v);
  const Rational ra = abs(a.radius());
  const Rational rb = abs(b.radius());
  if (sgn(square) == 0) {
    const RationalPoint at = a.centre() + Vector{ra, 0};
    return {OneRoot(abs(ra - rb)), ExactPoint(at), ExactPoint(b.centre() + Vector{rb, 0}), true};
  }
  const OneRoot distance =
      exact_sqrt(square) ? OneRoot(*exact_sqrt(square)) : OneRoot(0, 1, square);
  const OneRoot outside = distance - (ra + rb);
  const OneRoot inside = -distance + abs(ra - rb);
  if (compare(outside, inside) >= 0)
    return {outside, point_towards(a, v, square, 1), point_towards(b, v, square, -1)};
  const int sense = ra >= rb ? 1 : -1;  // nearest beyond the inner circle's centre
  return {inside, point_towards(a, v, square, sense), point_towards(b, v, square, sense)};
}

/// The point on the circle `a` and beside the circle `b` where they touch, as rationals: exact when
/// the contact is, since then the distance of the centres is |ra ± rb|.
RationalPoint contact_point(const Circle& a, const Circle& b, const Nearness& near) {
  const Vector v = b.centre() - a.centre();
  const Rational ra = abs(a.radius());
  const Rational rb = abs(b.radius());
  const Rational outer = ra + rb;
  const Rational square = squared_length(v);
  // Outer contact when the distance is nearer to ra + rb than to |ra − rb|.
  const bool outside = 2 * square > outer * outer + (ra - rb) * (ra - rb);
  const Rational reach = outside ? outer : Rational(ra - rb);
  if (reach * reach == square) return a.centre() + (ra / reach) * v;
  // In contact within the resolution: any rational that near to the nearest point serves.
  return {rational_within(near.on_a.x, 2 * kContactExponent),
          rational_within(near.on_a.y, 2 * kContactExponent)};
}

Meeting exact_meeting(const Line& a, const Line& b) {
  const Rational det = cross(a.normal().vector(), b.normal().vector());
  if (abs(det) > contact_resolution()) return OnePoint{Point(exact_crossing(a, b)), false};
  const bool along = sgn(dot(a.normal().vector(), b.normal().vector())) > 0;
  const Rational gap = abs(along ? Rational(a.p() - b.p()) : Rational(a.p() + b.p()));
  if (gap <= contact_resolution()) return Coincident{};
  const RationalPoint on_a = a.p() * a.normal().vector();
  return Apart{OneRoot(gap), ExactPoint(on_a), ExactPoint(b.foot(on_a)), true};
}

Apart apart(Nearness near) {
  return {std::move(near.gap), std::move(near.on_a), std::move(near.on_b), near.anywhere};
}

Meeting exact_meeting(const Carrier& a, const Carrier& b, const Line& line, const Circle& circle) {
  Nearness near = nearness(line, circle);
  if (!std::holds_alternative<Line>(*a.base)) std::swap(near.on_a, near.on_b);
  switch (verdict_of_gap(near.gap)) {
    case stages::Verdict::Crossing:
      return TwoPoints{a, b};
    case stages::Verdict::Contact:
      return OnePoint{Point(std::holds_alternative<Line>(*a.base) ? near.on_b : near.on_a), true};
    default:
      return apart(std::move(near));
  }
}

Meeting exact_meeting(const Carrier& a, const Carrier& b, const Circle& circle_a,
                      const Circle& circle_b) {
  const Vector v = circle_b.centre() - circle_a.centre();
  const Rational difference = abs(abs(circle_a.radius()) - abs(circle_b.radius()));
  if (abs(v.x) <= contact_resolution() && abs(v.y) <= contact_resolution() &&
      difference <= contact_resolution())
    return Coincident{};
  Nearness near = nearness(circle_a, circle_b);
  switch (verdict_of_gap(near.gap)) {
    case stages::Verdict::Crossing:
      return TwoPoints{a, b};
    case stages::Verdict::Contact:
      return OnePoint{Point(contact_point(circle_a, circle_b, near)), true};
    default:
      return apart(std::move(near));
  }
}

Meeting exact_meeting(const Carrier& a, const Carrier& b) {
  const Element ea = a.element();
  const Element eb = b.element();
  const auto* line_a = std::get_if<Line>(&ea);
  const auto* line_b = std::get_if<Line>(&eb);
  if (line_a && line_b) return exact_meeting(*line_a, *line_b);
  if (line_a) return exact_meeting(a, b, *line_a, std::get<Circle>(eb));
  if (line_b) return exact_meeting(a, b, *line_b, std::get<Circle>(ea));
  return exact_meeting(a, b, std::get<Circle>(ea), std::get<Circle>(eb));
}

}  // namespace

// --- Point ------------------------------------------------------------------------------------

Point::Point(const RationalPoint& p)
    : x_(nearest_double(OneRoot(p.x))),
      y_(nearest_double(OneRoot(p.y))),
      form_(std::make_shared<const Form>(p)) {}

Point::Point(const ExactPoint& p) : x_(nearest_double(p.x)), y_(nearest_double(p.y)) {
  if (p.is_rational())
    form_ = std::make_shared<const Form>(RationalPoint{p.x.a, p.y.a});
  else
    form_ = std::make_shared<const Form>(std::make_unique<const ExactPoint>(p));
}

Point Point::crossing(const Carrier& a, const Carrier& b, Which which) {
  Point point;
  point.form_ = std::make_shared<const Form>(Crossing{a, b, which});
  std::optional<double> x;
  std::optional<double> y;
  if (const auto filtered = filtered_crossing(a, b, which)) {
    x = filtered->x.nearest_double();
    y = filtered->y.nearest_double();
  }
  if (!x || !y) {
    const ExactPoint exact = point.exact();
    if (!x) x = nearest_double(exact.x);
    if (!y) y = nearest_double(exact.y);
  }
  point.x_ = *x;
  point.y_ = *y;
  return point;
}

Point Point::on_demand(double x, double y, std::function<ExactPoint()> exact) {
  Point point;
  point.x_ = x;
  point.y_ = y;
  point.form_ = std::make_shared<const Form>(std::move(exact));
  return point;
}

Point Point::decimal(std::int64_t x, std::int64_t y) {
  DGT_CHECK(std::abs(x) <= kMaxDecimalSteps && std::abs(y) <= kMaxDecimalSteps);
  static const Form kDecimal = Decimal{};
  constexpr auto kSteps = static_cast<double>(kDecimalStepsPerMillimetre);
  Point point;
  point.x_ = static_cast<double>(x) / kSteps;  // both are whole below 2⁵³: rounded once
  point.y_ = static_cast<double>(y) / kSteps;
  point.form_ = std::shared_ptr<const Form>(std::shared_ptr<const Form>(), &kDecimal);
  return point;
}

namespace {

/// The steps a double was rounded from. It is off by 2⁻⁵³ of its size and the product by as much
/// again, together by at most 2⁵⁰·2⁻⁵² = a quarter of a step.
Rational decimal_of(double x) {
  constexpr auto kSteps = static_cast<double>(Point::kDecimalStepsPerMillimetre);
  Rational value(static_cast<long>(std::llround(x * kSteps)), Point::kDecimalStepsPerMillimetre);
  value.canonicalize();
  return value;
}

}  // namespace

ExactPoint Point::exact() const {
  if (!form_) return ExactPoint(RationalPoint{0, 0});
  if (const auto* rational = std::get_if<RationalPoint>(form_.get())) return ExactPoint(*rational);
  if (const auto* crossing = std::get_if<Crossing>(form_.get()))
    return stages::exact_crossing(crossing->a.element(), crossing->b.element(), crossing->which);
  if (const auto* form = std::get_if<std::function<ExactPoint()>>(form_.get())) return (*form)();
  if (std::holds_alternative<Decimal>(*form_))
    return ExactPoint(RationalPoint{decimal_of(x_), decimal_of(y_)});
  return *std::get<std::unique_ptr<const ExactPoint>>(*form_);
}

bool operator==(const Point& a, const Point& b) {
  if (a.x_ != b.x_ || a.y_ != b.y_) return false;
  if (a.form_ == b.form_) return true;
  return same_place(a.exact(), b.exact());
}

// --- meet -------------------------------------------------------------------------------------

namespace stages {

Verdict filtered(const Carrier& a, const Carrier& b) {
  const auto* line_a = std::get_if<Line>(a.base.get());
  const auto* line_b = std::get_if<Line>(b.base.get());
  if (line_a && line_b) {
    const LineBalls la = balls(*line_a, a);
    const LineBalls lb = balls(*line_b, b);
    const Ball det = la.nx * lb.ny - la.ny * lb.nx;
    // Only clearly inclined lines are settled here.
    return std::fabs(det.mid) - det.rad > std::ldexp(2.0L, kContactExponent) ? Verdict::Crossing
                                                                             : Verdict::Unknown;
  }
  if (line_a || line_b) {
    const LineBalls line = line_a ? balls(*line_a, a) : balls(*line_b, b);
    const CircleBalls circle =
        line_a ? balls(std::get<Circle>(*b.base), b) : balls(std::get<Circle>(*a.base), a);
    const Ball h = line.nx * circle.x + line.ny * circle.y - line.p;
    return verdict_of_gap(absolute(h) - absolute(circle.r));
  }
  const CircleBalls ca = balls(std::get<Circle>(*a.base), a);
  const CircleBalls cb = balls(std::get<Circle>(*b.base), b);
  const Ball vx = cb.x - ca.x;
  const Ball vy = cb.y - ca.y;
  const auto distance = sqrt(vx * vx + vy * vy);
  if (!distance) return Verdict::Unknown;
  const Ball ra = absolute(ca.r);
  const Ball rb = absolute(cb.r);
  const Verdict outside = verdict_of_gap(*distance - (ra + rb));
  const Verdict inside = verdict_of_gap(absolute(ra - rb) - *distance);
  if (outside == Verdict::Apart || inside == Verdict::Apart) return Verdict::Apart;
  if (outside == Verdict::Crossing && inside == Verdict::Crossing) return Verdict::Crossing;
  return Verdict::Unknown;
}

Verdict exact(const Element& a, const Element& b) {
  const Meeting m = exact_meeting(carrier(a), carrier(b));
  if (const auto* one = std::get_if<OnePoint>(&m))
    return one->contact ? Verdict::Contact : Verdict::Crossing;
  if (std::holds_alternative<TwoPoints>(m)) return Verdict::Crossing;
  return std::holds_alternative<Apart>(m) ? Verdict::Apart : Verdict::Contact;
}

ExactPoint exact_crossing(const Element& a, const Element& b, Which which) {
  const auto* line_a = std::get_if<Line>(&a);
  const auto* line_b = std::get_if<Line>(&b);
  if (line_a && line_b) return ExactPoint(dgt::exact_crossing(*line_a, *line_b));
  if (line_a) return dgt::exact_crossing(*line_a, std::get<Circle>(b), which);
  if (line_b) return dgt::exact_crossing(*line_b, std::get<Circle>(a), which);
  return dgt::exact_crossing(std::get<Circle>(a), std::get<Circle>(b), which);
}

}  // namespace stages

Meeting meet(const Carrier& a, const Carrier& b) {
  if (stages::filtered(a, b) == stages::Verdict::Crossing) {
    if (a.is_line() && b.is_line()) return OnePoint{Point::crossing(a, b, Which::Entry), false};
    return TwoPoints{a, b};
  }
  return exact_meeting(a, b);
}

Meeting meet(const Element& a, const Element& b) { return meet(carrier(a), carrier(b)); }

Carrier carrier(const Element& e) { return {ElementPtr(e), nullptr}; }

}  // namespace dgt
