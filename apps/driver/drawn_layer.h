// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "apps/driver/drawn_curve.h"

namespace dgt {

/// Many curves of one kind in their order, with boxes around runs of them: what is in a window is
/// found without looking at the rest, and what is too small to be told apart is passed in one.
class DrawnLayer {
 public:
  /// `move`: its number in the path, rising.
  void add(const Move& move, std::uint32_t number);
  /// To be called once, after the last.
  void index();

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] DrawnCurve operator[](std::size_t i) const;
  [[nodiscard]] DrawnPlace begin_of(std::size_t i) const { return entries_[i].from; }
  [[nodiscard]] DrawnPlace end_of(std::size_t i) const { return entries_[i].to; }
  [[nodiscard]] bool is_arc(std::size_t i) const { return entries_[i].arc != kStraight; }
  [[nodiscard]] std::uint32_t number(std::size_t i) const { return entries_[i].number; }
  [[nodiscard]] const SourcePlace& source(std::size_t i) const { return entries_[i].source; }
  /// How many curves belong to moves before `number`.
  [[nodiscard]] std::size_t count_before(std::uint32_t number) const;
  /// Those that were asked for in a line of the source, rising.
  [[nodiscard]] std::span<const std::uint32_t> of_line(std::uint32_t file,
                                                       std::uint32_t line) const;
  [[nodiscard]] const Box& box() const { return box_; }

  /// Calls `curve(i)` for what may come into `window`, and `speck(first, last)` for a run of curves
  /// [first, last) there that lie within a square of side `small`; in order.
  template <class Curve, class Speck>
  void visit(const Box& window, double small, Curve&& curve, Speck&& speck) const {
    if (!levels_.empty()) descend(levels_.size() - 1, 0, window, small, curve, speck);
  }
  /// Calls `curve(i)` for what may come into `window`, in order.
  template <class Curve>
  void visit(const Box& window, Curve&& curve) const {
    visit(window, -1, curve, [](std::size_t, std::size_t) {});
  }

  /// A centre of arcs, and one of these.
  struct Centre {
    DrawnPlace at;
    std::uint32_t curve = 0;
  };
  /// Calls `centre(c)` for those in `window`, from left to right.
  template <class Visit>
  void visit_centres(const Box& window, Visit&& visit) const {
    for (std::size_t i = first_centre(window.left); i < centres_.size(); ++i) {
      const Centre& centre = centres_[i];
      if (centre.at.x > window.right) return;
      if (centre.at.y >= window.bottom && centre.at.y <= window.top) visit(centre);
    }
  }

 private:
  static constexpr std::uint32_t kStraight = ~std::uint32_t{0};
  static constexpr std::size_t kGroup = 8;  ///< curves or groups under one box

  struct Entry {
    DrawnPlace from;
    DrawnPlace to;
    std::uint32_t arc = kStraight;  ///< counts into arcs_
    std::uint32_t number = 0;
    SourcePlace source;
  };
  struct Arc {
    DrawnPlace centre;
    double radius = 0;
    double sweep = 0;
  };
  using Level = std::vector<Box>;

  [[nodiscard]] std::size_t first_centre(double left) const;
  void index_boxes();
  void index_centres();
  void index_lines();

  template <class Curve, class Speck>
  void descend(std::size_t level, std::size_t node, const Box& window, double small, Curve& curve,
               Speck& speck) const {
    const Box& box = levels_[level][node];
    if (!overlap(box, window)) return;
    std::size_t span = kGroup;
    for (std::size_t i = 0; i < level; ++i) span *= kGroup;
    const std::size_t first = node * span;
    const std::size_t last = std::min(first + span, entries_.size());
    if (box.width() <= small && box.height() <= small) {
      speck(first, last);
    } else if (level == 0) {
      for (std::size_t i = first; i < last; ++i) curve(i);
    } else {
      const std::size_t end = std::min((node + 1) * kGroup, levels_[level - 1].size());
      for (std::size_t i = node * kGroup; i < end; ++i)
        descend(level - 1, i, window, small, curve, speck);
    }
  }

  std::vector<Entry> entries_;
  std::vector<Arc> arcs_;
  std::vector<Level> levels_;  ///< around groups of curves, then around groups of these
  std::vector<Centre> centres_;
  std::vector<std::uint32_t> by_line_;
  Box box_;
};

}  // namespace dgt
