// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "kernel/construct.h"
#include "kernel/construct_bounds.h"

namespace dgt {
namespace {

Constructed<Circle> capped(Circle circle, double bound) {
  Constructed<Circle> result{std::move(circle), bound, 0};
  cap_height(result);
  return result;
}

Impossible why(Impossible::Why reason, double measure = 0) { return {reason, measure}; }

/// −1 or +1: which of the centres base ± √X·along the selector means, the minus being I1.
std::variant<int, Impossible> sense_of(Selector selector, const Vector& along) {
  const auto by = [&](const Rational& component, int wanted) -> std::variant<int, Impossible> {
    if (sgn(component) == 0) return why(Impossible::Why::EqualCandidates);
    return wanted * sgn(component);
  };
  switch (selector) {
    case Selector::Default:
    case Selector::I1:
      return -1;
    case Selector::I2:
      return 1;
    case Selector::GreaterX:
      return by(along.x, 1);
    case Selector::SmallerX:
      return by(along.x, -1);
    case Selector::GreaterY:
      return by(along.y, 1);
    case Selector::SmallerY:
      return by(along.y, -1);
  }
  return -1;
}

/// Bits of the whole part of |a/b|, at least 0: how much finer b's share must be.
int excess_bits(const Rational& a, const Rational& b) {
  const Rational q = abs(a / b);
  const auto bits = [](const Integer& n) {
    return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2));
  };
  return std::max(0, bits(q.get_num()) - bits(q.get_den()) + 1);
}

/// An upper bound of how far the two miss oriented contact, 0 when they do not: of the distance D
/// of the centres and the difference δ ≠ 0 of the radii, |D − |δ|| ≤ |D² − δ²| / |δ|.
Rational contact_error(const Circle& a, const Circle& b) {
  const Rational difference = a.radius() - b.radius();
  return abs((squared_length(a.centre() - b.centre()) - difference * difference) / difference);
}

/// Of the triangle 0, a, b over its longest side: how far its middle corner lies from the line of
/// the others, to within the square of the contact resolution.
Rational height_of_triangle(const Vector& a, const Vector& b) {
  const Rational area = cross(a, b);
  const Rational longest = std::max({squared_length(a), squared_length(b), squared_length(a - b)});
  return sqrt_within(area * area / longest, 2 * kContactExponent);
}

}  // namespace

Construction<Circle> circle_about(const KnownPoint& centre, const Rational& radius) {
  if (sgn(radius) == 0) return why(Impossible::Why::ZeroRadius);
  return capped(Circle(centre.stand_in, radius), 0);
}

Construction<Circle> circle_through(const KnownPoint& p, const KnownPoint& q, const KnownPoint& r,
                                    int bits) {
  const RationalPoint& anchor = p.stand_in;
  const Vector a = q.stand_in - anchor;
  const Vector b = r.stand_in - anchor;
  if (within_contact(a)) return why(Impossible::Why::CoincidentPoints, length(a));
  if (within_contact(b)) return why(Impossible::Why::CoincidentPoints, length(b));
  if (within_contact(a - b)) return why(Impossible::Why::CoincidentPoints, length(a - b));
  const Rational twice_area = 2 * cross(a, b);
  if (const Rational off = height_of_triangle(a, b); is_contact(off))
    return why(Impossible::Why::CollinearPoints, nearest_double(off));
  // The centre relative to p solves 2a·m = a², 2b·m = b².
  const Rational aa = squared_length(a);
  const Rational bb = squared_length(b);
  const Vector m{(aa * b.y - bb * a.y) / twice_area, (bb * a.x - aa * b.x) / twice_area};
  const Rational square = squared_length(m);
  if (const auto radius = exact_sqrt(square)) return capped(Circle(anchor + m, *radius), 0);
  // Exact through p: the centre lies a rational radius away from it in a rational direction.
  const int exponent = -(bits + 8);
  const Direction u = direction_of(m, bits + 8);
  const Rational radius = sqrt_within(square, exponent);
  const double bound = 2 * std::ldexp(1.0, exponent) + u.bound * upper_bound(radius);
  return capped(Circle(anchor + radius * u.unit.vector(), radius), bound);
}

