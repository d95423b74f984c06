// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "kernel/meet.h"

/// From exact coordinates to the whole units a machine counts in.
namespace dgt {

/// A place on a machine's grid, in units from the origin of the grid.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Coordinates known to within a radius.
struct BallPoint {
  Ball x;
  Ball y;
};

/// Nothing is written further out than this, in units: the squares of such numbers fit 128 bits,
/// and a tenth of a micron times it is still 100 km.
inline constexpr std::int64_t kMaxUnits = 1'000'000'000'000;

/// The points a machine can be told to go to: origin + k·unit with whole k on each axis.
///  (1) nearest(p) is the grid point nearest to p on each axis, decided exactly; a point half-way
///      goes away from the origin.
///  (2) So it lies within half a unit of p on each axis. A writer that sends the differences of
///      successive nearest points therefore never drifts, however long the program: the increments
///      of any stretch sum to the difference of its rounded ends, and those of a closed one to 0.
///  (3) Moving the origin by whole units changes the numbers and not the places (but half-way
///  ones).
class Grid {
 public:
  /// Precondition (checked): unit > 0, in mm.
  Grid(Rational unit, RationalPoint origin);

  [[nodiscard]] const Rational& unit() const { return unit_; }

  /// Nothing beyond kMaxUnits.
  [[nodiscard]] std::optional<GridPoint> nearest(const Point& p) const;
  /// Of a height, counted from 0 mm.
  [[nodiscard]] std::optional<std::int64_t> nearest_height(const Rational& z) const;

  /// In units from the origin, enclosed.
  [[nodiscard]] BallPoint enclosure(const Point& p) const;
  [[nodiscard]] BallPoint enclosure(const RationalPoint& p) const;
  [[nodiscard]] Ball enclosure(const Ball& millimetres) const { return millimetres * per_unit_; }

 private:
  Rational unit_;
  RationalPoint origin_;
  Ball per_unit_;  // 1 / unit
  Ball origin_x_;
  Ball origin_y_;
};

}  // namespace dgt
