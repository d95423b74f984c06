// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/snapping.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace dgt {
namespace {

/// Whether a place of the circle lies on the arc; the ends do.
bool is_on(const DrawnCurve& arc, DrawnPlace place) {
  const NearestPlace nearest = nearest_place(arc, place);
  return nearest.part > 0 && nearest.part < 1;
}

/// Keeps the nearest of the places it is shown.
class Choice {
 public:
  Choice(DrawnPlace pointer, double reach) : pointer_(pointer), same_(reach / 1000), least_(reach) {
    snap_.at = pointer;
  }
  void offer(SnapKind kind, DrawnPlace at, const DrawnCurve& curve) {
    const double far = distance(at, pointer_);
    const bool is_nearer = snap_.kind == SnapKind::Free ? far <= least_ : far < least_ - same_;
    if (!is_nearer) return;
    least_ = far;
    snap_ = {kind, at, curve};
  }
  [[nodiscard]] bool is_free() const { return snap_.kind == SnapKind::Free; }
  [[nodiscard]] const Snap& snap() const { return snap_; }

 private:
  DrawnPlace pointer_;
  double same_;
  double least_;
  Snap snap_;
};

Box around(DrawnPlace p, double reach) {
  return {p.x - reach, p.y - reach, p.x + reach, p.y + reach};
}

void offer_places(Choice& choice, const DrawnCurve& curve, const std::optional<DrawnPlace>& from) {
  choice.offer(SnapKind::End, curve.from, curve);
  choice.offer(SnapKind::End, curve.to, curve);
  choice.offer(SnapKind::Middle, place_at(curve, 0.5), curve);
  if (!from) return;
  for (const DrawnPlace& at : tangent_places(curve, *from))
    choice.offer(SnapKind::Tangent, at, curve);
  for (const DrawnPlace& at : perpendicular_places(curve, *from))
    choice.offer(SnapKind::Perpendicular, at, curve);
}

}  // namespace

Snap snap(const std::vector<const DrawnLayer*>& layers, DrawnPlace pointer, double reach,
          const std::optional<DrawnPlace>& from) {
  const Box window = around(pointer, reach);
  Choice choice(pointer, reach);
  Choice nearest(pointer, reach);
  for (const DrawnLayer* layer : layers) {
    layer->visit(window, [&](std::size_t i) {
      const DrawnCurve curve = (*layer)[i];
      if (!overlap(box_around(curve), window)) return;
      offer_places(choice, curve, from);
      nearest.offer(SnapKind::OnMove, nearest_place(curve, pointer).at, curve);
    });
    layer->visit_centres(window, [&](const DrawnLayer::Centre& centre) {
      choice.offer(SnapKind::Centre, centre.at, (*layer)[centre.curve]);
    });
  }
  return choice.is_free() ? nearest.snap() : choice.snap();
}

// With d the distance of the place from the centre, the radius to the tangent place makes an angle
// of cosine r/d with the way there.
std::vector<DrawnPlace> tangent_places(const DrawnCurve& arc, DrawnPlace from) {
  const DrawnPlace way = from - arc.centre;
  const double far = distance(from, arc.centre);
  if (!arc.is_arc() || far <= arc.radius) return {};
  const double cosine = arc.radius / far;
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  const DrawnPlace out = (1 / far) * way;
  std::vector<DrawnPlace> places;
  for (const double side : {1.0, -1.0}) {
    const DrawnPlace at = arc.centre + arc.radius * (cosine * out + side * sine * turned_left(out));
    if (is_on(arc, at)) places.push_back(at);
  }
  return places;
}

std::vector<DrawnPlace> perpendicular_places(const DrawnCurve& curve, DrawnPlace from) {
  std::vector<DrawnPlace> places;
  const auto offer = [&](DrawnPlace opposite) {
    const NearestPlace foot = nearest_place(curve, opposite);
    if (foot.part > 0 && foot.part < 1) places.push_back(foot.at);
  };
  offer(from);
  // The far side of a circle; the line through the centre meets it at right angles too.
  if (curve.is_arc()) offer(2 * curve.centre - from);
  return places;
}

Measurement measured(DrawnPlace from, DrawnPlace to) {
  const DrawnPlace way = to - from;
  double degrees = std::atan2(way.y, way.x) * 180 / std::numbers::pi;
  if (degrees == -180) degrees = 180;
  return {way.x, way.y, distance(from, to), degrees};
}

}  // namespace dgt
