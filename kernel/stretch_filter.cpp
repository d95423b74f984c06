// SPDX-License-Identifier: GPL-3.0-or-later
// The first stage of nearness: the candidates of comes_nearer() in balls. A candidate is two
// places, one on each stretch, that may be the nearest; it counts when both surely lie on their
// stretches and are surely nearer, and falls away when one of the three surely fails. All fallen:
// no.
#include <cmath>

#include "kernel/stretch.h"

namespace dgt {
namespace {

enum class Answer : std::uint8_t { No, Open, Yes };

Answer both(Answer a, Answer b) { return std::min(a, b); }
Answer either(Answer a, Answer b) { return std::max(a, b); }

Answer positive(const Ball& b) {
  if (b.mid > b.rad) return Answer::Yes;
  return b.mid < -b.rad ? Answer::No : Answer::Open;
}

Ball cross(const Ball& ux, const Ball& uy, const Ball& vx, const Ball& vy) {
  return ux * vy - uy * vx;
}

/// Whether the ray from the centre along (x, y) meets the arc.
Answer holds(const StretchBalls& arc, const Ball& x, const Ball& y) {
  if (arc.whole) return Answer::Yes;
  const Answer after = positive(cross(arc.first_x, arc.first_y, x, y));
  const Answer before = positive(cross(x, y, arc.last_x, arc.last_y));
  return arc.wide ? either(after, before) : both(after, before);
}

/// Whether the foot of a normal, `along` the direction (ny, −nx), lies between the ends.
Answer between(const StretchBalls& line, const Ball& along) {
  const Ball from = line.normal_y * line.from_x - line.normal_x * line.from_y;
  const Ball to = line.normal_y * line.to_x - line.normal_x * line.to_y;
  return positive((along - from) * (to - along));
}

Answer near_places(const Ball& ax, const Ball& ay, const Ball& bx, const Ball& by,
                   const Ball& square) {
  const Ball dx = ax - bx;
  const Ball dy = ay - by;
  return positive(square - (dx * dx + dy * dy));
}

Answer near_end(const Ball& x, const Ball& y, const StretchBalls& s, const Ball& t,
                const Ball& square) {
  const Answer ends = either(near_places(x, y, s.from_x, s.from_y, square),
                             near_places(x, y, s.to_x, s.to_y, square));
  if (ends == Answer::Yes) return ends;
  if (s.is_line) {
    const Ball h = s.normal_x * x + s.normal_y * y - s.p;
    const Answer near = both(positive(t - h), positive(t + h));
    if (near == Answer::No) return ends;
    return either(ends, both(near, between(s, s.normal_y * x - s.normal_x * y)));
  }
  const Ball dx = x - s.centre_x;
  const Ball dy = y - s.centre_y;
  const Ball away = dx * dx + dy * dy;
  const Ball outer = s.radius + t;
  const Ball inner = s.radius - t;
  const Answer beyond =
      positive(-inner) == Answer::Yes ? Answer::Yes : positive(away - inner * inner);
  const Answer near = both(positive(outer * outer - away), beyond);
  if (near == Answer::No) return ends;
  return either(ends, both(near, holds(s, dx, dy)));
}

Answer near_on_normal(const StretchBalls& line, const StretchBalls& arc, const Ball& t) {
  const Ball h = line.normal_x * arc.centre_x + line.normal_y * arc.centre_y - line.p;
  const Answer above = positive(h);
  if (above == Answer::Open) return Answer::Open;
  const Ball one(above == Answer::Yes ? -1 : 1, 0);  // towards the line
  const Ball gap = -one * h - arc.radius;
  const Answer near = both(positive(t - gap), positive(t + gap));
  if (near == Answer::No) return near;
  return both(near,
              both(holds(arc, one * line.normal_x, one * line.normal_y),
                   between(line, line.normal_y * arc.centre_x - line.normal_x * arc.centre_y)));
}

Answer near_on_centres(const StretchBalls& a, const StretchBalls& b, const Ball& t) {
  const Ball vx = b.centre_x - a.centre_x;
  const Ball vy = b.centre_y - a.centre_y;
  const Ball square = vx * vx + vy * vy;
  const auto distance = sqrt(square);
  if (!distance) {  // concentric or nearly so: the ends decide, where the rings lie clearly apart
    const Ball apart = a.radius - b.radius;
    const Ball most(std::sqrt(std::fabs(square.mid) + square.rad) * 2, 0);
    const Answer outside = positive(apart - t - most);
    const Answer inside = positive(-apart - t - most);
    return either(outside, inside) == Answer::Yes ? Answer::No : Answer::Open;
  }
  Answer any = Answer::No;
  for (const int sa : {-1, 1}) {
    for (const int sb : {-1, 1}) {
      const Ball on_a(sa, 0);
      const Ball on_b(sb, 0);
      const Ball apart = *distance + on_b * b.radius - on_a * a.radius;
      const Answer near = both(positive(t - apart), positive(t + apart));
      if (near == Answer::No) continue;
      any = either(
          any, both(near, both(holds(a, on_a * vx, on_a * vy), holds(b, on_b * vx, on_b * vy))));
    }
  }
  return any;
}

Answer near_inside_both(const StretchBalls& a, const StretchBalls& b, const Ball& t) {
  if (a.is_line && b.is_line) return Answer::No;
  if (a.is_line) return near_on_normal(a, b, t);
  if (b.is_line) return near_on_normal(b, a, t);
  return near_on_centres(a, b, t);
}

/// Yes is never said: what crosses is for the exact stage.
Answer may_cross(const StretchBalls& a, const StretchBalls& b) {
  if (!a.box.overlaps(b.box)) return Answer::No;
  const auto one_side = [](const StretchBalls& line, const StretchBalls& s) {
    const Ball from = line.normal_x * s.from_x + line.normal_y * s.from_y - line.p;
    const Ball to = line.normal_x * s.to_x + line.normal_y * s.to_y - line.p;
    return positive(from * to) == Answer::Yes;
  };
  if (a.is_line && b.is_line) return one_side(a, b) || one_side(b, a) ? Answer::No : Answer::Open;
  if (a.is_line || b.is_line) {
    const StretchBalls& line = a.is_line ? a : b;
    const StretchBalls& arc = a.is_line ? b : a;
    const Ball h = line.normal_x * arc.centre_x + line.normal_y * arc.centre_y - line.p;
    const Ball gap = h * h - arc.radius * arc.radius;
    return positive(gap) == Answer::Yes ? Answer::No : Answer::Open;
  }
  const Ball vx = b.centre_x - a.centre_x;
  const Ball vy = b.centre_y - a.centre_y;
  const Ball square = vx * vx + vy * vy;
  const Ball sum = a.radius + b.radius;
  const Ball difference = a.radius - b.radius;
  const bool apart = positive(square - sum * sum) == Answer::Yes ||
                     positive(difference * difference - square) == Answer::Yes;
  return apart ? Answer::No : Answer::Open;
}

}  // namespace

std::optional<bool> stages::filtered_nearer(const StretchBalls& a, const StretchBalls& b,
                                            const Ball& distance) {
  const Ball square = distance * distance;
  Answer any = near_end(a.from_x, a.from_y, b, distance, square);
  any = either(any, near_end(a.to_x, a.to_y, b, distance, square));
  any = either(any, near_end(b.from_x, b.from_y, a, distance, square));
  any = either(any, near_end(b.to_x, b.to_y, a, distance, square));
  if (any != Answer::Yes) any = either(any, near_inside_both(a, b, distance));
  if (any == Answer::No) any = may_cross(a, b);
  if (any == Answer::Open) return std::nullopt;
  return any == Answer::Yes;
}

}  // namespace dgt
