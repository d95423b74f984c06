// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <cstdint>

namespace dgt::studio {

/// The small signs on the buttons of the drawing.
enum class Glyph : std::uint8_t {
  Fit,
  ZoomIn,
  ZoomOut,
  Start,
  Back,
  Run,
  Pause,
  Step,
  End,
  Measure
};

/// Drawn in the colour of the program's letters at every painting: it follows the theme, and any
/// number of pixels.
[[nodiscard]] QIcon icon_of(Glyph glyph);

}  // namespace dgt::studio
