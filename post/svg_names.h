// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "kernel/element.h"
#include "kernel/toolpath.h"

/// What a drawing may show besides the path: elements with their names, each with an arrow where
/// its name stands.
namespace dgt {

/// A named point; a place that only has a name has no dot.
struct NamedSpot {
  double x = 0, y = 0;  ///< mm
  bool dot = true;
};
/// A coordinate system: its origin and the unit vector of its X axis.
struct NamedAxes {
  double x = 0, y = 0;
  double along_x = 1, along_y = 0;
};
struct NamedShape {
  std::string name;
  std::variant<Line, Circle, NamedSpot, NamedAxes> shape;
  bool lit = false;  ///< stands out: what the drawing is about
};

/// The part of the plane that is drawn, y up, in mm.
struct Sheet {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
  double pixel = 1;  ///< mm

  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top - height; }
  [[nodiscard]] bool holds(double x, double y) const {
    return x >= left && x <= right() && y >= bottom() && y <= top;
  }
};

struct PlacedName {
  std::string text;
  double x = 0, y = 0;  ///< the middle of its base line, mm
};
/// The data of `d` attributes, and where the names stand.
struct NamesLayout {
  std::string elements;  ///< lines across the sheet and whole circles
  std::string arrows;    ///< open heads, on the elements
  std::string heads;     ///< the same on the path, half-way along moves that have room for one
  std::string dots;
  std::string lit;  ///< elements that stand out
  std::string lit_dots;
  std::vector<PlacedName> names;
};

/// Lays the names out in their order, each where it covers least of the path and of names before
/// it. `letter`: the height of the letters, mm.
[[nodiscard]] NamesLayout lay_out_names(std::span<const NamedShape> shapes, const Toolpath& path,
                                        const Sheet& sheet, double letter);

}  // namespace dgt
