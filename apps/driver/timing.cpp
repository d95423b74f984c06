// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/timing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dgt {
namespace {

constexpr double kSecondsPerMinute = 60;

struct Direction {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// One move as the drives see it.
struct Stroke {
  double length = 0;  ///< mm, height included
  double speed = 0;   ///< mm/s, the most on it
  double entry = 0;   ///< mm/s, the most where it begins
  bool is_rapid = false;
  Direction begin;
  Direction end;
};

Direction normal(double x, double y, double z) {
  const double length = std::hypot(x, y, z);
  if (length == 0) return {};
  return {x / length, y / length, z / length};
}

double speed_of(const Move& move, const MotionSettings& motion) {
  if (move.kind == MoveKind::Rapid) return motion.rapid_speed / kSecondsPerMinute;
  const double feed =
      move.feed && sgn(*move.feed) > 0 ? nearest_double(*move.feed) : motion.cut_speed;
  return feed / kSecondsPerMinute;
}

void bend(Stroke& stroke, const Move& arc, double plane, double rise,
          const MotionSettings& motion) {
  const Circle circle = arc.circle();
  const double x = nearest_double(circle.centre().x);
  const double y = nearest_double(circle.centre().y);
  const double radius = nearest_double(abs(circle.radius()));
  const double sense = circle.counter_clockwise() ? 1 : -1;
  const auto tangent = [&](const Point& at) {
    const Direction flat = normal(-sense * (at.y() - y), sense * (at.x() - x), 0);
    return normal(flat.x * plane, flat.y * plane, rise);
  };
  stroke.begin = tangent(arc.from);
  stroke.end = tangent(arc.to);
  stroke.speed = std::min(stroke.speed, std::sqrt(motion.acceleration * radius));
}

Stroke stroke_of(const Move& move, double rise, const MotionSettings& motion) {
  Stroke stroke;
  const double plane = length(move);
  stroke.length = std::hypot(plane, rise);
  stroke.speed = speed_of(move, motion);
  stroke.is_rapid = move.kind == MoveKind::Rapid;
  if (move.kind == MoveKind::Arc) {
    bend(stroke, move, plane, rise, motion);
  } else {
    stroke.begin = normal(move.to.x() - move.from.x(), move.to.y() - move.from.y(), rise);
    stroke.end = stroke.begin;
  }
  return stroke;
}

/// mm/s
double corner_speed(const Stroke& before, const Stroke& after, const MotionSettings& motion) {
  const double cosine =
      before.end.x * after.begin.x + before.end.y * after.begin.y + before.end.z * after.begin.z;
  // Half the angle between the sides; the turn is what is left of half a circle.
  const double sine = std::sqrt(std::clamp((1 + cosine) / 2, 0.0, 1.0));
  // Two doubles tell no turn smaller than this from none; beyond 1 − 10⁻¹² the joint is smooth.
  constexpr double kSmooth = 1e-12;
  const double most = std::min(before.speed, after.speed);
  if (1 - sine < kSmooth) return most;
  const double speed = std::sqrt(motion.acceleration * motion.corner_deviation * sine / (1 - sine));
  return std::min(most, speed);
}

/// Seconds for one stroke between two speeds that it can reach.
double trapezoid(const Stroke& stroke, double from, double to, double acceleration) {
  const double peak =
      std::min(stroke.speed, std::sqrt(acceleration * stroke.length + (from * from + to * to) / 2));
  const double ramps = (2 * peak * peak - from * from - to * to) / (2 * acceleration);
  const double held = std::max(0.0, stroke.length - ramps);
  return (2 * peak - from - to) / acceleration + held / peak;
}

double reachable(double speed, const Stroke& stroke, const MotionSettings& motion) {
  return std::sqrt(speed * speed + 2 * motion.acceleration * stroke.length);
}

/// Adds the time of a run that begins and ends at rest, and forgets it.
void finish(std::vector<Stroke>& run, const MotionSettings& motion, Times& times) {
  double exit = 0;
  for (auto stroke = run.rbegin(); stroke != run.rend(); ++stroke) {
    stroke->entry = std::min(stroke->entry, reachable(exit, *stroke, motion));
    exit = stroke->entry;
  }
  double speed = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const double next = i + 1 < run.size() ? run[i + 1].entry : 0;
    const double end = std::min(next, reachable(speed, run[i], motion));
    (run[i].is_rapid ? times.rapid : times.cut) +=
        trapezoid(run[i], speed, end, motion.acceleration);
    speed = end;
  }
  run.clear();
}

}  // namespace

Times time_of(const Toolpath& path, const MotionSettings& motion) {
  Times times;
  std::vector<Stroke> run;
  bool cutting = false;
  double height = 0;
  for (const Move& move : path.moves) {
    if (!move.travels()) {
      finish(run, motion, times);
      if (move.seconds) times.dwell += nearest_double(*move.seconds);
      continue;
    }
    const double rise = move.z ? nearest_double(*move.z) - height : 0;
    height += rise;
    if (move.cuts() && !cutting) times.pierce += motion.pierce_time;
    if (move.cuts() != cutting) finish(run, motion, times);
    cutting = move.cuts();
    Stroke stroke = stroke_of(move, rise, motion);
    if (stroke.length == 0) continue;
    if (!run.empty()) stroke.entry = corner_speed(run.back(), stroke, motion);
    run.push_back(stroke);
  }
  finish(run, motion, times);
  return times;
}

}  // namespace dgt
