// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/timing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "apps/driver/pipeline.h"

namespace dgt {
namespace {

/// 1 m/min and 100 mm/s², with stops at corners.
constexpr MotionSettings kSlow{6000, 600, 100, 0, 2};

Times times(const std::string& gcode, const MotionSettings& motion = kSlow) {
  const Compilation made =
      compile_bytes("a.ngc", "G90\nG00 X0 Y0\nM07\n" + gcode, SourceSettings{});
  EXPECT_TRUE(made.result.path.has_value());
  return made.result.path ? time_of(*made.result.path, motion) : Times{};
}

TEST(Timing, ALongLineIsATrapezoid) {
  // 10 mm/s: 0.1 s and 0.5 mm up, the same down, 99 mm at speed.
  EXPECT_NEAR(times("G01 X100\n").cut, 0.2 + 9.9, 1e-9);
}

TEST(Timing, AShortLineIsATriangle) {
  EXPECT_NEAR(times("G01 X0.25\n").cut, 2 * std::sqrt(0.25 / 100), 1e-9);
}

TEST(Timing, TheFeedOfTheProgramHolds) {
  EXPECT_NEAR(times("G01 X100 F1200\n").cut, 0.4 + 96 / 20.0, 1e-9);
}

TEST(Timing, APartedLineTakesNoLonger) {
  EXPECT_NEAR(times("G01 X30\nX31\nX100\n").cut, times("G01 X100\n").cut, 1e-9);
}

TEST(Timing, ATangentJointOfLineAndArcSlowsNothing) {
  const double length = 50 + 50 * std::numbers::pi;
  EXPECT_NEAR(times("G01 X50\nG03 X50 Y100 J50\n").cut, length / 10 + 0.1, 1e-9);
}

TEST(Timing, ASquareCornerStopsWithoutADeviation) {
  EXPECT_NEAR(times("G01 X100\nY100\n").cut, 2 * times("G01 X100\n").cut, 1e-9);
}

TEST(Timing, ASquareCornerIsRunAsFastAsItsDeviationSays) {
  MotionSettings motion = kSlow;
  motion.corner_deviation = 0.05;
  const double s = std::sqrt(0.5);
  const double v = std::sqrt(100 * 0.05 * s / (1 - s));  // 3.47 mm/s
  // Each side: up from one speed to 10 mm/s, down to the other.
  const double ramps = 10 / 100.0 + (10 - v) / 100;
  const double covered = (100 + 100 - v * v) / 200;
  EXPECT_NEAR(times("G01 X100\nY100\n", motion).cut, 2 * (ramps + (100 - covered) / 10), 1e-9);
}

TEST(Timing, ATurnBackStops) {
  MotionSettings motion = kSlow;
  motion.corner_deviation = 1;
  EXPECT_NEAR(times("G01 X100\nX0\n", motion).cut, 2 * times("G01 X100\n").cut, 1e-9);
}

TEST(Timing, ATightArcIsSlow) {
  // √(100·0.25) = 5 mm/s: 0.05 s and 0.125 mm up and down.
  const double length = 0.25 * std::numbers::pi;
  EXPECT_NEAR(times("G03 X0 Y0.5 J0.25\n").cut, 0.1 + (length - 0.25) / 5, 1e-9);
}

TEST(Timing, EveryPierceAndDwellCounts) {
  const Times sum = times("G01 X10\nM08\nG00 X20\nM07\nG04 X1.5\nG01 X30\n");
  EXPECT_DOUBLE_EQ(sum.pierce, 4);
  EXPECT_DOUBLE_EQ(sum.dwell, 1.5);
  EXPECT_GT(sum.rapid, 0);
  EXPECT_DOUBLE_EQ(sum.total(), sum.cut + sum.rapid + 5.5);
}

TEST(Timing, ManyShortMovesAreLookedAhead) {
  std::string steps = "G01\n";
  for (int i = 1; i <= 1000; ++i) steps += "X" + std::to_string(i / 10.0) + "\n";
  EXPECT_NEAR(times(steps).cut, times("G01 X100\n").cut, 1e-6);
}

TEST(Timing, APathThatGoesNowhereTakesNoTime) {
  EXPECT_EQ(time_of(Toolpath{}, MotionSettings{}).total(), 0);
}

}  // namespace
}  // namespace dgt
