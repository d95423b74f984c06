// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>

#include "apps/driver/drawn_curve.h"

namespace dgt::studio {

/// Which part of the plane is shown, and how large. Pixels count from the upper left corner, y
/// down. Everything is reckoned about the centre in doubles: places far from the origin do not
/// tremble.
struct SheetView {
  DrawnPlace centre;  ///< mm, in the middle of the window
  double scale = 1;   ///< pixels a millimetre
  QSizeF size{1, 1};  ///< pixels

  [[nodiscard]] QPointF pixel(DrawnPlace place) const {
    return {size.width() / 2 + (place.x - centre.x) * scale,
            size.height() / 2 - (place.y - centre.y) * scale};
  }
  [[nodiscard]] DrawnPlace place(QPointF pixel) const {
    return {centre.x + (pixel.x() - size.width() / 2) / scale,
            centre.y - (pixel.y() - size.height() / 2) / scale};
  }
  /// What is shown, in mm, and `pixels` more on each side.
  [[nodiscard]] Box window(double pixels = 0) const;

  /// Magnified by `factor`; the place under `about` stays there.
  [[nodiscard]] SheetView zoomed(double factor, QPointF about) const;
  /// What is shown moves by so many pixels.
  [[nodiscard]] SheetView moved(QPointF by) const;
  /// The same on a finer grid of pixels.
  [[nodiscard]] SheetView on_pixels(double ratio) const {
    return {centre, scale * ratio, size * ratio};
  }
  /// With a border of so many pixels more on each side.
  [[nodiscard]] SheetView widened(QSizeF border) const {
    return {centre, scale, size + 2 * border};
  }

  /// `box` as large as it fits, with a margin of `margin` times the window's shorter side.
  [[nodiscard]] static SheetView fitting(const Box& box, QSizeF size, double margin);

  friend bool operator==(const SheetView&, const SheetView&) = default;
};

/// How near one may look at a drawing, in pixels a millimetre: coordinates are doubles, and a pixel
/// is to be 16 of their steps at the drawing's far end, so that nothing trembles.
[[nodiscard]] double finest_scale(const Box& box);
/// How far one may go away from it: it is as good as a point then.
[[nodiscard]] double coarsest_scale(const Box& box);

}  // namespace dgt::studio
