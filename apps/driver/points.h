// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/toolpath.h"
#include "post/figures.h"

namespace dgt {

/// A place between which the tool moves. Points are numbered from 1: the start, then where each
/// move that travels ends.
struct ControlPoint {
  double x = 0;  ///< mm
  double y = 0;
  std::optional<MoveKind> kind;   ///< of the move that leads there; none: the start
  std::optional<ArcFigures> arc;  ///< when it is an arc
  std::optional<double> z;        ///< mm, when the move says a height
  SourcePlace source;             ///< where the move was asked for; line 0: nowhere
};
[[nodiscard]] std::vector<ControlPoint> control_points(const Toolpath& path);

/// A figure of the list: six decimals, never a negative zero.
[[nodiscard]] std::string point_figure(double value);
/// `start`, or the name of the kind.
[[nodiscard]] std::string point_kind(const ControlPoint& point);
/// The radius with the sense of the arc: negative when it runs clockwise.
[[nodiscard]] double signed_radius(const ArcFigures& arc);

/// One line a point: number, X, Y, kind of move, then for arcs the centre and the radius (negative:
/// clockwise), then the height. `first`: the number of the first.
[[nodiscard]] std::string list_points(std::span<const ControlPoint> points, std::size_t first = 1);
[[nodiscard]] inline std::string list_points(const Toolpath& path) {
  return list_points(control_points(path));
}

}  // namespace dgt
