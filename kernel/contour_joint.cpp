// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "kernel/construct_bounds.h"
#include "kernel/contour_legs.h"

namespace dgt {
namespace {

using Kind = ContourFault::Kind;

/// Where a joint's rational stand-in of an irrational point lies beside it.
constexpr int kFootExponent = -160;

Carrier carried(const UsedElement& used, const Shifts& shifts) {
  return {used.element, shifts[used.step]};
}

ContourFault fault(Kind kind, std::size_t item, std::size_t other, double measure) {
  ContourFault f{};
  f.kind = kind;
  f.item = item;
  f.other = other;
  f.measure = measure;
  return f;
}

/// A joint of two carriers: their crossing, their contact, or the nearest point of a near miss,
/// taken on an arc where one is among them.
PlacedJoint crossing_of(const Carrier& a, const Carrier& b, Which which, std::size_t item,
                        std::size_t other, const ContourOptions& options) {
  const Meeting meeting = meet(a, b);
  PlacedJoint joint;
  if (const auto* two = std::get_if<TwoPoints>(&meeting)) {
    joint.at = two->at(which);
  } else if (const auto* one = std::get_if<OnePoint>(&meeting)) {
    joint.at = one->at;
  } else if (const auto* apart = std::get_if<Apart>(&meeting)) {
    const double gap = nearest_double(apart->gap);
    if (apart->anywhere || compare(apart->gap, options.join_tolerance) > 0) {
      joint.fault = fault(Kind::NoMeeting, item, other, gap);
    } else {
      joint.at = Point(a.is_line() ? apart->on_b : apart->on_a);
      joint.notice = ContourNotice{ContourNotice::Kind::JoinedGap, item, other, gap};
    }
  } else {
    joint.fault = fault(Kind::SameElement, item, other, 0);
  }
  return joint;
}

struct Placer {
  const Shifts& shifts;
  const ContourOptions& options;

  PlacedJoint operator()(const FixedJoint& j) const { return {j.at, {}, {}}; }
  PlacedJoint operator()(const FootJoint& j) const {
    return {Point(foot_of_normal(carried(j.on, shifts).element(), j.from)), {}, {}};
  }
  PlacedJoint operator()(const CrossJoint& j) const {
    return crossing_of(carried(j.a, shifts), carried(j.b, shifts), j.which, j.a.item, j.b.item,
                       options);
  }
  PlacedJoint operator()(const TangentJoint& j) const {
    return {Point(contact(carried(j.a, shifts).element(), carried(j.b, shifts).element())), {}, {}};
  }
  PlacedJoint operator()(const AxisJoint& j) const {
    return crossing_of(carried(j.on, shifts), {j.axis, nullptr}, j.which, j.on.item, j.on.item,
                       options);
  }
  PlacedJoint operator()(const BesideJoint& j) const {
    const RationalPtr& shift = shifts[j.on.step];
    if (!shift) return {j.at, {}, {}};
    const Vector& n = std::get<Line>(*j.on.element).normal().vector();
    const ExactPoint at = j.at.exact();
    return {Point(ExactPoint(at.x + *shift * n.x, at.y + *shift * n.y)), {}, {}};
  }
};

}  // namespace

RationalPoint rational_near(const Point& p) {
  const ExactPoint exact = p.exact();
  return {rational_within(exact.x, kFootExponent), rational_within(exact.y, kFootExponent)};
}

PlacedJoint place_joint(const Joint& joint, const Shifts& shifts, const ContourOptions& options) {
  return std::visit(Placer{shifts, options}, joint.rule);
}

ExactPoint foot_of_normal(const Element& element, const Point& from) {
  if (const auto* line = std::get_if<Line>(&element)) {
    const ExactPoint q = from.exact();
    const Vector& n = line->normal().vector();
    // q − (n·q − p) n, coordinate by coordinate in the field of q.
    return {combine(1 - n.x * n.x, q.x, -n.x * n.y, q.y, line->p() * n.x),
            combine(-n.x * n.y, q.x, 1 - n.y * n.y, q.y, line->p() * n.y)};
  }
  const auto& circle = std::get<Circle>(element);
  const RationalPoint& c = circle.centre();
  const Vector v = rational_near(from) - c;
  const Rational square = squared_length(v);
  const Rational radius = abs(circle.radius());
  if (const auto root = exact_sqrt(square)) return ExactPoint(c + (radius / *root) * v);
  const Rational k = radius / square;
  return {OneRoot(c.x, k * v.x, square), OneRoot(c.y, k * v.y, square)};
}

bool lies_on(const Element& element, const Point& p) {
  if (const auto* line = std::get_if<Line>(&element))
    return is_contact(line->distance_to_left(rational_near(p)));
  return on_circle(std::get<Circle>(element), {p.exact(), rational_near(p), 0});
}

bool indistinct(const Point& a, const Point& b) {
  return std::fabs(a.x() - b.x()) <= kLegResolution && std::fabs(a.y() - b.y()) <= kLegResolution;
}

double coarse_sweep(const Circle& circle, const Point& from, const Point& to) {
  const double cx = nearest_double(circle.centre().x);
  const double cy = nearest_double(circle.centre().y);
  double sweep = std::atan2(to.y() - cy, to.x() - cx) - std::atan2(from.y() - cy, from.x() - cx);
  const double turn = 2 * std::numbers::pi;
  if (circle.counter_clockwise() && sweep < 0) sweep += turn;
  if (!circle.counter_clockwise() && sweep > 0) sweep -= turn;
  return sweep * 180 / std::numbers::pi;
}

}  // namespace dgt
