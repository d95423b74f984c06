// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <cstdint>
#include <limits>

#include "apps/studio/window/theme.h"

namespace dgt::studio {

/// What is shown besides the equidistant.
struct Shown {
  bool programmed = true;  ///< the contours with W = 0
  bool rapids = true;
  bool tool = true;         ///< the disc of the kerf
  bool kerf = false;        ///< what the tool cuts away
  bool directions = false;  ///< arrows along the cuts
  bool names = false;       ///< the elements, with their names
  bool points = false;      ///< control points, numbered
  bool sizes = false;       ///< the box around the part
  bool grid = true;         ///< and the axes

  friend bool operator==(const Shown&, const Shown&) = default;
};

/// A line of the source whose moves are lit.
struct LitLine {
  std::uint32_t file = 0;
  std::uint32_t line = 0;  ///< from 1; 0: none

  friend bool operator==(const LitLine&, const LitLine&) = default;
};

/// How a scene is painted.
struct Look {
  Colours colours;
  QFont font;
  Shown shown;
  LitLine lit;
  int decimals = 3;  ///< of sizes
  double pixel = 1;  ///< of the screen, in those of the picture: widths and letters grow with it
  /// Moves from this one on are still to come, and dim.
  std::uint32_t run_to = std::numeric_limits<std::uint32_t>::max();
  bool stale = false;  ///< all of it dim: the text is ahead of the drawing

  friend bool operator==(const Look&, const Look&) = default;
};

/// As it looks where it does not matter now.
[[nodiscard]] inline QColor dimmed(const QColor& colour, const QColor& sheet) {
  constexpr float kLeft = 0.34F;  // of the colour
  const auto mix = [](float a, float b) { return kLeft * a + (1 - kLeft) * b; };
  return QColor::fromRgbF(mix(colour.redF(), sheet.redF()), mix(colour.greenF(), sheet.greenF()),
                          mix(colour.blueF(), sheet.blueF()));
}

}  // namespace dgt::studio
