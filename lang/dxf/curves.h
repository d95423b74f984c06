// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/dxf/drawing.h"

namespace dgt {

/// A map of the plane: p ↦ (x_axis p.x + y_axis p.y) + origin.
struct Placement {
  Vector x_axis{1, 0};
  Vector y_axis{0, 1};
  RationalPoint origin;

  [[nodiscard]] Vector turned(const Vector& v) const { return v.x * x_axis + v.y * y_axis; }
  [[nodiscard]] RationalPoint of(const RationalPoint& p) const { return turned(p) + origin; }
  /// First `inner`, then this.
  [[nodiscard]] Placement after(const Placement& inner) const {
    return {turned(inner.x_axis), turned(inner.y_axis), of(inner.origin)};
  }
};

/// What an ellipse is once it is put in place, when that is a circle: axes that differ, or lean, by
/// less than a part in 10⁹ are those of one.
struct PlacedEllipse {
  RationalPoint centre;
  Vector major;
  Vector minor;
};
[[nodiscard]] bool is_circle(const PlacedEllipse& ellipse);

/// The rational quadratic curves along the ellipse from one direction (of its parameter) to the
/// other, each over a quarter at most; the same twice is once round.
[[nodiscard]] std::vector<RationalCurve> curves_of(const PlacedEllipse& ellipse,
                                                   const UnitVector& start, const UnitVector& end);

/// The Bézier curves of a spline, one for each span of its knots, exactly: the polar form at the
/// ends of the span (Ramshaw, *Blossoms are polar forms*).
[[nodiscard]] std::vector<RationalCurve> curves_of(const DxfSpline& spline,
                                                   const Placement& placement);

}  // namespace dgt
