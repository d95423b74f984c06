// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <string>

#include "kernel/toolpath.h"

/// A tool path in doubles, for drawings and lists: every figure is rounded once, from the exact
/// value.
namespace dgt {

/// The circle an arc runs on.
struct ArcFigures {
  double centre_x = 0;
  double centre_y = 0;
  double radius = 0;  ///< mm, positive
  bool counter_clockwise = true;
};
[[nodiscard]] ArcFigures figures(const Move& arc);

/// The double nearest to a coordinate or length in mm; 0 within 2^kZeroExponent of it.
[[nodiscard]] double coordinate(const Rational& value);

/// Appends the shortest decimal that reads back as `value`; never a negative zero. The same on
/// every machine.
void append_number(std::string& out, double value);

/// An upright rectangle in mm.
struct Box {
  double left = std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool empty() const { return left > right; }
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return top - bottom; }
  void add(double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    bottom = std::min(bottom, y);
    top = std::max(top, y);
  }
};

/// The least box around what the moves travel, bulging arcs included; each side within an ulp or
/// two.
[[nodiscard]] Box box_of(std::span<const Move> moves);

}  // namespace dgt
