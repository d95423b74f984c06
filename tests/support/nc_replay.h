// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// A control in small: runs written programs, to hold the writers against. It shares no code with
/// them, reads no more than they should write, and throws std::runtime_error at anything else.
namespace dgt::replay {

struct Spot {
  double x = 0;
  double y = 0;
};

struct Step {
  enum class Kind { Rapid, Line, Arc, Word };
  Kind kind = Kind::Word;
  Spot from, to;
  Spot centre;          ///< of an arc
  double radius = 0;    ///< at the start of an arc
  double mismatch = 0;  ///< |radius at the start − radius at the end|
  bool ccw = false;
  double sweep = 0;  ///< radians, > 0
  double z = 0;      ///< at the end
  bool torch = false;
  std::string text;
};

struct Run {
  std::vector<Step> steps;
  Spot end;
  std::int64_t sum_x = 0;  ///< ESSI: of the increments, in units
  std::int64_t sum_y = 0;
};

/// `unit` in mm; the tool begins at `start`.
/// Radius, mismatch and sweep from the ends, the centre and the sense.
void finish_arc(Step& s);

enum class EssiArcs { ByRadius, ByCentre };
[[nodiscard]] Run essi(std::string_view text, double unit, Spot start,
                       EssiArcs arcs = EssiArcs::ByRadius);
/// `B X B Y B J G Z`; between one D and the next the wire is out.
[[nodiscard]] Run three_b(std::string_view text, double unit, Spot start);
[[nodiscard]] Run gcode(std::string_view text, Spot start);

/// Points along a step, its ends included, no further apart than the step's length / (count − 1).
[[nodiscard]] std::vector<Spot> samples(const Step& step, int count);
/// The distance of a point from what a step runs along.
[[nodiscard]] double distance(const Spot& p, const Step& step);

}  // namespace dgt::replay
