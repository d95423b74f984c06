// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/element.h"

#include <cmath>

namespace dgt {
namespace {

/// n·q − p, positive to the left.
OneRoot signed_distance(const Line& line, const ExactPoint& q) {
  return combine(line.normal().x(), q.x, line.normal().y(), q.y, -line.p());
}

/// |q − c|² as a one-root number over the root of q.
OneRoot squared_distance(const RationalPoint& c, const ExactPoint& q) {
  const auto squared = [](const OneRoot& d) {
    return OneRoot(d.a * d.a + d.b * d.b * d.c, 2 * d.a * d.b, d.c);
  };
  return combine(1, squared(q.x - c.x), 1, squared(q.y - c.y), 0);
}

class KnownElement final : public ElementSource {
 public:
  explicit KnownElement(Element element) : element_(std::move(element)) {}
  [[nodiscard]] const Element& element() const override { return element_; }

 private:
  Element element_;
};

}  // namespace

ElementPtr::ElementPtr(Element element)
    : source_(std::make_shared<const KnownElement>(std::move(element))) {}

const Element& ElementOnDemand::element() const {
  const Element* known = made_.load(std::memory_order_acquire);
  if (known != nullptr) return *known;
  auto fresh = std::make_unique<const Element>(make());
  // Where another thread was faster, `known` becomes what it made.
  if (made_.compare_exchange_strong(known, fresh.get(), std::memory_order_acq_rel))
    known = fresh.release();
  return *known;
}

UnitVector UnitVector::from_half_tangent(const Rational& t) {
  const Rational square = t * t;
  const Rational scale = 1 / (1 + square);
  return unchecked({(1 - square) * scale, 2 * t * scale});
}

Element reversed(const Element& e) {
  return std::visit([](const auto& x) { return Element(x.reversed()); }, e);
}

Element offset(const Element& e, const Rational& distance) {
  return std::visit([&](const auto& x) { return Element(x.offset(distance)); }, e);
}

int side_of(const Element& e, const ExactPoint& q) {
  if (const auto* line = std::get_if<Line>(&e)) return sign(signed_distance(*line, q));
  const auto& circle = std::get<Circle>(e);
  const int outside =
      compare(squared_distance(circle.centre(), q), Rational(circle.radius() * circle.radius()));
  return circle.counter_clockwise() ? -outside : outside;
}

double distance_to(const Element& e, const ExactPoint& q) {
  if (const auto* line = std::get_if<Line>(&e))
    return std::fabs(nearest_double(signed_distance(*line, q)));
  const auto& circle = std::get<Circle>(e);
  // |d − r| = |d² − r²| / (d + r): the difference is taken exactly, so nothing cancels.
  const OneRoot square = squared_distance(circle.centre(), q);
  const double from_centre = std::sqrt(nearest_double(square));
  const double radius = std::fabs(nearest_double(circle.radius()));
  const double difference = nearest_double(square - Rational(circle.radius() * circle.radius()));
  return std::fabs(difference) / (from_centre + radius);
}

}  // namespace dgt
