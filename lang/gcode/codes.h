// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace dgt::gcode {

/// What the G words of one block may say once each.
enum class Group : std::uint8_t {
  Motion,
  Once,  ///< acts in its block alone
  Plane,
  Units,
  Distance,
  ArcDistance,
  FeedMode,
  Kerf,
  ToolLength,
  Frame,
  PathMode,
  Spindle,
  Retract,
  Unknown  ///< not read
};

/// `tenths`: 411 of G41.1.
[[nodiscard]] constexpr Group group_of(int tenths) {
  switch (tenths) {
    case 0:
    case 10:
    case 20:
    case 30:
    case 800:
      return Group::Motion;
    case 40:
    case 530:
    case 920:
    case 921:
    case 922:
      return Group::Once;
    case 170:
    case 180:
    case 190:
      return Group::Plane;
    case 200:
    case 210:
      return Group::Units;
    case 900:
    case 910:
      return Group::Distance;
    case 901:
    case 911:
      return Group::ArcDistance;
    case 940:
      return Group::FeedMode;
    case 400:
    case 410:
    case 411:
    case 420:
    case 421:
      return Group::Kerf;
    case 430:
    case 490:
      return Group::ToolLength;
    case 540:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
      return Group::Frame;
    case 610:
    case 611:
    case 640:
      return Group::PathMode;
    case 970:
      return Group::Spindle;
    case 980:
    case 990:
      return Group::Retract;
    default:
      return Group::Unknown;
  }
}

}  // namespace dgt::gcode