Construction<Circle> touching(const Line& a, const Line& b, const Rational& radius) {
  if (sgn(radius) == 0) return why(Impossible::Why::ZeroRadius);
  const Meeting loci = meet(Element(a.offset(radius)), Element(b.offset(radius)));
  if (const auto* crossing = std::get_if<OnePoint>(&loci)) {
    const ExactPoint centre = crossing->at.exact();
    return capped(Circle({centre.x.a, centre.y.a}, radius), 0);
  }
  if (const auto* apart = std::get_if<Apart>(&loci))
    return why(Impossible::Why::ParallelLines, nearest_double(apart->gap));
  return why(Impossible::Why::AlwaysTouching);
}

Construction<Circle> touching(const Line& line, const Circle& circle, const Rational& radius,
                              Selector selector, int bits) {
  if (sgn(radius) == 0) return why(Impossible::Why::ZeroRadius);
  // In the frame of the line about the circle's centre, the centres (x, y) of all circles that
  // touch both form the parabola x² = k² + 2ky with k = h − r1; their radius is y + h.
  const RationalPoint& focus = circle.centre();
  const Vector& normal = line.normal().vector();
  const Vector direction = line.direction().vector();
  const Rational h = line.distance_to_left(focus);
  const Rational k = h - circle.radius();
  const Rational y = radius - h;
  if (is_contact(k))  // they touch already: the centre lies on the normal at the contact
    return capped(Circle(focus + y * normal, radius), sgn(k) == 0 ? 0 : upper_bound(k));
  const Rational square = k * k + 2 * k * y;
  const Rational gap = abs(y) - abs(circle.radius() - radius);  // between the loci
  if (!is_contact(gap) && sgn(square) < 0)
    return why(Impossible::Why::NoTouchingCircle, nearest_double(gap));
  const auto sense = sense_of(selector, direction);
  if (const auto* no = std::get_if<Impossible>(&sense); no && !is_contact(gap)) return *no;

  Rational x = 0;
  double off = 0;
  if (!is_contact(gap)) {
    const int* s = std::get_if<int>(&sense);
    if (const auto root = exact_sqrt(square)) {
      x = *s * *root;
    } else {
      // y and the radius move by x δx / k: refine by as many bits as x exceeds k, and as 1 exceeds
      // r.
      const int exponent = -(bits + 8 + excess_bits(square, k * k) + excess_bits(1, radius));
      x = *s * sqrt_within(square, exponent);
      off = std::ldexp(1.0, exponent);
    }
  }
  const Rational on_parabola = (x * x - k * k) / (2 * k);
  const Rational moved = on_parabola - y;
  if (sgn(moved) != 0) off += 2 * upper_bound(moved);
  return capped(Circle(focus + x * direction + on_parabola * normal, on_parabola + h), off);
}

