// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/points.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "post/figures.h"

namespace dgt {
namespace {

// 1e-6 mm, which no digit of a machine shows; figures below it are not to print as "-0.000000".
double shown(double value) { return std::abs(value) < 0.5e-6 ? 0.0 : value; }

void append_point(std::string& out, std::size_t number, double x, double y) {
  fmt::format_to(std::back_inserter(out), "{:6} {:14.6f} {:14.6f}  ", number, shown(x), shown(y));
}

void append_move(std::string& out, const Move& move) {
  out += name_of(move.kind);
  if (move.kind == MoveKind::Arc) {
    const ArcFigures arc = figures(move);
    fmt::format_to(std::back_inserter(out), " X{:.6f} Y{:.6f} R{:.6f}", shown(arc.centre_x),
                   shown(arc.centre_y), arc.counter_clockwise ? arc.radius : -arc.radius);
  }
  if (move.z) fmt::format_to(std::back_inserter(out), " Z{:.6f}", shown(coordinate(*move.z)));
}

}  // namespace

std::string list_points(const Toolpath& path) {
  std::string out;
  std::size_t number = 1;
  append_point(out, number, coordinate(path.start.x), coordinate(path.start.y));
  out += "start\n";
  for (const Move& move : path.moves) {
    if (!move.travels()) continue;
    append_point(out, ++number, move.to.x(), move.to.y());
    append_move(out, move);
    out += '\n';
  }
  return out;
}

}  // namespace dgt
