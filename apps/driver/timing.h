// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/toolpath.h"

/// How long a machine takes for a tool path.
namespace dgt {

/// What the machine is. Times come out in seconds; everything is in doubles, since a clock is all
/// they are held against.
struct MotionSettings {
  double rapid_speed = 10000;      ///< mm/min
  double cut_speed = 1000;         ///< mm/min, where the program says no feed
  double acceleration = 500;       ///< mm/s², along the path and across it
  double corner_deviation = 0.01;  ///< mm, see time_of
  double pierce_time = 0;          ///< s, each time cutting begins
};

struct Times {
  double cut = 0;  ///< s
  double rapid = 0;
  double pierce = 0;
  double dwell = 0;
  [[nodiscard]] double total() const { return cut + rapid + pierce + dwell; }
};

/// Each move is run with a trapezoidal profile: speed rises and falls with `acceleration` and is
/// held at the feed between.
///  * On an arc of radius r no faster than √(a r), or the acceleration across would pass a.
///  * At a corner as fast as on the arc that leaves the corner by `corner_deviation` d and joins
///    both sides: v² = a d s/(1 − s) with s the sine of half the angle between the sides. (S. K.
///    Jeon's junction deviation, known from GRBL.) A smooth joint slows nothing, a turn back stops.
///  * The tool stands still at the ends of the path, between cuts and rapids, at dwells and at
///  codes.
///  * Speeds are made to fit by looking ahead without bound, as a control does that reads far
///  enough.
[[nodiscard]] Times time_of(const Toolpath& path, const MotionSettings& motion);

}  // namespace dgt
