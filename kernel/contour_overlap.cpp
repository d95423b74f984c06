// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fillets and chamfers that need more of an element than the contour leaves them.
//
// Nouns. The *corner* at an end of a leg is where it would end were there no blend: where its
// element crosses the one behind the blend. The *contact* is where the blend begins or ends on it.
// Contacts that lie the wrong way round between corners that lie the right way round are a leg too
// short for its blends. Corners that lie the wrong way round too are an element that is run against
// its direction, which has a notice of its own.
#include <cmath>
#include <numbers>

#include "kernel/contour_path.h"

namespace dgt {
namespace {

bool is_blend(const Leg& leg) {
  return leg.role == Role::Fillet || leg.role == Role::Chamfer || leg.role == Role::Tangent;
}

/// Where the two cross; nothing where they do not.
std::vector<Point> crossings(const Element& a, const Element& b) {
  const Meeting meeting = meet(a, b);
  if (const auto* one = std::get_if<OnePoint>(&meeting)) return {one->at};
  if (const auto* two = std::get_if<TwoPoints>(&meeting))
    return {two->at(Which::Entry), two->at(Which::Exit)};
  return {};
}

/// The element that the blend `next` joins `leg` to; null where it is none.
const Element* behind(const Leg& next, const Joint& far) {
  return std::visit(
      [&](const auto& rule) -> const Element* {
        if constexpr (requires { rule.a; })
          return (rule.a.element == next.element.element ? rule.b : rule.a).element.get();
        else
          return nullptr;
      },
      far.rule);
}

/// From `from` to `to` along `line`, in mm, negative against it. Of several corners it picks the
/// nearest; which side of a point a corner lies on is decided by motion_along().
double way_along(const Line& line, const Point& from, const Point& to) {
  return motion_along(line, from, to) * std::hypot(to.x() - from.x(), to.y() - from.y());
}

/// The shorter way round from `from` to `to` in degrees, positive in the sense of the circle.
double way_round(const Circle& circle, const Point& from, const Point& to) {
  if (indistinct(from, to)) return 0;
  const double way = std::fabs(coarse_sweep(circle, from, to));
  return way > 180 ? way - 360 : way;
}

}  // namespace

/// An end of a leg. Both points are the same where no blend stands.
struct Path::LegEnd {
  const Leg* blend = nullptr;
  Point contact;
  std::optional<Point> corner;
  /// Not known: the leg ends at no element. Known without a corner: behind the blend lies an
  /// element that does not cross the leg's, however far one goes.
  bool known = false;
};

/// `way` +1: where the leg ends, −1: where it begins.
Path::LegEnd Path::end_of(const Leg& leg, int way) const {
  const Joint& own = legs_.joints[way > 0 ? leg.to : leg.from];
  const Leg* const next = beside(leg, way);
  LegEnd end{nullptr, own.programmed, std::nullopt, false};
  if (!next || !is_blend(*next)) {
    end.known = std::holds_alternative<CrossJoint>(own.rule);
    if (end.known) end.corner = own.programmed;
    return end;
  }
  end.blend = next;
  const Element* const other = behind(*next, legs_.joints[way > 0 ? next->to : next->from]);
  if (!other) return end;
  end.known = true;
  const auto* const line = std::get_if<Line>(leg.element.element.get());
  double nearest = 0;
  for (const Point& at : crossings(*leg.element.element, *other)) {
    // A blend leaves a line before the corner, unless it loops round it; of an arc either side.
    const double ahead =
        line ? way * way_along(*line, end.contact, at)
             : way * way_round(std::get<Circle>(*leg.element.element), end.contact, at);
    const double cost = line && ahead < 0 ? HUGE_VAL : std::fabs(ahead);
    if (end.corner && cost >= nearest) continue;
    end.corner = at;
    nearest = cost;
  }
  return end;
}

void Path::check_blends(const Leg& leg, const Move& move) {
  if (leg.full_circle || is_blend(leg)) return;
  const auto* const line = std::get_if<Line>(leg.element.element.get());
  const auto* const circle = std::get_if<Circle>(leg.element.element.get());
  // Run backwards; the other way round, an arc that should have vanished is almost a full turn.
  const double sweep = line ? 0 : std::fabs(coarse_sweep(*circle, move.from, move.to));
  if (line ? motion_along(*line, move.from, move.to) >= 0 : sweep < 180) return;
  const LegEnd from = end_of(leg, -1);
  const LegEnd to = end_of(leg, +1);
  if ((!from.blend && !to.blend) || !from.known || !to.known) return;
  if (line) {
    const bool right_way =
        !from.corner || !to.corner || motion_along(*line, *from.corner, *to.corner) > 0;
    if (right_way) report(ContourFault::Kind::BlendsOverlap, leg.element.item, dgt::length(move));
    return;
  }
  if (!from.corner || !to.corner || indistinct(*from.corner, *to.corner)) return;
  // What the blends leave between the corners is the sweep of the leg, or that less a full turn:
  // a difference that floating point cannot mistake.
  const double left = std::fabs(coarse_sweep(*circle, *from.corner, *to.corner)) -
                      way_round(*circle, *from.corner, from.contact) -
                      way_round(*circle, to.contact, *to.corner);
  if (left > sweep - 180) return;
  const double lacking = (360 - sweep) * std::numbers::pi / 180;
  report(ContourFault::Kind::BlendsOverlap, leg.element.item,
         lacking * std::fabs(nearest_double(circle->radius())));
}

/// The leg before or after, dwells and codes passed over; null where there is none.
const Leg* Path::beside(const Leg& leg, int way) const {
  const auto count = static_cast<std::ptrdiff_t>(legs_.legs.size());
  for (auto i = &leg - legs_.legs.data() + way; i >= 0 && i < count; i += way) {
    const Leg& found = legs_.legs[static_cast<std::size_t>(i)];
    if (found.travel != Leg::Travel::Stop) return &found;
  }
  return nullptr;
}

}  // namespace dgt
