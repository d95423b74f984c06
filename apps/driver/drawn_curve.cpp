// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/drawn_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/check.h"

namespace dgt {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double dot(DrawnPlace a, DrawnPlace b) { return a.x * b.x + a.y * b.y; }
double cross(DrawnPlace a, DrawnPlace b) { return a.x * b.y - a.y * b.x; }

DrawnPlace unit(DrawnPlace v) {
  const double length = std::hypot(v.x, v.y);
  return length > 0 ? (1 / length) * v : DrawnPlace{1, 0};
}

/// The angle between the two ends of an arc, without sign. Of a flat arc the chord tells it to a
/// few ulps; its angles about a far centre would not.
double swept(const DrawnCurve& arc, int half_turn) {
  constexpr double kFlat = 0.7;  // sine of half the angle: below it the arc sine is well behaved
  const double sine = distance(arc.from, arc.to) / (2 * arc.radius);
  double angle = 0;
  if (sine < kFlat) {
    angle = 2 * std::asin(sine);
  } else {
    const DrawnPlace a = arc.from - arc.centre;
    const DrawnPlace b = arc.to - arc.centre;
    angle = std::fabs(std::atan2(cross(a, b), dot(a, b)));
  }
  return half_turn > 0 ? kTurn - angle : angle;
}

/// `anchor` turned about the centre of the arc: the chord it moves along is added to it.
DrawnPlace turned(const DrawnCurve& arc, DrawnPlace anchor, double angle) {
  const DrawnPlace out = unit(anchor - arc.centre);
  const double sine = std::sin(angle / 2);
  const double cosine = std::cos(angle / 2);
  return anchor + 2 * arc.radius * sine * (cosine * turned_left(out) - sine * out);
}

/// How far an arc bulges beyond its chord, which turns by `angle`.
double bulge(double radius, double angle) {
  const double sine = std::sin(angle / 4);
  return 2 * radius * sine * sine;
}

/// Radians from the beginning of the arc to the place opposite `to`, along the arc, 0…2π. Reckoned
/// from the beginning, so that a far centre does no harm.
double turn_to(const DrawnCurve& arc, DrawnPlace to) {
  const DrawnPlace out = unit(arc.from - arc.centre);
  const DrawnPlace way = to - arc.from;
  double angle = std::atan2(cross(out, way), arc.radius + dot(out, way));
  if (arc.sweep < 0) angle = -angle;
  return angle < 0 ? angle + kTurn : angle;
}

Box box_of_ends(DrawnPlace a, DrawnPlace b, double grown) {
  return {std::min(a.x, b.x) - grown, std::min(a.y, b.y) - grown, std::max(a.x, b.x) + grown,
          std::max(a.y, b.y) + grown};
}

/// One arc being flattened: halves are taken until they are flat or outside.
struct Flattening {
  const DrawnCurve& arc;
  const Box& window;
  double tolerance;
  std::vector<DrawnPlace>& corners;

  void add(double begin, DrawnPlace from, double end, DrawnPlace to) {
    const double rise = bulge(arc.radius, (end - begin) * arc.sweep);
    // An arc of at most half a turn lies within its rise of the chord, and so in this box.
    if (rise <= tolerance || !overlap(box_of_ends(from, to, rise), window)) {
      corners.push_back(to);
      return;
    }
    const double middle = begin + (end - begin) / 2;
    const DrawnPlace half_way = place_at(arc, middle);
    add(begin, from, middle, half_way);
    add(middle, half_way, end, to);
  }
};

}  // namespace

double distance(DrawnPlace a, DrawnPlace b) { return std::hypot(a.x - b.x, a.y - b.y); }

double DrawnCurve::length() const {
  return is_arc() ? radius * std::fabs(sweep) : distance(from, to);
}

DrawnCurve drawn(const Move& move) {
  DrawnCurve curve{{move.from.x(), move.from.y()}, {move.to.x(), move.to.y()}, {}, 0, 0};
  if (move.kind != MoveKind::Arc) return curve;
  const ArcFigures arc = figures(move);
  curve.centre = {arc.centre_x, arc.centre_y};
  curve.radius = arc.radius;
  curve.sweep = move.full_circle ? kTurn : swept(curve, half_turn_order(move));
  if (!arc.counter_clockwise) curve.sweep = -curve.sweep;
  return curve;
}

DrawnPlace place_at(const DrawnCurve& curve, double part) {
  if (part <= 0) return curve.from;
  if (part >= 1) return curve.to;
  if (curve.is_arc()) {
    return part <= 0.5 ? turned(curve, curve.from, part * curve.sweep)
                       : turned(curve, curve.to, (part - 1) * curve.sweep);
  }
  return part <= 0.5 ? curve.from + part * (curve.to - curve.from)
                     : curve.to + (1 - part) * (curve.from - curve.to);
}

DrawnPlace direction_at(const DrawnCurve& curve, double part) {
  if (!curve.is_arc()) return unit(curve.to - curve.from);
  const DrawnPlace out = unit(place_at(curve, part) - curve.centre);
  return curve.sweep > 0 ? turned_left(out) : -1 * turned_left(out);
}

DrawnCurve beginning_of(const DrawnCurve& curve, double part) {
  DrawnCurve beginning = curve;
  beginning.to = place_at(curve, part);
  beginning.sweep = part * curve.sweep;
  return beginning;
}

Box box_around(const DrawnCurve& curve) {
  if (!curve.is_arc()) return box_of_ends(curve.from, curve.to, 0);
  const double angle = std::fabs(curve.sweep);
  if (angle <= std::numbers::pi)
    return box_of_ends(curve.from, curve.to, bulge(curve.radius, angle));
  return box_of_ends(curve.centre, curve.centre, curve.radius);
}

bool overlap(const Box& a, const Box& b) {
  return a.left <= b.right && b.left <= a.right && a.bottom <= b.top && b.bottom <= a.top;
}

NearestPlace nearest_place(const DrawnCurve& curve, DrawnPlace to) {
  double part = 0;
  if (!curve.is_arc()) {
    const DrawnPlace way = curve.to - curve.from;
    const double square = dot(way, way);
    part = square > 0 ? std::clamp(dot(to - curve.from, way) / square, 0.0, 1.0) : 0.0;
  } else {
    const double angle = std::fabs(curve.sweep);
    part = angle > 0 ? turn_to(curve, to) / angle : 0;
    if (part > 1) part = distance(curve.from, to) < distance(curve.to, to) ? 0 : 1;
  }
  const DrawnPlace at = place_at(curve, part);
  return {distance(at, to), part, at};
}

void flatten(const DrawnCurve& curve, const Box& window, double tolerance,
             std::vector<DrawnPlace>& corners) {
  DGT_CHECK(tolerance > 0);
  if (!curve.is_arc()) {
    corners.push_back(curve.to);
    return;
  }
  Flattening work{curve, window, tolerance, corners};
  const int pieces = std::fabs(curve.sweep) > std::numbers::pi ? 4 : 1;  // at most half a turn each
  DrawnPlace from = curve.from;
  for (int i = 0; i < pieces; ++i) {
    const double begin = double(i) / pieces;
    const double end = double(i + 1) / pieces;
    const DrawnPlace to = place_at(curve, end);
    work.add(begin, from, end, to);
    from = to;
  }
}

}  // namespace dgt
