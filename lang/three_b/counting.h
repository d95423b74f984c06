// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

/// Where a control that counts steps ends a block of 3B. All lengths are whole units.
///
/// A control is told no end: it steps along the line, or along the circle through the beginning of
/// the arc, until so many steps have been made along one axis. Controls step in two ways:
///  * *beside* the curve, always to the place nearest to it. It turns at an extreme of a circle of
///    radius² n at √n rounded.
///  * by the *sign* of x² + y² − n, as they were built first: inwards where it is not negative,
///    else onwards. It turns at ⌈√(n−1)⌉.
/// The end that is read is the grid place nearest to the curve among those that have the counted
/// coordinate of the first. How far the second stops from there is told with it. Counted along the
/// axis along which the curve runs at its end, both stop within one unit of each other; along the
/// other one the second stops earlier, by as much as the curve climbs in a step.
namespace dgt::three_b {

enum class Axis : std::uint8_t { X, Y };

/// Seen from the centre of an arc, or from where a line begins.
struct Cell {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The signs of a quadrant, 1 to 4.
[[nodiscard]] constexpr Cell signs_of(int quadrant) {
  return {quadrant == 1 || quadrant == 4 ? 1 : -1, quadrant <= 2 ? 1 : -1};
}

/// The quadrant of a direction that is not 0; along an axis the one that begins there
/// counter-clockwise, or clockwise.
[[nodiscard]] int quadrant_of(const Cell& direction, bool counter_clockwise);

/// An arc as its block says it.
struct CountedTurn {
  Cell begin;  ///< seen from the centre
  bool counter_clockwise = true;
  Axis axis = Axis::X;
  std::int64_t count = 0;
};

struct CountedEnd {
  Cell end;
  /// Units, along X or along Y, by which the controls that step by the sign stop beside `end`.
  std::int64_t apart = 0;
  /// Steps by which the count passes a whole turn; 0: it passes none.
  std::int64_t surplus = 0;
};
/// Preconditions: the radius is at least two units, coordinates and count are below 10¹⁸, the
/// count is above 0.
[[nodiscard]] CountedEnd end_of_turn(const CountedTurn& turn);

/// Steps along either axis in one whole turn, of a control that keeps beside the circle.
[[nodiscard]] std::int64_t steps_of_turn(const Cell& begin);

/// Where the line along `slope`, two lengths that are not both 0, stops after `count` steps along
/// an axis in which it has a part, if that is a place of the grid.
[[nodiscard]] std::optional<CountedEnd> end_of_line(const Cell& slope, Axis axis,
                                                    std::int64_t count);

}  // namespace dgt::three_b
