// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace dgt {

/// An axis-parallel box in mm.
struct Bounds {
  double min_x = 0;
  double min_y = 0;
  double max_x = 0;
  double max_y = 0;

  [[nodiscard]] Bounds united(const Bounds& b) const {
    return {std::min(min_x, b.min_x), std::min(min_y, b.min_y), std::max(max_x, b.max_x),
            std::max(max_y, b.max_y)};
  }
  [[nodiscard]] Bounds grown(double by) const {
    return {min_x - by, min_y - by, max_x + by, max_y + by};
  }
  [[nodiscard]] bool overlaps(const Bounds& b) const {
    return min_x <= b.max_x && b.min_x <= max_x && min_y <= b.max_y && b.min_y <= max_y;
  }
};

/// Boxes in contour order under a tree of fours. Neighbours on a contour are neighbours in the
/// plane, so the order of the contour serves as it is: no sorting, n boxes in 4n/3 nodes, built in
/// one pass. Boxes are kept in floats, rounded outward: what overlaps is always told, and now and
/// then what comes within a part in ten million of it.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Bounds>& boxes)
      : BoxTree(boxes.size(), [&](std::size_t i) { return boxes[i]; }) {}
  /// `box_of(i)` for each i below `count`.
  template <class BoxOf>
  BoxTree(std::size_t count, BoxOf&& box_of) {
    Level& leaves = levels_.emplace_back((count + 3) / 4);
    for (std::size_t i = 0; i < count; ++i) leaves[i / 4].set(i % 4, outward(box_of(i)));
    while (levels_.back().size() > 1) levels_.push_back(above(levels_.back()));
  }

  /// Calls `visit(index)` for each box that overlaps `box`, in contour order.
  template <class Visit>
  void overlapping(const Bounds& box, Visit&& visit) const {
    if (!levels_.front().empty()) descend(levels_.size() - 1, 0, outward(box), visit);
  }

  /// Calls `visit(i, j)` with i < j once for each two boxes that overlap.
  template <class Visit>
  void pairs(Visit&& visit) const {
    if (!levels_.front().empty()) pairs_within(levels_.size() - 1, 0, visit);
  }

 private:
  struct FloatBox {
    float min_x, min_y, max_x, max_y;
  };

  /// Four floats that compilers treat as one.
  using Lanes [[gnu::vector_size(16)]] = float;
  using Bits [[gnu::vector_size(16)]] = int;

  /// Bit i: lane i is set.
  static unsigned bits_of(Bits lanes) {
#ifdef __SSE2__
    return static_cast<unsigned>(__builtin_ia32_movmskps(std::bit_cast<Lanes>(lanes)));
#else
    lanes &= Bits{1, 2, 4, 8};
    return static_cast<unsigned>(lanes[0] | lanes[1] | lanes[2] | lanes[3]);
#endif
  }

  /// Four boxes, those that are not there empty: a node of the tree, with its lanes' children in
  /// the level below at 4 · index + lane.
  struct Four {
    Lanes min_x, min_y, max_x, max_y;

    static constexpr float kFar = std::numeric_limits<float>::max();
    Four()
        : min_x{kFar, kFar, kFar, kFar},
          min_y(min_x),
          max_x{-kFar, -kFar, -kFar, -kFar},
          max_y(max_x) {}

    void set(std::size_t lane, const FloatBox& box) {
      min_x[lane] = box.min_x;
      min_y[lane] = box.min_y;
      max_x[lane] = box.max_x;
      max_y[lane] = box.max_y;
    }
    [[nodiscard]] FloatBox lane(std::size_t i) const {
      return {min_x[i], min_y[i], max_x[i], max_y[i]};
    }
    [[nodiscard]] FloatBox all() const {
      FloatBox box = lane(0);
      for (std::size_t i = 1; i < 4; ++i) {
        box = {std::min(box.min_x, min_x[i]), std::min(box.min_y, min_y[i]),
               std::max(box.max_x, max_x[i]), std::max(box.max_y, max_y[i])};
      }
      return box;
    }
    /// Bit i: lane i overlaps.
    [[nodiscard]] unsigned overlapping(const FloatBox& b) const {
      return bits_of((min_x <= b.max_x) & (max_x >= b.min_x) & (min_y <= b.max_y) &
                     (max_y >= b.min_y));
    }
  };
  using Level = std::vector<Four>;

  /// A float is nearest within 2⁻²⁴ of its size; twice that and the smallest normal number cover
  /// it.
  static FloatBox outward(const Bounds& box) {
    const auto low = [](double v) {
      return static_cast<float>(v - std::fabs(v) * 0x1p-23) - std::numeric_limits<float>::min();
    };
    const auto high = [](double v) {
      return static_cast<float>(v + std::fabs(v) * 0x1p-23) + std::numeric_limits<float>::min();
    };
    return {low(box.min_x), low(box.min_y), high(box.max_x), high(box.max_y)};
  }

  static Level above(const Level& below) {
    Level level((below.size() + 3) / 4);
    for (std::size_t i = 0; i < below.size(); ++i) level[i / 4].set(i % 4, below[i].all());
    return level;
  }

  /// Calls `each(lane)` for each bit set.
  template <class Each>
  static void for_lanes(unsigned bits, Each&& each) {
    for (; bits != 0; bits &= bits - 1) each(static_cast<std::size_t>(std::countr_zero(bits)));
  }

  template <class Visit>
  void pairs_within(std::size_t level, std::size_t index, Visit& visit) const {
    const Four& four = levels_[level][index];
    for (std::size_t i = 0; i < 4; ++i) {
      const FloatBox box = four.lane(i);
      if (box.min_x > box.max_x) continue;  // empty
      if (level > 0) pairs_within(level - 1, 4 * index + i, visit);
      const unsigned behind = ~0U << (i + 1);
      for_lanes(four.overlapping(box) & behind, [&](std::size_t j) {
        if (level == 0)
          visit(4 * index + i, 4 * index + j);
        else
          pairs_between(level - 1, 4 * index + i, 4 * index + j, four.lane(j), visit);
      });
    }
  }
  /// `all_of_b` is the box of the second node.
  template <class Visit>
  void pairs_between(std::size_t level, std::size_t a, std::size_t b, const FloatBox& all_of_b,
                     Visit& visit) const {
    const Four& first = levels_[level][a];
    const Four& second = levels_[level][b];
    for_lanes(first.overlapping(all_of_b), [&](std::size_t i) {
      for_lanes(second.overlapping(first.lane(i)), [&](std::size_t j) {
        if (level == 0)
          visit(4 * a + i, 4 * b + j);
        else
          pairs_between(level - 1, 4 * a + i, 4 * b + j, second.lane(j), visit);
      });
    });
  }

  template <class Visit>
  void descend(std::size_t level, std::size_t index, const FloatBox& box, Visit& visit) const {
    for_lanes(levels_[level][index].overlapping(box), [&](std::size_t i) {
      if (level == 0)
        visit(4 * index + i);
      else
        descend(level - 1, 4 * index + i, box, visit);
    });
  }

  std::vector<Level> levels_;  // the boxes first, the root last
};

}  // namespace dgt
