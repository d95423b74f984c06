// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace dgt {

/// An axis-parallel box in mm.
struct Box {
  double min_x = 0;
  double min_y = 0;
  double max_x = 0;
  double max_y = 0;

  [[nodiscard]] Box united(const Box& b) const {
    return {std::min(min_x, b.min_x), std::min(min_y, b.min_y), std::max(max_x, b.max_x),
            std::max(max_y, b.max_y)};
  }
  [[nodiscard]] Box grown(double by) const {
    return {min_x - by, min_y - by, max_x + by, max_y + by};
  }
  [[nodiscard]] bool overlaps(const Box& b) const {
    return min_x <= b.max_x && b.min_x <= max_x && min_y <= b.max_y && b.min_y <= max_y;
  }
};

/// Boxes in contour order under a tree of fours. Neighbours on a contour are neighbours in the
/// plane, so the order of the contour serves as it is: no sorting, n boxes in 4n/3 nodes, built in
/// one pass. Boxes are kept in floats, rounded outward: what overlaps is always told, and now and
/// then what comes within a part in ten million of it.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes)
      : BoxTree(boxes.size(), [&](std::size_t i) { return boxes[i]; }) {}
  /// `box_of(i)` for each i below `count`.
  template <class BoxOf>
  BoxTree(std::size_t count, BoxOf&& box_of) {
    std::vector<Node>& leaves = levels_.emplace_back();
    leaves.reserve(count);
    for (std::size_t i = 0; i < count; ++i) leaves.push_back(outward(box_of(i)));
    while (levels_.back().size() > 1) levels_.push_back(above(levels_.back()));
  }

  /// Calls `visit(index)` for each box that overlaps `box`, in contour order.
  template <class Visit>
  void overlapping(const Box& box, Visit&& visit) const {
    if (!levels_.front().empty()) descend(levels_.size() - 1, 0, outward(box), visit);
  }

  /// Calls `visit(i, j)` with i < j once for each two boxes that overlap.
  template <class Visit>
  void pairs(Visit&& visit) const {
    if (!levels_.front().empty()) pairs_within(levels_.size() - 1, 0, visit);
  }

 private:
  struct Node {
    float min_x, min_y, max_x, max_y;

    [[nodiscard]] bool overlaps(const Node& b) const {
      return static_cast<int>(min_x <= b.max_x) & static_cast<int>(b.min_x <= max_x) &
             static_cast<int>(min_y <= b.max_y) & static_cast<int>(b.min_y <= max_y);
    }
  };
  using Level = std::vector<Node>;

  /// A float is nearest within 2⁻²⁴ of its size; twice that and the smallest normal number cover it.
  static Node outward(const Box& box) {
    const auto low = [](double v) {
      return static_cast<float>(v - std::fabs(v) * 0x1p-23) - std::numeric_limits<float>::min();
    };
    const auto high = [](double v) {
      return static_cast<float>(v + std::fabs(v) * 0x1p-23) + std::numeric_limits<float>::min();
    };
    return {low(box.min_x), low(box.min_y), high(box.max_x), high(box.max_y)};
  }

  static Level above(const Level& below) {
    Level level;
    level.reserve((below.size() + 3) / 4);
    for (std::size_t i = 0; i < below.size(); i += 4) {
      Node node = below[i];
      for (std::size_t j = i + 1; j < std::min(i + 4, below.size()); ++j) {
        node = {std::min(node.min_x, below[j].min_x), std::min(node.min_y, below[j].min_y),
                std::max(node.max_x, below[j].max_x), std::max(node.max_y, below[j].max_y)};
      }
      level.push_back(node);
    }
    return level;
  }

  template <class Visit>
  void pairs_within(std::size_t level, std::size_t index, Visit& visit) const {
    if (level == 0) return;
    const Level& below = levels_[level - 1];
    const std::size_t end = std::min(4 * index + 4, below.size());
    for (std::size_t i = 4 * index; i < end; ++i) {
      pairs_within(level - 1, i, visit);
      for (std::size_t j = i + 1; j < end; ++j)
        if (below[i].overlaps(below[j])) pairs_between(level - 1, i, j, visit);
    }
  }
  /// Of two nodes of one level that overlap, the first before the second.
  template <class Visit>
  void pairs_between(std::size_t level, std::size_t a, std::size_t b, Visit& visit) const {
    if (level == 0) {
      visit(a, b);
      return;
    }
    const Level& below = levels_[level - 1];
    const Node& node_b = levels_[level][b];
    const std::size_t end_a = std::min(4 * a + 4, below.size());
    const std::size_t end_b = std::min(4 * b + 4, below.size());
    for (std::size_t i = 4 * a; i < end_a; ++i) {
      if (!below[i].overlaps(node_b)) continue;
      for (std::size_t j = 4 * b; j < end_b; ++j)
        if (below[i].overlaps(below[j])) pairs_between(level - 1, i, j, visit);
    }
  }

  template <class Visit>
  void descend(std::size_t level, std::size_t index, const Node& box, Visit& visit) const {
    if (!levels_[level][index].overlaps(box)) return;
    if (level == 0) {
      visit(index);
      return;
    }
    const std::size_t end = std::min(4 * index + 4, levels_[level - 1].size());
    for (std::size_t i = 4 * index; i < end; ++i) descend(level - 1, i, box, visit);
  }

  std::vector<Level> levels_;  // the boxes first, the root last
};

}  // namespace dgt
