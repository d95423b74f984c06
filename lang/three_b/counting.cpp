// SPDX-License-Identifier: GPL-3.0-or-later
//
// Along one axis a turn runs to and fro between the two extremes, E and −E. The steps made since it
// last left E are its phase, 0 to 4E: up to 2E the coordinate falls, E − phase, then it rises. So
// the coordinate at the end is that of the phase at the beginning plus the count.
#include "lang/three_b/counting.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace dgt::three_b {
namespace {

// Squares of numbers below 10¹⁸, and their sums, fit.
__extension__ typedef __int128 Wide;

Wide square(std::int64_t v) { return static_cast<Wide>(v) * v; }

/// ⌊√n⌋; 0 below 0.
std::int64_t floor_root(Wide n) {
  if (n <= 0) return 0;
  // The root of a whole number that a double holds is never rounded up to the next whole one, which
  // is farther from it than a double of that size tells apart.
  constexpr Wide kExact = Wide{1} << 52;
  if (n < kExact)
    return static_cast<std::int64_t>(std::sqrt(static_cast<double>(static_cast<std::int64_t>(n))));
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<long double>(n)));
  while (square(root) > n) --root;
  while (square(root + 1) <= n) ++root;
  return root;
}
std::int64_t nearest_root(Wide n) {
  const std::int64_t root = floor_root(n);
  return n > square(root) + root ? root + 1 : root;
}
std::int64_t ceiling_root(Wide n) {
  const std::int64_t root = floor_root(n);
  return square(root) == std::max<Wide>(n, 0) ? root : root + 1;
}

/// A turn seen along its counted axis.
struct Swing {
  std::int64_t along = 0;  ///< the counted coordinate
  std::int64_t aside = 0;  ///< the other one
  /// Whether the counted coordinate falls where the other is positive.
  bool falls_above = true;
};

Swing swing_of(const CountedTurn& turn) {
  const bool along_x = turn.axis == Axis::X;
  return {along_x ? turn.begin.x : turn.begin.y, along_x ? turn.begin.y : turn.begin.x,
          along_x == turn.counter_clockwise};
}

/// Where a swing between the extremes ±`extreme` has come after `count` steps.
struct Reached {
  std::int64_t along = 0;
  bool falling = true;  ///< the last step led downwards
};

Reached reached(const Swing& swing, std::int64_t extreme, std::int64_t count) {
  const bool falls = swing.aside == 0 || (swing.aside > 0) == swing.falls_above;
  const std::int64_t begin = falls ? extreme - swing.along : 3 * extreme + swing.along;
  const std::int64_t turn = 4 * extreme;
  const std::int64_t steps = (begin + count) % turn;
  const std::int64_t phase = steps == 0 ? turn : steps;
  if (phase <= 2 * extreme) return {extreme - phase, true};
  return {phase - 3 * extreme, false};
}

/// The other coordinate, where a control that keeps beside the circle is.
std::int64_t beside(const Swing& swing, const Reached& at, Wide n) {
  const std::int64_t aside = nearest_root(n - square(at.along));
  return at.falling == swing.falls_above ? aside : -aside;
}

/// And where one is that steps by the sign: towards the axis it steps at the first place that is
/// not inside, away from it at the last that is.
std::int64_t by_the_sign(const Swing& swing, const Reached& at, Wide n) {
  const std::int64_t here = std::llabs(at.along);
  const bool inwards = at.along == 0 || (at.along > 0) == at.falling;
  const std::int64_t aside =
      inwards ? ceiling_root(n - square(here + 1))
              : std::max<std::int64_t>(0, ceiling_root(n - square(here - 1)) - 1);
  return at.falling == swing.falls_above ? aside : -aside;
}

}  // namespace

int quadrant_of(const Cell& direction, bool counter_clockwise) {
  const auto [x, y] = direction;
  if (counter_clockwise) {
    if (x > 0 && y >= 0) return 1;
    if (x <= 0 && y > 0) return 2;
    return x < 0 ? 3 : 4;
  }
  if (x >= 0 && y > 0) return 1;
  if (x < 0 && y >= 0) return 2;
  return x <= 0 ? 3 : 4;
}

std::int64_t steps_of_turn(const Cell& begin) {
  return 4 * nearest_root(square(begin.x) + square(begin.y));
}

CountedEnd end_of_turn(const CountedTurn& turn) {
  const Wide n = square(turn.begin.x) + square(turn.begin.y);
  const Swing swing = swing_of(turn);
  const std::int64_t extreme = nearest_root(n);
  const Reached at = reached(swing, extreme, turn.count);
  const std::int64_t aside = beside(swing, at, n);
  const Reached other = reached(swing, ceiling_root(n - 1), turn.count);
  CountedEnd end;
  end.end = turn.axis == Axis::X ? Cell{at.along, aside} : Cell{aside, at.along};
  end.apart = std::max(std::llabs(other.along - at.along),
                       std::llabs(by_the_sign(swing, other, n) - aside));
  end.surplus = std::max<std::int64_t>(0, turn.count - 4 * extreme);
  return end;
}

std::optional<CountedEnd> end_of_line(const Cell& slope, Axis axis, std::int64_t count) {
  const std::int64_t along = axis == Axis::X ? slope.x : slope.y;
  const std::int64_t aside = axis == Axis::X ? slope.y : slope.x;
  std::int64_t other = aside;
  if (count != along) {
    const Wide product = static_cast<Wide>(count) * aside;
    constexpr std::int64_t kLargest = 1'000'000'000'000'000'000;
    if (product % along != 0 || product / along > kLargest) return std::nullopt;
    other = static_cast<std::int64_t>(product / along);
  }
  CountedEnd found;
  found.end = axis == Axis::X ? Cell{count, other} : Cell{other, count};
  // Behind the last counted step there may be as many of the others as fit between two.
  found.apart = aside > along ? (aside + along - 1) / along : 0;
  return found;
}

}  // namespace dgt::three_b
