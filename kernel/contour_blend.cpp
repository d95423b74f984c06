// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "kernel/construct_bounds.h"
#include "kernel/contour_legs.h"

namespace dgt {
namespace {

using Kind = ContourFault::Kind;

ContourFault fault(Kind kind) {
  ContourFault f{};
  f.kind = kind;
  return f;
}

ContourFault fault(const Impossible& why) {
  ContourFault f = fault(Kind::Impossible);
  f.impossible = why;
  f.measure = why.measure;
  return f;
}

/// A fillet arc that touches both elements along their directions.
struct Candidate {
  Circle circle;
  /// Its sweep: past the half turn, then by the cosine, which falls as the sweep grows in the first
  /// half and rises in the second. Rational, since both contacts are.
  bool past_half = false;
  Rational cosine;
  double travel = 0;  ///< along `a` to its beginning; breaks ties
};

/// −1, 0, +1 by sweep; ideal ties differ by no more than the stand-ins do.
int compare_sweeps(const Candidate& x, const Candidate& y) {
  if (x.past_half != y.past_half) return x.past_half ? 1 : -1;
  const Rational difference = x.cosine - y.cosine;
  if (is_contact(difference)) return 0;
  return (sgn(difference) < 0) == x.past_half ? -1 : 1;
}

/// Travel in mm (line) or degrees (circle) from `start` to `to`. It only breaks ties between arcs
/// of equal sweep, whose beginnings lie far apart, so floating point decides as well as anything.
double travel_along(const Element& a, const Point& start, const RationalPoint& to) {
  const Point end(to);
  if (const auto* line = std::get_if<Line>(&a)) {
    const UnitVector d = line->direction();
    return (end.x() - start.x()) * nearest_double(d.x()) +
           (end.y() - start.y()) * nearest_double(d.y());
  }
  return std::fabs(coarse_sweep(std::get<Circle>(a), start, end));
}

std::optional<Candidate> candidate(const Element& a, const Element& b, const Circle& circle,
                                   const std::optional<Point>& start) {
  const RationalPoint begin = contact(circle, a);
  const Vector u = begin - circle.centre();
  const Vector v = contact(circle, b) - circle.centre();
  const Rational sine = circle.counter_clockwise() ? cross(u, v) : -cross(u, v);
  const Rational square = circle.radius() * circle.radius();
  Candidate c{circle, sgn(sine) < 0, dot(u, v) / square, 0};
  if (is_contact(sine / square) && sgn(c.cosine) > 0) return std::nullopt;  // already in contact
  if (start) c.travel = travel_along(a, *start, begin);
  return c;
}

}  // namespace

std::variant<Blend, ContourFault> fillet_between(const Element& a, const Element& b,
                                                 const Rational& radius,
                                                 const std::optional<Point>& start, bool next) {
  if (sgn(radius) == 0) return fault(Kind::ZeroValue);
  const bool lines = std::holds_alternative<Line>(a) && std::holds_alternative<Line>(b);
  std::vector<Rational> senses{radius};
  if (sgn(radius) > 0) senses.push_back(-radius);
  std::vector<Selector> selectors{lines ? Selector::Default : Selector::I1};
  if (!lines) selectors.push_back(Selector::I2);

  std::vector<Candidate> candidates;
  std::optional<Impossible> nearest_failure;
  for (const Rational& r : senses) {
    for (const Selector selector : selectors) {
      const Construction<Circle> made = touching(a, b, r, selector);
      if (const auto* no = std::get_if<Impossible>(&made)) {
        if (!nearest_failure || no->measure < nearest_failure->measure) nearest_failure = *no;
        continue;
      }
      const Circle& circle = std::get<Constructed<Circle>>(made).value;
      const bool known = std::any_of(candidates.begin(), candidates.end(),
                                     [&](const auto& c) { return c.circle == circle; });
      if (known) continue;
      if (auto c = candidate(a, b, circle, start)) candidates.push_back(std::move(*c));
    }
  }
  if (candidates.empty()) return nearest_failure ? fault(*nearest_failure) : fault(Kind::ZeroArc);
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& x, const auto& y) {
    const int by_sweep = compare_sweeps(x, y);
    return by_sweep != 0 ? by_sweep < 0 : x.travel < y.travel;
  });
  if (next && candidates.size() < 2) return fault(Kind::NoChoice);
  return Blend{ElementPtr(candidates[next ? 1 : 0].circle), true};
}

std::variant<Blend, ContourFault> chamfer_between(const Element& a, const Element& b,
                                                  const Rational& leg) {
  const auto* first = std::get_if<Line>(&a);
  const auto* second = std::get_if<Line>(&b);
  if (!first || !second) return fault(Kind::BevelKinds);
  if (sgn(leg) <= 0) return fault(Kind::ZeroValue);
  const Construction<KnownPoint> corner = meeting_point(a, b, Selector::Default);
  if (const auto* no = std::get_if<Impossible>(&corner)) return fault(*no);
  const RationalPoint& at = std::get<Constructed<KnownPoint>>(corner).value.stand_in;
  const RationalPoint begin = at - leg * first->direction().vector();
  const RationalPoint end = at + leg * second->direction().vector();
  const Construction<Line> line = line_through(known_point(begin), known_point(end));
  if (const auto* no = std::get_if<Impossible>(&line)) return fault(*no);
  return Blend{ElementPtr(std::get<Constructed<Line>>(line).value), false};
}

std::variant<Blend, ContourFault> tangent_between(const Element& a, const Element& b) {
  const auto* first = std::get_if<Circle>(&a);
  const auto* second = std::get_if<Circle>(&b);
  if (!first || !second) return fault(Kind::BevelKinds);
  const Construction<Line> line = common_tangent(*first, *second);
  if (const auto* no = std::get_if<Impossible>(&line)) return fault(*no);
  return Blend{ElementPtr(std::get<Constructed<Line>>(line).value), true};
}

}  // namespace dgt