Construction<Circle> touching(const Circle& a, const Circle& b, const Rational& radius,
                              Selector selector, int bits) {
  if (sgn(radius) == 0) return why(Impossible::Why::ZeroRadius);
  if (a.radius() == radius || b.radius() == radius) return why(Impossible::Why::SameElement);
  const Vector d = a.centre() - b.centre();
  if (within_contact(d)) {
    if (is_contact(abs(a.radius() - radius) - abs(b.radius() - radius)))
      return why(Impossible::Why::AlwaysTouching);
    return why(Impossible::Why::ConcentricCircles,
               std::fabs(nearest_double(Rational(abs(a.radius()) - abs(b.radius())))));
  }
  if (in_oriented_contact(a, b)) {
    const Rational difference = a.radius() - b.radius();
    const Vector n = (1 / difference) * d;
    // The contacts are off by | |n| − 1 | ≤ | n² − 1 | times the way to either centre.
    const Rational reach = abs(radius - a.radius()) + abs(difference);
    const Rational off = reach * (squared_length(n) - 1);
    return capped(Circle(a.centre() + (radius - a.radius()) * n, radius),
                  sgn(off) == 0 ? 0 : upper_bound(off));
  }
  // The locus about each centre is directed as the circle it comes from.
  Rational locus_radius = abs(a.radius() - radius);
  if (!a.counter_clockwise()) locus_radius = -locus_radius;
  const Meeting loci = meet(Element(Circle(a.centre(), locus_radius)),
                            Element(Circle(b.centre(), abs(b.radius() - radius))));
  if (const auto* apart = std::get_if<Apart>(&loci))
    return why(Impossible::Why::NoTouchingCircle, nearest_double(apart->gap));
  DGT_CHECK(!std::holds_alternative<Coincident>(loci));  // their centres are apart
  if (const auto* one = std::get_if<OnePoint>(&loci)) {
    const ExactPoint centre = one->at.exact();
    const RationalPoint at{rational_within(centre.x, 2 * kContactExponent),
                           rational_within(centre.y, 2 * kContactExponent)};
    const Rational off =
        contact_error(a, Circle(at, radius)) + contact_error(b, Circle(at, radius));
    return capped(Circle(at, radius), sgn(off) == 0 ? 0 : upper_bound(off));
  }
  const auto& two = std::get<TwoPoints>(loci);
  const auto which = choose(two, Which::Entry, selector);
  if (const auto* no = std::get_if<Impossible>(&which)) return *no;
  ExactPoint centre = two.at(std::get<Which>(which)).exact();
  const Rational& root = centre.x.is_rational() ? centre.y.c : centre.x.c;
  if (const auto rational = exact_sqrt(root)) {
    return capped(
        Circle({centre.x.a + centre.x.b * *rational, centre.y.a + centre.y.b * *rational}, radius),
        0);
  }
  // Any rational unit vector u near (c − c1)/(r1 − R) keeps both contacts exact; R moves a little.
  const Rational reach = a.radius() - radius;
  OneRoot ux = (centre.x - a.centre().x) * Rational(sgn(reach));
  OneRoot uy = (centre.y - a.centre().y) * Rational(sgn(reach));
  const Rational size = abs(radius) < 1 ? abs(radius) : Rational(1);
  for (int fine = bits + 8;; fine *= 2) {
    DGT_CHECK(fine < 100000);
    const Direction u = direction_of(ux, uy, fine);
    const Rational along = dot(d, u.unit.vector());
    const Rational denominator = 2 * (along + a.radius() - b.radius());
    if (sgn(denominator) == 0) continue;
    const Rational r = (squared_length(d) + 2 * a.radius() * along + a.radius() * a.radius() -
                        b.radius() * b.radius()) /
                       denominator;
    const Rational moved = abs(r - radius);
    if (moved > size * power_of_two(-(bits + 1)) || sgn(r) != sgn(radius)) continue;
    return capped(Circle(a.centre() + (a.radius() - r) * u.unit.vector(), r),
                  2 * upper_bound(moved) + u.bound * upper_bound(reach));
  }
}

Construction<Circle> touching(const Element& a, const Element& b, const Rational& radius,
                              Selector selector, int bits) {
  const auto* line_a = std::get_if<Line>(&a);
  const auto* line_b = std::get_if<Line>(&b);
  if (line_a && line_b) {
    if (selector != Selector::Default) return why(Impossible::Why::NoChoice);
    return touching(*line_a, *line_b, radius);
  }
  if (line_a) return touching(*line_a, std::get<Circle>(b), radius, selector, bits);
  if (line_b) return touching(*line_b, std::get<Circle>(a), radius, selector, bits);
  return touching(std::get<Circle>(a), std::get<Circle>(b), radius, selector, bits);
}

Construction<Circle> circle_polar(const KnownPoint& point, const Rational& distance,
                                  const Rational& degrees, const Rational& radius, int bits) {
  const Constructed<KnownPoint> centre = point_polar(point, distance, degrees, bits);
  Construction<Circle> result = circle_about(centre.value, radius);
  if (auto* made = std::get_if<Constructed<Circle>>(&result)) made->bound += centre.bound;
  return result;
}

}  // namespace dgt
