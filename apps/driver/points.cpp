// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/points.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace dgt {
namespace {

// 1e-6 mm, which no digit of a machine shows; figures below it are not to print as "-0.000000".
double shown(double value) { return std::abs(value) < 0.5e-6 ? 0.0 : value; }

void append_point(std::string& out, std::size_t number, const ControlPoint& point) {
  fmt::format_to(std::back_inserter(out), "{:6} {:14.6f} {:14.6f}  {}", number, shown(point.x),
                 shown(point.y), point_kind(point));
  if (point.arc) {
    fmt::format_to(std::back_inserter(out), " X{} Y{} R{}", point_figure(point.arc->centre_x),
                   point_figure(point.arc->centre_y), point_figure(signed_radius(*point.arc)));
  }
  if (point.z) fmt::format_to(std::back_inserter(out), " Z{}", point_figure(*point.z));
  out += '\n';
}

}  // namespace

std::vector<ControlPoint> control_points(const Toolpath& path) {
  std::vector<ControlPoint> points;
  points.push_back({coordinate(path.start.x), coordinate(path.start.y), {}, {}, {}, {}});
  for (const Move& move : path.moves) {
    if (!move.travels()) continue;
    ControlPoint& point = points.emplace_back();
    point.x = move.to.x();
    point.y = move.to.y();
    point.kind = move.kind;
    if (move.kind == MoveKind::Arc) point.arc = figures(move);
    if (move.z) point.z = coordinate(*move.z);
    point.source = move.source;
  }
  return points;
}

std::string point_figure(double value) { return fmt::format("{:.6f}", shown(value)); }

std::string point_kind(const ControlPoint& point) {
  return point.kind ? name_of(*point.kind) : "start";
}

double signed_radius(const ArcFigures& arc) {
  return arc.counter_clockwise ? arc.radius : -arc.radius;
}

std::string list_points(std::span<const ControlPoint> points, std::size_t first) {
  std::string out;
  for (const ControlPoint& point : points) append_point(out, first++, point);
  return out;
}

}  // namespace dgt
