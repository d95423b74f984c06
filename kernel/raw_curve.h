// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernel/box_tree.h"
#include "kernel/offset_source.h"
#include "kernel/strand.h"

/// The raw curves in doubles, as the production engine keeps them. Internal to the kernel.
namespace dgt {

/// A float not below `value` ≥ 0: one is nearest within 2⁻²⁴, and below the normal ones by less
/// than the smallest of them.
inline float rounded_up(double value) {
  return static_cast<float>(value * (1 + 0x1p-22)) + std::numeric_limits<float>::min();
}

/// A strand, up to where the one behind it begins. One cache line.
struct RawStrand {
  double x = 0;  ///< where it begins
  double y = 0;
  double centre_x = 0;
  double centre_y = 0;
  double radius = 0;   ///< not negative
  float ends_rad = 0;  ///< errors of both ends' coordinates, of the centre's and of the radius
  float centre_rad = 0;
  float radius_rad = 0;
  float rise = 0;  ///< no less than how far an arc rises above its chord
  RawKey key;
  bool is_line = true;
  bool counter_clockwise = true;
  bool first = false;  ///< of its loop
  bool last = false;
};

/// The strands of all loops. Behind the last one of each loop stands an end: a copy of where its
/// first begins, no strand itself.
class RawCurve {
 public:
  explicit RawCurve(const OffsetSource& source);

  [[nodiscard]] std::size_t size() const { return strands_.size(); }
  [[nodiscard]] const RawStrand& operator[](std::size_t i) const { return strands_[i]; }
  [[nodiscard]] std::uint32_t begin(std::size_t loop) const { return first_[loop]; }
  [[nodiscard]] std::uint32_t end(std::size_t loop) const { return first_[loop + 1] - 1; }
  [[nodiscard]] std::size_t loop_of(std::uint32_t strand) const;
  [[nodiscard]] std::uint32_t next(std::uint32_t strand) const;
  /// Whether the strands a < b follow each other on a loop.
  [[nodiscard]] bool adjacent(std::uint32_t a, std::uint32_t b) const;

  [[nodiscard]] Strand<double> strand(std::uint32_t i) const;
  /// Holds the whole strand; empty for an end.
  [[nodiscard]] Bounds box(std::uint32_t i) const;
  /// Whether two strands surely do not meet, by the sides of their chords alone.
  [[nodiscard]] bool surely_apart(std::uint32_t a, std::uint32_t b) const;

  /// The winding number of the region left of the loops (offset_raw.h).
  [[nodiscard]] int region_number() const { return region_number_; }

 private:
  void lay(const OffsetSource& source, std::size_t loop);
  /// The corner behind edge `i`, when it is not one arc.
  bool lay_corner(const OffsetSource& source, std::uint32_t i);

  std::vector<RawStrand> strands_;
  std::vector<std::uint32_t> first_;
  double width_ = -1;  ///< of the widest loop so far
  int region_number_ = 0;
};

inline Strand<double> RawCurve::strand(std::uint32_t i) const {
  const RawStrand& s = strands_[i];
  const RawStrand& behind = strands_[i + 1];
  return {{s.x, s.y, s.ends_rad},
          {behind.x, behind.y, s.ends_rad},
          {s.centre_x, s.centre_y, s.centre_rad},
          {s.radius, s.radius_rad},
          s.is_line,
          s.counter_clockwise};
}

inline std::uint32_t RawCurve::next(std::uint32_t strand) const {
  return strands_[strand].last ? first_[loop_of(strand)] : strand + 1;
}

inline bool RawCurve::adjacent(std::uint32_t a, std::uint32_t b) const {
  if (b == a + 1) return true;  // an end stands between loops
  return strands_[a].first && strands_[b].last && loop_of(a) == loop_of(b);
}

/// One strand lies to one side of the other's chord and beyond the rises. Cross products of vectors
/// no longer than S, whose coordinates are off by e, are off by less than 4 S e and the roundings
/// of two products and three sums of size S², 2⁻⁵⁰ S².
inline bool RawCurve::surely_apart(std::uint32_t i, std::uint32_t j) const {
  const RawStrand& a = strands_[i];
  const RawStrand& b = strands_[j];
  const double ux = strands_[i + 1].x - a.x;
  const double uy = strands_[i + 1].y - a.y;
  const double vx = strands_[j + 1].x - b.x;
  const double vy = strands_[j + 1].y - b.y;
  const double wx = b.x - a.x;
  const double wy = b.y - a.y;
  const double u = std::fabs(ux) + std::fabs(uy);
  const double v = std::fabs(vx) + std::fabs(vy);
  const double size = u + v + std::fabs(wx) + std::fabs(wy);
  const double off = static_cast<double>(a.ends_rad) + b.ends_rad;
  const double error = size * (4.5 * off + 0x1p-49 * size);
  const double turn = ux * vy - uy * vx;
  const double rises = static_cast<double>(a.rise) + b.rise;

  const double b_from = ux * wy - uy * wx;
  const double b_to = b_from + turn;
  const double beside_a = u * rises + error;
  if (std::min(b_from, b_to) > beside_a || std::max(b_from, b_to) < -beside_a) return true;
  const double a_from = vy * wx - vx * wy;
  const double a_to = a_from - turn;
  const double beside_b = v * rises + error;
  return std::min(a_from, a_to) > beside_b || std::max(a_from, a_to) < -beside_b;
}

}  // namespace dgt
