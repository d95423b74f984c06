// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "apps/driver/drawn_path.h"

/// Measuring in a drawing: the places a person means when pointing near them.
namespace dgt {

enum class SnapKind : std::uint8_t {
  Free,  ///< nothing is near
  End,
  Middle,
  Centre,
  Tangent,        ///< where the line from the first place touches an arc
  Perpendicular,  ///< where the line from the first place meets a move at a right angle
  OnMove          ///< the nearest place of a move
};

struct Snap {
  SnapKind kind = SnapKind::Free;
  DrawnPlace at;
  std::optional<DrawnCurve> curve;  ///< the move it belongs to
};

/// What is pointed at from within `reach` mm. Of the ends, middles, centres, and from the first
/// place of a measure the tangents and perpendiculars, the nearest counts; only where there are
/// none the nearest place of a move. Places nearer to each other than a thousandth of the reach are
/// one, and named as the first of these.
[[nodiscard]] Snap snap(const std::vector<const DrawnLayer*>& layers, DrawnPlace pointer,
                        double reach, const std::optional<DrawnPlace>& from);

/// The places of a circle where lines from `from` touch it, and those of its arc only; nothing from
/// inside.
[[nodiscard]] std::vector<DrawnPlace> tangent_places(const DrawnCurve& arc, DrawnPlace from);
/// The places of a move where a line from `from` meets it at a right angle.
[[nodiscard]] std::vector<DrawnPlace> perpendicular_places(const DrawnCurve& curve,
                                                           DrawnPlace from);

struct Measurement {
  double dx = 0;  ///< mm
  double dy = 0;
  double distance = 0;
  double degrees = 0;  ///< of the way, from the X axis, in (−180, 180]
};
[[nodiscard]] Measurement measured(DrawnPlace from, DrawnPlace to);

}  // namespace dgt
