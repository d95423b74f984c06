// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/stretch.h"

#include <array>
#include <cmath>

#include "kernel/contour_legs.h"

namespace dgt {
namespace {

/// The directions from the centre of an arc that meet it, from `first` counter-clockwise to `last`.
struct Sector {
  RationalPoint centre;
  const Point* first;
  const Point* last;
  bool whole = false;
  bool wide = false;  ///< more than half a turn

  Sector(const Stretch& arc, const Circle& circle) : centre(circle.centre()) {
    first = circle.counter_clockwise() ? &arc.from : &arc.to;
    last = circle.counter_clockwise() ? &arc.to : &arc.from;
    whole = arc.from == arc.to;
    if (whole) return;
    const int turn = turn_about(centre, *first, *last);
    // Exactly half a turn is not wide; ends in one direction from the centre would be one place.
    wide = turn < 0;
  }

  /// `towards`: a place, or a direction from the centre.
  template <class Towards>
  [[nodiscard]] bool holds(const Towards& towards) const {
    if (whole) return true;
    const bool after_first = turn_about(centre, *first, towards) >= 0;
    if (after_first == wide) return wide;
    return turn_about(centre, *last, towards) <= 0;
  }
};

/// Whether the foot of a normal on the line, `along` its direction, lies between the ends.
bool between_ends(const Stretch& segment, const Line& line, const Rational& along) {
  const Vector d = line.direction().vector();
  const int from = order_along(d, along, segment.from);
  const int to = order_along(d, along, segment.to);
  return from == 0 || to == 0 || from != to;
}

bool within_segment(const Stretch& segment, const Line& line, const Point& p) {
  const Vector d = line.direction().vector();
  const int from = order_along(d, segment.from, p);
  const int to = order_along(d, segment.to, p);
  return from == 0 || to == 0 || from != to;
}

// --- nearness -----------------------------------------------------------------------------------

/// Of the place `q` to the inside of a segment.
bool near_inside(const Point& q, const Stretch& segment, const Line& line, const Rational& t) {
  const Vector& n = line.normal().vector();
  if (order_along(n, line.p() + t, q) >= 0 || order_along(n, line.p() - t, q) <= 0) return false;
  return within_segment(segment, line, q);
}

bool near_inside(const Point& q, const Stretch& arc, const Circle& circle, const Rational& t) {
  const Rational r = abs(circle.radius());
  const Rational outer = r + t;
  const Rational inner = r - t;
  if (compare_distance(q, circle.centre(), outer * outer) >= 0) return false;
  if (sgn(inner) >= 0 && compare_distance(q, circle.centre(), inner * inner) <= 0) return false;
  return Sector(arc, circle).holds(q);
}

bool near_end(const Point& q, const Stretch& other, const Element& carrier, const Rational& t) {
  const Rational square = t * t;
  if (compare_distance(q, other.from, square) < 0 || compare_distance(q, other.to, square) < 0)
    return true;
  if (const auto* line = std::get_if<Line>(&carrier)) return near_inside(q, other, *line, t);
  return near_inside(q, other, std::get<Circle>(carrier), t);
}

/// On the normal of the line through the centre of the circle.
bool near_on_normal(const Stretch& segment, const Line& line, const Stretch& arc,
                    const Circle& circle, const Rational& t) {
  const Rational h = line.distance_to_left(circle.centre());
  if (abs(abs(h) - abs(circle.radius())) >= t || sgn(h) == 0) return false;
  const Vector& n = line.normal().vector();
  if (!Sector(arc, circle).holds(sgn(h) > 0 ? -n : n)) return false;
  return between_ends(segment, line, dot(line.direction().vector(), circle.centre()));
}

/// On the line of centres: at each end of each diameter along it.
bool near_on_centres(const Stretch& a, const Circle& circle_a, const Stretch& b,
                     const Circle& circle_b, const Rational& t) {
  const Vector v = circle_b.centre() - circle_a.centre();
  const Rational square = squared_length(v);
  if (sgn(square) == 0) return false;  // concentric: the ends decide
  for (const int sa : {-1, 1}) {
    for (const int sb : {-1, 1}) {
      // The places lie |√square + k| apart.
      const Rational k = sb * abs(circle_b.radius()) - sa * abs(circle_a.radius());
      const OneRoot apart{k, 1, square};
      if (compare(apart, t) >= 0 || compare(apart, -t) <= 0) continue;
      if (Sector(a, circle_a).holds(sa > 0 ? v : -v) && Sector(b, circle_b).holds(sb > 0 ? v : -v))
        return true;
    }
  }
  return false;
}

bool near_inside_both(const Stretch& a, const Element& on_a, const Stretch& b, const Element& on_b,
                      const Rational& t) {
  const auto* line_a = std::get_if<Line>(&on_a);
  const auto* line_b = std::get_if<Line>(&on_b);
  if (line_a && line_b) return false;  // parallel ones are nearest at an end too
  if (line_a) return near_on_normal(a, *line_a, b, std::get<Circle>(on_b), t);
  if (line_b) return near_on_normal(b, *line_b, a, std::get<Circle>(on_a), t);
  return near_on_centres(a, std::get<Circle>(on_a), b, std::get<Circle>(on_b), t);
}

// --- crossings ----------------------------------------------------------------------------------

/// One element moved by two distances: parallel, or concentric, as is known without arithmetic.
bool is_beside(const Carrier& a, const Carrier& b) {
  if (a.base != b.base) return false;
  const Rational none;
  return (a.shift ? *a.shift : none) != (b.shift ? *b.shift : none);
}

/// The places of the meeting of the two carriers, wherever they lie.
template <class Visit>
void for_each_meeting(const Carrier& a, const Carrier& b, bool contacts, Visit&& visit) {
  if (is_beside(a, b) || stages::filtered(a, b) == stages::Verdict::Apart) return;
  const Meeting meeting = meet(a, b);
  if (const auto* two = std::get_if<TwoPoints>(&meeting)) {
    visit(two->at(Which::Entry));
    visit(two->at(Which::Exit));
  } else if (const auto* one = std::get_if<OnePoint>(&meeting)) {
    if (contacts || !one->contact) visit(one->at);
  }
}

bool they_cross(const Stretch& a, const Stretch& b) {
  bool found = false;
  for_each_meeting(a.carrier, b.carrier, true,
                   [&](const Point& p) { found = found || (covers(a, p) && covers(b, p)); });
  return found;
}

}  // namespace

StretchBalls balls_of(const Stretch& stretch) {
  StretchBalls s;
  s.is_line = stretch.carrier.is_line();
  s.from_x = around(stretch.from.x());
  s.from_y = around(stretch.from.y());
  s.to_x = around(stretch.to.x());
  s.to_y = around(stretch.to.y());
  s.box = box_around(stretch);
  const Ball shift = stretch.carrier.shift ? Ball(*stretch.carrier.shift) : Ball();
  if (s.is_line) {
    const auto& line = std::get<Line>(*stretch.carrier.base);
    s.normal_x = Ball(line.normal().x());
    s.normal_y = Ball(line.normal().y());
    s.p = Ball(line.p()) + shift;
    return s;
  }
  const Element on = stretch.carrier.element();
  const auto& circle = std::get<Circle>(on);
  const Sector sector(stretch, circle);
  s.centre_x = Ball(circle.centre().x);
  s.centre_y = Ball(circle.centre().y);
  s.radius = Ball(Rational(abs(circle.radius())));
  s.first_x = around(sector.first->x()) - s.centre_x;
  s.first_y = around(sector.first->y()) - s.centre_y;
  s.last_x = around(sector.last->x()) - s.centre_x;
  s.last_y = around(sector.last->y()) - s.centre_y;
  s.whole = sector.whole;
  s.wide = sector.wide;
  return s;
}

Stretch stretch_of(const Move& move) { return {move.from, move.to, move.carrier}; }

bool covers(const Stretch& stretch, const Point& p) {
  const Element on = stretch.carrier.element();
  if (const auto* line = std::get_if<Line>(&on)) return within_segment(stretch, *line, p);
  return Sector(stretch, std::get<Circle>(on)).holds(p);
}

bool comes_nearer(const Stretch& a, const Stretch& b, const Rational& distance) {
  if (sgn(distance) <= 0) return false;
  const Element on_a = a.carrier.element();
  const Element on_b = b.carrier.element();
  return near_end(a.from, b, on_b, distance) || near_end(a.to, b, on_b, distance) ||
         near_end(b.from, a, on_a, distance) || near_end(b.to, a, on_a, distance) ||
         near_inside_both(a, on_a, b, on_b, distance) || they_cross(a, b);
}

std::vector<Point> common_places(const Stretch& a, const Stretch& b) {
  std::vector<Point> places;
  const auto add = [&](const Point& p) {
    if (std::find(places.begin(), places.end(), p) == places.end()) places.push_back(p);
  };
  if (is_beside(a.carrier, b.carrier)) return places;
  if (std::holds_alternative<Coincident>(meet(a.carrier, b.carrier))) {
    for (const Point& end : {a.from, a.to})
      if (covers(b, end)) add(end);
    for (const Point& end : {b.from, b.to})
      if (covers(a, end)) add(end);
    return places;
  }
  for_each_meeting(a.carrier, b.carrier, true, [&](const Point& p) {
    if (covers(a, p) && covers(b, p)) add(p);
  });
  return places;
}

std::vector<Point> crossings_inside(const Stretch& a, const Stretch& b) {
  std::vector<Point> places;
  for_each_meeting(a.carrier, b.carrier, false, [&](const Point& p) {
    const std::array ends{&a.from, &a.to, &b.from, &b.to};
    const bool at_end = std::any_of(ends.begin(), ends.end(),
                                    [&](const Point* end) { return indistinct(*end, p); });
    if (!at_end && covers(a, p) && covers(b, p)) places.push_back(p);
  });
  return places;
}

}  // namespace dgt
